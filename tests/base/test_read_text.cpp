#include "base/files.h"

#include <catch2/catch.hpp>

#include "base/error.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;

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

TEST_CASE("A folder is no file to be read") {
    const test::TemporaryFolder folder;
    CHECK_THROWS_WITH(read_file(folder.file("")),
                      "cannot read '" + folder.file("") + "': Is a directory.");
}
