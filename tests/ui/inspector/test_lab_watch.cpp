#include <filesystem>

#include "support/effort.h"
#include "tests/support/catch.h"
#include "tests/support/handout_rows.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/diagnosed.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/lab.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// The bytes of a picture that these settings draw.
std::string png_of(const Image& picture) {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("picture.png");
    write_png(picture, path);
    return test::bytes_of(path);
}

/// Replaces a file with these bytes, as a program does when it saves again.
void save_again(Driver& driver, const test::TemporaryFolder& folder, const std::string& name,
                const std::string& bytes) {
    std::filesystem::remove(folder.file(name));
    folder.write(name, bytes);
    driver.hand.frames(1);
}

} // namespace

TEST_CASE("A picture that is saved again is checked again, and the answer stays until then") {
    const test::TemporaryFolder folder;
    Driver driver;
    Settings reference = pixel_light(driver, small_side);
    reference.camera.yaw = 0.1f;
    driver.ui.session.a.settings = reference;
    Settings wrong = reference;
    wrong.spans = Spans::last_dropped;
    const std::string mine = png_of(drawn_by(driver, wrong));
    const std::string path = folder.write("mine.png", mine);
    diagnose_file(driver.ui, path);
    finish_check(driver);
    compare_result_with(driver.ui, true);
    driver.hand.frames(3);
    CHECK(driver.hand.is_visible("lab.diagnosis")); // that of the other reference
    finish_check(driver);
    REQUIRE(driver.ui.lab.answer);
    CHECK(shown_text(driver, "lab.candidate.0") == "B9");
    const std::string before = shown_text(driver, "lab.diagnosis");
    // The same once more is no news.
    save_again(driver, folder, "mine.png", mine);
    CHECK_FALSE(is_diagnosing(driver.ui));
    // With the mistake shown, the file is still compared with what was set.
    driver.hand.click("lab.show.0");
    driver.hand.rest();
    const float top = driver.ui.widgets.at("lab.diagnosis").top_left.y;
    Settings other = reference;
    other.interpolation = Interpolation::affine;
    save_again(driver, folder, "mine.png", png_of(drawn_by(driver, other)));
    REQUIRE(is_diagnosing(driver.ui));
    CHECK_THAT(driver.ui.widgets.at("lab.watch").text,
               Catch::Matchers::StartsWith("Your file has changed: checking"));
    CHECK(driver.ui.widgets.at("lab.diagnosis").text == before);
    CHECK(driver.ui.widgets.at("lab.diagnosis").top_left.y == top);
    finish_check(driver);
    CHECK(shown_text(driver, "lab.candidate.0") == "B3");
    save_again(driver, folder, "mine.png", png_of(drawn_by(driver, reference)));
    finish_check(driver);
    CHECK(driver.ui.lab.answer->diagnosis.is_same());
    CHECK(shown_text(driver, "lab.diagnosis") ==
          "Your picture matches the reference, pixel for pixel.");
    // If it is given up, the check leaves the answer, and says when that answer is from.
    save_again(driver, folder, "mine.png", mine);
    REQUIRE(is_diagnosing(driver.ui));
    give_up_diagnosis(driver.ui);
    driver.hand.frames(2);
    CHECK(driver.ui.lab.answer->diagnosis.is_same());
    CHECK_THAT(shown_text(driver, "lab.watch"),
               Catch::Matchers::StartsWith("The check was stopped"));
}

TEST_CASE("A file is not looked at while its answer is not on screen") {
    const test::TemporaryFolder folder;
    Driver driver;
    const std::string path = folder.write("rows.txt", std::string(test::handout_rows));
    diagnose_file(driver.ui, path);
    finish_check(driver);
    driver.open("settings");
    std::filesystem::remove(path);
    driver.hand.frames(2);
    CHECK(driver.ui.lab.result_fault == "");
    driver.open("lab");
    driver.hand.frames(2);
    CHECK_THAT(driver.ui.lab.result_fault, Catch::Matchers::ContainsSubstring("rows.txt"));
}

TEST_CASE("A file that is half written, or gone for a moment, leaves the answer as it is") {
    const test::TemporaryFolder folder;
    Driver driver;
    driver.ui.session.a.settings = pixel_light(driver, small_side);
    Settings wrong = pixel_light(driver, small_side);
    wrong.spans = Spans::last_dropped;
    const std::string mine = png_of(drawn_by(driver, wrong));
    const std::string path = folder.write("mine.png", mine);
    diagnose_file(driver.ui, path);
    finish_check(driver);
    REQUIRE(driver.ui.lab.answer);
    const std::string before = shown_text(driver, "lab.diagnosis");
    const float top = driver.hand.find("lab.diagnosis").top_left.y;
    const auto stays = [&] {
        driver.hand.frames(2);
        CHECK_FALSE(is_diagnosing(driver.ui));
        CHECK(shown_text(driver, "lab.diagnosis") == before);
        CHECK(driver.hand.find("lab.diagnosis").top_left.y == top);
        CHECK_THAT(shown_text(driver, "lab.watch"),
                   Catch::Matchers::ContainsSubstring("mine.png cannot be read now"));
    };
    for (const std::size_t part : {std::size_t{0}, std::size_t{20}, mine.size() / 2}) {
        INFO(part << " of " << mine.size() << " bytes");
        save_again(driver, folder, "mine.png", mine.substr(0, part));
        stays();
    }
    std::filesystem::remove(path);
    stays();
    // Whole again it is the one that was answered.
    folder.write("mine.png", mine);
    driver.hand.frames(2);
    CHECK_FALSE(is_diagnosing(driver.ui));
    CHECK(shown_text(driver, "lab.watch") == "mine.png: checked again whenever it changes");
    // What is being checked is not dropped either.
    save_again(driver, folder, "mine.png",
               png_of(drawn_by(driver, pixel_light(driver, small_side))));
    REQUIRE(is_diagnosing(driver.ui));
    std::filesystem::remove(path);
    finish_check(driver);
    CHECK(driver.ui.lab.answer->diagnosis.is_same());
}

TEST_CASE("Rows that are printed again are checked again, and row and end are named") {
    const test::TemporaryFolder folder;
    Driver driver;
    const auto with = [&](const std::string& was, const std::string& is) {
        std::string text(test::handout_rows);
        const std::size_t at = text.find(was);
        REQUIRE(at != text.npos);
        return text.replace(at, was.size(), is);
    };
    const std::string path = folder.write("rows.txt", with("Start: (6,9)", "Start: (7,9)"));
    diagnose_file(driver.ui, path);
    finish_check(driver);
    CHECK(shown_text(driver, "lab.difference") ==
          "1 row differs from the reference. The first is row 9: columns 6 to 12 in the "
          "reference, columns 7 to 12 in yours.");
    save_again(driver, folder, "rows.txt", with("End: (12,9)", "End: (10,9)"));
    driver.hand.frames(2);
    CHECK(shown_text(driver, "lab.difference") ==
          "1 row differs from the reference. The first is row 9: columns 6 to 12 in the "
          "reference, columns 6 to 10 in yours.");
    save_again(driver, folder, "rows.txt", std::string(test::handout_rows));
    driver.hand.frames(2);
    CHECK(driver.ui.lab.answer->diagnosis.is_same());
}

TEST_CASE("A search that is stopped in the middle shows what it found, and says so") {
    const test::TemporaryFolder folder;
    Driver driver;
    Settings wrong = pixel_light(driver, small_side);
    wrong.spans = Spans::last_dropped;
    const std::string path = folder.write("mine.png", png_of(drawn_by(driver, wrong)));
    for (const bool by_itself : {false, true}) {
        INFO((by_itself ? "by itself" : "by the button"));
        diagnose_file(driver.ui, path);
        driver.ui.lab.answer = std::nullopt;
        driver.hand.frames(4);
        REQUIRE(driver.ui.lab.check);
        REQUIRE_FALSE(driver.ui.lab.check->is_stopped);
        if (by_itself) {
            driver.ui.lab.check->seconds = longest_search;
            driver.hand.frames(1);
        } else {
            driver.hand.click("lab.stop");
        }
        CHECK((!driver.ui.lab.check || driver.ui.lab.check->is_stopped));
        finish_check(driver);
        REQUIRE(driver.ui.lab.answer);
        CHECK_FALSE(driver.ui.lab.answer->diagnosis.is_complete);
        CHECK(shown_text(driver, "lab.incomplete") ==
              "The search was stopped before everything was tried.");
    }
    diagnose_file(driver.ui, path);
    finish_check(driver);
    CHECK(driver.ui.lab.answer->diagnosis.is_complete);
    CHECK_FALSE(driver.hand.is_visible("lab.incomplete"));
}

TEST_CASE("While a file is checked again, the progress and Stop are seen whole") {
    for (const SmallWindow& window : test::some_of(all_windows(), 3)) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text_scale);
        const test::TemporaryFolder folder;
        Driver driver("lab-room.toml", window.size, window.text_scale);
        Settings wrong = pixel_light(driver, small_side);
        wrong.interpolation = Interpolation::affine;
        const std::string path = folder.write("mine.png", png_of(drawn_by(driver, wrong)));
        diagnose_file(driver.ui, path);
        finish_check(driver);
        const WidgetPlace before = driver.ui.widgets.at("lab.watch");
        CHECK(before.is_whole);
        wrong.spans = Spans::last_dropped;
        save_again(driver, folder, "mine.png", png_of(drawn_by(driver, wrong)));
        REQUIRE(is_diagnosing(driver.ui));
        const WidgetPlace line = driver.ui.widgets.at("lab.watch");
        const WidgetPlace stop = driver.ui.widgets.at("lab.stop");
        CHECK(line.is_whole);
        CHECK(stop.is_whole);
        CHECK(line.top_left.y == before.top_left.y);
        CHECK(line.bottom_right.x <= stop.top_left.x);
        CHECK_THAT(line.text, Catch::Matchers::ContainsSubstring("hecking"));
    }
}

} // namespace rasterwalk
