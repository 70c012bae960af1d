#include "session/depth_view.h"

#include <algorithm>
#include <numeric>

#include <cstdlib>
#include <sstream>
#include <string>

#include "picture/colour_map.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "session/results.h"
#include "settings/setting_table.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Session depth_session() {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    session.a.settings.stage = Stage::depth;
    session.view = View::depth;
    return session;
}

glm::vec<3, std::uint8_t> colour_at(const Image& image, std::size_t pixel) {
    return {image.rgba[4 * pixel], image.rgba[4 * pixel + 1], image.rgba[4 * pixel + 2]};
}

} // namespace

TEST_CASE("Without a set range the depth view goes from the smallest to the largest 1/z") {
    const Session session = depth_session();
    Results results;
    update(session, results);
    REQUIRE(results.depth);
    float smallest = 1e9f, largest = 0.0f;
    for (const float depth : results.a.framebuffer->depth) {
        if (depth > 0.0f) smallest = std::min(smallest, depth);
        largest = std::max(largest, depth);
    }
    CHECK(results.depth->range == DepthRange{smallest, largest});
    CHECK(results.depth->nearer == 0);
    CHECK(results.depth->farther == 0);
    CHECK(results.a.picture == view_image(*results.a.framebuffer, View::depth));
}

TEST_CASE("What lies outside the range takes the colour of its end") {
    Session session = depth_session();
    session.depth_range = DepthInterval{0.28f, 0.36f};
    Results results;
    update(session, results);
    std::int64_t nearer = 0, farther = 0;
    for (std::size_t i = 0; i < results.a.framebuffer->depth.size(); ++i) {
        const float depth = results.a.framebuffer->depth[i];
        const auto colour = colour_at(results.a.picture, i);
        INFO("pixel " << i << ", 1/z " << depth);
        if (!(depth > 0.0f)) {
            REQUIRE(colour == glm::vec<3, std::uint8_t>(0));
        } else if (depth < 0.28f) {
            ++farther;
            REQUIRE(colour == viridis(0.0f));
        } else if (depth > 0.36f) {
            ++nearer;
            REQUIRE(colour == viridis(1.0f));
        } else {
            REQUIRE(colour == viridis((depth - 0.28f) / (0.36f - 0.28f)));
        }
    }
    CHECK(nearer > 1000);
    CHECK(farther > 1000);
    CHECK(results.depth->nearer == nearer);
    CHECK(results.depth->farther == farther);
}

TEST_CASE("Every pixel with a depth is in the histogram once, in its own bin") {
    const Session session = depth_session();
    Results results;
    update(session, results);
    const DepthHistogram& histogram = results.depth->histogram;
    CHECK(std::accumulate(histogram.bins.begin(), histogram.bins.end(), std::int64_t{0}) ==
          results.depth->drawn);
    CHECK(results.depth->drawn == 250'000 - 998);
    const double width = (static_cast<double>(histogram.axis.near) - histogram.axis.far) /
                         static_cast<double>(depth_bins);
    std::vector<std::int64_t> expected(depth_bins, 0);
    for (const float depth : results.a.framebuffer->depth) {
        if (depth > 0.0f)
            ++expected[static_cast<std::size_t>((depth - histogram.axis.far) / width)];
    }
    std::int64_t strays = 0;
    for (std::size_t b = 0; b < depth_bins; ++b)
        strays += std::abs(expected[b] - histogram.bins[b]);
    // Those on the border of two bins can be rounded to either.
    CHECK(strays <= 20);
}

TEST_CASE("One large wall does not press all other bars of the histogram flat") {
    const Session session = depth_session();
    Results results;
    update(session, results);
    const DepthHistogram& histogram = results.depth->histogram;
    const auto largest = *std::max_element(histogram.bins.begin(), histogram.bins.end());
    CHECK(largest > 5 * histogram.full); // the back wall
    int cut = 0, low = 0;
    for (const std::int64_t pixels : histogram.bins) {
        cut += pixels > histogram.full ? 1 : 0;
        low += 10 * pixels < histogram.full ? 1 : 0;
    }
    CHECK(cut < 8);
    CHECK(low < depth_bins / 4);
}

TEST_CASE("A range stays as it was set while the picture changes") {
    Session session = depth_session();
    session.depth_range = DepthInterval{0.3f, 0.4f};
    Results results;
    update(session, results);
    const std::uint64_t number = results.a.picture_number;
    session.cursor = Cursor{2, Phase::vertices, 0, 0};
    update(session, results);
    CHECK(results.depth->range == DepthRange{0.3f, 0.4f});
    CHECK(results.a.picture_number == number + 1);
    session.depth_range = std::nullopt;
    update(session, results);
    CHECK(results.a.picture_number == number + 2);
    CHECK(results.depth->range == *results.depth->present);
}

TEST_CASE("The ends of the range never cross, wherever they are dragged") {
    Session session = depth_session();
    Results results;
    for (const float value : {-5.0f, 0.0f, 0.25f, 0.33f, 0.499f, 0.6f, 1e9f}) {
        for (const bool is_near : {false, true}) {
            update(session, results);
            (is_near ? set_near : set_far)(session, *results.depth, value);
            INFO((is_near ? "near to " : "far to ") << value);
            REQUIRE(session.depth_range);
            CHECK(session.depth_range->smallest >= 0.0f);
            CHECK(session.depth_range->largest > session.depth_range->smallest);
        }
    }
    session.depth_range = std::nullopt;
    update(session, results);
    set_far(session, *results.depth, 0.3f);
    CHECK(session.depth_range == DepthInterval{0.3f, results.depth->present->near});
}

TEST_CASE("Before anything has a depth the view is empty and still has an axis") {
    Session session = depth_session();
    session.cursor = cursor_begin;
    Results results;
    update(session, results);
    CHECK_FALSE(results.depth->present);
    CHECK(results.depth->drawn == 0);
    CHECK(results.depth->histogram.full == 1);
    CHECK(results.depth->histogram.axis.near > results.depth->histogram.axis.far);
    set_near(session, *results.depth, 0.5f);
    CHECK(session.depth_range->largest > session.depth_range->smallest);
}

TEST_CASE("Other views have no depth view next to them") {
    Session session = depth_session();
    Results results;
    update(session, results);
    session.view = View::colour;
    update(session, results);
    CHECK_FALSE(results.depth);
}

TEST_CASE("A stored depth shows how far in front of the camera its vertex is") {
    Session session = depth_session();
    const Scene room = read_scene(lessons_folder() + "/scenes/lab-room.toml");
    struct Choice {
        const char* text;
        const char* name;
    };
    for (const Choice& choice :
         {Choice{"projection_mix=0", "1/z"}, Choice{"depth_format=reversed_32", "reversed z"},
          Choice{"depth_format=ndc_32", "NDC z"}, Choice{"projection_mix=0.4", "reversed z"},
          Choice{"projection=orthographic", "reversed z"},
          Choice{"depth_format=ndc_32 projection_mix=0.4", "NDC z"},
          Choice{"depth_format=ndc_32 projection=orthographic", "NDC z"}}) {
        Settings settings = session.a.settings;
        std::istringstream words(choice.text);
        for (std::string word; words >> word;)
            set_from_text(settings, word);
        const Frame frame = prepare_frame(room, settings);
        CAPTURE(choice.text);
        CHECK(depth_words(frame).name == choice.name);
        for (int t = 0; t < room.triangle_count(); ++t) {
            for (int v = 0; v < 3; ++v) {
                // The camera of the room is not turned.
                const float z = room.corner(t, v).position.z - settings.camera.position.z;
                const float depth = frame.triangle_vertices(t)[static_cast<std::size_t>(v)].depth;
                CHECK(z_of_stored_depth(frame, depth) == Approx(z).epsilon(1e-4));
            }
        }
    }
}

TEST_CASE("Under ndc z the far end of the range is the larger one, and near is still bright") {
    Session session = depth_session();
    Results results;
    update(session, results);
    REQUIRE(results.depth);
    const DepthView by_inv_z = *results.depth;
    const Image usual = results.a.picture;
    set_from_text(session.a.settings, "depth_format=ndc_32");
    update(session, results);
    REQUIRE(results.depth);
    REQUIRE(results.depth->present);
    const DepthView view = *results.depth;
    CHECK(view.drawn == by_inv_z.drawn);
    CHECK(view.range.far > view.range.near);
    CHECK(view.histogram.axis.far > view.histogram.axis.near);
    CHECK(view.farther + view.nearer == 0);
    const Frame& frame = results.a.frame;
    CHECK(z_of_stored_depth(frame, view.range.far) ==
          Approx(1.0 / static_cast<double>(by_inv_z.range.far)).epsilon(1e-3));
    CHECK(z_of_stored_depth(frame, view.range.near) ==
          Approx(1.0 / static_cast<double>(by_inv_z.range.near)).epsilon(1e-3));
    // Ndc z is a straight line of 1/z: the colours are those of 1/z, but for rounding and ties.
    REQUIRE(results.a.picture.rgba.size() == usual.rgba.size());
    int others = 0;
    for (std::size_t i = 0; i < usual.rgba.size(); ++i)
        others += std::abs(int{usual.rgba[i]} - int{results.a.picture.rgba[i]}) > 3 ? 1 : 0;
    CAPTURE(others);
    CHECK(others < 400);
    // The ends are dragged the way they are drawn, and written down with the smaller one first.
    set_far(session, view, view.range.far - 0.001f);
    REQUIRE(session.depth_range);
    CHECK(session.depth_range->smallest < session.depth_range->largest);
    update(session, results);
    CHECK(results.depth->range.far == Approx(view.range.far - 0.001f));
    CHECK(results.depth->range.near == view.range.near);
    CHECK(results.depth->farther > 0);
    CHECK(results.depth->nearer == 0);
    set_near(session, *results.depth, 2.0f); // beyond the far end: it keeps its distance
    update(session, results);
    CHECK(results.depth->range.near < results.depth->range.far);
    CHECK(parse_depth_range(to_text(*session.depth_range)) == session.depth_range);
}
