#include "session/moments.h"

#include <regex>
#include <string>

#include "base/element_names.h"
#include "base/error.h"
#include "pipeline/timeline.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "support/effort.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// The moment that the words describe, put together from their numbers; what is wrong with
/// them, if they do not count from 0.
std::string named_moment(const std::string& words, int triangles) {
    static const std::regex form(
        "triangles\\[(\\d+)\\] of (\\d+) \\([^)]*\\) · "
        "(?:vertices\\[(\\d+)\\] of (\\d+)"
        "|edge (\\d+) · line\\[(\\d+)\\] of (\\d+)"
        "|row (-?\\d+), entry \\[(\\d+)\\] of (\\d+)(?:: its two ends| · fragments\\[(\\d+)\\] of "
        "(\\d+)))");
    std::smatch match;
    if (!std::regex_match(words, match, form)) return "not of that form";
    const auto number = [&](std::size_t group) {
        return match[group].matched ? std::stoi(match[group]) : -1;
    };
    // Which of how many, for everything counted: the last is one less than the count.
    for (const auto& [index, count] : {std::pair(1, 2), {3, 4}, {6, 7}, {9, 10}, {11, 12}}) {
        if (number(index) >= 0 && number(index) >= number(count)) return "beyond the last";
    }
    if (number(2) != triangles) return "another number of triangles";
    if (number(5) > 2) return "a triangle has the edges 0 to 2";
    std::string text = "t" + match[1].str() + "/";
    if (match[3].matched) return text + "v" + match[3].str();
    if (match[5].matched) return text + "e" + match[5].str() + "/s" + match[6].str();
    return text + "r" + match[9].str() + "/c" + (match[11].matched ? match[11].str() : "0");
}

/// Every moment of the frame at this granularity, put into words and read back.
void describe_all(const std::string& scene, StripStep step, Granularity granularity) {
    const Scene read = read_scene_file(lessons_folder() + "/scenes/" + scene);
    Settings settings = default_settings(read);
    set_step(settings, step);
    const Frame frame = prepare_frame(read, settings);
    const Timeline timeline(frame);
    std::int64_t moments = 0;
    std::string last;
    for (Cursor at = timeline.first(); at != cursor_end; at = timeline.next(at, granularity)) {
        const std::string words = describe_moment(frame, at);
        const std::string reported = named_moment(words, frame.triangle_count());
        ++moments;
        if (reported != to_text(at))
            FAIL(to_text(at) << " is described as '" << words << "': " << reported);
        last = words;
    }
    CHECK(moments > frame.triangle_count());
    const int last_triangle = frame.triangle_count() - 1;
    CHECK(last.starts_with("triangles[" + std::to_string(last_triangle) + "] of "));
}

} // namespace

TEST_CASE("Every moment of the bench and the room is counted from 0, in words as in its text") {
    for (const StageInfo& info : test::some_of(stage_list(), 4)) {
        INFO(info.name);
        describe_all("one-triangle.toml", info.step, Granularity::moment);
        describe_all("lab-room.toml", info.step,
                     has_fragments(info.step.stage) ? Granularity::line : Granularity::moment);
    }
}

TEST_CASE("A moment in words") {
    const Scene room = read_scene_file(lessons_folder() + "/scenes/lab-room.toml");
    Settings settings = default_settings(room);
    set_step(settings, StripStep::pixel_light);
    const Frame frame = prepare_frame(room, settings);
    CHECK(describe_moment(frame, {20, Phase::edges, 1, 13}) ==
          "triangles[20] of 30 (tall block) · edge 1 · line[13] of 98");
    CHECK(describe_moment(frame, {0, Phase::vertices, 2, 0}) ==
          "triangles[0] of 30 (floor) · vertices[2] of 3");
}

TEST_CASE("A moment of clip or cull in words") {
    const Scene room = read_scene_file(lessons_folder() + "/scenes/lab-room.toml");
    Settings settings = default_settings(room);
    settings.camera.position.z = -0.9f;
    settings.clip = Clip::all;
    settings.cull = Cull::screen_area;
    const Frame frame = prepare_frame(room, settings);
    CHECK(describe_moment(frame, {0, Phase::clip, 0, 2}) ==
          "triangles[0] of 30 (floor) · near plane · edge 2");
    int tested = 0;
    while (!frame.is_cull_tested(tested))
        ++tested;
    const std::string words = describe_moment(frame, {tested, Phase::cull, 0, 0});
    CHECK(words.starts_with(triangle_name(tested) + " of 30 ("));
    CHECK(words.ends_with(") · front or back"));
    CHECK(moment_name({0, Phase::clip, 3, 1}) == "triangles[0], right plane, edge 1");
    CHECK(moment_name({0, Phase::clip, 99, 99}) == "triangles[0], plane 99, edge 99");
    CHECK(moment_name({0, Phase::cull, 0, 0}) == "triangles[0], front or back");
    // Every moment of the frame can be described, even of what is taken away.
    const Timeline timeline(frame);
    int clip = 0, cull = 0;
    for (Cursor at = timeline.first(); at != cursor_end;
         at = timeline.next(at, Granularity::line)) {
        CHECK(describe_moment(frame, at).starts_with(triangle_name(at.triangle) + " of 30 ("));
        clip += at.phase == Phase::clip ? 1 : 0;
        cull += at.phase == Phase::cull ? 1 : 0;
    }
    CHECK(clip > 10);
    CHECK(cull > 10);
}

TEST_CASE("A moment has a short name that no decimal can be mistaken for") {
    CHECK(moment_name({20, Phase::edges, 1, 13}) == "triangles[20], edge 1, line[13]");
    CHECK(moment_name({0, Phase::vertices, 2, 0}) == "triangles[0], vertices[2]");
    CHECK(moment_name({3, Phase::rows, 37, 5}) == "triangles[3], entry [37], fragments[5]");
    CHECK(moment_name(cursor_end) == "end of the frame");
}

TEST_CASE("What only another run does is named, not described") {
    const Scene room = read_scene_file(lessons_folder() + "/scenes/lab-room.toml");
    const Frame frame = prepare_frame(room, default_settings(room));
    for (const Cursor& at : {Cursor{3, Phase::edges, 7, 0}, Cursor{3, Phase::edges, 0, 9999},
                             Cursor{3, Phase::rows, 9999, 0}, Cursor{3, Phase::rows, -1, 0},
                             Cursor{3, Phase::tests, 2, 5}, Cursor{3, Phase::clip, 9, 1},
                             Cursor{300, Phase::vertices, 0, 0}, moment_of_square(4),
                             moment_of_resolve(3, 4), cursor_end})
        CHECK(describe_moment(frame, at) == moment_name(at));
}

TEST_CASE("A square of the picture, and a fragment in it, in words") {
    const Scene room = read_scene_file(lessons_folder() + "/scenes/lab-room.toml");
    Settings settings = default_settings(room);
    set_step(settings, StripStep{Stage::depth});
    settings.hidden = Hidden::warnock;
    const Frame frame = prepare_frame(room, settings);
    REQUIRE(frame.squares != nullptr);
    const std::string count = std::to_string(frame.squares->count());
    CHECK(describe_moment(frame, moment_of_square(0)) ==
          "square w0 of " + count + ": columns 0 to 499, rows 0 to 499 · divided");
    CHECK(moment_name(moment_of_square(12)) == "square w12");
    CHECK(describe_square_in_short(frame, 0) == "square w0 · divided");
    int pixels = 0;
    for (int n = 0; n < frame.squares->count(); ++n) {
        const WarnockSquare& square = (*frame.squares)[n];
        const std::string words = describe_moment(frame, moment_of_square(n));
        REQUIRE(words.starts_with("square w" + std::to_string(n) + " of " + count + ": column"));
        REQUIRE(
            (square.surface >= 0) ==
            (words.find(": triangles[" + std::to_string(square.surface) + "] (") != words.npos));
        if (square.reason != SquareReason::one_pixel) continue;
        ++pixels;
        REQUIRE(words.find(" · one pixel: ") != words.npos);
    }
    CHECK(pixels > 100);

    // A fragment in a square stands for it.
    const int surface = (*frame.squares)[frame.squares->count() - 1].surface;
    REQUIRE(surface >= 0);
    const Cursor fragment{surface, Phase::rows, 1, 0, 0, frame.squares->count() - 1};
    CHECK(moment_of(frame, to_text(fragment)) == moment_of_square(fragment.square));
    const std::string name = triangle_name(surface);
    CHECK(moment_name(fragment) ==
          "square w" + std::to_string(fragment.square) + ", " + name + ", entry [1], fragments[0]");
    const std::string words = describe_moment(frame, fragment);
    CHECK(words.starts_with("square w" + std::to_string(fragment.square) + " · " + name +
                            " of 30 ("));

    const auto refusal = [&](const char* text) -> std::string {
        try {
            moment_of(frame, text);
        } catch (const UsageError& error) {
            return error.what();
        }
        return {};
    };
    CHECK(refusal("t12") == "there is no moment t12: the picture has the squares w0 to w" +
                                std::to_string(frame.squares->count() - 1) +
                                ", and triangles have no moments of their own.");
    CHECK(refusal("w99999999").starts_with("there is no moment w99999999: the picture has"));
    settings.hidden = Hidden::depth_buffer;
    const Frame other = prepare_frame(room, settings);
    for (const char* const text : {"w12", "w12/t3/r37/c5"})
        CHECK_THROWS_WITH(moment_of(other, text),
                          Catch::Matchers::ContainsSubstring("is not divided into squares"));
}
