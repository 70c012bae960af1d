// The memory that a student's program writes into, written here as a hostile program would.

#include "mine/recording.h"

#include <cerrno>
#include <cstring>
#include <limits>

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/catch.h"

using namespace rasterwalk;
using rasterwalk_kit::Recorded;

namespace {

/// The memory as the program sees it: mapped once more through the descriptor.
class ProgramsView {
  public:
    explicit ProgramsView(const RecordingMemory& memory) {
        void* const mapped = ::mmap(nullptr, sizeof(Recorded), PROT_READ | PROT_WRITE, MAP_SHARED,
                                    memory.descriptor(), 0);
        REQUIRE(mapped != MAP_FAILED);
        recorded_ = static_cast<Recorded*>(mapped);
    }
    ProgramsView(const ProgramsView&) = delete;
    ProgramsView& operator=(const ProgramsView&) = delete;
    ~ProgramsView() { ::munmap(recorded_, sizeof(Recorded)); }

    Recorded* operator->() const { return recorded_; }

  private:
    Recorded* recorded_ = nullptr;
};

/// A program that has drawn one frame of this size and put one pixel.
void draw_frame(const ProgramsView& program, int width, int height) {
    program->progress.width = width;
    program->progress.height = height;
    program->progress.frames = 1;
    program->progress.puts = 1;
    program->puts[0] = {2, 1, 0.25f, 0.5f, 0.75f};
}

} // namespace

TEST_CASE("The program reads the task as it was written") {
    RecordingMemory memory;
    ProgramTask task;
    task.parts = 0xa4;
    task.before_main = true;
    task.frames = 7;
    task.key = 0x40000052;
    QuestionStream questions;
    questions.numbers = {0.5, -2.0, 1e300};
    questions.ends = {0, 0, 1, 3, 3, 3, 3, 3};
    memory.write(task, questions);

    const ProgramsView program(memory);
    CHECK(program->task.magic == rasterwalk_kit::recording_magic);
    CHECK(program->task.parts == 0xa4);
    CHECK(program->task.before_main == 1);
    CHECK(program->task.frames == 7);
    CHECK(program->task.key == 0x40000052);
    CHECK(program->task.question_end[1] == 0);
    CHECK(program->task.question_end[2] == 1);
    CHECK(program->task.question_end[7] == 3);
    CHECK(program->questions[0] == 0.5);
    CHECK(program->questions[1] == -2.0);
    CHECK(program->questions[2] == 1e300);
}

TEST_CASE("At least one frame is drawn") {
    RecordingMemory memory;
    ProgramTask task;
    for (const int frames : {0, -3}) {
        task.frames = frames;
        memory.write(task, {});
        CHECK(ProgramsView(memory)->task.frames == 1);
    }
}

TEST_CASE("What a program has written is read, and no more") {
    RecordingMemory memory;
    memory.write({}, {});
    const ProgramsView program(memory);
    draw_frame(program, 3, 2);
    program->picture[3 * 5 + 0] = 0.25f;
    program->picture[3 * 5 + 1] = 1.5f;
    program->picture[3 * 5 + 2] = -1.0f;
    program->progress.answers = 2;
    program->answers[0] = 1.0;
    program->answers[1] = -1.0;
    program->answers[2] = 99.0;

    const Recording recording = memory.read();
    CHECK(recording.window.width == 3);
    CHECK(recording.window.height == 2);
    REQUIRE(recording.picture.size() == 6);
    CHECK(recording.picture[0] == glm::vec3(0.0f));
    CHECK(recording.picture[5] == glm::vec3(0.25f, 1.5f, -1.0f));
    REQUIRE(recording.puts.size() == 1);
    CHECK(recording.puts[0].x == 2);
    CHECK(recording.puts[0].blue == 0.75f);
    CHECK(recording.answers == std::vector<double>{1.0, -1.0});
}

TEST_CASE("A window without a frame or a pixel has no picture") {
    RecordingMemory memory;
    memory.write({}, {});
    const ProgramsView program(memory);
    program->progress.width = 40;
    program->progress.height = 30;
    CHECK(memory.read().window.width == 40);
    CHECK_FALSE(memory.read().has_picture());
    program->progress.puts = 1;
    CHECK(memory.read().has_picture());
}

TEST_CASE("A window of a size that cannot be has no picture") {
    struct Size {
        std::int32_t width, height;
    };
    constexpr std::int32_t largest = std::numeric_limits<std::int32_t>::max();
    constexpr std::int32_t smallest = std::numeric_limits<std::int32_t>::min();
    RecordingMemory memory;
    memory.write({}, {});
    const ProgramsView program(memory);
    for (const Size size : {Size{-1, 10}, Size{10, -1}, Size{0, 10}, Size{10, 0}, Size{-5, -5},
                            Size{largest, largest}, Size{largest, 1}, Size{smallest, smallest},
                            Size{65536, 65536}, Size{2049, 2048}, Size{smallest, 1}}) {
        CAPTURE(size.width, size.height);
        draw_frame(program, size.width, size.height);
        const Recording recording = memory.read();
        CHECK(recording.window.width == 0);
        CHECK(recording.window.height == 0);
        CHECK_FALSE(recording.has_picture());
    }
    draw_frame(program, 2048, 2048);
    CHECK(memory.read().picture.size() == rasterwalk_kit::most_pixels);
}

TEST_CASE("Counts beyond the room are cut off to it") {
    RecordingMemory memory;
    memory.write({}, {});
    const ProgramsView program(memory);
    draw_frame(program, 3, 2);
    for (const std::uint64_t count : {std::uint64_t{rasterwalk_kit::most_puts} + 1,
                                      std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
        CAPTURE(count);
        program->progress.puts = count;
        CHECK(memory.read().puts.size() == rasterwalk_kit::most_puts);
        program->progress.puts = 1;
        program->progress.answers = count;
        CHECK(memory.read().answers.size() == rasterwalk_kit::most_answers);
        program->progress.answers = 0;
    }
    program->progress.depth = 0xffffffff;
    CHECK(memory.read().progress.depth == rasterwalk_kit::most_frames_deep);
}

TEST_CASE("A program cannot change the size of the memory") {
    const RecordingMemory memory;
    const int file = memory.descriptor();
    for (const off_t size : {off_t{0}, off_t{4096}, static_cast<off_t>(sizeof(Recorded)) + 4096}) {
        CAPTURE(size);
        errno = 0;
        CHECK(::ftruncate(file, size) == -1);
        CHECK(errno == EPERM);
    }
    struct stat state {};
    REQUIRE(::fstat(file, &state) == 0);
    CHECK(state.st_size == static_cast<off_t>(sizeof(Recorded)));
}

TEST_CASE("The next program finds nothing of the one before") {
    RecordingMemory memory;
    memory.write({}, {});
    const ProgramsView program(memory);
    draw_frame(program, 3, 2);
    program->picture[0] = 1.0f;
    program->progress.answers = 1;
    program->answers[0] = 42.0;
    memory.write({}, {});
    CHECK(program->answers[0] == 0.0);
    CHECK(program->picture[0] == 0.0f);
    CHECK(program->puts[0].x == 0);
    const Recording recording = memory.read();
    CHECK(recording.window.width == 0);
    CHECK(recording.puts.empty());
    CHECK(recording.answers.empty());
    CHECK_FALSE(recording.has_picture());
}
