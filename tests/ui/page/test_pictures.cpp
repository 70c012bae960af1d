#include "ui/widgets/pictures.h"

#include <cstdlib>
#include <filesystem>

#include "tests/support/catch.h"
#include "tests/support/hostile_lessons.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "ui/actions/view_files.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// A picture whose pixels say where they are.
Image numbered(int width, int height) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const int value : {x, y, x + y, 255})
                image.rgba.push_back(static_cast<std::uint8_t>(value));
        }
    }
    return image;
}

int channel(const Image& image, int x, int y, int c) {
    return image.rgba[static_cast<std::size_t>(4 * (y * image.width + x) + c)];
}

/// A separate folder of lessons, as long as it lives.
class OwnLessons {
  public:
    OwnLessons() {
        std::filesystem::create_directories(folder_.file("lessons/images"));
        std::filesystem::create_directory(folder_.file("screenshots"));
        folder_.write("lessons/presets.toml", "");
        ::setenv("RASTERWALK_LESSONS", folder_.file("lessons").c_str(), 1);
    }
    OwnLessons(const OwnLessons&) = delete;
    OwnLessons& operator=(const OwnLessons&) = delete;
    ~OwnLessons() { ::unsetenv("RASTERWALK_LESSONS"); }

    std::string file(const std::string& name) const { return folder_.file(name); }
    void write(const std::string& name, const std::string& bytes) const {
        folder_.write(name, bytes);
    }

  private:
    test::TemporaryFolder folder_;
};

bool is_shown(const std::string& target) {
    ImageCache cache;
    return picture_size(cache, {"", target}).x > 0.0f;
}

} // namespace

TEST_CASE("A smaller picture has the averages of the larger one") {
    const Image image = numbered(8, 4);
    const Image half = shrink(image, 4);
    REQUIRE(half.width == 4);
    REQUIRE(half.height == 2);
    CHECK(channel(half, 0, 0, 0) == 1); // (0 + 1) / 2, rounded
    CHECK(channel(half, 3, 1, 0) == 7);
    CHECK(channel(half, 3, 1, 1) == 3);
    CHECK(channel(half, 1, 1, 3) == 255);
    const Image dot = shrink(image, 1);
    CHECK(dot.width == 1);
    CHECK(dot.height == 1);
    CHECK(channel(dot, 0, 0, 0) == 4); // 3.5
    CHECK(shrink(image, 8) == image);
    CHECK(shrink(image, 100) == image);
    CHECK(shrink(image, 0) == image);
    CHECK(shrink(numbered(100, 1), 7).height == 1);
}

TEST_CASE("One colour stays that colour at every size") {
    Image image{97, 61, {}};
    for (int i = 0; i < 97 * 61; ++i) {
        for (const int value : {10, 200, 255, 128})
            image.rgba.push_back(static_cast<std::uint8_t>(value));
    }
    for (int width = 1; width < 97; width += 5) {
        const Image small = shrink(image, width);
        REQUIRE(small.rgba.size() == static_cast<std::size_t>(4 * small.width * small.height));
        for (int c = 0; c < 4; ++c) {
            REQUIRE(channel(small, 0, 0, c) == channel(image, 0, 0, c));
            REQUIRE(channel(small, small.width - 1, small.height - 1, c) ==
                    channel(image, 0, 0, c));
        }
    }
}

TEST_CASE("Pictures are found in the lessons' folder and next to it in screenshots") {
    const OwnLessons lessons;
    write_png(numbered(20, 10), lessons.file("lessons/images/a.png"));
    write_png(numbered(30, 10), lessons.file("screenshots/b.png"));
    ImageCache cache;
    CHECK(picture_size(cache, {"", "images/a.png"}).x == 20.0f);
    CHECK(picture_size(cache, {"", "../screenshots/b.png"}).x == 30.0f);
    CHECK(cache.pictures.size() == 2);
    // It is read once.
    std::filesystem::remove(lessons.file("lessons/images/a.png"));
    CHECK(picture_size(cache, {"", "images/a.png"}).y == 10.0f);
}

TEST_CASE("A picture that is broken, too large or outside is not shown") {
    const OwnLessons lessons;
    write_png(numbered(20, 10), lessons.file("outside.png"));
    write_png(numbered(20, 10), lessons.file("lessons/images/good.png"));
    const std::string good = test::bytes_of(lessons.file("lessons/images/good.png"));
    REQUIRE(is_shown("images/good.png"));
    lessons.write("lessons/images/cut.png", good.substr(0, good.size() / 2));
    lessons.write("lessons/images/text.png", "not a picture");
    lessons.write("lessons/images/empty.png", "");
    lessons.write("lessons/images/endless.png", test::endless_picture());
    write_png({5'000, 1, std::vector<std::uint8_t>(20'000, 255)},
              lessons.file("lessons/images/wide.png"));
    std::filesystem::create_symlink(lessons.file("outside.png"),
                                    lessons.file("lessons/images/link.png"));
    std::filesystem::create_directory(lessons.file("lessons/images/folder.png"));
    for (const char* target :
         {"images/cut.png", "images/text.png", "images/empty.png", "images/endless.png",
          "images/wide.png", "images/link.png", "images/folder.png", "images/none.png", "",
          "../outside.png", "../lessons/../outside.png", "../screenshots/../outside.png",
          "http://example.org/a.png", "file:///a.png", "images\\good.png", "images"}) {
        INFO(target);
        CHECK_FALSE(is_shown(target));
    }
    CHECK_FALSE(is_shown(lessons.file("outside.png")));
    CHECK_FALSE(is_shown(lessons.file("lessons/images/good.png"))); // absolute
    // Bits that are changed one by one.
    ImageCache cache;
    for (std::size_t i = 8; i < good.size(); ++i) {
        std::string bytes = good;
        bytes[i] = static_cast<char>(bytes[i] ^ 0x55);
        lessons.write("lessons/images/changed.png", bytes);
        cache.pictures.clear();
        const ImVec2 size = picture_size(cache, {"", "images/changed.png"});
        REQUIRE(size.x <= 4096.0f);
        REQUIRE(size.y <= 4096.0f);
    }
}

TEST_CASE("No more pictures are kept than there is room for") {
    const OwnLessons lessons;
    ImageCache cache;
    for (int i = 0; i < 200; ++i)
        picture_size(cache, {"", "images/" + std::to_string(i) + ".png"});
    CHECK(cache.pictures.size() == most_pictures);
}

TEST_CASE("A lesson of one's own shows the pictures next to it") {
    const test::TemporaryFolder folder;
    std::filesystem::create_directory(folder.file("images"));
    write_png(numbered(33, 10), folder.file("images/own.png"));
    const std::string lesson = folder.write("01-own.md", "<!-- lesson\n"
                                                         "title = \"Own\"\n"
                                                         "section = \"Drawing points\"\n"
                                                         "minutes = 5\n"
                                                         "about = \"A test.\"\n"
                                                         "program = \"nothing\"\n"
                                                         "scene = \"scenes/lab-room.toml\"\n"
                                                         "-->\n"
                                                         "# Own\n\n"
                                                         "![Mine](images/own.png)\n");
    Driver driver;
    open_file(driver.ui, lesson);
    driver.hand.rest();
    REQUIRE(driver.ui.pictures);
    const PictureName name{driver.ui.session.lesson_folder, "images/own.png"};
    REQUIRE(driver.ui.pictures->pictures.count(name) == 1);
    CHECK(driver.ui.pictures->pictures[name].size.x == 33.0f);
    CHECK(driver.ui.pictures->pictures[name].texture != ImTextureID{});
}

TEST_CASE("A picture is drawn as wide as the page, and remade only when that changes") {
    Driver driver;
    Ui& ui = driver.ui;
    ui.pictures = std::make_shared<ImageCache>();
    ShownPicture& picture = ui.pictures->pictures[{"", "images/a.png"}];
    picture.image = numbered(200, 100);
    picture.size = {200, 100};
    const int before = driver.textures.uploads;
    const ImTextureID texture = picture_texture(ui, {"", "images/a.png"}, 50);
    CHECK(texture != ImTextureID{});
    CHECK(driver.textures.last.width == 50);
    CHECK(driver.textures.last.height == 25);
    CHECK(picture_texture(ui, {"", "images/a.png"}, 50) == texture);
    CHECK(driver.textures.uploads == before + 1);
    CHECK(picture_texture(ui, {"", "images/a.png"}, 80) == texture);
    CHECK(driver.textures.uploads == before + 2);
    CHECK(picture_texture(ui, {"", "images/none.png"}, 80) == ImTextureID{});
}

} // namespace rasterwalk
