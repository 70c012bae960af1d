#include "ui/canvas/vector_marks.h"

#include <set>
#include <string>

#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "tests/ui/shown_colours.h"
#include "ui/actions/open_lesson.h"
#include "ui/canvas/vector_legend.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/vector_letters.h"

namespace rasterwalk {

namespace {

void show_vectors(Driver& driver, bool on = true) {
    driver.ui.session.overlays.set(Overlay::vectors, on);
    driver.hand.rest();
}

ImU32 letter_colour(const Driver& driver, VectorName name) {
    return packed(colour_of(vector_meaning(name), driver.ui.options.theme));
}

/// The colours to the left of the canvas: in the lesson.
std::set<ImU32> lesson_colours(Driver& driver) {
    const WidgetPlace canvas = driver.hand.find("canvas");
    WidgetPlace lesson;
    lesson.top_left = {0.0f, canvas.top_left.y};
    lesson.bottom_right = {canvas.top_left.x - 20.0f, canvas.bottom_right.y};
    return shown_colours(lesson);
}

std::string symbols(const Driver& driver) {
    std::string all;
    for (const VectorEntry& entry : vector_entries(driver.ui))
        all += entry.symbol + " ";
    return all;
}

} // namespace

TEST_CASE("The vectors have their letters in the picture, outside and in the legend") {
    for (const CanvasShows shows : {CanvasShows::picture, CanvasShows::both}) {
        Driver driver("cylinder.toml");
        driver.ui.session.canvas.shows = shows;
        driver.hand.click("stage.pixel_light");
        driver.ui.session.selection.pixel = {170, 120};
        CHECK(symbols(driver).empty());
        show_vectors(driver);
        REQUIRE(driver.ui.results.a.inspected.vectors);
        CHECK(symbols(driver) == "n l v h ");
        CHECK(vector_subject(driver.ui) == "at the picked pixel");
        for (const char letter : std::string("nlvh")) {
            CAPTURE(letter);
            int count = 0;
            for (const ScreenText& text : screen_text())
                count += text.window.starts_with("canvas") && text.words.front() == letter &&
                                 text.words.size() == 1
                             ? 1
                             : 0;
            // Its rim is the letter as well.
            CHECK(count >= (shows == CanvasShows::both ? 2 : 1));
        }
        CHECK(shows_words("to the lamp, length 1", "legend"));
        CHECK(shows_words("normal, length 1", "legend"));
    }
}

TEST_CASE("In a scene in pixels, the sides of the triangle shown are the vectors") {
    Driver driver("arrows.toml");
    driver.ui.session.selection.triangle = 0;
    driver.ui.session.selection.pixel = {8, 14};
    show_vectors(driver);
    CHECK(symbols(driver) == "u v ");
    CHECK(vector_subject(driver.ui) == "of triangles[0]");
    CHECK(shows_words("[0] to [1], 10.00 pixels", "legend"));
    CHECK(shows_words("[0] to [2], 8.94 pixels", "legend"));
}

TEST_CASE("Without a picked pixel, they are in the world, with the way from the eye to a corner") {
    Driver driver;
    driver.hand.click("stage.pixel_light");
    driver.ui.session.selection.triangle = 12;
    show_vectors(driver);
    CHECK(symbols(driver) == "n u v ");
    // A vertex is looked at.
    driver.ui.session.selection.vertex = 0;
    driver.hand.rest();
    CHECK(symbols(driver) == "n p − C ");
    driver.ui.session.selection.vertex = 1;
    driver.hand.rest();
    CHECK(symbols(driver) == "n p − C ");
    CHECK(shows_words("from the eye to the vertex", "legend"));
    driver.ui.session.selection.pixel = {250, 33};
    driver.hand.rest();
    CHECK(symbols(driver) == "n l ");
    driver.hand.click("stage.depth"); // without light
    CHECK(vector_subject(driver.ui).starts_with("of triangles["));
    show_vectors(driver, false);
    CHECK(symbols(driver).empty());
}

TEST_CASE("A lesson's formulas have the colours of the vectors while these are shown") {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        Driver driver;
        driver.ui.options.theme = theme;
        open_lesson(driver.ui, "14-arrows", 2);
        driver.hand.rest();
        show_vectors(driver, false);
        CHECK(lesson_colours(driver).count(letter_colour(driver, VectorName::v)) == 0);
        show_vectors(driver);
        CHECK(lesson_colours(driver).count(letter_colour(driver, VectorName::u)) == 1);
        CHECK(lesson_colours(driver).count(letter_colour(driver, VectorName::v)) == 1);
        CHECK(lesson_colours(driver).count(letter_colour(driver, VectorName::normal)) ==
              0); // is not shown
    }
}

TEST_CASE("A step that does not show the vectors itself keeps its letters plain") {
    Driver driver;
    // Its u and v are places in the picture, and its n is a coefficient.
    open_lesson(driver.ui, "11-perspective", 0);
    driver.hand.rest();
    const Lesson* const lesson = open_lesson_of(driver.ui);
    REQUIRE(lesson != nullptr);
    const int steps = static_cast<int>(lesson->steps.size());
    int shown = 0;
    for (int step = 0; step < steps; ++step) {
        INFO("step " << step);
        open_lesson(driver.ui, "11-perspective", step);
        driver.hand.rest();
        show_vectors(driver, false);
        const std::set<ImU32> before = lesson_colours(driver);
        show_vectors(driver);
        const std::set<ImU32> after = lesson_colours(driver);
        for (const VectorEntry& entry : vector_entries(driver.ui)) {
            CAPTURE(entry.symbol);
            const ImU32 colour = letter_colour(driver, entry.name);
            CHECK(after.count(colour) == before.count(colour));
            ++shown;
        }
    }
    CHECK(shown > steps); // in most of the steps there are some
}

TEST_CASE("A symbolic formula of the light has the colours of its vectors") {
    Driver driver("cylinder.toml");
    driver.hand.click("stage.pixel_light");
    driver.ui.session.selection.pixel = {170, 120};
    driver.ui.session.tab = "fragment";
    driver.ui.inspector.chosen.fragment_number = "pixel_light.n_dot_h";
    driver.hand.rest();
    const auto has = [&](VectorName name) {
        return shown_colours(driver.hand.find("fragment.formula.expression"))
                   .count(letter_colour(driver, name)) == 1;
    };
    CHECK_FALSE(has(VectorName::normal));
    show_vectors(driver);
    CHECK(has(VectorName::normal));
    CHECK(has(VectorName::half));
    CHECK_FALSE(has(VectorName::to_lamp));
    // There u and v are places in a texture, and z is no vector.
    driver.ui.inspector.chosen.fragment_number = "zinv";
    driver.hand.rest();
    for (const VectorName name :
         {VectorName::normal, VectorName::to_lamp, VectorName::to_eye, VectorName::half})
        CHECK_FALSE(has(name));
}

TEST_CASE("An expression is cut at the letters of vectors, and at nothing else") {
    const auto cut = [](std::string_view expression) {
        std::string text;
        std::size_t begin = 0;
        for (const LetterPart& part : vector_letters_in(expression)) {
            text += part.vector != 0 ? "<" : "";
            text += expression.substr(begin, part.end - begin);
            text += part.vector != 0 ? ">" : "";
            begin = part.end;
        }
        return text;
    };
    CHECK(cut("max(0, n.x · h.x + n.y · h.y)") == "max(0, <n>.x · <h>.x + <n>.y · <h>.y)");
    CHECK(cut("pow(n·h, e)") == "pow(<n>·<h>, e)");
    CHECK(cut("a.x · t + a.y · b + a.z · n") == "a.x · <t> + a.y · <b> + a.z · <n>");
    CHECK(cut("int(f · lit) / m.n") == "int(f · lit) / m.n");
    CHECK(cut("") == "");
    CHECK(cut("l") == "<l>");
}

} // namespace rasterwalk
