#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "base/files.h"
#include "facts/expression.h"
#include "session/session.h"

namespace rasterwalk {

/// The page about what is shown: Markdown that begins with its title.
struct StageNote {
    std::string path;  ///< lessons/stages/NAME.md
    std::string text;  ///< the whole file; empty if it could not be read
    std::string fault; ///< why it could not be read, a sentence; empty if it could
};

/// Name of the note for what the session shows: the stage's, in a pass before the picture `shadow`,
/// or for a scene in pixel space `bench`
/// if it has the lab's examples, otherwise `pixels`.
std::string note_name(const Session& session);

/// The text of a note about what is shown: each {EXPRESSION} is replaced by its number, as in
/// fill_in(). A paragraph with a missing number, such as one about a pixel while none is picked, is
/// left out. One with an expression that is not understood stays as written.
std::string note_about(std::string_view text, const FactReader& fact);

/// Reads FOLDER/stages/NAME.md. Never throws: what goes wrong is in the note's fault.
StageNote read_stage_note(const std::string& folder, std::string_view name);

/// The notes read so far. A file that changes is read again.
class StageNotes {
  public:
    /// The note with this name from lessons_folder(). Valid until the next call. Never throws.
    const StageNote& find(const std::string& name);

  private:
    struct Kept {
        StageNote note;
        FileState state;
    };
    std::map<std::string, Kept> kept_;
};

/// The largest note to read, bytes.
inline constexpr std::size_t largest_note = std::size_t{1} << 20;

} // namespace rasterwalk
