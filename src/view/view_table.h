#pragma once

// All that can be shown, one row for each thing. The keys of a lesson's blocks and of a saved view,
// the links of lessons, the options of the command line and the line that Ctrl+C copies follow from
// this table. Something new that can be shown is a member of Session, in Choices if undo takes it
// back, a member of ViewState, and a row here.

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

/// Which part of the view a field belongs to. `--help` lists the options part by part.
enum class ViewPart : std::uint8_t {
    drawn,     ///< what is drawn, however it is looked at
    plane,     ///< which plane of the picture is seen
    panel,     ///< what is seen next to it and over it
    selection, ///< what is picked
    canvas,    ///< which place of the picture, how large
    runs,      ///< the second run
};

/// An option as it was given, with all its words.
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
    /// Throws UsageError for an argument that names nothing on any scene.
    std::function<void(const std::string& argument)> check{};
    /// Shows it on this frame, which is the session's. Throws UsageError for what there is not; the
    /// session is then as before.
    std::function<void(Session&, const Frame&, const std::string& argument)> follow{};
};

/// From one view to another, when a command line is written.
struct ViewChange {
    const Session& from_session; ///< what the line begins with
    const Session& to_session;   ///< what it is to open
    const ViewState& from;
    const ViewState& to;
};

/// One thing that can be shown.
struct ViewField {
    std::string_view key; ///< in the blocks of a lesson and in a saved view
    ViewPart part = ViewPart::drawn;
    bool is_of_scene = false; ///< it means nothing on another scene
    ViewOption option;
    ViewLink link{};

    /// From a TOML value. Throws InputError, or adds to the block's faults.
    std::function<void(const TomlBlock&, const toml::node&, ViewState&)> read{};
    /// As a TOML value; empty if it is not said. Missing where a saved view cannot hold it.
    std::function<std::string(const ViewState&)> write{};
    /// From an option. Throws UsageError. Missing where open_view() reads the option itself.
    std::function<void(const GivenOption&, ViewState&)> parse{};
    /// The words of the option, one occurrence each; none if nothing changes.
    std::function<std::vector<std::string>(const ViewChange&)> words{};
    /// What the session shows of it, where that is not what a fresh session shows.
    std::function<void(const Session&, const Scene& original, ViewState&)> tell{};
    /// Shows it, said or not; what is drawn is shown already. Throws UsageError for what there is
    /// not. Missing where show_state() does it before all others.
    std::function<void(const ViewState&, Session&)> show{};
    /// Takes over what is said.
    std::function<void(const ViewState& over, ViewState&)> take{};
    /// Unsays it.
    std::function<void(ViewState&)> clear{};
};

/// All of them, in the order in which a saved view has them.
std::span<const ViewField> view_table();

/// The same, but what is drawn comes before what is seen of it: the order in which they are shown
/// and said on a command line.
std::span<const ViewField* const> view_table_drawn_first();

/// The field of this key, which must exist.
const ViewField& view_field(std::string_view key);

/// The keys of what is shown, reading into `state` and noting their lines. Both arguments must
/// outlive the keys.
TomlKeys view_keys(const TomlBlock& block, ViewState& state);

/// What a table of TOML says is shown.
/// @param line where the table begins: faults of the whole table are reported there
/// @param what how messages name the table
ViewState read_view_state(const toml::table& table, int line, FaultList& faults,
                          const char* what = "the block");

} // namespace rasterwalk
