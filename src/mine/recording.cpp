#include "mine/recording.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include "base/error.h"

namespace rasterwalk {

namespace {

using rasterwalk_kit::Recorded;

#ifdef __linux__

/// A file without a name, of a size that cannot be changed: otherwise the program could cut it off,
/// and reading it here would end this program.
int make_sealed_file(std::size_t size) {
    const int file = ::memfd_create("rasterwalk-recording", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (file < 0) return -1;
    if (::ftruncate(file, static_cast<off_t>(size)) == 0 &&
        ::fcntl(file, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) == 0)
        return file;
    const int fault = errno;
    ::close(file);
    errno = fault;
    return -1;
}

#else

int make_sealed_file(std::size_t) {
    errno = ENOSYS;
    return -1;
}

#endif

/// The first `count` of them, but no more than there is room for.
template <class Value, std::size_t room>
std::vector<Value> first_of(const Value (&values)[room], std::uint64_t count) {
    const auto kept = static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(count, room));
    return {values, values + kept};
}

} // namespace

RecordingMemory::RecordingMemory() : descriptor_(make_sealed_file(sizeof(Recorded))) {
    void* memory = MAP_FAILED;
    if (descriptor_ >= 0)
        memory = ::mmap(nullptr, sizeof(Recorded), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_NORESERVE, descriptor_, 0);
    if (memory == MAP_FAILED) {
        const int fault = errno;
        if (descriptor_ >= 0) ::close(descriptor_);
        throw AccessError(fmt::format("there is no memory to watch your program with: {}.",
                                      std::strerror(fault)));
    }
    memory_ = static_cast<Recorded*>(memory);
}

RecordingMemory::~RecordingMemory() {
    ::munmap(memory_, sizeof(Recorded));
    ::close(descriptor_);
}

void RecordingMemory::write(const ProgramTask& task, const QuestionStream& questions) {
    // What an earlier program has written goes back to the system, and reads as zeros.
    ::madvise(memory_, sizeof(Recorded), MADV_REMOVE);
    memory_->progress = {};
    rasterwalk_kit::Task& written = memory_->task;
    written.magic = rasterwalk_kit::recording_magic;
    written.parts = task.parts;
    written.before_main = task.before_main ? 1 : 0;
    written.frames = static_cast<std::uint32_t>(std::max(task.frames, 1));
    written.key = task.key;
    std::copy(questions.ends.begin(), questions.ends.end(), written.question_end);
    std::copy(questions.numbers.begin(), questions.numbers.end(), memory_->questions);
}

Recording RecordingMemory::read() const {
    Recording recording;
    recording.progress = memory_->progress;
    rasterwalk_kit::Progress& progress = recording.progress;
    progress.depth = std::min<std::uint32_t>(progress.depth, rasterwalk_kit::most_frames_deep);
    recording.answers = first_of(memory_->answers, progress.answers);
    recording.puts = first_of(memory_->puts, progress.puts);
    const std::int64_t width = progress.width, height = progress.height;
    const auto most = static_cast<std::int64_t>(rasterwalk_kit::most_pixels);
    if (width <= 0 || height <= 0 || width > most || height > most || width * height > most)
        return recording;
    recording.window = {progress.width, progress.height};
    if (progress.frames == 0 && progress.puts == 0) return recording;
    recording.picture.resize(static_cast<std::size_t>(width * height));
    for (std::size_t i = 0; i < recording.picture.size(); ++i) {
        const float* const pixel = memory_->picture + 3 * i;
        recording.picture[i] = {pixel[0], pixel[1], pixel[2]};
    }
    return recording;
}

} // namespace rasterwalk
