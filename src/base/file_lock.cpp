#include "base/file_lock.h"

#include <cerrno>
#include <ctime>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "base/error.h"

namespace rasterwalk {

namespace {

constexpr int most_tries = 50;
constexpr timespec pause_between_tries{0, 10'000'000}; // 10 ms

} // namespace

FileLock::FileLock(const std::string& path)
    : descriptor_(
          ::open((path + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600)) {
    if (descriptor_ < 0) return;
    for (int i = 0; i < most_tries; ++i) {
        if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
        if (errno != EWOULDBLOCK && errno != EINTR) return;
        ::nanosleep(&pause_between_tries, nullptr);
    }
    ::close(descriptor_);
    throw AccessError("cannot write '" + path + "': another program is writing to it.");
}

FileLock::~FileLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

} // namespace rasterwalk
