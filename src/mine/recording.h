#pragma once

// What a student's program did, as it wrote it into the memory that it shares with this one. All of
// it is copied and checked: the program may have written anything there.

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "mine/functions/questions.h"
#include "mine/kit/recording.h"
#include "scene/scene.h"

namespace rasterwalk {

/// What a program is to do.
struct ProgramTask {
    std::uint32_t parts = 0;  ///< bits of Part that are asked
    bool before_main = false; ///< asked before main(), without a first frame
    int frames = 1;           ///< to be drawn
    int key = 0;              ///< held from the second frame on, as SDL 2 numbers it; 0: none
};

/// What a program did, copied out of the memory. Counts are within the limits of the kit.
struct Recording {
    rasterwalk_kit::Progress progress{};
    Viewport window{0, 0}; ///< of the picture, pixels; 0: no window was opened, or one too large
    std::vector<rasterwalk_kit::Put> puts; ///< of the first frame since it was cleared, in order
    std::vector<glm::vec3> picture; ///< of the first frame, row by row from the top; not clamped
    std::vector<double> answers;

    bool has_picture() const { return !picture.empty(); }
};

/// The memory. It keeps its size whatever the program does to it.
class RecordingMemory {
  public:
    /// Throws AccessError if the system has none.
    RecordingMemory();
    ~RecordingMemory();
    RecordingMemory(const RecordingMemory&) = delete;
    RecordingMemory& operator=(const RecordingMemory&) = delete;

    /// To be passed to the program.
    int descriptor() const { return descriptor_; }

    /// Writes the task. Call it before the program starts.
    /// @param questions at most most_questions numbers
    void write(const ProgramTask& task, const QuestionStream& questions);

    /// What the program has written by now. It must have ended.
    Recording read() const;

  private:
    int descriptor_ = -1;
    rasterwalk_kit::Recorded* memory_ = nullptr;
};

} // namespace rasterwalk
