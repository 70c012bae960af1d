#pragma once

// The tabs of the inspector, the groups they are in, and who chose the one shown: the lesson or the
// stage, until the student does.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_words.h"
#include "stages/stages.h"

namespace rasterwalk {

struct Session;
struct Settings;

/// What the tabs of the inspector are about.
enum class TabGroup : std::uint8_t { triangle, pixel, runs, code };

inline constexpr std::size_t tab_group_count = enum_words<TabGroup>.size();

/// A tab of the inspector.
struct TabInfo {
    std::string_view name; ///< as in lessons, files and options
    std::string_view title;
    std::string_view help; ///< one sentence
    TabGroup group = TabGroup::triangle;
    bool needs_camera = false;      ///< of no use in a scene in pixels, which has no view volume
    bool needs_maps = false;        ///< of no use in a scene without textures and other maps
    std::string_view tests_title{}; ///< if edge functions test every pixel; empty: the same
    std::string_view tests_help{};  ///< in that case too; empty: the same
    bool needs_order = false;       ///< of no use while triangles are drawn in the scene's order
    bool needs_model = false;       ///< of no use in a scene that was not read from a model file
};

/// A tab's title and help in the interface.
struct TabWords {
    std::string_view title, help;
};

/// The words of a tab under the current run's settings: if pixels are tested one by one, the tab
/// of the rows is about what is inside.
TabWords tab_words(const TabInfo& tab, const Settings& settings);

/// The tabs in order, group by group.
std::span<const TabInfo> tab_list();

/// The tab with this name; null for the settings, and if there is none.
const TabInfo* find_tab(std::string_view name);

/// The settings cover the inspector instead of being one of its tabs, but have a name like a tab.
inline constexpr std::string_view settings_tab = "settings";

/// The tab of the lab's code.
inline constexpr std::string_view code_tab = "code";

/// The tab of the ways to remove hidden surfaces.
inline constexpr std::string_view hidden_tab = "hidden";

/// All names: those of the tabs, and the settings.
std::span<const std::string_view> tab_names();

/// Who chose the tab that is shown, and what else the inspector holds.
struct TabGuide {
    bool is_own = false;        ///< the student: lesson and stage leave it alone
    std::string of_step;        ///< the tab that the lesson's step shows; empty: it names none
    std::string under_settings; ///< the tab below the settings; empty: the usual one
    std::string before_compare; ///< the tab that a comparison replaced; empty: none
    std::array<std::string, tab_group_count> last; ///< each group's last tab shown, or empty
    std::vector<std::string> panels; ///< tabs that the lesson's step shows; empty: all
    bool shows_all = false;          ///< shows all anyway, because the student asked for it
    std::optional<StripStep> stage;  ///< the last one that was seen
};

/// The tab if none has been chosen: the one that suits the stage, or, if the lesson's step hides
/// it, the first that the step shows.
std::string_view usual_tab(const Session& session);

/// The lesson's step, or a view that is opened, shows this tab; empty: the usual one. If no lesson
/// is open, a named tab counts as the student's choice.
void guide_to_tab(Session& session, std::string_view tab);
/// A link leads to this tab, which does not count as the student's choice.
void lead_to_tab(Session& session, std::string_view tab);
/// The student asks for this tab. The settings cover the tab shown.
void choose_tab(Session& session, std::string_view tab);
/// The lesson has moved on, and the tab is still the student's earlier choice; if the step shows
/// the settings, it is below them.
void keep_own_tab(Session& session, std::string_view tab);
/// Lesson and stage choose the tab again.
void follow_guide(Session& session);
/// A comparison has begun, and its own tab explains it: that one is shown, or is put below the
/// settings.
void show_compare_tab(Session& session);
/// If the comparison has ended, restores the previous tab, unless another was chosen since. Call it
/// once per frame.
void leave_compare_tab(Session& session);
/// Closes the settings: the tab below them is back.
void close_settings(Session& session);
/// Shows a tab, unless the student or the lesson has chosen one, or runs are compared, which
/// belongs to no stage; then it is shown when the comparison ends.
void suggest_tab(Session& session, std::string_view tab);
/// If the stage has changed, suggests its tab. Call it once per frame.
void follow_stage(Session& session);

/// The tab shown, or the one below the settings.
std::string_view tab_below(const Session& session);
/// The tab that a click on the group opens: the last one shown, or the first that is not hidden.
std::string_view tab_of_group(const Session& session, TabGroup group);
/// Does the inspector offer this tab? Only if the scene has a use for it. A lesson's step may hide
/// it, but never the tab shown.
bool is_offered(const Session& session, const TabInfo& tab);
/// Does the lesson's step hide any tab?
bool hides_tabs(const Session& session);

} // namespace rasterwalk
