#include "session/warnings.h"

#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.h"
#include "engines/engine_planes.h"
#include "inspect/stats.h"
#include "settings/setting_faults.h"

namespace rasterwalk {

namespace {

/// The number of the lesson that explains this reason for leaving triangles out; 0: none does.
int lesson_of(Rejection rejection) {
    switch (rejection) {
    case Rejection::too_far_out:
        return 12;
    case Rejection::behind_camera:
        return 17;
    case Rejection::outside:
        return 18;
    case Rejection::back_facing:
        return 19;
    default:
        return 0;
    }
}

/// Why hidden surfaces are not removed as the settings ask; empty if they are.
std::string_view hidden_undone(const Frame& frame) {
    const Hidden hidden = hidden_rule(frame.settings);
    if (hidden == Hidden::depth_buffer) return {};
    if (frame.in_order->space == SceneSpace::pixels) return "a scene in pixels has no camera";
    if (hidden == Hidden::warnock && frame.squares == nullptr)
        return "the scene is too large to divide the picture into squares";
    const bool is_sorted = hidden == Hidden::warnock || frame.list != nullptr;
    // Nothing that is drawn is in front of anything.
    if (is_sorted || frame.in_order->triangle_count() == 0) return {};
    return hidden == Hidden::painter ? "the scene is too large to be sorted"
                                     : "the scene is too large to be divided by planes";
}

/// The number of pixels that the stages give to a row that no edge sample has reached.
int empty_row_pixels(const Frame& frame) {
    PolygonRows rows;
    frame.stages.begin_polygon_rows(std::array<ScreenVertex, 1>{}, edge_rules(frame.settings),
                                    rows);
    return row_span(frame.stages, rows, 0).count;
}

} // namespace

Warning steps_draw_instead(Engine engine, const std::string& why) {
    return {why + ", so the steps draw", fmt::format("engine={}: the steps draw", word_of(engine))};
}

std::vector<Warning> describe_warnings(const Frame& frame, const DrawTally& of_steps,
                                       Engine engine) {
    const DrawTally tally = engine == Engine::steps ? of_steps : DrawTally{};
    std::vector<Warning> warnings;
    for (SettingFault& fault : setting_faults(frame.settings, *frame.given))
        warnings.push_back({std::move(fault.sentence), std::move(fault.in_short)});
    if (const std::string refusal = engine_refuses(*frame.scene, frame.settings); !refusal.empty())
        warnings.push_back(steps_draw_instead(frame.settings.engine, refusal));
    if (const std::string_view undone = hidden_undone(frame); !undone.empty()) {
        warnings.push_back(
            {fmt::format("hidden={}: {}, so the triangles are drawn in the scene's "
                         "order, without a depth test",
                         word_of(frame.settings.hidden), undone),
             fmt::format("hidden={}: the scene's order", word_of(frame.settings.hidden))});
    }
    const bool is_ordered = draw_order_rule(frame.settings) != DrawOrder::scene;
    if (is_ordered && frame.list == nullptr && frame.in_order->triangle_count() > 0) {
        const std::string_view why = frame.in_order->space == SceneSpace::pixels
                                         ? "a scene in pixels has no camera"
                                         : "the scene is too large to be sorted";
        warnings.push_back(
            {fmt::format("draw_order={}: {}, so the triangles are drawn in the scene's order",
                         word_of(frame.settings.draw_order), why),
             fmt::format("draw_order={}: the scene's order", word_of(frame.settings.draw_order))});
    }
    const LeftOut left_out = count_left_out(frame);
    for (const RejectionWords& reason : rejection_list) {
        const int count = left_out.of(reason.rejection);
        if (count == 0 || !is_left_out_by(engine, reason.rejection)) continue;
        const std::string left_out_count = counted(count, "triangle", "triangles") + " left out";
        warnings.push_back({left_out_count + ": " + std::string(reason.cause), left_out_count,
                            false, -1, lesson_of(reason.rejection)});
    }
    const std::int64_t empty_row_count = tally.empty_rows;
    if (empty_row_count > 0) {
        warnings.push_back(
            {fmt::format("{} that no edge sample reached: right − left + 1 is {} there, and none "
                         "of those pixels are in the picture",
                         counted(empty_row_count, "row", "rows"), empty_row_pixels(frame)),
             counted(empty_row_count, "empty row", "empty rows"), true});
    }
    const Viewport size = frame.settings.viewport;
    if (frame.settings.depth_index == DepthIndex::transposed && size.width != size.height &&
        depth_rule(frame.settings) != DepthTest::off) {
        warnings.push_back(
            {fmt::format("[x][y] is outside the depth buffer for every pixel with x ≥ {} or y ≥ "
                         "{}, so nothing is written there",
                         size.height, size.width),
             "[x][y] outside the depth buffer"});
    }
    // Some small triangles of a model always have one, and it makes no visible difference.
    if (tally.samples_outside > 0 && !frame.scene->model_report) {
        const std::string samples = counted(tally.samples_outside, "edge sample", "edge samples");
        warnings.push_back({fmt::format("{} outside the row table of {}, and not written", samples,
                                        counted(tally.triangles_outside, "triangle", "triangles")),
                            samples + " outside", true, tally.first_outside, 12});
    }
    return warnings;
}

} // namespace rasterwalk
