// The look back of each lesson: one question about the lesson two earlier, at the end of the
// opening, whose answer the program computes.

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "lessons/lesson_check.h"
#include "lessons/lesson_list.h"
#include "lessons/lesson_run.h"
#include "session/content.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

int number_of_lesson(const std::string& id) {
    return std::stoi(id.substr(0, 2));
}

std::vector<const LessonPrediction*> looks_back_of(const Lesson& lesson) {
    std::vector<const LessonPrediction*> found;
    for (const LessonPrediction& prediction : lesson.predictions)
        if (prediction.looks_back) found.push_back(&prediction);
    return found;
}

int count_words(const std::string& text) {
    std::istringstream stream(text);
    int words = 0;
    for (std::string word; stream >> word;)
        ++words;
    return words;
}

/// The file that the last link of a text names, if the text ends with it.
std::string link_at_end_of(const std::string& text) {
    const std::string end = ")).";
    const std::size_t begin = text.rfind("](");
    if (begin == text.npos || !text.ends_with(end)) return {};
    const std::string target = text.substr(begin + 2, text.size() - end.size() - begin - 2);
    return target.find(')') == target.npos ? target : std::string();
}

/// The conditions or expressions that decide which answer is right.
std::vector<const Expression*> deciding(const LessonPrediction& prediction) {
    std::vector<const Expression*> all;
    for (const Expression& condition : prediction.right)
        all.push_back(&condition);
    if (prediction.answer) all.push_back(&*prediction.answer);
    if (prediction.where) all.push_back(&*prediction.where);
    return all;
}

std::vector<Lesson> lessons_with_looks_back() {
    LessonList list;
    list.read_folder(lessons_folder());
    return list.all();
}

} // namespace

// The reader reports a look back in another place or form, see
// tests/lessons/broken/21-look-back.md.
TEST_CASE("Each lesson from the third looks back once, and the reader has no complaint") {
    const std::vector<Lesson> lessons = lessons_with_looks_back();
    REQUIRE(lessons.size() >= 36);
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        const Lesson& lesson = lessons[i];
        INFO(lesson.path);
        CHECK(lesson.faults.empty());
        const std::vector<const LessonPrediction*> found = looks_back_of(lesson);
        if (i < 2) {
            CHECK(found.empty());
            continue;
        }
        CHECK(found.size() == 1);
        if (found.size() != 1) continue;
        for (const std::string& choice : found.front()->choices)
            CHECK(count_words(choice) <= 12);
    }
}

TEST_CASE("A look back ends with a link to a lesson that comes at least two before its own") {
    const std::vector<Lesson> lessons = lessons_with_looks_back();
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        for (const LessonPrediction* const prediction : looks_back_of(lessons[i])) {
            INFO(lessons[i].path << ": " << prediction->because);
            const std::string target = link_at_end_of(prediction->because);
            REQUIRE(target.ends_with(".md"));
            const std::string id = target.substr(0, target.size() - 3);
            const auto earlier = std::find_if(lessons.begin(), lessons.end(),
                                              [&](const Lesson& other) { return other.id == id; });
            REQUIRE(earlier != lessons.end());
            CHECK(earlier - lessons.begin() + 2 <= static_cast<std::ptrdiff_t>(i));
            const std::string words = "[lesson " + std::to_string(number_of_lesson(id)) + "](";
            CHECK(prediction->because.find(words + target) != std::string::npos);
        }
    }
}

TEST_CASE("Every answer of a look back is decided by facts or settings") {
    const std::vector<Lesson> lessons = lessons_with_looks_back();
    for (const Lesson& lesson : lessons) {
        for (const LessonPrediction* const prediction : looks_back_of(lesson)) {
            INFO(lesson.path);
            CHECK_FALSE(deciding(*prediction).empty());
            for (const Expression* const expression : deciding(*prediction))
                CHECK_FALSE(expression->is_constant());
        }
    }
}

namespace {

struct RuleAsked {
    std::string lesson, setting;
};

/// Look backs about a rule that a setting changes, and with it the answer.
std::vector<RuleAsked> looks_back_at_rules() {
    return {
        {"02-moving-the-camera", "rounding=floor"},
        {"04-edges", "camera.position=0,0,-5"},
        {"05-row-table", "edge_samples=rows"},
        {"06-filling", "camera.yaw=0.3"},
        {"08-depth-buffer", "spans=last_dropped"},
        {"09-light-per-vertex", "hidden=depth_buffer"},
        {"10-light-per-pixel", "projection=orthographic"},
        {"11-perspective", "light.falloff=linear"},
        {"12-float-traps", "stage=vertex_light"},
        {"14-arrows", "line_walk=exact"},
        {"15-matrices", "depth_clear=0"},
        {"17-near-plane", "translation=bottom_row"},
        {"18-outcodes", "projection=perspective"},
        {"21-edge-functions", "cull=view_axis"},
        {"22-weights", "line=interpolate"},
        {"23-textures", "fill_rule=inclusive"},
        {"24-mipmaps", "weight_edge=own"},
        {"25-z-fighting", "interpolation=affine"},
        {"26-hidden-surfaces", "texel_rule=level_along_x"},
        {"27-flat-gouraud-phong", "depth_test=or_equal"},
        {"28-shine", "hidden=painter"},
        {"30-obj", "light.renormalize=on"},
        {"33-cost", "shadow_offset=0.001"},
        {"36-your-own-program", "depth_order=before_depth_test"},
    };
}

struct FactAsked {
    std::string lesson, reason;
};

/// Look backs about something that no setting changes.
std::vector<FactAsked> looks_back_at_facts() {
    return {
        {"07-painters-order", "no setting is the value that a row's left end begins with"},
        {"13-reading-a-bug", "that q/z is linear on the screen follows from the projection"},
        {"16-orthographic", "the dot product of two given sides is arithmetic"},
        {"19-culling", "the sign of x/z is arithmetic"},
        {"20-bresenham", "what the outcodes of given corners prove is arithmetic"},
        {"29-normal-maps", "no light and no shading moves a corner"},
        {"31-shadows", "a normal is perpendicular to its surface, by definition"},
        {"32-blending", "the model's file says how many corners are different"},
        {"34-simd", "no setting changes the order of drawing in a scene in pixels"},
        {"35-rays", "what a depth pre-pass would shade is counted, and no setting adds one"},
    };
}

} // namespace

TEST_CASE("Each look back is about a rule that a setting changes, or there is a reason why not") {
    std::vector<std::string> listed;
    for (const RuleAsked& rule : looks_back_at_rules())
        listed.push_back(rule.lesson);
    for (const FactAsked& fact : looks_back_at_facts()) {
        INFO(fact.lesson);
        CHECK(count_words(fact.reason) >= 5);
        listed.push_back(fact.lesson);
    }
    std::vector<std::string> looking_back;
    for (const Lesson& lesson : lessons_with_looks_back()) {
        if (!looks_back_of(lesson).empty()) looking_back.push_back(lesson.id);
    }
    std::sort(listed.begin(), listed.end());
    std::sort(looking_back.begin(), looking_back.end());
    CHECK(listed == looking_back);
}

TEST_CASE("The answer to a look back changes with the rule that it asks for") {
    const std::vector<Lesson> lessons = lessons_with_looks_back();
    const Session session = empty_session();
    LessonTrial trial;
    for (const RuleAsked& rule : looks_back_at_rules()) {
        INFO(rule.lesson << " with " << rule.setting);
        const auto lesson = std::find_if(lessons.begin(), lessons.end(),
                                         [&](const Lesson& one) { return one.id == rule.lesson; });
        REQUIRE(lesson != lessons.end());
        const std::vector<const LessonPrediction*> found = looks_back_of(*lesson);
        CHECK(found.size() == 1);
        if (found.size() != 1) continue;
        LessonPrediction prediction = *found.front();
        const bool is_number = prediction.kind == LessonPrediction::Kind::number;
        const GivenAnswer any = is_number ? GivenAnswer{0.0} : GivenAnswer{0};
        const Judgement before = judge(*lesson, prediction, any, session, trial);
        CHECK(before.fault.empty());
        prediction.at.set.push_back(rule.setting);
        const Judgement after = judge(*lesson, prediction, any, session, trial);
        CHECK(after.answer != before.answer);
    }
}
