#pragma once

// Everything that can be shown, one row per thing. The keys of a lesson's blocks and of a saved
// view, the links of lessons, the options of the command line and the line that Ctrl+C copies all
// come from this table. To add something, add a member to Session (and to Choices if undo takes it
// back), a member to ViewState, and a row here.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/toml_block.h"
#include "pipeline/frame.h"
#include "scene/scene.h"
#include "session/session.h"
#include "view/view_state.h"

namespace rasterwalk {

/// The part of the view that a field belongs to. `--help` lists the options part by part.
enum class ViewPart : std::uint8_t {
    drawn,     ///< what is drawn, however it is looked at
    plane,     ///< which plane of the picture is seen
    panel,     ///< what is seen next to it and over it
    selection, ///< what is picked
    canvas,    ///< which place of the picture, how large
    runs,      ///< the second run
};

/// An option as given, with all its words.
struct GivenOption {
    std::string name; ///< as the student writes it: "--tab"
    std::vector<std::string> words;
};

/// The option of a field.
struct ViewOption {
    std::string_view name; ///< without its dashes; empty: the field has none
    std::string_view type; ///< in --help: "X,Y"
    std::string help;
    bool is_repeatable = false;
};

/// The link of a field in a lesson.
struct ViewLink {
    std::string_view name; ///< before the colon: `pixel:250,131`; empty: the field has none
    /// Throws UsageError for an argument that names nothing in any scene.
    std::function<void(const std::string& argument)> check{};
    /// Shows it in this frame, which is the session's. Throws UsageError for what does not exist;
    /// the session is then unchanged.
    std::function<void(Session&, const Frame&, const std::string& argument)> follow{};
};

/// The change from one view to another, for writing a command line.
struct ViewChange {
    const Session& from_session; ///< what the line begins with
    const Session& to_session;   ///< what it should open
    const ViewState& from;
    const ViewState& to;
};

/// One thing that can be shown.
struct ViewField {
    std::string_view key; ///< in the blocks of a lesson and in a saved view
    ViewPart part = ViewPart::drawn;
    bool is_of_scene = false; ///< it means nothing in another scene
    ViewOption option;
    ViewLink link{};

    /// From a TOML value. Throws InputError, or adds to the block's faults.
    std::function<void(const TomlBlock&, const toml::node&, ViewState&)> read{};
    /// As a TOML value; empty if it is not given. Missing if a saved view cannot hold it.
    std::function<std::string(const ViewState&)> write{};
    /// From an option. Throws UsageError. Missing if open_view() reads the option itself.
    std::function<void(const GivenOption&, ViewState&)> parse{};
    /// The words of the option, one occurrence each; none if nothing changes.
    std::function<std::vector<std::string>(const ViewChange&)> words{};
    /// Reads it from the session, if that differs from a fresh session.
    std::function<void(const Session&, const Scene& original, ViewState&)> read_session{};
    /// Shows it, given or not; what is drawn is already shown. Throws UsageError for what does not
    /// exist. Missing if show_state() does it before all others.
    std::function<void(const ViewState&, Session&)> show{};
    /// Takes over a value that is given.
    std::function<void(const ViewState& over, ViewState&)> take{};
    /// Clears it.
    std::function<void(ViewState&)> clear{};
};

/// All of them, in the order of a saved view.
std::span<const ViewField> view_table();

/// The same, but what is drawn comes before what is seen of it: the order in which they are shown
/// and written on a command line.
std::span<const ViewField* const> view_table_drawn_first();

/// The field of this key, which must exist.
const ViewField& view_field(std::string_view key);

/// The keys of what is shown, which read into `state` and note their lines. Both arguments must
/// outlive the keys.
TomlKeys view_keys(const TomlBlock& block, ViewState& state);

/// What is shown according to a TOML table.
/// @param line where the table begins: faults of the whole table are reported there
/// @param what the table's name in messages
ViewState read_view_state(const toml::table& table, int line, FaultList& faults,
                          const char* what = "the block");

} // namespace rasterwalk
