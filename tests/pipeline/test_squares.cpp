// Warnock's squares: they show what a depth buffer shows, and what rays meet; and time runs through
// them as through the moments of triangles.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/draw.h"
#include "pipeline/event_source.h"
#include "pipeline/frame_preparation.h"
#include "pipeline/replay.h"
#include "pipeline/square_steps.h"
#include "pipeline/stepping.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "support/bits.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/random.h"
#include "support/ray_caster.h"
#include "support/ray_picture.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// Depths closer than this, relative to their size, are a tie: rows are added up in float.
constexpr double tie = 1e-4;

bool is_tie(double a, double b) {
    return std::abs(a - b) <= tie * std::max(std::abs(a), std::abs(b));
}

/// Every scene of the lessons in the world in which all surfaces are opaque.
std::vector<Scene> opaque_scenes() {
    std::vector<std::string> paths;
    for (const auto& file : std::filesystem::directory_iterator(lessons_folder() + "/scenes"))
        if (file.path().extension() == ".toml") paths.push_back(file.path().string());
    std::sort(paths.begin(), paths.end());
    std::vector<Scene> scenes;
    for (const std::string& path : paths) {
        Scene scene = read_scene(path);
        if (scene.space == SceneSpace::world && !has_alpha(scene) && !has_texture_alpha(scene))
            scenes.push_back(std::move(scene));
    }
    return scenes;
}

/// A few triangles in front of the camera, many of which go through each other.
Scene crossing_scene(Random& random) {
    Scene scene;
    scene.space = SceneSpace::world;
    scene.camera.position = {0.0f, 0.0f, -3.0f};
    const int triangles = random.integer(1, 12);
    for (int t = 0; t < triangles; ++t) {
        std::array<Vertex, triangle_corners> corners;
        const glm::vec3 middle{random.number(-1.2, 1.2), random.number(-1.2, 1.2),
                               random.number(-1.0, 1.5)};
        const double size = random.real(0.1, 2.0);
        for (Vertex& corner : corners) {
            for (int axis = 0; axis < 3; ++axis)
                corner.position[axis] = middle[axis] + random.number(-size, size);
            corner.position.z = std::max(corner.position.z, -2.5f);
            corner.reflectance = glm::vec3(1.0f);
        }
        scene.mesh.add_triangle_of(corners);
    }
    return scene;
}

Settings settings_of(const Scene& scene, Hidden hidden) {
    Settings settings = default_settings(scene);
    set_step(settings, {Stage::depth, Shading::unlit});
    settings.hidden = hidden;
    return settings;
}

/// Centres of pixels decide coverage, and corners are snapped to 256ths of a pixel.
void cover_by_centres(Settings& settings) {
    settings.coverage = Coverage::edge_functions;
    settings.snap = Snap::subpixel;
    settings.clip = Clip::all;
}

struct SquareCounts {
    std::int64_t compared = 0, ties = 0, wrong = 0;
    std::string first_wrong;

    void add(bool is_tied, int column, int row, int drawn, int expected) {
        ++(is_tied ? ties : wrong);
        if (is_tied || wrong > 1) return;
        first_wrong = "column " + std::to_string(column) + ", row " + std::to_string(row) +
                      ": drawn " + std::to_string(drawn) + ", expected " + std::to_string(expected);
    }
};

/// Compares the squares' picture with the depth buffer's; both have the depth of what they show.
void compare_pictures(const Framebuffer& squares, const Framebuffer& buffer, SquareCounts& counts) {
    for (int row = 0; row < squares.size.height; ++row) {
        for (int column = 0; column < squares.size.width; ++column) {
            const std::size_t pixel = squares.at(column, row);
            ++counts.compared;
            if (squares.owner[pixel] == buffer.owner[pixel]) {
                const bool is_same = squares.colour[pixel] == buffer.colour[pixel] &&
                                     squares.depth[pixel] == buffer.depth[pixel];
                if (!is_same) counts.add(false, column, row, -2, -2);
                continue;
            }
            const bool has_both = squares.owner[pixel] >= 0 && buffer.owner[pixel] >= 0;
            const auto depth = static_cast<double>(squares.depth[pixel]);
            counts.add(has_both && is_tie(depth, static_cast<double>(buffer.depth[pixel])), column,
                       row, squares.owner[pixel], buffer.owner[pixel]);
        }
    }
}

/// Compares a picture with the rays through the centres of its pixels.
void compare_squares_with_rays(const Frame& frame, const Framebuffer& drawn, SquareCounts& counts) {
    constexpr double margin = 1.0;
    const Settings& settings = frame.settings;
    const std::vector<int> met = cast_rays(*frame.scene, settings.camera, settings.viewport,
                                           {settings.near, settings.far}, margin);
    std::optional<RayCaster> rays; // to look at a difference more closely
    for (int row = 0; row < drawn.size.height; ++row) {
        for (int column = 0; column < drawn.size.width; ++column) {
            const std::size_t pixel = drawn.at(column, row);
            if (met[pixel] == ray_near_outline) continue;
            ++counts.compared;
            const int a = drawn.owner[pixel], b = met[pixel];
            if (a == b) continue;
            if (!rays) rays.emplace(*frame.scene, settings.camera, settings.light);
            const glm::dvec2 place(column + 0.5 - drawn.size.width / 2,
                                   row + 0.5 - drawn.size.height / 2);
            const bool is_tied =
                a >= 0 && b >= 0 &&
                is_tie(rays->on_plane(a, place).zinv, rays->on_plane(b, place).zinv);
            counts.add(is_tied, column, row, a, b);
        }
    }
}

/// The depth of every fragment of a triangle; no number where it has none.
std::vector<double> lone_depths(const Frame& frame, int triangle) {
    const Viewport size = frame.settings.viewport;
    std::vector<double> depths(static_cast<std::size_t>(size.width * size.height), NAN);
    Framebuffer planes;
    clear(planes, frame);
    const Observer keep{.fragment = [&](const FragmentEvent& event) {
        depths[planes.at(event.fragment.column, event.fragment.row)] = double{event.fragment.depth};
    }};
    draw(frame, {beginning_of(triangle), beginning_of(triangle + 1), {}}, planes, &keep);
    return depths;
}

/// What the pixels of a square say about it.
struct Checked {
    std::vector<int> met;
    std::vector<int> in_front;  ///< covers it, and is nowhere behind another by more than a tie
    std::vector<int> far_ahead; ///< covers it, and is everywhere ahead by more than a tie
};
Checked check_pixels(const std::vector<std::vector<double>>& depths, const Rectangle& square,
                     int width) {
    Checked checked;
    const auto each_pixel = [&](const auto& look) {
        for (int row = square.top; row < square.bottom; ++row)
            for (int column = square.left; column < square.right; ++column)
                look(static_cast<std::size_t>(row * width + column));
    };
    for (std::size_t t = 0; t < depths.size(); ++t) {
        bool meets = false, covers = true;
        each_pixel([&](std::size_t pixel) {
            const bool is_there = !std::isnan(depths[t][pixel]);
            meets = meets || is_there;
            covers = covers && is_there;
        });
        if (meets) checked.met.push_back(static_cast<int>(t));
        if (!covers) continue;
        bool in_front = true, far_ahead = true;
        each_pixel([&](std::size_t pixel) {
            for (std::size_t other = 0; other < depths.size(); ++other) {
                const double own = depths[t][pixel], its = depths[other][pixel];
                if (other == t || std::isnan(its)) continue;
                in_front = in_front && (own >= its || is_tie(own, its));
                far_ahead = far_ahead && own > its && !is_tie(own, its);
            }
        });
        if (in_front) checked.in_front.push_back(static_cast<int>(t));
        if (far_ahead) checked.far_ahead.push_back(static_cast<int>(t));
    }
    return checked;
}

bool has(const std::vector<int>& list, int value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

void check_reason(const WarnockSquare& square, const Checked& checked) {
    const bool is_pixel = square.pixels.right - square.pixels.left == 1 &&
                          square.pixels.bottom - square.pixels.top == 1;
    switch (square.reason) {
    case SquareReason::empty:
        REQUIRE(checked.met.empty());
        REQUIRE(square.surface == -1);
        break;
    case SquareReason::one_surface:
        REQUIRE(checked.met == std::vector<int>{square.surface});
        break;
    case SquareReason::one_in_front:
        REQUIRE(!is_pixel);
        REQUIRE(checked.met.size() > 1);
        REQUIRE(has(checked.in_front, square.surface));
        break;
    case SquareReason::one_pixel:
        REQUIRE(is_pixel);
        REQUIRE(checked.met.size() > 1);
        REQUIRE(has(checked.in_front, square.surface));
        break;
    case SquareReason::divide:
        REQUIRE(!is_pixel);
        REQUIRE(checked.met.size() > 1);
        REQUIRE(checked.far_ahead.empty());
        REQUIRE(square.surface == -1);
        break;
    }
}

/// Do the parts of each square cover it, one after another in time?
void check_nesting(const WarnockSquares& squares, const Rectangle& picture) {
    REQUIRE(squares.count() > 0);
    REQUIRE(squares[0].pixels == picture);
    REQUIRE(squares.after(0) == squares.count());
    for (int n = 0; n < squares.count(); ++n) {
        const WarnockSquare& square = squares[n];
        std::array<Rectangle, 4> parts;
        const int count = square.reason == SquareReason::divide ? divide(square.pixels, parts) : 0;
        int part = n + 1;
        for (int i = 0; i < count; ++i) {
            REQUIRE(squares[part].pixels == parts[static_cast<std::size_t>(i)]);
            REQUIRE(squares[part].parent == n);
            REQUIRE(squares[part].depth == square.depth + 1);
            part = squares.after(part);
        }
        REQUIRE(part == squares.after(n));
    }
    std::vector<int> times(static_cast<std::size_t>(picture.right * picture.bottom), 0);
    for (const WarnockSquare& square : squares.squares) {
        if (square.reason == SquareReason::divide) continue;
        for (int row = square.pixels.top; row < square.pixels.bottom; ++row)
            for (int column = square.pixels.left; column < square.pixels.right; ++column)
                ++times[static_cast<std::size_t>(row * picture.right + column)];
    }
    REQUIRE(std::all_of(times.begin(), times.end(), [](int count) { return count == 1; }));
}

/// A small frame that is divided.
Frame small_frame(Random& random, const Scene& scene) {
    Settings settings = settings_of(scene, Hidden::warnock);
    set_step(settings, {Stage::depth, random.integer(0, 1) == 0 ? Shading::unlit : Shading::flat});
    settings.viewport = {random.integer(5, 26), random.integer(5, 20)};
    settings.camera.focal_length = 20.0f;
    if (random.integer(0, 1) == 0) cover_by_centres(settings);
    return prepare_frame(scene, settings);
}

std::vector<Cursor> all_squares(const Frame& frame) {
    std::vector<Cursor> moments;
    for (int n = 0; n < frame.squares->count(); ++n)
        moments.push_back(moment_of_square(n));
    moments.push_back(cursor_end);
    return moments;
}

Framebuffer drawn_to(const Frame& frame, const Cursor& cursor) {
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {cursor_begin, cursor, {}}, framebuffer);
    return framebuffer;
}

/// Calls this with small frames of random scenes and their moments.
template <class Look>
void with_small_frames(std::uint32_t seed, int full, int fewest, const Look& look) {
    Random random(seed);
    for (int i = 0; i < rounds(full, fewest); ++i) {
        const Scene scene = crossing_scene(random);
        const Frame frame = small_frame(random, scene);
        CAPTURE(i);
        REQUIRE(frame.squares != nullptr);
        look(random, frame, all_squares(frame));
    }
}

} // namespace

TEST_CASE("In every scene of the lessons the squares show what the depth buffer shows") {
    const std::vector<Scene> scenes = opaque_scenes();
    REQUIRE(scenes.size() > 5);
    SquareCounts counts;
    for (const Scene& scene : scenes) {
        for (const bool by_centres : {false, true}) {
            Settings settings = settings_of(scene, Hidden::warnock);
            if (by_centres) cover_by_centres(settings);
            CAPTURE(scene.name, by_centres);
            const Frame frame = prepare_frame(scene, settings);
            if (frame.squares == nullptr) continue; // too many rows
            const Framebuffer drawn = draw_frame(frame);
            settings.hidden = Hidden::depth_buffer;
            compare_pictures(drawn, draw_frame(prepare_frame(scene, settings)), counts);
            if (counts.wrong > 0) FAIL(counts.first_wrong);
        }
    }
    CAPTURE(counts.compared, counts.ties);
    CHECK(counts.compared > 1'000'000);
    CHECK(500 * counts.ties < counts.compared);
}

TEST_CASE("In every scene of the lessons the squares show what rays meet") {
    SquareCounts counts;
    for (const Scene& scene : opaque_scenes()) {
        if (scene.camera.aim != CameraAim::angles) continue; // as rays are cast
        Settings settings = settings_of(scene, Hidden::warnock);
        cover_by_centres(settings);
        CAPTURE(scene.name);
        const Frame frame = prepare_frame(scene, settings);
        if (frame.squares == nullptr) continue;
        compare_squares_with_rays(frame, draw_frame(frame), counts);
        if (counts.wrong > 0) FAIL(counts.first_wrong);
    }
    CAPTURE(counts.compared, counts.ties);
    CHECK(counts.compared > 500'000);
    CHECK(500 * counts.ties < counts.compared);
}

TEST_CASE("In random scenes the squares show what the depth buffer shows and what rays meet") {
    Random random(81);
    SquareCounts by_buffer, by_rays;
    for (int i = 0; i < rounds(1000, 100); ++i) {
        const Scene scene = crossing_scene(random);
        Settings settings = settings_of(scene, Hidden::warnock);
        settings.viewport = {64, 48};
        settings.camera.focal_length = 50.0f;
        cover_by_centres(settings);
        const Frame frame = prepare_frame(scene, settings);
        REQUIRE(frame.squares != nullptr);
        const Framebuffer drawn = draw_frame(frame);
        compare_squares_with_rays(frame, drawn, by_rays);
        settings.hidden = Hidden::depth_buffer;
        compare_pictures(drawn, draw_frame(prepare_frame(scene, settings)), by_buffer);
        CAPTURE(i);
        if (by_rays.wrong > 0) FAIL("rays: " << by_rays.first_wrong);
        if (by_buffer.wrong > 0) FAIL("buffer: " << by_buffer.first_wrong);
    }
    CAPTURE(by_rays.compared, by_rays.ties, by_buffer.compared, by_buffer.ties);
    CHECK(2 * by_rays.compared > by_buffer.compared);
    CHECK(1000 * by_rays.ties < by_rays.compared);
    CHECK(1000 * by_buffer.ties < by_buffer.compared);
}

TEST_CASE("Squares are nested, cover the picture once, and each has its reason") {
    std::array<int, enum_words<SquareReason>.size()> seen{};
    with_small_frames(82, 400, 40, [&](Random&, const Frame& frame, const std::vector<Cursor>&) {
        const Viewport size = frame.settings.viewport;
        check_nesting(*frame.squares, {0, 0, size.width, size.height});
        Settings settings = frame.settings;
        settings.hidden = Hidden::depth_buffer;
        const Frame buffer = prepare_frame(*frame.given, settings);
        std::vector<std::vector<double>> depths;
        for (int t = 0; t < buffer.triangle_count(); ++t)
            depths.push_back(lone_depths(buffer, t));
        for (const WarnockSquare& square : frame.squares->squares) {
            check_reason(square, check_pixels(depths, square.pixels, size.width));
            ++seen[static_cast<std::size_t>(square.reason)];
        }
    });
    for (const int count : seen)
        CHECK(count > 0);
}

TEST_CASE("Every square reached forward, backward or at random is as if drawn from the start") {
    with_small_frames(83, 60, 8, [](Random& random, const Frame& frame, const auto& moments) {
        std::vector<Framebuffer> expected;
        for (const Cursor& cursor : moments)
            expected.push_back(drawn_to(frame, cursor));
        Replay replay;
        replay.begin(frame);
        const auto require_at = [&](std::size_t i) {
            CAPTURE(to_text(moments[i]));
            require_same(expected[i], replay.at(moments[i]));
        };
        const std::size_t count = moments.size();
        for (std::size_t i = 0; i < count; ++i)
            require_at(i);
        Framebuffer planes;
        clear(planes, frame);
        CHECK(replay.tally() == draw(frame, {}, planes));
        for (std::size_t i = count; i-- > 0;)
            require_at(i);
        for (int jump = 0; jump < 40; ++jump)
            require_at(static_cast<std::size_t>(random.integer(0, static_cast<int>(count) - 1)));
    });
}

TEST_CASE("A large frame of squares is drawn in parts and sought in any order") {
    const Scene room = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    const Frame frame = prepare_frame(room, settings_of(room, Hidden::warnock));
    REQUIRE(frame.squares != nullptr);
    Replay replay;
    replay.begin(frame);
    const WorkLimit limit{.at_once = 10'000, .slice = 10'000};
    int parts = 0;
    for (; !replay.is_at(cursor_end); ++parts)
        replay.toward(cursor_end, limit);
    CHECK(parts > 10);
    require_same(draw_frame(frame), replay.at(cursor_end));
    Random random(84);
    for (int i = 0; i < rounds(100, 10); ++i) {
        const Cursor cursor = moment_of_square(random.integer(0, frame.squares->count() - 1));
        require_same(drawn_to(frame, cursor), replay.at(cursor));
    }
    Framebuffer planes;
    clear(planes, frame);
    CHECK(replay.tally() == draw(frame, {}, planes));
}

TEST_CASE("The fragments of squares come in order, each in its square, however time is cut") {
    with_small_frames(85, 100, 10, [](Random& random, const Frame& frame, const auto&) {
        std::vector<FragmentEvent> whole;
        const Observer keep{.fragment = [&](const auto& event) { whole.push_back(event); }};
        EventSource(frame).play({}, keep);
        for (std::size_t i = 0; i < whole.size(); ++i) {
            const FragmentEvent& event = whole[i];
            REQUIRE((i == 0 || whole[i - 1].cursor < event.cursor));
            const WarnockSquare& square = (*frame.squares)[event.cursor.square];
            REQUIRE(square.surface == event.cursor.triangle);
            REQUIRE(contains(square.pixels, event.fragment.column, event.fragment.row));
            REQUIRE(event.fate == Fate::written);
        }
        if (whole.empty()) return;
        for (int cut = 0; cut < 8; ++cut) {
            const auto at =
                static_cast<std::size_t>(random.integer(0, static_cast<int>(whole.size()) - 1));
            std::vector<Cursor> parts;
            const Observer note{
                .fragment = [&](const auto& event) { parts.push_back(event.cursor); }};
            const Cursor middle = whole[at].cursor;
            EventSource(frame).play({cursor_begin, middle, {}}, note);
            REQUIRE(parts.size() == at);
            EventSource(frame).play({middle, cursor_end, {}}, note);
            REQUIRE(parts.size() == whole.size());
            for (std::size_t i = 0; i < parts.size(); ++i)
                REQUIRE(parts[i] == whole[i].cursor);
        }
    });
}

TEST_CASE("Time runs through squares in both directions, by steps of every size") {
    with_small_frames(86, 100, 10, [](Random& random, const Frame& frame, const auto& moments) {
        const Timeline timeline(frame);
        const WarnockSquares& squares = *frame.squares;
        REQUIRE(timeline.first() == moment_of_square(0));
        for (const Granularity step :
             {Granularity::moment, Granularity::line, Granularity::triangle, Granularity::phase}) {
            for (const Cursor& cursor : moments) {
                const Cursor next = timeline.next(cursor, step);
                const Cursor back = timeline.previous(cursor, step);
                REQUIRE((next > cursor || cursor == cursor_end));
                REQUIRE((back < cursor || cursor == moments.front()));
                REQUIRE(timeline.exists(next));
                REQUIRE(timeline.exists(back));
                // Many steps at once are as many single ones.
                Cursor stepped = cursor;
                const int count = random.integer(0, 6);
                for (int i = 0; i < count; ++i)
                    stepped = timeline.next(stepped, step);
                REQUIRE(advance(timeline, cursor, count, step) == stepped);
            }
        }
        for (std::size_t i = 0; i + 1 < moments.size(); ++i) {
            const Cursor& cursor = moments[i];
            REQUIRE(timeline.next(cursor, Granularity::moment) == moments[i + 1]);
            REQUIRE(timeline.previous(moments[i + 1], Granularity::moment) == cursor);
            REQUIRE(timeline.at_place(timeline.place(cursor)) == cursor);
            const int n = cursor.square;
            const WarnockSquare& square = squares[n];
            const auto at = [&](int number) { return cursor_at_square(squares, number); };
            if (square.depth == 0) continue;
            REQUIRE(timeline.next(cursor, Granularity::line) == at(squares.after(n)));
            const int quarter = enclosing_square(squares, n, 1);
            REQUIRE(timeline.next(cursor, Granularity::triangle) == at(squares.after(quarter)));
            const int outer = square.depth > 1 ? square.parent : n;
            REQUIRE(timeline.next(cursor, Granularity::phase) == at(squares.after(outer)));
            if (square.depth > 1)
                REQUIRE(timeline.previous(cursor, Granularity::phase) == at(square.parent));
            // Back over a whole square is the opposite of forward.
            if (squares.after(n) < squares.count() &&
                squares[squares.after(n)].parent == square.parent)
                REQUIRE(timeline.previous(at(squares.after(n)), Granularity::line) == cursor);
        }
        REQUIRE(timeline.at_place(1.0) == cursor_end);
        const FrameLength length = frame_length(timeline);
        REQUIRE(length.triangles == 1);
        REQUIRE(length.of(Granularity::moment) == static_cast<double>(squares.count()));
        REQUIRE(run_on(timeline, {moments.front(), 0.0}, 1.0, Granularity::moment).cursor ==
                cursor_end);
    });
}

TEST_CASE("Any cursor stands at a square, or at the end") {
    with_small_frames(87, 60, 8, [](Random& random, const Frame& frame, const auto&) {
        const Timeline timeline(frame);
        const int count = frame.squares->count();
        for (int i = 0; i < 50; ++i) {
            Cursor cursor = any_cursor(random, frame.triangle_count());
            CHECK(timeline.at_or_after(cursor) == moment_of_square(0));
            cursor.square = random.integer(0, count + 1);
            CHECK(timeline.at_or_after(cursor) ==
                  (cursor.square < count ? moment_of_square(cursor.square) : cursor_end));
            CHECK(to_text(*parse_cursor(to_text(cursor))) == to_text(cursor));
        }
        for (int t = 0; t < frame.triangle_count(); ++t)
            CHECK(timeline.moments(t).count == 0);
        Settings settings = frame.settings;
        settings.hidden = Hidden::depth_buffer;
        const Frame other = prepare_frame(*frame.given, settings);
        CHECK(other.squares == nullptr);
        CHECK(Timeline(other).at_or_after(moment_of_square(0)) == cursor_end);
        CHECK_FALSE(have_same_moments(frame, other));
    });
}

TEST_CASE("A square is written w12, and a fragment in it w12/t3/r37/c5") {
    CHECK(to_text(moment_of_square(12)) == "w12");
    CHECK(parse_cursor("w12") == moment_of_square(12));
    const Cursor fragment{3, Phase::rows, 37, 5, 0, 12};
    CHECK(to_text(fragment) == "w12/t3/r37/c5");
    CHECK(parse_cursor("w12/t3/r37/c5") == fragment);
    CHECK(short_place(moment_of_square(12)) == "w12");
    CHECK(short_place(fragment) == "r37 [5]");
    for (const char* const text : {"w", "w-1", "w12/", "w12/r3", "w1t2", "w12/w3", "12"})
        CHECK_FALSE(parse_cursor(text).has_value());
    CHECK(moment_of_square(12) < fragment);
    CHECK(fragment < moment_of_square(13));
    CHECK(cursor_begin < moment_of_square(0));
    CHECK(moment_of_square(1 << 30) < cursor_end);
}

TEST_CASE("Squares do not depend on how many parts the frame is prepared in") {
    const Scene room = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    const Settings settings = settings_of(room, Hidden::warnock);
    const Frame whole = prepare_frame(room, settings);
    Frame frame;
    FramePreparation preparation = begin_frame(room, settings, nullptr, frame);
    int parts = 0;
    for (; !preparation.is_done(); ++parts)
        preparation.advance({.at_once = 1'000.0, .slice = 1'000.0});
    CHECK(parts > 10);
    CHECK(frame.squares->squares == whole.squares->squares);
    CHECK(frame.squares->comparisons == whole.squares->comparisons);
    require_same(draw_frame(frame), draw_frame(whole));
}

TEST_CASE("Before stage depth, and in a scene in pixels, nothing is divided") {
    const Scene room = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    Settings settings = settings_of(room, Hidden::warnock);
    set_step(settings, {Stage::fill});
    CHECK(prepare_frame(room, settings).squares == nullptr);
    const Scene pixels = small_scene();
    CHECK(prepare_frame(pixels, settings_of(pixels, Hidden::warnock)).squares == nullptr);
}
