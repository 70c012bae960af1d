#include "base/files.h"

#include <chrono>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

namespace {

unsigned mode_of(const std::string& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 ? status.st_mode & 07777u : 0;
}

/// A pipe into which a thread writes in pieces, with pauses longer than a reader needs to come
/// back.
class SlowPipe {
  public:
    explicit SlowPipe(const std::string& piece, int count) {
        if (::pipe(ends_) != 0) std::abort();
        writer_ = std::thread([this, piece, count] {
            for (int i = 0; i < count; ++i) {
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
                if (::write(ends_[1], piece.data(), piece.size()) < 0) break;
            }
            ::close(ends_[1]);
        });
    }
    SlowPipe(const SlowPipe&) = delete;
    SlowPipe& operator=(const SlowPipe&) = delete;
    ~SlowPipe() {
        writer_.join();
        ::close(ends_[0]);
    }
    int read_end() const { return ends_[0]; }
    std::string path() const { return "/dev/fd/" + std::to_string(ends_[0]); }

  private:
    int ends_[2]{};
    std::thread writer_;
};

/// The number of a process that has ended.
pid_t ended_process() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    return child;
}

} // namespace

TEST_CASE("A file that was written is read back, byte for byte") {
    const test::TemporaryFolder folder;
    const std::string bytes("a\0b\r\n\xff", 6);
    write_file(folder.file("x"), bytes);
    CHECK(read_file(folder.file("x")) == bytes);
    write_file(folder.file("x"), "shorter");
    CHECK(read_file(folder.file("x")) == "shorter");
}

TEST_CASE("Writing leaves no temporary file behind, whether it succeeds or not") {
    const test::TemporaryFolder folder;
    write_file(folder.file("x"), "1");
    CHECK(folder.file_count() == 1);
    CHECK_THROWS_AS(write_file(folder.file("no/folder/x"), "1"), AccessError);
    CHECK_THROWS_AS(write_file(folder.file(""), "1"), AccessError);
    CHECK(folder.file_count() == 1);
}

TEST_CASE("A link is followed: the file it points to is replaced, not the link") {
    const test::TemporaryFolder folder;
    folder.write("real", "old");
    std::filesystem::create_symlink(folder.file("real"), folder.file("link"));
    write_file(folder.file("link"), "new");
    CHECK(std::filesystem::is_symlink(folder.file("link")));
    CHECK(test::bytes_of(folder.file("real")) == "new");
}

TEST_CASE("A device is written to and stays a device") {
    write_file("/dev/null", "gone");
    CHECK(std::filesystem::is_character_file("/dev/null"));
    CHECK_THROWS_WITH(write_file("/dev/full", "x"),
                      "cannot write '/dev/full': No space left on device.");
}

TEST_CASE("A file larger than the limit is refused as bad input") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("big", std::string(3 << 20, 'x'));
    CHECK_THROWS_WITH(read_file(path, 2 << 20), path + ": the file is larger than 2 MB.");
    CHECK(read_file(path, 3 << 20).size() == 3 << 20);
    CHECK_THROWS_AS(read_file("/dev/zero", 1 << 20), InputError);
}

TEST_CASE("A folder is not read as a file") {
    const test::TemporaryFolder folder;
    CHECK_THROWS_WITH(read_file(folder.file("")),
                      "cannot read '" + folder.file("") + "': Is a directory.");
}

TEST_CASE("All of a pipe is read, however slowly it is written") {
    const SlowPipe pipe("a row\n", 5);
    CHECK(read_file(pipe.path()) == "a row\na row\na row\na row\na row\n");
}

TEST_CASE("Reading a pipe stops if its writer stays silent") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("pipe");
    REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
    const int writer = ::open(path.c_str(), O_RDWR);
    REQUIRE(writer >= 0);
    const std::chrono::milliseconds silence(5);
    CHECK_THROWS_WITH(read_file(path, largest_text_file, silence),
                      "cannot read '" + path + "': nothing is being written into this pipe.");
    // The text so far is not complete.
    REQUIRE(::write(writer, "half", 4) == 4);
    CHECK_THROWS_AS(read_file(path, largest_text_file, silence), AccessError);
    ::close(writer);
}

TEST_CASE("'-' is the standard input for a command") {
    const SlowPipe pipe("piece ", 3);
    const int kept = ::dup(STDIN_FILENO);
    REQUIRE(::dup2(pipe.read_end(), STDIN_FILENO) == STDIN_FILENO);
    const std::string bytes = read_input("-");
    ::dup2(kept, STDIN_FILENO);
    ::close(kept);
    CHECK(bytes == "piece piece piece ");
    const test::TemporaryFolder folder;
    CHECK(read_input(folder.write("x", "file")) == "file");
}

TEST_CASE("A window does not wait for pipes and devices") {
    const test::TemporaryFolder folder;
    REQUIRE(::mkfifo(folder.file("pipe").c_str(), 0600) == 0);
    CHECK_THROWS_AS(refuse_endless_file(folder.file("pipe")), AccessError);
    CHECK_THROWS_AS(refuse_endless_file("/dev/zero"), AccessError);
    CHECK_NOTHROW(refuse_endless_file(folder.write("x", "file")));
    CHECK_NOTHROW(refuse_endless_file(folder.file("")));
    CHECK_NOTHROW(refuse_endless_file(folder.file("not there")));
}

TEST_CASE("A file that is overwritten keeps its mode") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("x", "old");
    for (const unsigned mode : {0600u, 0640u, 0755u, 0666u}) {
        REQUIRE(::chmod(path.c_str(), mode) == 0);
        write_file(path, "new");
        CHECK(mode_of(path) == mode);
    }
}

TEST_CASE("A link to a file that does not exist yet is followed") {
    const test::TemporaryFolder folder;
    std::filesystem::create_symlink("second", folder.file("first"));
    std::filesystem::create_symlink("real", folder.file("second"));
    write_file(folder.file("first"), "new");
    CHECK(std::filesystem::is_symlink(folder.file("first")));
    CHECK(std::filesystem::is_symlink(folder.file("second")));
    CHECK(test::bytes_of(folder.file("real")) == "new");
    // Links that lead round in a circle end nowhere.
    std::filesystem::create_symlink("round", folder.file("round"));
    CHECK_THROWS_AS(write_file(folder.file("round"), "x"), AccessError);
}

TEST_CASE("A file with two names stays one file when written") {
    const test::TemporaryFolder folder;
    const std::string path = folder.write("one", "a longer text");
    std::filesystem::create_hard_link(path, folder.file("other"));
    for (const std::string& text :
         {std::string("short"), std::string(100'000, 'x'), std::string()}) {
        write_file(path, text);
        CHECK(test::bytes_of(folder.file("other")) == text);
    }
    CHECK(folder.file_count() == 2);
}

TEST_CASE("Half-written files of killed processes are removed, and nothing else") {
    const test::TemporaryFolder folder;
    const std::string mine = ".part" + std::to_string(ended_process());
    const std::vector<std::string> others{
        folder.write("x.part" + std::to_string(::getppid()), "another is writing"),
        folder.write("y" + mine, "of another file"), folder.write("x.part", "no number"),
        folder.write("x" + mine + "a", "a name of its own")};
    folder.write("x" + mine, "half");
    write_file(folder.file("x"), "whole");
    CHECK_FALSE(std::filesystem::exists(folder.file("x" + mine)));
    for (const std::string& other : others)
        CHECK(std::filesystem::exists(other));
}

TEST_CASE("A file has only one lock at a time") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("x");
    {
        const FileLock lock(path);
        CHECK_THROWS_AS(FileLock(path), AccessError);
    }
    CHECK_NOTHROW(FileLock(path));
    CHECK_NOTHROW(FileLock("/proc/nowhere/x")); // writing will report it
}
