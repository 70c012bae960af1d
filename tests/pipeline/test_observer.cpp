#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "pipeline/draw.h"
#include "support/bits.h"
#include "support/cut_frames.h"
#include "support/effort.h"
#include "support/frames.h"
#include "support/moments.h"
#include "support/recorder.h"
#include "support/samples.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

TEST_CASE("An observer gets every moment in order, and changes no bit") {
    const auto check = [](const Frame& frame) {
        Recorder recorder(true);
        Framebuffer watched;
        clear(watched, frame);
        const DrawTally tally = draw(frame, {}, watched, &recorder);
        Framebuffer unwatched;
        clear(unwatched, frame);
        CHECK(draw(frame, {}, unwatched) == tally);
        require_same(unwatched, watched);
        CHECK(tally.fragments == static_cast<std::int64_t>(recorder.fragments.size()));
        const auto is_earlier = [](const auto& a, const auto& b) { return a.cursor < b.cursor; };
        const Stage stage = frame.settings.stage;
        if (has_fragments(stage)) {
            CHECK(std::is_sorted(recorder.fragments.begin(), recorder.fragments.end(), is_earlier));
        }
        CHECK(std::is_sorted(recorder.samples.begin(), recorder.samples.end(), is_earlier));
        // Vertices, clip steps, culling, samples, tests and fragments together are the moments, if
        // the stage is `edges` or later.
        const std::vector<Cursor> reported = recorded_moments(recorder, stage);
        std::vector<Cursor> expected = all_moments(frame);
        if (stage == Stage::rows) {
            std::erase_if(expected, [](const Cursor& c) { return c.phase == Phase::rows; });
        }
        REQUIRE(reported.size() == expected.size());
        for (std::size_t i = 0; i < reported.size(); ++i) {
            if (reported[i] != expected[i])
                FAIL(to_text(reported[i]) + " for " + to_text(expected[i]));
        }
    };
    for_each_frame(small_scene(), check);
    for_each_cut_frame(cut_scene(), 5, check);
}

TEST_CASE("A window reports only its own clip steps and culls") {
    const Scene scene = cut_scene();
    Random random(35);
    for_each_cut_frame(scene, 2, [&](const Frame& frame) {
        Recorder all;
        Framebuffer framebuffer;
        clear(framebuffer, frame);
        draw(frame, {}, framebuffer, &all);
        for (int round = 0; round < 30; ++round) {
            Cursor from = any_cursor(random, frame.triangle_count());
            Cursor to = any_cursor(random, frame.triangle_count());
            if (to < from) std::swap(from, to);
            Recorder part;
            draw(frame, {from, to, {}}, framebuffer, &part);
            const auto in_window = [&](const auto& events) {
                std::vector<Cursor> cursors;
                for (const auto& event : events) {
                    if (event.cursor >= from && event.cursor < to) cursors.push_back(event.cursor);
                }
                return cursors;
            };
            const auto cursors_of = [](const auto& events) {
                std::vector<Cursor> cursors;
                for (const auto& event : events)
                    cursors.push_back(event.cursor);
                return cursors;
            };
            CAPTURE(to_text(from), to_text(to));
            REQUIRE(cursors_of(part.clip_steps) == in_window(all.clip_steps));
            REQUIRE(cursors_of(part.culls) == in_window(all.culls));
            REQUIRE(cursors_of(part.vertices) == in_window(all.vertices));
        }
    });
}

TEST_CASE("The vertices of a cut triangle are its own three, and its edges join what is left") {
    const Scene scene = cut_scene();
    const Frame frame = cut_frame(scene, {Stage::points}, {Clip::all, Cull::none, Reject::none});
    Recorder recorder;
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {}, framebuffer, &recorder);
    const VertexRules rules = vertex_rules(frame.settings, scene.space);
    int behind = 0, cut = 0;
    for (const VertexEvent& event : recorder.vertices) {
        const ShadedVertex own =
            shade_vertex(scene.corner(event.cursor.triangle, event.cursor.index),
                         camera_rotation(rules.camera), rules, frame.stages);
        CAPTURE(to_text(event.cursor));
        REQUIRE(event.vertex.has_pixel == own.has_pixel);
        behind += own.has_pixel ? 0 : 1;
        if (own.has_pixel) REQUIRE(same_bits(event.vertex.pixel, own.pixel));
    }
    for (int t = 0; t < frame.triangle_count(); ++t)
        cut += frame.is_cut(t) && frame.is_drawn(t) ? 1 : 0;
    CHECK(behind > 3);
    CHECK(cut > 2);
    // A scissor shows the same marks as the whole picture has there.
    for (int column = 0; column < 24; column += 3) {
        Framebuffer part;
        clear(part, frame);
        draw(frame, {cursor_begin, cursor_end, Rectangle{column, 0, column + 3, 18}}, part);
        for (int row = 0; row < 18; ++row) {
            for (int x = column; x < column + 3; ++x)
                REQUIRE(part.owner[part.at(x, row)] == framebuffer.owner[part.at(x, row)]);
        }
    }
}

TEST_CASE("The planes follow from the fragments that an observer gets") {
    const Scene scene = small_scene();
    for_each_frame(scene, [&](const Frame& frame) {
        Recorder recorder;
        Framebuffer drawn, built;
        clear(drawn, frame);
        built = drawn;
        draw(frame, {}, drawn, &recorder);
        for (const FragmentEvent& event : recorder.fragments) {
            const std::size_t pixel = built.at(event.fragment.column, event.fragment.row);
            CHECK(same_bits(event.stored, built.depth[pixel]));
            CHECK(same_bits(event.before, built.colour[pixel]));
            ++built.overdraw[pixel];
            if (event.fate != Fate::written) {
                CHECK(same_bits(event.after, event.before));
                continue;
            }
            built.colour[pixel] = event.after;
            const bool has_cell =
                has_depth_cell(frame.stages, event.fragment.column, event.fragment.row,
                               frame.settings.viewport) ||
                !has_fragments(frame.settings.stage); // marks change no depth
            if (has_cell) built.depth[pixel] = event.depth;
            built.owner[pixel] = event.cursor.triangle;
        }
        require_same(built, drawn);
    });
}

TEST_CASE("A window reports only its own samples, with the effect of each on the table") {
    const Scene scene = small_scene();
    Random random(31);
    for_each_frame(scene, [&](const Frame& frame) {
        Recorder all(true);
        Framebuffer framebuffer;
        clear(framebuffer, frame);
        draw(frame, {}, framebuffer, &all);
        for (int round = 0; round < 30; ++round) {
            Cursor from = any_cursor(random, frame.triangle_count());
            Cursor to = any_cursor(random, frame.triangle_count());
            if (to < from) std::swap(from, to);
            Recorder part(true);
            draw(frame, {from, to, {}}, framebuffer, &part);
            std::vector<SampleEvent> expected;
            for (const SampleEvent& event : all.samples) {
                if (event.cursor >= from && event.cursor < to) expected.push_back(event);
            }
            CAPTURE(to_text(from), to_text(to));
            REQUIRE(part.samples.size() == expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i) {
                const SampleEvent &a = part.samples[i], &b = expected[i];
                const bool same =
                    a.cursor == b.cursor && same_bits(a.sample.fragment, b.sample.fragment) &&
                    same_bits(a.sample.x, b.sample.x) && same_bits(a.sample.y, b.sample.y) &&
                    a.sample.write == b.sample.write;
                if (!same) FAIL("sample " + to_text(b.cursor) + " is reported differently");
            }
        }
    });
}

namespace {

/// A row table as an observer of edge samples would make it.
struct ReplayedRows {
    struct Ends {
        int left, right;
        Fragment left_sample, right_sample;
    };
    int left_start = INT_MAX, right_start = -INT_MAX;
    std::map<int, Ends> rows; ///< by number in the table
    int outside = 0;
    RowSearch search = RowSearch::indexed;

    RowWrite enter(Fragment sample, const PolygonRows& table) {
        int r = sample.row - table.first_row;
        if (search == RowSearch::clamped) r = std::max(0, std::min(r, table.size() - 1));
        if (search == RowSearch::column_only)
            sample = {sample.column, sample.row, 0.0f, 0.0f, 0.0f, {}};
        if (r < 0 || r >= table.size()) {
            ++outside;
            return {};
        }
        const Ends start{left_start, right_start,
                         Fragment{left_start, sample.row, 0.0f, 0.0f, 0.0f, {}},
                         Fragment{right_start, sample.row, 0.0f, 0.0f, 0.0f, {}}};
        Ends& ends = rows.try_emplace(r, start).first->second;
        const RowWrite write{true, sample.column<ends.left, sample.column> ends.right};
        if (write.left) ends.left_sample = sample;
        if (write.right) ends.right_sample = sample;
        ends.left = std::min(ends.left, sample.column);
        ends.right = std::max(ends.right, sample.column);
        return write;
    }

    /// The first row, from the top, that differs from the table; -1 if none.
    int first_difference(const PolygonRows& table) const {
        for (int r = 0; r < table.size(); ++r) {
            const auto found = rows.find(r);
            const bool same =
                found == rows.end()
                    ? table.is_empty_row(r)
                    : same_bits(row_end(found->second.left_sample), table.left[r]) &&
                          same_bits(row_end(found->second.right_sample), table.right[r]);
            if (!same) return r;
        }
        return -1;
    }
};

} // namespace

TEST_CASE("10,000 random row tables replayed sample by sample equal those made at once") {
    Random random(32);
    constexpr Viewport viewport{48, 36};
    std::vector<std::array<glm::vec3, 3>> triangles;
    for (int i = 0; i < 10'000; ++i)
        triangles.push_back(random_triangle(random, viewport));
    const Scene scene = pixel_scene(triangles, viewport);
    for (const Variant& variant : rule_variants()) {
        const Frame frame = frame_of(scene, Stage::edges, variant);
        const bool handout = variant.name == "handout";
        const int count = handout ? frame.triangle_count() : rounds(1000, 250);
        Recorder recorder(true);
        Framebuffer framebuffer;
        clear(framebuffer, frame);
        // Only up to the last rows of the last triangle, because the next one would be counted too.
        const DrawWindow window{cursor_begin, {count - 1, Phase::rows, 2 * viewport.height, 0}, {}};
        const DrawTally tally = draw(frame, window, framebuffer, &recorder);
        CAPTURE(variant.name);
        std::int64_t outside = 0;
        auto event = recorder.samples.begin();
        for (int t = 0; t < count; ++t) {
            if (!frame.is_drawn(t)) continue;
            PolygonRows rows;
            compute_polygon_rows(frame.triangle_vertices(t), frame.settings, rows);
            ReplayedRows replayed;
            replayed.search = frame.settings.row_search;
            if (frame.settings.row_start == RowStart::window) {
                replayed.left_start = viewport.width;
                replayed.right_start = 0;
            }
            for (; event != recorder.samples.end() && event->cursor.triangle == t; ++event) {
                if (replayed.enter(event->sample.fragment, rows) == event->sample.write) continue;
                FAIL("the end written is not the one reported at " + to_text(event->cursor));
            }
            const int row = replayed.first_difference(rows);
            if (row >= 0) FAIL("triangle " << t << " differs in row " << row << " of its table");
            if (replayed.outside != rows.outside) FAIL("triangle " << t << " counts differently");
            outside += replayed.outside;
        }
        CHECK(event == recorder.samples.end());
        CHECK(outside == tally.samples_outside);
        if (frame.settings.line_walk == LineWalk::exact) CHECK(outside == 0);
        if (handout) CHECK(outside > 100);
    }
}
