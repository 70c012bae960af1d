// A recording answers every question as drawing does: the history of a pixel, the list of a
// triangle's moments, and where two runs diverge.

#include <string>
#include <vector>

#include "base/error.h"
#include "base/numbers.h"
#include "compare/divergence.h"
#include "inspect/event_list.h"
#include "inspect/pixel_history.h"
#include "pipeline/event_file.h"
#include "settings/setting_table.h"
#include "support/bits.h"
#include "support/frames.h"
#include "support/recorder.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace recorded_runs {

/// Two triangles that overlap, and one behind them; all lie in the picture.
Scene scene_inside() {
    return pixel_scene({{{{5, 4, 2}, {3, 14, 1}, {16, 11, 3}}},
                        {{{4, 5, 1}, {14, 3, 2}, {13, 15, 2}}},
                        {{{3, 3, 4}, {16, 4, 4}, {9, 16, 4}}}},
                       {20, 20});
}

/// What our own drawing tells, written to a file and read again.
EventSource from_file(const Frame& frame) {
    return {frame, parse_recording(recording_text(record(frame)), "told.txt")};
}

/// All that a history says about its entries, as text.
std::vector<std::string> lines_of(const PixelHistory& history) {
    std::vector<std::string> lines;
    for (const PixelEntry& e : history.entries) {
        std::string line = to_text(e.cursor) + " " + std::string(word_of(e.fate));
        for (const float value : {static_cast<float>(e.row), static_cast<float>(e.column), e.zinv,
                                  e.z, e.depth, e.stored, e.margin, e.margin_to_winner, e.alpha,
                                  e.share, e.colour_before.r, e.colour_before.g, e.colour_before.b,
                                  e.colour_after.r, e.colour_after.g, e.colour_after.b})
            line += " " + shortest(value);
        lines.push_back(line);
    }
    for (const TestEvent& test : history.tests)
        lines.push_back(to_text(test.cursor) + (test.test.is_inside ? " inside" : " outside"));
    for (const NearTriangle& near : history.nearest)
        lines.push_back("near " + std::to_string(near.triangle));
    lines.push_back("winner " + std::to_string(history.winner));
    return lines;
}

std::vector<std::string> lines_of(const EventList& list) {
    std::vector<std::string> lines;
    for (int i = 0; i < list.count(); ++i)
        lines.push_back(event_text(list, i));
    return lines;
}

/// Every divergence, forward from the beginning; and back from the end, only the last.
std::vector<std::string> lines_of(const EventSource& a, const EventSource& b) {
    std::vector<std::string> lines;
    const auto add = [&](const Divergence& found) {
        lines.push_back(to_text(found.cursor) + " " + kind_text(found.kind) + " " + found.text);
    };
    Cursor from = cursor_begin;
    while (const std::optional<Divergence> found = next_divergence(a, b, from)) {
        add(*found);
        from = found->cursor;
        ++(phase_info(from.phase).step_letter == 0 ? from.index : from.step);
        if (lines.size() > 40) break;
    }
    if (const std::optional<Divergence> last = previous_divergence(a, b, cursor_end)) add(*last);
    return lines;
}

} // namespace recorded_runs
} // namespace

TEST_CASE("A recording gives the same moments, histories and lists as drawing") {
    using namespace recorded_runs;
    for_each_frame(scene_inside(), [](const Frame& frame) {
        const EventSource drawn(frame), recorded = from_file(frame);
        for (int t = 0; t < frame.triangle_count(); ++t)
            REQUIRE(lines_of(list_events(recorded, t)) == lines_of(list_events(drawn, t)));
        for (int i = 0; i < 20; ++i) {
            const glm::ivec2 pixel{i, (7 * i + 3) % 20};
            REQUIRE(lines_of(pixel_history(recorded, pixel)) ==
                    lines_of(pixel_history(drawn, pixel)));
        }
    });
}

TEST_CASE("A recorded run diverges where the drawn one does, in the same words") {
    using namespace recorded_runs;
    const Scene scene = scene_inside();
    for (const char* const change :
         {"vertex_rounding=floor", "interpolation=affine", "stage=fill", "stage=points",
          "coverage=edge_functions", "cull=screen_area", "depth_epsilon=0.1"}) {
        CAPTURE(change);
        Settings settings = default_settings(scene);
        settings.stage = Stage::depth;
        const Frame a = prepare_frame(scene, settings);
        set_from_text(settings, change);
        const Frame b = prepare_frame(scene, settings);
        const std::vector<std::string> drawn = lines_of(a, b);
        CHECK(lines_of(from_file(a), b) == drawn);
        CHECK(lines_of(a, from_file(b)) == drawn);
        CHECK(lines_of(from_file(a), from_file(b)) == drawn);
        CHECK(lines_of(a, from_file(a)).empty());
    }
}

TEST_CASE("Where a recording has holes, the other run has something more") {
    using namespace recorded_runs;
    const Scene scene = scene_inside();
    for (const Stage stage : {Stage::points, Stage::edges, Stage::rows, Stage::depth}) {
        const Frame frame = frame_of(scene, stage, rule_variants().front());
        const std::vector<Event> whole = record(frame);
        for (std::size_t hole = 0; hole < whole.size(); hole += 7) {
            const Cursor at = cursor_of(whole[hole]);
            const bool has_mark = hole + 1 < whole.size() && cursor_of(whole[hole + 1]) == at;
            if (has_mark && stage != Stage::rows) continue; // the moment is still there
            std::vector<Event> events = whole;
            events.erase(events.begin() + static_cast<std::ptrdiff_t>(hole));
            const EventSource recorded(frame, events);
            const std::optional<Divergence> missing = next_divergence(frame, recorded, {});
            REQUIRE(missing);
            CHECK(missing->cursor == at);
            CHECK(missing->kind == DivergenceKind::missing);
            CHECK_FALSE(missing->text.empty());
            CHECK(next_divergence(recorded, frame, {})->kind == DivergenceKind::extra);
            for (int t = 0; t < frame.triangle_count(); ++t)
                lines_of(list_events(recorded, t));
            pixel_history(recorded, {9, 9});
        }
    }
}

TEST_CASE("A recording whose rows contradict each other is refused") {
    using namespace recorded_runs;
    const Scene scene = scene_inside();
    const Frame frame = frame_of(scene, Stage::depth, rule_variants().front());
    const std::vector<Event> whole = record(frame);
    int changed = 0;
    for (std::size_t i = 1; i < whole.size(); i += 31) {
        std::vector<Event> events = whole;
        auto* const pixel = std::get_if<FragmentEvent>(&events[i]);
        const bool has_neighbour = cursor_of(whole[i - 1]).phase == Phase::rows &&
                                   cursor_of(whole[i - 1]).triangle == cursor_of(whole[i]).triangle;
        if (pixel == nullptr || pixel->cursor.phase != Phase::rows || !has_neighbour) continue;
        ++pixel->fragment.row;
        CHECK_THROWS_AS(EventSource(frame, events), InputError);
        ++changed;
    }
    CHECK(changed > 5);
}

TEST_CASE("A source goes back by drawing again, and on from where it is") {
    using namespace recorded_runs;
    const Scene scene = scene_inside();
    const Frame frame = frame_of(scene, Stage::depth, rule_variants().front());
    const EventSource source(frame);
    const std::vector<Event> whole = record(source);
    CHECK(recording_text(record(source)) == recording_text(whole));
    std::vector<Event> parts;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        for (const Event& event : record(source, {beginning_of(t), beginning_of(t + 1), {}}))
            parts.push_back(event);
    }
    CHECK(recording_text(parts) == recording_text(whole));
}
