#pragma once

// What a student's program has drawn, pixel by pixel, as a run that has moments: those of our
// picture, put by put.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "scene/scene.h"
#include "settings/settings.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// A pixel that one of our moments puts.
struct OurPut {
    Cursor cursor; ///< the moment
    glm::ivec2 pixel{0};
};

/// Where two sequences part. Puts outside the picture count in neither.
struct SequenceParting {
    std::int64_t index = 0;           ///< of the first put that differs, from 0
    std::optional<glm::ivec2> theirs; ///< none: their sequence has ended
    std::optional<OurPut> ours;       ///< none: ours has ended
};

/// A pixel that a program puts.
struct ProgramPut {
    glm::ivec2 pixel{0};    ///< column and row; may lie anywhere
    glm::vec3 colour{0.0f}; ///< linear, not clamped, finite
};

/// What a program has drawn, and what we draw under its rules.
struct ProgramDrawing {
    std::string name;                   ///< of the program, for people: "skeleton.cpp"
    std::shared_ptr<const Scene> scene; ///< that it draws: the lab's room
    Settings settings;                  ///< by which our picture corresponds to its own
    std::vector<ProgramPut> puts;       ///< of its first frame that lie in the picture, in order
    std::vector<Cursor> ours;           ///< the moments of our puts, in order
    std::optional<SequenceParting> parting; ///< none: both put the same pixels in the same order

    /// Memory that it takes without the scene.
    std::size_t bytes() const;
};

/// How many of its puts are made at a moment of ours: as many as we have made before it; at the
/// end, all.
std::size_t puts_at(const ProgramDrawing& drawing, const Cursor& cursor);

/// The moment of our put that theirs differs from first: everything before it is the same. The end,
/// if ours has ended there. None if they never part.
std::optional<Cursor> moment_of_parting(const ProgramDrawing& drawing);

/// Where the two part, in a sentence: their pixel and ours.
std::string parting_text(const SequenceParting& parting);

/// What a program puts on one pixel.
struct ProgramWrite {
    std::size_t index = 0; ///< of the put, from 0
    glm::vec3 colour{0.0f};

    friend bool operator==(const ProgramWrite&, const ProgramWrite&) = default;
};

/// All that it puts there, in order.
std::vector<ProgramWrite> writes_on(const ProgramDrawing& drawing, glm::ivec2 pixel);

/// The planes of a program's picture: colour, the owner as far as our puts are the same, and as
/// overdraw the times that a pixel was put. The depth is not known, and stays that of an empty
/// buffer.
class ProgramPlanes {
  public:
    /// Starts over.
    /// @param drawing not null
    /// @param frame   ours under the program's rules; its size and its rules of the screen are used
    void begin(std::shared_ptr<const ProgramDrawing> drawing, const Frame& frame);

    /// Goes to this number of puts, no more than there are: forward it draws on, backward it starts
    /// again from an empty picture. Puts outside the planes are left out.
    void go_to(std::size_t puts);

    const Framebuffer& planes() const { return planes_; }
    /// How many puts are made.
    std::size_t puts() const { return puts_; }
    /// All pixels that the last go_to() has changed lie in it; after the first call since begin(),
    /// those of the whole picture.
    const Rectangle& changed() const { return changed_; }

  private:
    void put(std::size_t index);

    std::shared_ptr<const ProgramDrawing> drawing_;
    Framebuffer planes_;
    std::size_t puts_ = 0;
    Rectangle changed_;
    bool is_new_ = true; ///< no go_to() since begin()
};

} // namespace rasterwalk
