#include "base/files.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

/// A file descriptor that is closed when it goes out of scope.
class OpenFile {
  public:
    OpenFile(const std::string& path, int flags, mode_t mode = 0666)
        : descriptor_(::open(path.c_str(), flags, mode)) {}
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
    throw AccessError(fmt::format("cannot {} '{}': {}.", doing, path, std::strerror(reason)));
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

/// The timeout for input that may take forever: as poll() wants it.
constexpr int however_long = -1;

/// Waits until there is something to be read, or the writer has ended; false: it took too long.
bool wait_for_input(int descriptor, int milliseconds) {
    pollfd wanted{descriptor, POLLIN, 0};
    return ::poll(&wanted, 1, milliseconds) != 0;
}

/// @param silence milliseconds, or `however_long`
std::string read_all(int descriptor, const std::string& name, std::size_t limit, int silence) {
    struct stat status {};
    if (::fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode)) refuse("read", name, EISDIR);
    std::string bytes;
    std::string block(std::size_t{1} << 16, '\0');
    while (true) {
        const ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0 && errno == EAGAIN) {
            if (wait_for_input(descriptor, silence)) continue;
            throw AccessError(fmt::format("cannot read '{}': nothing is being written into this "
                                          "pipe.",
                                          name));
        }
        if (count < 0) refuse("read", name, errno);
        if (count == 0) return bytes;
        if (bytes.size() + static_cast<std::size_t>(count) > limit) {
            const bool is_small = limit < std::size_t{1} << 20;
            throw InputError(fmt::format("{}: the file is larger than {} {}.", name,
                                         limit >> (is_small ? 10 : 20), is_small ? "kB" : "MB"));
        }
        bytes.append(block, 0, static_cast<std::size_t>(count));
    }
}

void write_directly(const std::string& path, std::string_view bytes) {
    OpenFile file(path, O_WRONLY | O_CLOEXEC);
    if (!file.is_open() || !write_all(file.descriptor(), bytes) || !file.close()) {
        refuse("write", path, errno);
    }
}

/// Renaming would leave the old bytes under the file's other names. Its space is allocated first,
/// so that a full disk leaves it unchanged.
void write_in_place(const std::string& path, std::string_view bytes) {
    OpenFile file(path, O_WRONLY | O_CLOEXEC);
    if (!file.is_open()) refuse("write", path, errno);
    const auto size = static_cast<off_t>(bytes.size());
    const int full = size > 0 ? ::posix_fallocate(file.descriptor(), 0, size) : 0;
    if (full != 0) refuse("write", path, full);
    if (!write_all(file.descriptor(), bytes) || ::ftruncate(file.descriptor(), size) != 0 ||
        !file.close()) {
        refuse("write", path, errno);
    }
}

/// Where a chain of links ends, whether something is there or not.
fs::path end_of_links(fs::path path) {
    constexpr int longest_chain = 40;
    std::error_code fault;
    for (int i = 0; i < longest_chain && fs::is_symlink(path, fault); ++i) {
        const fs::path next = fs::read_symlink(path, fault);
        if (fault) break;
        path = path.parent_path() / next; // or just `next`, if that is absolute
    }
    return path;
}

constexpr std::string_view temporary_ending = ".part";

/// The number of the process that made a temporary file for `name`; 0 if it is none.
pid_t creator_of(std::string_view file, std::string_view name) {
    if (!file.starts_with(name)) return 0;
    file.remove_prefix(name.size());
    if (!file.starts_with(temporary_ending)) return 0;
    file.remove_prefix(temporary_ending.size());
    pid_t creator = 0;
    const auto [end, fault] = std::from_chars(file.data(), file.data() + file.size(), creator);
    return fault == std::errc{} && end == file.data() + file.size() && creator > 0 ? creator : 0;
}

/// Removes the temporary files of processes that ended before they could.
void remove_leftovers(const fs::path& target) {
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const std::string name = target.filename().string();
    std::error_code fault;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        const pid_t creator = creator_of(entry->path().filename().string(), name);
        if (creator == 0 || ::kill(creator, 0) == 0 || errno != ESRCH) continue;
        std::error_code ignored;
        if (fs::is_regular_file(entry->symlink_status(ignored))) ::unlink(entry->path().c_str());
    }
}

/// Gives a file the mode of another, and its owner and group as far as allowed.
bool take_after(int descriptor, const struct stat& old) {
    if (::fchown(descriptor, old.st_uid, old.st_gid) != 0) {
        // Only root may give files away.
        if (::fchown(descriptor, static_cast<uid_t>(-1), old.st_gid) != 0) errno = 0;
    }
    return ::fchmod(descriptor, old.st_mode & 07777) == 0;
}

constexpr int most_tries = 50;
constexpr timespec pause_between_tries{0, 10'000'000}; // 10 ms

} // namespace

std::string read_file(const std::string& path, std::size_t limit,
                      std::chrono::milliseconds silence) {
    // Opening must not wait for another process to open the other end of a pipe.
    const OpenFile file(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (!file.is_open()) refuse("read", path, errno);
    return read_all(file.descriptor(), path, limit, static_cast<int>(silence.count()));
}

std::string read_input(const std::string& path, std::size_t limit) {
    if (path != "-") return read_file(path, limit);
    return read_all(STDIN_FILENO, standard_input_name, limit, however_long);
}

void refuse_endless_file(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (!fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status)) return;
    throw AccessError("cannot read '" + path + "': it is a pipe or a device.");
}

void write_file(const std::string& path, std::string_view bytes) {
    const std::string target = end_of_links(path).string();
    std::error_code ignored;
    if (fs::is_symlink(target, ignored)) refuse("write", path, ELOOP);
    struct stat old {};
    const bool is_there = ::stat(target.c_str(), &old) == 0;
    if (is_there) {
        if (S_ISDIR(old.st_mode)) refuse("write", path, EISDIR);
        // Renaming would replace /dev/null by a plain file.
        if (!S_ISREG(old.st_mode)) return write_directly(path, bytes);
        if (::access(target.c_str(), W_OK) != 0) refuse("write", path, errno);
        if (old.st_nlink > 1) return write_in_place(target, bytes);
    }
    remove_leftovers(target);
    const std::string temporary =
        target + std::string(temporary_ending) + std::to_string(::getpid());
    OpenFile file(temporary, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC,
                  is_there ? 0600 : 0666);
    if (!file.is_open()) refuse("write", path, errno);
    if (!write_all(file.descriptor(), bytes) || (is_there && !take_after(file.descriptor(), old)) ||
        !file.close() || ::rename(temporary.c_str(), target.c_str()) != 0) {
        const int reason = errno;
        ::unlink(temporary.c_str());
        refuse("write", path, reason);
    }
}

void make_folder_of(const std::string& path) {
    std::error_code fault;
    fs::create_directories(fs::path(path).parent_path(), fault);
    if (fault) refuse("write", path, fault.value());
}

bool is_same_file(const std::string& a, const std::string& b) {
    std::error_code fault;
    return a == b || (std::filesystem::equivalent(a, b, fault) && !fault);
}

FileState file_state(const std::string& path) {
    FileState state;
    std::error_code fault;
    const auto written = std::filesystem::last_write_time(path, fault);
    if (!fault) state.written = written;
    const std::uintmax_t size = std::filesystem::file_size(path, fault);
    if (!fault) state.size = size;
    return state;
}

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
