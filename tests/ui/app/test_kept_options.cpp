// What of the window is found again the next time.

#include <string>

#include <catch2/catch.hpp>

#include "base/error.h"
#include "base/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "ui/app/kept_options.h"

namespace rasterwalk {

TEST_CASE("Theme, text size, columns and score are written and read back") {
    UiOptions options;
    options.theme = Theme::light;
    options.wished_text_scale = 1.25f;
    options.lesson_width = 0.25f;
    options.inspector_width = 0.375f;
    options.score = {.rounds = 3, .points = 240, .is_kept = true};
    const UiOptions back = parse_options(options_text(options), "window.toml", {});
    CHECK(back.theme == Theme::light);
    CHECK(back.wished_text_scale == 1.25f);
    CHECK(back.lesson_width == 0.25f);
    CHECK(back.inspector_width == 0.375f);
    CHECK(back.score.rounds == 3);
    CHECK(back.score.points == 240);
    CHECK(back.score.is_kept);
}

TEST_CASE("A score that is not to be kept is not written") {
    UiOptions options;
    options.score = {.rounds = 3, .points = 240, .is_kept = false};
    CHECK(options_text(options).find("quiz") == std::string::npos);
    CHECK_FALSE(parse_options(options_text(options), "window.toml", {}).score.is_kept);
}

TEST_CASE("A broken file of options is named with its line, and nothing is taken from it") {
    const struct {
        const char* text;
        const char* sentence;
    } cases[] = {
        {"theme = \"dark\"\ntext_scale = 99\n", "window.toml:2"},
        {"theme = \"pink\"\n", "window.toml:1"},
        {"colour = 1\n", "window.toml:1"},
        {"lesson_width = nan\n", "window.toml:1"},
        {"quiz_rounds = -1\n", "window.toml:1"},
        {"quiz_points = 1e99\n", "window.toml:1"},
        {"theme = \n", "window.toml:1"},
    };
    for (const auto& one : cases) {
        INFO(one.text);
        CHECK_THROWS_WITH(parse_options(one.text, "window.toml", {}),
                          Catch::StartsWith(one.sentence));
    }
}

TEST_CASE("What is changed in one run is there in the next") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("state/window.toml");
    {
        Driver driver;
        keep_options(driver.ui, path);
        driver.hand.click("tab.lab");
        driver.hand.click("lab.mode.quiz");
        driver.hand.click("lab.keep_score");
        driver.ui.options.score.points = 70;
        driver.ui.options.score.rounds = 1;
        driver.hand.frames(2);
    }
    Driver driver;
    keep_options(driver.ui, path);
    CHECK(driver.ui.options.score.is_kept);
    CHECK(driver.ui.options.score.points == 70);
    driver.hand.click("tab.lab");
    driver.hand.click("lab.mode.quiz");
    CHECK(driver.hand.find("lab.points").visible);
    driver.hand.click("lab.reset_score");
    CHECK(driver.ui.options.score.points == 0);
}

TEST_CASE("A broken file of options is left as it is, and said to be so") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("window.toml");
    write_file(path, "text_scale = 1.5\ntheme = \"pink\"\n");
    Driver driver;
    keep_options(driver.ui, path);
    CHECK_THAT(driver.ui.session.notice, Catch::Contains("window.toml:2"));
    driver.ui.options.theme = Theme::light;
    driver.hand.frames(3);
    CHECK(read_file(path) == "text_scale = 1.5\ntheme = \"pink\"\n");
}

} // namespace rasterwalk
