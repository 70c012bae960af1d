// What the window keeps until the next start.

#include <filesystem>
#include <string>

#include "base/error.h"
#include "base/files.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "ui/actions/open_lesson.h"
#include "ui/app/app.h"
#include "ui/app/kept_options.h"
#include "ui/start/start_choice.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

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
                          Catch::Matchers::StartsWith(one.sentence));
    }
}

TEST_CASE("A change made in one run is there in the next") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("state/window.toml");
    {
        Driver driver;
        keep_options(driver.ui, path);
        driver.open("lab");
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
    driver.open("lab");
    driver.hand.click("lab.mode.quiz");
    CHECK(driver.hand.find("lab.points").visible);
    driver.hand.click("lab.reset_score");
    CHECK(driver.ui.options.score.points == 0);
}

TEST_CASE("A broken file of options is left as it is, and reported") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("window.toml");
    write_file(path, "text_scale = 1.5\ntheme = \"pink\"\n");
    Driver driver;
    keep_options(driver.ui, path);
    CHECK_THAT(driver.ui.session.notice, Catch::Matchers::ContainsSubstring("window.toml:2"));
    driver.ui.options.theme = Theme::light;
    driver.hand.frames(3);
    CHECK(read_file(path) == "text_scale = 1.5\ntheme = \"pink\"\n");
}

TEST_CASE("Two windows each keep what they changed") {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("window.toml");
    Driver driver;
    Ui& a = driver.ui;
    Ui b; // another window's; nothing of it is drawn
    a.options.score = b.options.score = {.rounds = 2, .points = 100, .is_kept = true};
    keep_options(a, path);
    keep_options(b, path);
    a.options.theme = Theme::light;
    a.options.score.rounds += 1;
    a.options.score.points += 70;
    save_options(a);
    b.options.lesson_width = 0.25f;
    b.options.score.rounds += 1;
    b.options.score.points += 30;
    save_options(b);
    const UiOptions kept = parse_options(read_file(path), path, {});
    CHECK(kept.theme == Theme::light);
    CHECK(kept.lesson_width == 0.25f);
    CHECK(kept.score == QuizScore{.rounds = 4, .points = 200, .is_kept = true});
    CHECK(b.options.theme == Theme::dark); // its look is its own
    b.options.score = {.rounds = 0, .points = 0, .is_kept = true};
    save_options(b);
    CHECK(parse_options(read_file(path), path, {}).score.points == 0);
}

TEST_CASE("After a moment in which nothing can be written, options and progress are kept again") {
    const test::TemporaryFolder folder;
    const std::string place = folder.write("state", "a file where a folder should be");
    Driver driver;
    keep_options(driver.ui, place + "/window.toml");
    keep_progress(driver.ui, place + "/progress.toml");
    driver.ui.options.theme = Theme::light;
    driver.ui.lesson.progress.record_step("01-pinhole-camera", 2);
    driver.hand.frames(2);
    CHECK_THAT(
        driver.ui.session.notice,
        Catch::Matchers::StartsWith("Progress and the look of the window will not be kept until"));
    driver.ui.session.notice.clear();
    driver.hand.frames(20, 1.0f);
    CHECK(driver.ui.session.notice.empty()); // it is reported once
    std::filesystem::remove(place);
    driver.hand.frames(10, 1.0f);
    CHECK_THAT(driver.ui.session.notice, Catch::Matchers::ContainsSubstring("kept again"));
    CHECK(parse_options(read_file(place + "/window.toml"), "", {}).theme == Theme::light);
    CHECK(read_progress(place + "/progress.toml").was_step_shown("01-pinhole-camera", 2));
}

TEST_CASE("Where nothing can be written, the first lesson says that progress is not kept") {
    const test::TemporaryFolder folder;
    const std::string place = folder.write("state", "");
    Driver driver;
    keep_options(driver.ui, place + "/window.toml");
    keep_progress(driver.ui, place + "/progress.toml");
    begin_at_start(driver.ui);
    driver.hand.rest();
    driver.hand.press(key::equal, {.ctrl = true});
    driver.hand.rest();
    driver.hand.click("start.lessons");
    driver.hand.rest();
    CHECK_THAT(driver.ui.session.notice, Catch::Matchers::StartsWith("Progress"));
}

TEST_CASE("At the end saving is tried once more, without waiting") {
    const test::TemporaryFolder folder;
    const std::string place = folder.write("state", "");
    Driver driver;
    keep_progress(driver.ui, place + "/progress.toml");
    driver.ui.lesson.progress.record_step("01-pinhole-camera", 2);
    driver.hand.frames(2);
    std::filesystem::remove(place);
    keep_everything(driver.ui);
    CHECK(read_progress(place + "/progress.toml").was_step_shown("01-pinhole-camera", 2));
}

TEST_CASE("Files that nest too deeply do not keep the window from opening, and stay unchanged") {
    const test::TemporaryFolder folder;
    std::string deep;
    for (int i = 0; i < 30'000; ++i)
        deep += "a.";
    deep += "a = 1\n";
    const std::string options = folder.write("window.toml", deep);
    const std::string progress = folder.write("progress.toml", deep);
    Driver driver;
    keep_options(driver.ui, options);
    CHECK_THAT(driver.ui.session.notice,
               Catch::Matchers::ContainsSubstring(options + ":1: this is nested too deeply"));
    keep_progress(driver.ui, progress);
    CHECK_THAT(driver.ui.session.notice,
               Catch::Matchers::ContainsSubstring(progress + ":1: this is nested too deeply"));
    driver.ui.options.theme = Theme::light;
    driver.ui.lesson.progress.record_step("01-pinhole-camera", 2);
    driver.hand.frames(10, 1.0f);
    CHECK(read_file(options) == deep);
    CHECK(read_file(progress) == deep);
}

} // namespace rasterwalk
