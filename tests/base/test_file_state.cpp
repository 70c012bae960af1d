#include "base/files.h"

#include <chrono>
#include <filesystem>
#include <string>

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace rasterwalk {

TEST_CASE("The state of a file changes with its size and with its time, and only with these") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("mine.txt");
    CHECK(file_state(path) == FileState{});
    folder.write("mine.txt", "four");
    const FileState four = file_state(path);
    CHECK(four.size == 4);
    CHECK(file_state(path) == four);
    folder.write("mine.txt", "seven..");
    CHECK(file_state(path).size == 7);
    folder.write("mine.txt", "five");
    std::filesystem::last_write_time(path, four.written);
    CHECK(file_state(path) == four);
    std::filesystem::last_write_time(path, four.written + std::chrono::seconds(1));
    CHECK(file_state(path) != four);
    std::filesystem::remove(path);
    CHECK(file_state(path) == FileState{});
}

} // namespace rasterwalk
