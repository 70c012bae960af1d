#pragma once

// The commands: each takes its options, prints data on `out` and messages on `err`, and throws
// Error.

#include <iosfwd>
#include <string>
#include <vector>

#include "base/error.h"
#include "cli/progress_line.h"
#include "inspect/measures.h"
#include "opening/view_options.h"

namespace rasterwalk {

struct RenderOptions {
    ViewOptions view;
    std::string output;
};
void render_command(const RenderOptions& options, std::ostream& err);

struct StatsOptions {
    ViewOptions view;
    bool json = false;
    bool time = false;   ///< also measure what each measure against useless work saves
    bool hidden = false; ///< also count what each way to remove hidden surfaces takes
};
/// @param clock for `time`; without one UsageError
void stats_command(const StatsOptions& options, const Clock& clock, std::ostream& out,
                   std::ostream& err);
/// What each of its numbers counts, one per line: for its help.
std::string stats_footer();

struct RowsOptions {
    std::vector<std::string> points; ///< X,Y
    std::vector<std::string> presets;
    std::vector<std::string> assignments;
    bool json = false;
};
void rows_command(const RowsOptions& options, std::ostream& out, std::ostream& err);

struct TriangleOptions {
    ViewOptions view;
    std::string triangle;  ///< its number, from 0
    bool formulas = false; ///< each number of its vertices with its formula
    bool json = false;
};
void triangle_command(const TriangleOptions& options, std::ostream& out);

struct PixelOptions {
    ViewOptions view;
    std::string pixel;     ///< X,Y
    bool formulas = false; ///< each number of the fragment that stays with its formula
    bool json = false;
};
void pixel_command(const PixelOptions& options, std::ostream& out);

struct CodeOptions {
    ViewOptions view;
    int lines = 0; ///< after the moment began
    bool json = false;
};
void code_command(const CodeOptions& options, std::ostream& out);

struct SettingsOptions {
    ViewOptions view;
    bool json = false;
};
void settings_command(const SettingsOptions& options, std::ostream& out);

struct PresetsOptions {
    bool json = false;
};

void presets_command(const PresetsOptions& options, std::ostream& out);

struct BugsOptions {
    bool json = false;
};
void bugs_command(const BugsOptions& options, std::ostream& out);

struct CheckOptions {
    std::vector<std::string> paths; ///< folders, lessons, scenes
    bool luck = false;              ///< each task is tried at random as well
    bool advice = false;            ///< also what may be right as it is
    bool style = false;             ///< just the English of texts, strings and comments
};
/// Prints every fault, file:line and a sentence. Returns ExitCode::difference if there is one.
/// Throws AccessError for a file that is not there.
ExitCode check_command(const CheckOptions& options, std::ostream& out, std::ostream& err,
                       ProgressLine& progress);

struct FactsOptions {
    bool json = false;
};
void facts_command(const FactsOptions& options, std::ostream& out);

struct LessonsOptions {
    bool json = false;
};
/// Lists the lessons and the progress in them; progress that cannot be read is a warning on `err`.
void lessons_command(const LessonsOptions& options, std::ostream& out, std::ostream& err);

/// The most vertices that `rows` takes.
inline constexpr std::size_t max_polygon_vertices = 1000;

} // namespace rasterwalk
