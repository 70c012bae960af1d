#include "base/files.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

/// A file descriptor that is closed when it goes out of scope.
class OpenFile {
  public:
    OpenFile(const std::string& path, int flags) : descriptor_(::open(path.c_str(), flags, 0666)) {}
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    bool is_open() const { return descriptor_ >= 0; }
    int descriptor() const { return descriptor_; }
    /// True if closing went well; some file systems report a full disk only then.
    bool close() { return ::close(std::exchange(descriptor_, -1)) == 0; }

  private:
    int descriptor_;
};

[[noreturn]] void refuse(const std::string& doing, const std::string& path, int reason) {
    throw AccessError("cannot " + doing + " '" + path + "': " + std::strerror(reason) + ".");
}

bool write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

void write_directly(const std::string& path, std::string_view bytes) {
    OpenFile file(path, O_WRONLY | O_CLOEXEC);
    if (!file.is_open() || !write_all(file.descriptor(), bytes) || !file.close()) {
        refuse("write", path, errno);
    }
}

} // namespace

std::string read_file(const std::string& path, std::size_t limit) {
    // Not to wait for ever for someone to write into a pipe.
    const OpenFile file(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (!file.is_open()) refuse("read", path, errno);
    struct stat status {};
    if (::fstat(file.descriptor(), &status) == 0 && S_ISDIR(status.st_mode)) {
        refuse("read", path, EISDIR);
    }
    std::string bytes;
    std::string block(std::size_t{1} << 16, '\0');
    while (true) {
        const ssize_t count = ::read(file.descriptor(), block.data(), block.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) refuse("read", path, errno);
        if (count == 0) return bytes;
        if (bytes.size() + static_cast<std::size_t>(count) > limit) {
            throw InputError(path + ": the file is larger than " + std::to_string(limit >> 20) +
                             " MB.");
        }
        bytes.append(block, 0, static_cast<std::size_t>(count));
    }
}

void write_file(const std::string& path, std::string_view bytes) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    std::string target = path;
    if (fs::exists(status)) {
        if (fs::is_directory(status)) refuse("write", path, EISDIR);
        // Renaming would put a plain file in the place of /dev/null.
        if (!fs::is_regular_file(status)) return write_directly(path, bytes);
        if (::access(path.c_str(), W_OK) != 0) refuse("write", path, errno);
        const fs::path real = fs::canonical(path, ignored);
        if (!ignored) target = real.string();
    }
    const std::string temporary = target + ".part" + std::to_string(::getpid());
    OpenFile file(temporary, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC);
    if (!file.is_open()) refuse("write", path, errno);
    if (!write_all(file.descriptor(), bytes) || !file.close() ||
        ::rename(temporary.c_str(), target.c_str()) != 0) {
        const int reason = errno;
        ::unlink(temporary.c_str());
        refuse("write", path, reason);
    }
}

bool is_same_file(const std::string& a, const std::string& b) {
    std::error_code fault;
    return a == b || (std::filesystem::equivalent(a, b, fault) && !fault);
}

} // namespace rasterwalk
