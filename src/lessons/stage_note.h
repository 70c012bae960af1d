#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "base/file_state.h"
#include "facts/expression.h"
#include "session/session.h"

namespace rasterwalk {

/// The page about what is shown: Markdown that begins with its title.
struct StageNote {
    std::string path;  ///< lessons/stages/NAME.md
    std::string text;  ///< the whole file; empty if it could not be read
    std::string fault; ///< a sentence why it could not be read; empty if it could
};

/// Name of the note that belongs to what the session shows: that of the stage, or for a scene in
/// pixel space `bench` where it has the lab's examples, `pixels` where it has none.
std::string note_name(const Session& session);

/// The text of a note about what is shown: the number of each {EXPRESSION} in its place, as in
/// fill_in(). A paragraph that lacks one of its numbers, such as those of a pixel while none is
/// picked, is left out. One with an expression that is not understood stays as it is written.
std::string note_about(std::string_view text, const FactReader& fact);

/// Reads FOLDER/stages/NAME.md. Never throws: what goes wrong is the note's fault.
StageNote read_stage_note(const std::string& folder, std::string_view name);

/// The notes that were read so far. A file that changes is read again.
class StageNotes {
  public:
    /// The note of this name from lessons_folder(). Valid until the next call. Never throws.
    const StageNote& find(const std::string& name);

  private:
    struct Kept {
        StageNote note;
        FileState state;
    };
    std::map<std::string, Kept> kept_;
};

/// The largest note that is read, bytes.
inline constexpr std::size_t largest_note = std::size_t{1} << 20;

} // namespace rasterwalk
