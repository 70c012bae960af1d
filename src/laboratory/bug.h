#pragma once

// The mistakes that a rasterizer can make, each a named set of settings with its texts. Data read
// from lessons/bugs.toml.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "session/session.h"

namespace rasterwalk {

/// Setting names with values as text, in order.
using Assignments = std::vector<std::pair<std::string, std::string>>;

/// One mistake.
struct Bug {
    std::string id;       ///< "B9"; variants of one mistake have letters: "B20a"
    std::string name;     ///< "Last column dropped"
    std::string sentence; ///< what it is
    std::string symptom;  ///< what you see of it
    std::string look;     ///< where to look for it; may hold links, as in lessons
    std::string cure;     ///< what to write instead
    std::string section;  ///< of the lab
    std::string lesson;   ///< id of the lesson that explains it: "06-filling"; may be empty
    std::string code;     ///< a few lines of wrong C++; may be empty
    std::string scene;    ///< file that shows it, relative to lessons_folder(): "scenes/..."
    Assignments set;      ///< what makes the mistake
    Assignments against;  ///< what the correct run sets to make the mistake visible; the run with
                          ///< the mistake starts from it too
};

/// Reads the mistakes and tries each value, so that a wrong one is found here. Throws AccessError,
/// or InputError with file:line.
std::vector<Bug> read_bugs(const std::string& path);
std::vector<Bug> parse_bugs(std::string_view text, const std::string& path);

/// The mistakes of lessons_folder(). Throws as read_bugs().
std::vector<Bug> read_bugs();

/// The mistake of this id, in either case. Throws UsageError that names the nearest.
const Bug& find_bug(const std::vector<Bug>& bugs, std::string_view id);

/// The mistake of exactly this id; null if there is none.
const Bug* bug_of_id(const std::vector<Bug>& bugs, std::string_view id);

/// The run without the mistake and the run with it, on top of other settings.
Settings correct_run(const Bug& bug, const Settings& base);
Settings wrong_run(const Bug& bug, const Settings& base);

/// The lab's own rules, with the camera, light, picture and stage of other settings.
Settings with_handout_rules(const Settings& settings);

/// Makes run A the one with the mistake and run B the correct one. Both have the lab's rules except
/// for what the bug says; scene, camera, light, picture and cursor stay. Ends a comparison in
/// progress first; end_comparison() turns the mistake off again.
void apply_bug(const Bug& bug, Session& session);

/// The same in the bug's own scene, which it loads. Throws Error.
void open_bug(const Bug& bug, Session& session);

/// Makes the given run with the bug of this id run A, and the given one without it run B.
/// end_comparison() turns the mistake off again.
void show_bug(const std::string& id, const Settings& wrong, const Settings& correct,
              Session& session);

/// Is this mistake, by its id, compared with the correct run?
bool is_on(const Session& session, std::string_view bug);

} // namespace rasterwalk
