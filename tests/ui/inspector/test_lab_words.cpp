#include "base/numbers.h"
#include "laboratory/diagnose.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"
#include "tests/ui/diagnosed.h"
#include "tests/ui/shown_number.h"
#include "ui/actions/compare.h"
#include "ui/inspector/lab_parts.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// The answer to a picture for which this was found.
LabAnswer answer_with(Diagnosis diagnosis) {
    LabAnswer answer;
    answer.subject.is_picture = true;
    answer.diagnosis = std::move(diagnosis);
    return answer;
}

Diagnosis likely(std::vector<Suspect> mistakes, std::int64_t still_different) {
    Diagnosis found;
    found.different = 1000;
    found.candidates.resize(1);
    Candidate& candidate = found.candidates[0];
    candidate.mistakes = std::move(mistakes);
    candidate.different = still_different;
    candidate.explained = 1.0 - static_cast<double>(still_different) / 1000.0;
    candidate.is_likely = true;
    candidate.remark = "with light.power=14";
    return found;
}

using Lines = std::vector<std::string>;

} // namespace

TEST_CASE("Each name of each likely mistake has a line of its own, with how sure it is") {
    const LabHeadline one = headline_of(answer_with(likely({{{"B9"}, {"Last"}}}, 0)));
    CHECK(one.names == Lines{"B9 “Last”"});
    CHECK(one.rest == "It explains your picture down to the last pixel.");
    const LabHeadline choice =
        headline_of(answer_with(likely({{{"B9", "upside_down"}, {"Last", "Upside down"}}}, 0)));
    CHECK(choice.names == Lines{"B9 “Last”", "or Upside down"});
    CHECK(choice.rest == "Each of them alone explains your picture down to the last pixel.");
    const LabHeadline two = headline_of(
        answer_with(likely({{{"B9"}, {"Last"}}, {{"B3", "B4"}, {"As it is", "Twice"}}}, 4)));
    CHECK(two.names == Lines{"B9 “Last”", "together with B3 “As it is”", "or B4 “Twice”"});
    CHECK(two.rest == "Together they explain 99.6 % of what is wrong.");
    LabAnswer rows = answer_with(likely({{{"B9"}, {"Last"}}}, 0));
    rows.subject.is_picture = false;
    CHECK(headline_of(rows).rest == "It explains your rows down to the last end.");
}

TEST_CASE("The nearest mistake is named apart from the verdict that none is likely") {
    Diagnosis found;
    found.different = 10;
    found.verdict = "No known mistake explains the difference; the best match, B3 “As it is” (with "
                    "light.power=14), explains 87 % of it.";
    const LabHeadline headline = headline_of(answer_with(found));
    CHECK(headline.names == Lines{"No known mistake explains the difference."});
    CHECK(headline.rest ==
          "The best match, B3 “As it is” (with “Lamp power: 14”), explains 87 % of it.");
}

TEST_CASE("Rules and numbers of a program are given in words, as right or as the nearest") {
    Diagnosis found;
    CHECK(rules_words(found) == "");
    found.rules = "line_walk=exact, light.position=0.1,-0.53480123,-2 and light.power=9";
    const std::string rules =
        "“Walking a line: without error”, “Lamp position: 0.1, −0.5348, −2” and “Lamp power: 9”";
    CHECK(rules_words(found) == "Your program draws with " + rules + ", which is just as correct.");
    found.different = 3;
    CHECK(rules_words(found) == "The nearest correct picture is drawn with " + rules + ".");
    Diagnosis sure = likely({{{"B9"}, {"Last"}}}, 0);
    sure.rules = found.rules;
    CHECK(rules_words(sure) == "Your program draws with " + rules + ", which is just as correct.");
}

TEST_CASE("What differs by rounding alone, or by rules, is right all the same") {
    Diagnosis found;
    CHECK(headline_of(answer_with(found)).names ==
          Lines{"Your picture matches the reference, pixel for pixel."});
    Diagnosis rounding = found;
    rounding.findings = {"2 pixels differ along edges, as rounding of floats may make them."};
    CHECK(headline_of(answer_with(rounding)).names == Lines{"Your picture is correct."});
    Diagnosis rules = found;
    rules.rules = "light.power=9";
    CHECK(headline_of(answer_with(rules)).names == Lines{"Your picture is correct."});
}

TEST_CASE("The diagnosis says sizes and settings in words") {
    Driver driver;
    const Settings reference = pixel_light(driver, 500);
    driver.ui.session.a.settings = reference;
    driver.open("lab");
    check_picture(driver, reference);
    CHECK(shown_text(driver, "lab.diagnosis") ==
          "Your picture matches the reference, pixel for pixel.");
    CHECK_THAT(shown_text(driver, "lab.held_against"),
               Catch::Matchers::EndsWith("500 x 500 pixels like yours."));
    Settings small = reference;
    set_from_text(small, "viewport.size=100x100");
    set_from_text(small, "camera.focal_length=" + number_text(reference.camera.focal_length / 5));
    check_picture(driver, small);
    CHECK(driver.ui.lab.answer->diagnosis.is_same());
    CHECK_THAT(shown_text(driver, "lab.held_against"),
               Catch::Matchers::EndsWith("100 x 100 pixels instead of 500 x 500."));
    set_from_text(small, "line_walk=exact");
    check_picture(driver, small);
    CHECK(shown_text(driver, "lab.diagnosis") == "Your picture is correct.");
    CHECK(shown_text(driver, "lab.rules") ==
          "Your program draws with “Walking a line: without error”, which is just as correct.");
}

TEST_CASE("Of two mistakes at once both are named, described and mended on the card") {
    Driver driver;
    const std::vector<Bug> bugs = read_bugs();
    Settings wrong = pixel_light(driver, small_side);
    const std::string ids[] = {"B9", "B3"}; // the stage of the second counts
    for (const std::string& id : ids) {
        for (const auto& [name, value] : find_bug(bugs, id).set)
            set_value(wrong, *find_setting(name), value);
    }
    wrong.light.power = glm::vec3(14.0f); // so that B3 is seen
    check_image(driver, drawn_by(driver, wrong));
    REQUIRE(driver.ui.lab.answer);
    REQUIRE(likely_candidate(driver.ui.lab.answer->diagnosis) != nullptr);
    const std::string card = shown_text(driver, "lab.diagnosis");
    const std::string remedy = shown_text(driver, "lab.remedy");
    CHECK_THAT(card,
               Catch::Matchers::ContainsSubstring(" together with ") &&
                   Catch::Matchers::EndsWith("Together they explain your picture down to the last "
                                             "pixel."));
    for (const std::string& id : ids) {
        const Bug& bug = find_bug(bugs, id);
        INFO(id);
        CHECK_THAT(card, Catch::Matchers::ContainsSubstring(id + " “" + bug.name + "”"));
        CHECK_THAT(remedy, Catch::Matchers::ContainsSubstring(bug.look) &&
                               Catch::Matchers::ContainsSubstring(bug.code));
    }
    CHECK(driver.hand.find("lab.diagnosis").bottom_right.y <
          driver.hand.find("lab.picture.own").top_left.y);
    driver.hand.click("lab.show.0");
    CHECK(driver.ui.session.a.settings == wrong);
}

TEST_CASE("Where no mistake is likely, the answer says what the wrong pixels have in common") {
    Driver driver;
    const Settings reference = pixel_light(driver, small_side);
    const Image right = drawn_by(driver, reference);
    Image scratched = right;
    std::int64_t black = 0;
    for (int row = 40; row < 60; ++row) {
        for (int column = 40; column < 70; ++column) {
            std::uint8_t* const pixel =
                scratched.rgba.data() + 4 * static_cast<std::size_t>(row * small_side + column);
            black += pixel[0] + pixel[1] + pixel[2] > 0 ? 1 : 0;
            std::fill_n(pixel, 3, std::uint8_t{0});
        }
    }
    REQUIRE(black > 100);
    check_image(driver, scratched);
    REQUIRE(driver.ui.lab.answer);
    CHECK(shown_text(driver, "lab.diagnosis") == "No known mistake explains the difference.");
    CHECK_THAT(shown_text(driver, "lab.difference"),
               Catch::Matchers::StartsWith(grouped(black) +
                                           " pixels differ from the correct picture. "
                                           "They are in columns 40 to 69 and rows "
                                           "40 to 59."));
    CHECK_THAT(
        shown_text(driver, "lab.finding.0"),
        Catch::Matchers::StartsWith(std::to_string(black) + " pixels are black but should not be"));
    CHECK_FALSE(driver.hand.is_visible("lab.remedy"));
    CHECK_THAT(shown_text(driver, "lab.lamp_and_camera"),
               Catch::Matchers::ContainsSubstring("set it here"));
    check_image(driver, right);
    CHECK_FALSE(driver.hand.is_visible("lab.lamp_and_camera"));
    CHECK_FALSE(driver.hand.is_visible("lab.finding.0"));
}

} // namespace rasterwalk
