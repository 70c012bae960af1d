// The predictions and the figures of lesson 25, found a second time: the fragments of a picture are
// gathered, and this file decides in double which is nearer by more than epsilon.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/files.h"
#include "pipeline/draw.h"
#include "pipeline/observer.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/prediction_checks.h"
#include "support/questions.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace z_fighting {

/// All fragments of a picture, by pixel, in the order of drawing: triangle and depth.
struct Gathered {
    Gathered(const std::string& name, std::initializer_list<const char*> set)
        : scene(read_scene(lessons_folder() + "/scenes/" + name + ".toml")) {
        Settings settings = default_settings(scene);
        set_from_text(settings, "stage=depth");
        for (const char* text : set)
            set_from_text(settings, text);
        const Frame frame = prepare_frame(scene, settings);
        Framebuffer picture;
        clear(picture, frame);
        width = picture.size.width;
        pixels.resize(picture.owner.size());
        smaller_is_nearer = clip_depth_rule(settings, scene.space) == ClipDepth::ndc;
        const Observer gather{.fragment = [&](const FragmentEvent& event) {
            pixels[static_cast<std::size_t>(event.fragment.row * width + event.fragment.column)]
                .emplace_back(event.cursor.triangle, static_cast<double>(event.depth));
        }};
        draw(frame, {}, picture, &gather);
    }
    /// The part that each pixel shows with this epsilon; -1: none. What a fragment must beat is
    /// rounded to a float, as in the buffer, or is the exact sum.
    std::vector<int> parts(double epsilon, bool is_rounded = true) const {
        const double given =
            is_rounded ? static_cast<double>(static_cast<float>(epsilon)) : epsilon;
        std::vector<int> shown;
        for (const auto& fragments : pixels) {
            int part = -1;
            double stored = smaller_is_nearer ? 1.0 : 0.0;
            for (const auto& [triangle, depth] : fragments) {
                double limit = smaller_is_nearer ? stored - given : stored + given;
                if (is_rounded) limit = static_cast<double>(static_cast<float>(limit));
                if (smaller_is_nearer ? depth >= limit : depth <= limit) continue;
                stored = depth;
                part = part_of(scene, triangle);
            }
            shown.push_back(part);
        }
        return shown;
    }
    int count(const std::vector<int>& shown, int part, int column, int first, int last) const {
        int sum = 0;
        for (int row = first; row <= last; ++row)
            sum += shown[static_cast<std::size_t>(row * width + column)] == part ? 1 : 0;
        return sum;
    }
    Scene scene;
    bool smaller_is_nearer = false;
    int width = 0;
    std::vector<std::vector<std::pair<int, double>>> pixels;
};

std::string lesson_text() {
    return read_file(lessons_folder() + "/25-z-fighting.md");
}

constexpr int left_wall = 1, ceiling = 3, back_wall = 4;           // of the room
constexpr int decal = 0, poster = 2;                               // of the paper on the wall
constexpr int corner = 126, corner_top = 126, corner_bottom = 373; // of the room's picture

PREDICTIONS_TEST("Lesson 25: crumbs with and without an epsilon", "25-z-fighting", "crumbs-left",
                 "others-too") {
    const Gathered room("lab-room", {});
    const std::vector<int> plain = room.parts(0.0), one = room.parts(1e-6),
                           more = room.parts(1.1e-6), two = room.parts(2e-6);
    const auto crumbs = [&](const std::vector<int>& shown) {
        return room.count(shown, back_wall, corner, corner_top, corner_bottom);
    };
    const auto changed = [&](const std::vector<int>& now, bool outside_corner) {
        int sum = 0;
        for (std::size_t i = 0; i < now.size(); ++i) {
            const bool counts = !outside_corner || static_cast<int>(i) % room.width != corner;
            sum += counts && now[i] != plain[i] ? 1 : 0;
        }
        return sum;
    };
    CHECK(crumbs(plain) == 134);
    CHECK(room.count(plain, ceiling, corner, corner_top, corner_bottom) == 1);
    CHECK(room.count(plain, left_wall, corner, 0, 499) == 248 - 135);
    CHECK(crumbs(one) == 1);
    CHECK(room.count(one, left_wall, corner, 0, 499) == 248 - 1);
    CHECK(crumbs(more) == 0);
    CHECK(crumbs(two) == 0);
    CHECK(changed(one, false) == 158);
    CHECK(changed(two, false) == 325);
    CHECK(changed(one, true) == 24);
    CHECK(changed(two, true) == 190);
    // Exact sums would give three pixels fewer: their margins are within the rounding.
    const std::vector<int> by_sums = room.parts(1e-6, false);
    int on_the_limit = 0;
    for (std::size_t i = 0; i < by_sums.size(); ++i)
        on_the_limit += one[i] != by_sums[i] ? 1 : 0;
    CHECK(on_the_limit == 3);
    CHECK(room.count(two, left_wall, corner, 0, 499) == 248);
    const Gathered exact("lab-room", {"line_walk=exact"});
    CHECK(exact.count(exact.parts(0.0), back_wall, corner, corner_top, corner_bottom) == 38);

    const Questions lesson("25-z-fighting");
    lesson.require_number("crumbs-left", crumbs(one), 0.0, 67.0);
    CHECK_FALSE(lesson.answered("crumbs-left", {135.0}).is_right);
    lesson.require_choice("others-too", 1);
    const std::string said = lesson_text();
    for (const char* figure :
         {"took 134 pixels of it, and the ceiling one", "134 of the 135 crumbs",
          "With 0.000002, 325 pixels change", "has 38 crumbs, not 135"}) {
        INFO(figure);
        CHECK(said.find(figure) != std::string::npos);
    }
}

PREDICTIONS_TEST("Lesson 25: the steps of sixteen bits, and reversed z", "25-z-fighting",
                 "far-away", "step-at-two", "double-near", "reversed") {
    const Questions lesson("25-z-fighting");
    // The depth at which 1/z is larger by a millionth, not by the formula.
    const double hidden = 400.0 - 1.0 / (1.0 / 400.0 + 1e-6);
    for (const double wrong : {0.0016, 0.000016})
        lesson.require_number("far-away", hidden, 1e-4, wrong);
    CHECK(4.0 - 1.0 / (1.0 / 4.0 + 1e-6) == Approx(0.000016).margin(1e-9));

    // How far z advances while NDC z grows by one step, from the inverted formula.
    const auto step_at = [](double z, double near) {
        const double far = 100.0, ndc = far / (far - near) * (1.0 - near / z);
        const auto z_of = [&](double depth) { return near / (1.0 - depth * (far - near) / far); };
        return z_of(ndc + 1.0 / 65535.0) - z_of(ndc);
    };
    CHECK(step_at(4.0, 0.1) == Approx(0.0024).margin(0.00005));
    for (const double wrong : {0.0012, 0.0024, 0.0048})
        lesson.require_number("step-at-two", step_at(2.0, 0.1), 2e-6, wrong);
    lesson.require_number("double-near", step_at(4.0, 0.2), 2e-6, step_at(4.0, 0.1));
    // Seen from two units nearer, no fragment of the poster loses.
    const Gathered nearer("z-fighting", {"depth_format=ndc_16", "camera.position=0,0,2"});
    const std::vector<int> seen = nearer.parts(0.0);
    int of_poster = 0, lost = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        for (const auto& [triangle, depth] : nearer.pixels[i]) {
            if (part_of(nearer.scene, triangle) != poster) continue;
            ++of_poster;
            lost += seen[i] == poster ? 0 : 1;
        }
    }
    CHECK(of_poster > 1000);
    CHECK(lost == 0);

    const Gathered sixteen("z-fighting", {"depth_format=ndc_16"});
    CHECK(sixteen.count(sixteen.parts(0.0), poster, 60, 0, 149) == 27);
    const Gathered apart("z-fighting", {"depth_format=ndc_16", "near=0.3"});
    CHECK(apart.count(apart.parts(0.0), poster, 60, 0, 149) == 70);
    const Gathered nearly("z-fighting", {"depth_format=ndc_16", "near=0.25"});
    CHECK(nearly.count(nearly.parts(0.0), poster, 60, 0, 149) == 69);
    for (const double wrong : {0.0024, 0.0048})
        CHECK_FALSE(lesson.answered("double-near", {wrong}).is_right);
    const Gathered torn("z-fighting", {"depth_format=ndc_32"});
    CHECK(torn.count(torn.parts(0.0), decal, 150, 0, 149) == 62);
    CHECK(torn.count(torn.parts(1.4e-6), decal, 150, 0, 149) == 69);
    CHECK(torn.count(torn.parts(1.5e-6), decal, 150, 0, 149) == 70);
    const Gathered bits("z-fighting", {"depth_format=ndc_24"});
    CHECK(bits.parts(0.0) == torn.parts(0.0));
    // With near at 0.01 the poster is torn in the column of the question, until depth is reversed.
    // The buffer's bits are not the reason: the sums near 1 drift.
    const auto poster_of = [](const char* format, const char* walk = "line_walk=accumulate") {
        const Gathered paper("z-fighting", {"near=0.01", format, walk});
        return paper.count(paper.parts(0.0), poster, 60, 0, 149);
    };
    CHECK(poster_of("depth_format=ndc_32") == 5);
    CHECK(poster_of("depth_format=ndc_24") == 5);
    CHECK(poster_of("depth_format=ndc_32", "line_walk=multiply") == 70);
    CHECK(poster_of("depth_format=reversed_24") == 70);
    CHECK(poster_of("depth_format=inv_z") == 70);
    CHECK(poster_of("depth_format=reversed_32") == 70);
    lesson.require_choice("reversed", 2);
    // The decal has no lead: seen from the side it is torn in every format.
    for (const char* format :
         {"depth_format=ndc_24", "depth_format=ndc_32", "depth_format=reversed_24",
          "depth_format=reversed_32", "depth_format=inv_z"}) {
        const Gathered turned("z-fighting", {"near=0.01", "camera.yaw=0.2", format});
        const auto pieces = [&](double epsilon) {
            int sum = 0;
            for (const int part : turned.parts(epsilon))
                sum += part == decal ? 1 : 0;
            return sum;
        };
        INFO(format);
        CHECK(pieces(0.0) < 2000);
        CHECK(pieces(1e-4) > 3000);
    }
    // The floats of the text: below 1, and at the depth of the wall.
    const double ndc = 100.0 / 99.99 * (1.0 - 0.01 / 4.0);
    CHECK(ndc == Approx(0.9976).margin(5e-5));
    const double below_one = 1.0 - static_cast<double>(std::nextafter(1.0f, 0.0f));
    CHECK(below_one == Approx(6e-8).epsilon(0.01));
    const float small = static_cast<float>(1.0 - ndc);
    CHECK(small == Approx(0.0024f).margin(5e-5f));
    CHECK(below_one ==
          256.0 * (static_cast<double>(std::nextafter(small, 1.0f)) - static_cast<double>(small)));
    CHECK(0.001 * 0.01 / 16.0 == Approx(6e-7).epsilon(0.05)); // the poster's lead
}

} // namespace z_fighting
} // namespace

TEST_CASE("Mistake B61 takes the feet of the blocks, and nothing that stands free") {
    using namespace z_fighting;
    const Gathered room("lab-room", {});
    const std::vector<int> plain = room.parts(0.0), far_off = room.parts(0.05);
    int lost = 0, gained = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        lost += plain[i] >= 5 && far_off[i] < 5 ? 1 : 0;
        gained += plain[i] < 5 && far_off[i] >= 5 ? 1 : 0;
    }
    CHECK(lost > 1000);
    CHECK(gained == 0);
    // At z = 3 the epsilon is 0.39 units: 1/3 + 0.05 is the 1/z of 2.61. By the formula 0.45.
    CHECK(3.0 - 1.0 / (1.0 / 3.0 + 0.05) == Approx(0.39).margin(0.005));
    CHECK(0.05 * 3.0 * 3.0 == Approx(0.45));
}
