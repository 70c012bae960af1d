#include "inspect/row_graph.h"

#include <algorithm>
#include <cmath>

#include "pipeline/draw.h"
#include "support/bits.h"
#include "support/random.h"
#include "support/recorder.h"
#include "support/samples.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using rasterwalk::test::same_bits;

TEST_CASE("A row's graph has the numbers that are drawn, under either interpolation") {
    const Scene room = test::lab_room();
    int fragments = 0, empty_pictures = 0;
    for (const test::Variant& variant : test::rule_variants()) {
        Settings settings = default_settings(room);
        set_step(settings, StripStep::vertex_light);
        variant.apply(settings);
        // Among squares a row has no moments to be drawn by; its graph is that of the triangle.
        if (hidden_rule(settings) == Hidden::warnock) settings.hidden = Hidden::depth_buffer;
        const Frame frame = prepare_frame(room, settings);
        // Rules chosen at random can leave no triangle in the picture.
        const int count = frame.triangle_count();
        auto t = static_cast<int>(&variant - test::rule_variants().data()) % count;
        int tried = 0;
        // Nor need any of its rows be.
        const auto has_row = [&] { return frame.is_drawn(t) && widest_row(frame, t); };
        for (; tried < count && !has_row(); ++tried)
            t = (t + 1) % count;
        if (tried == count) {
            ++empty_pictures;
            continue;
        }
        const std::optional<int> index = widest_row(frame, t);
        INFO(variant.name << ", triangle " << t);
        REQUIRE(index);
        const std::optional<RowGraph> graph = row_graph(frame, t, *index);
        REQUIRE(graph);
        Framebuffer framebuffer;
        clear(framebuffer, frame);
        test::Recorder recorder;
        draw(frame, {{t, Phase::rows, *index, 0}, {t, Phase::rows, *index + 1, 0}, {}}, framebuffer,
             &recorder);
        const int end = graph->first_column + frame.stages.drawn_pixels(graph->count());
        REQUIRE(static_cast<int>(recorder.fragments.size()) ==
                std::min(end, settings.viewport.width) - std::max(graph->first_column, 0));
        for (const FragmentEvent& event : recorder.fragments) {
            const Fragment& shown = graph->at(settings.interpolation, event.cursor.step);
            if (!same_bits(shown, event.fragment)) {
                FAIL(variant.name << ": " << to_text(event.cursor) << " differs");
            }
            ++fragments;
        }
    }
    CHECK(fragments > 500);
    CHECK(empty_pictures < 5);
}

TEST_CASE("The values carried along a row are straight lines, and the truth is their quotient") {
    const Scene room = test::lab_room();
    const Frame frame = prepare_frame(room, default_settings(room));
    const std::optional<RowGraph> graph = row_graph(frame, 6, *widest_row(frame, 6));
    REQUIRE(graph);
    const int last = graph->count() - 1;
    for (const QuantityInfo& info : quantity_list()) {
        const Quantity q = info.quantity;
        const float a = carried_value(*graph, q, 0), b = carried_value(*graph, q, last);
        for (int i = 0; i <= last; ++i) {
            INFO(info.words.name << " at index " << i);
            const float line = a + (b - a) * static_cast<float>(i) / static_cast<float>(last);
            CHECK(carried_value(*graph, q, i) == Approx(line).margin(2e-5));
            const float zinv = true_value(*graph, Quantity::zinv, i);
            if (is_varying(q)) {
                CHECK(true_value(*graph, q, i) == carried_value(*graph, q, i) / zinv);
            }
        }
        // Chord and truth meet at the ends.
        CHECK(affine_value(*graph, q, 0) == Approx(true_value(*graph, q, 0)).margin(0.01));
        CHECK(affine_value(*graph, q, last) == Approx(true_value(*graph, q, last)).margin(0.01));
    }
    // The floor's nearest row is at a single depth, so nothing there is wrong. The side wall's rows
    // run into the depth.
    const std::optional<RowGraph> wall = row_graph(frame, 2, *widest_row(frame, 2));
    REQUIRE(wall);
    const int worst = worst_index(*wall, quantity_of(&Varyings::position_world, 2));
    CHECK(worst > 0);
    CHECK(worst < wall->count() - 1);
    CHECK(std::abs(affine_value(*wall, quantity_of(&Varyings::position_world, 2), worst) -
                   true_value(*wall, quantity_of(&Varyings::position_world, 2), worst)) > 0.1f);
}

TEST_CASE("The widest row is the one with the most pixels in the picture") {
    const Scene room = test::lab_room();
    Settings settings = default_settings(room);
    settings.camera = {{0.1f, 0.2f, -1.6f}, 0.05f, -0.1f, 260.0f};
    settings.viewport = {300, 280};
    const Frame frame = prepare_frame(room, settings);
    for (int t = 0; t < frame.triangle_count(); ++t) {
        if (!frame.is_drawn(t)) continue;
        PolygonRows rows;
        test::compute_polygon_rows(frame.triangle_vertices(t), settings, rows);
        std::vector<int> seen(rows.left.size(), 0);
        int most = 0;
        for (std::size_t r = 0; r < seen.size(); ++r) {
            for (int c = rows.left[r].column; c <= rows.right[r].column; ++c) {
                const int y = rows.first_row + static_cast<int>(r);
                if (c >= 0 && c < 300 && y >= 0 && y < 280) ++seen[r];
            }
            most = std::max(most, seen[r]);
        }
        INFO("triangle " << t);
        const std::optional<int> widest = widest_row(frame, t);
        REQUIRE(widest.has_value() == (most > 0));
        if (widest) CHECK(seen[static_cast<std::size_t>(*widest)] == most);
    }
}

TEST_CASE("A row that is empty or does not exist has no graph") {
    const Scene scene = test::small_scene();
    const Frame frame = prepare_frame(scene, default_settings(scene));
    CHECK_FALSE(row_graph(frame, 0, -1));
    CHECK_FALSE(row_graph(frame, 0, 1000));
    CHECK(row_graph(frame, 0, 0));
    const std::optional<RowGraph> point = row_graph(frame, 4, 0);
    REQUIRE(point);
    CHECK(point->count() == 1);
    CHECK(worst_index(*point, quantity_of(&Varyings::position_world, 0)) == 0);
}

TEST_CASE("Ticks are round, evenly spaced, in the range, and no more than asked for") {
    test::Random random(3);
    for (int i = 0; i < 5000; ++i) {
        const double low = random.real(-10.0, 10.0) * std::pow(10.0, random.integer(-5, 5));
        const double width = random.real(0.1, 10.0) * std::pow(10.0, random.integer(-5, 5));
        const Interval range{low, low + width};
        const int most = random.integer(2, 9);
        const Ticks ticks = nice_ticks(range, most);
        INFO(low << " to " << low + width << ", at most " << most);
        REQUIRE(static_cast<int>(ticks.places.size()) <= most);
        // Steps of 1, 2, 5 lose at most a factor of 2.5.
        REQUIRE(static_cast<double>(ticks.places.size()) > 0.4 * most - 1.0);
        for (std::size_t k = 0; k < ticks.places.size(); ++k) {
            const double slack = 1e-9 * std::max(std::abs(low), width);
            REQUIRE(ticks.places[k] >= range.low - slack);
            REQUIRE(ticks.places[k] <= range.high + slack);
            const double scaled = ticks.places[k] * std::pow(10.0, ticks.digits);
            REQUIRE(scaled == Approx(std::round(scaled)).margin(1e-6));
        }
        if (ticks.places.size() < 3) continue;
        const double step = ticks.places[1] - ticks.places[0];
        const double slack = 1e-9 * std::max(std::abs(low), width);
        REQUIRE(ticks.places[2] - ticks.places[1] == Approx(step).margin(slack));
    }
    CHECK(nice_ticks({0.0, 10.0}, 6).places == std::vector<double>{0, 2, 4, 6, 8, 10});
    CHECK(nice_ticks({0.0, 1.0}, 6).digits == 1);
    CHECK(nice_ticks({0.0, 250.0}, 6).places == std::vector<double>{0, 50, 100, 150, 200, 250});
    CHECK(nice_ticks({3.0, 3.0}, 5).places.empty());
    CHECK(nice_ticks({0.0, INFINITY}, 5).places.empty());
    CHECK(nice_ticks({NAN, 1.0}, 5).places.empty());
    CHECK(nice_ticks({1e20, 1.0000000000000001e20}, 5).places.empty());
}

TEST_CASE("An axis gets a margin, and a constant line is in its middle") {
    const Interval wide = with_margin({0.0, 10.0}, 0.1);
    CHECK(wide.low == Approx(-1.0));
    CHECK(wide.high == Approx(11.0));
    const Interval flat = with_margin({5.0, 5.0}, 0.1);
    CHECK(flat.low < 5.0);
    CHECK(flat.high - 5.0 == Approx(5.0 - flat.low));
    const Interval zero = with_margin({0.0, 0.0}, 0.1);
    CHECK(zero.low < 0.0);
    CHECK(zero.high > 0.0);
}
