#include "cli/commands.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <ostream>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "cli/json.h"
#include "engines/engine_planes.h"
#include "inspect/ray_stats.h"
#include "inspect/stats.h"
#include "inspect/visibility_hints.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "pipeline/draw_cost.h"
#include "session/shown_pass.h"
#include "settings/setting_faults.h"

namespace rasterwalk {

namespace {

/// @param engine whose picture or counts they are about
void report_warnings(const Frame& frame, const LeftOut& left_out, Engine engine,
                     std::ostream& err) {
    if (frame.scene->model_report) {
        const ObjReport& report = *frame.scene->model_report;
        for (const std::vector<std::string>& lines : {fault_lines(report), remark_lines(report)}) {
            for (const std::string& line : lines)
                err << "rasterwalk: " << line << '\n';
        }
    }
    if (const std::string refusal = engine_refuses(*frame.scene, frame.settings); !refusal.empty())
        err << "rasterwalk: " << refusal << ", so the steps draw.\n";
    for (const SettingFault& fault : setting_faults(frame.settings, *frame.given))
        err << "rasterwalk: " << fault.sentence << ".\n";
    for (const RejectionWords& reason : rejection_list) {
        const int count = left_out.of(reason.rejection);
        if (count == 0 || !is_left_out_by(engine, reason.rejection)) continue;
        err << "rasterwalk: " << counted(count, "triangle is", "triangles are")
            << " left out: " << (count == 1 ? reason.sentence : reason.of_many) << ".\n";
    }
}

Json to_json(const LeftOut& left_out) {
    std::map<std::string_view, int> counts; // by name
    for (const RejectionWords& reason : rejection_list) {
        const int count = left_out.of(reason.rejection);
        if (count > 0 || reason.is_always_counted) counts[reason.name] = count;
    }
    return Json(counts);
}

/// A number of the frame.
struct StatInfo {
    std::string_view name, help;
    std::int64_t (*read)(const FrameStats&);
};

/// All of them, in the order they are printed.
constexpr StatInfo stat_list[] = {
    {"triangles", "triangles of the scene, drawn or not",
     [](const FrameStats& s) -> std::int64_t { return s.triangles; }},
    {"rejected", "triangles whose vertices all lie beyond the same plane, left out by reject",
     [](const FrameStats& s) -> std::int64_t { return s.left_out.of(Rejection::outside); }},
    {"clipped", "triangles that a plane has cut",
     [](const FrameStats& s) -> std::int64_t { return s.clipped; }},
    {"clip_triangles", "triangles after clipping: the fan of each polygon, and uncut ones",
     [](const FrameStats& s) -> std::int64_t { return s.clip_triangles; }},
    {"culled", "triangles left out by cull because they face away",
     [](const FrameStats& s) -> std::int64_t { return s.left_out.of(Rejection::back_facing); }},
    {"fragments", "fragments that fall inside the picture; before the fill stage, marks",
     [](const FrameStats& s) { return s.fragments; }},
    {"fragments_outside", "fragments that are walked but fall outside the picture",
     [](const FrameStats& s) { return s.fragments_outside; }},
    {"pixels_tested", "pixels of the picture that edge functions test; 0 with any other coverage",
     [](const FrameStats& s) { return s.pixels_tested; }},
    {"max_overdraw", "most fragments on one pixel",
     [](const FrameStats& s) -> std::int64_t { return s.max_overdraw; }},
    {"uncovered", "pixels on which nothing falls", [](const FrameStats& s) { return s.uncovered; }},
    {"rows_outside", "edge samples outside their triangle's row table",
     [](const FrameStats& s) { return s.rows_outside; }},
    {"rows_outside_triangles", "triangles that have such samples",
     [](const FrameStats& s) -> std::int64_t { return s.rows_outside_triangles; }},
    {"shaded", "fragments whose colour is computed", [](const FrameStats& s) { return s.shaded; }},
    {"rows_looked_at", "rows that edge samples search before they find their own",
     [](const FrameStats& s) { return s.row_lookups; }},
    {"unset_rows", "rows that are drawn although no sample reached them",
     [](const FrameStats& s) { return s.empty_rows; }},
    {"depth_outside", "fragments whose pixel has no cell in the depth buffer",
     [](const FrameStats& s) { return s.depth_outside; }},
    {"comparisons",
     "what hidden compared: fragments with the depth buffer, depths, planes or squares",
     [](const FrameStats& s) { return s.hidden.comparisons; }},
    {"splits", "triangles and pieces that planes of the BSP tree have cut",
     [](const FrameStats& s) -> std::int64_t { return s.hidden.splits; }},
    {"squares", "squares into which Warnock's algorithm divides the picture",
     [](const FrameStats& s) -> std::int64_t { return s.hidden.squares; }},
    {"memory", "bytes that hidden needs besides scene and picture",
     [](const FrameStats& s) { return s.hidden.memory; }},
};

/// The counts of work that the numbers of a frame do not have already.
std::vector<CostInfo> further_costs() {
    std::vector<CostInfo> further;
    for (const CostInfo& info : cost_list()) {
        const auto has_its_name = [&](const StatInfo& stat) { return stat.name == info.name; };
        if (std::none_of(std::begin(stat_list), std::end(stat_list), has_its_name))
            further.push_back(info);
    }
    return further;
}

Json to_json(const FrameStats& stats, const DrawCost& cost) {
    std::map<std::string_view, Json> numbers; // by name
    for (const StatInfo& info : stat_list)
        numbers[info.name] = info.read(stats);
    for (const CostInfo& info : further_costs())
        numbers[info.name] = cost.*info.count;
    numbers["left_out"] = to_json(stats.left_out);
    Json json = Json::object();
    for (const auto& [name, value] : numbers)
        json[std::string(name)] = value;
    return json;
}

Json to_json(const ObjReport& report) {
    std::map<std::string_view, std::int64_t> counts; // by name
    for (const ObjCountInfo& info : obj_count_list)
        counts[info.name] = report.counts.*info.count;
    return {{"counts", counts},
            {"faults", fault_lines(report)},
            {"notes", remark_lines(report)},
            {"skipped", skipped_lines(report)}};
}

std::int64_t culled_count(const MeasureCost& cost) {
    return cost.stats.left_out.of(Rejection::back_facing);
}

/// The ways of culling alone, as they have been called ever since.
Json culling_json(const MeasureCosts& costs) {
    Json ways = Json::array();
    for (const MeasureCost& cost : costs.of("cull")) {
        ways.push_back({{"cull", cost.way},
                        {"culled", culled_count(cost)},
                        {"fragments", cost.stats.fragments},
                        {"milliseconds", cost.milliseconds},
                        {"shaded", cost.stats.shaded},
                        {"share", cost.share}});
    }
    return {{"draws", costs.draws}, {"ways", std::move(ways)}};
}

Json to_json(const MeasureCosts& costs) {
    Json ways = Json::array();
    for (const MeasureCost& cost : costs.ways) {
        ways.push_back({{"depth_tests", cost.depth_tests},
                        {"fragments", cost.stats.fragments},
                        {"is_possible", cost.is_possible},
                        {"left_out", cost.stats.left_out.total()},
                        {"measure", cost.measure->name},
                        {"milliseconds", cost.milliseconds},
                        {"prepass_fragments", cost.prepass_fragments},
                        {"shaded", cost.stats.shaded},
                        {"share", cost.share},
                        {"way", cost.way}});
    }
    return {{"draws", costs.draws}, {"ways", std::move(ways)}};
}

void print_costs(const MeasureCosts& costs, std::ostream& out) {
    for (const MeasureCost& cost : costs.ways) {
        if (cost.way == cost.measure->ways.front()) {
            out << fmt::format("\n{:<18}{:>9}{:>11}{:>13}{:>10}{:>14}{:>8}\n", cost.measure->name,
                               "left_out", "fragments", "depth_tests", "shaded", "milliseconds",
                               "share");
        }
        if (!cost.is_possible) {
            out << fmt::format("{:<18}  not possible with these settings\n", cost.way);
            continue;
        }
        out << fmt::format("{:<18}{:>9}{:>11}{:>13}{:>10}{:>14.3f}{:>8.3f}\n", cost.way,
                           cost.stats.left_out.total(),
                           cost.stats.fragments + cost.prepass_fragments, cost.depth_tests,
                           cost.stats.shaded, cost.milliseconds, cost.share);
    }
}

Json to_json(const std::vector<HiddenWay>& ways) {
    Json json = Json::array();
    for (const HiddenWay& way : ways) {
        json.push_back({{"comparisons", way.counts.comparisons},
                        {"hidden", word_of(way.way)},
                        {"is_possible", way.is_possible},
                        {"memory", way.counts.memory},
                        {"splits", way.counts.splits},
                        {"squares", way.counts.squares},
                        {"triangles", way.triangles},
                        {"wrong", way.wrong}});
    }
    return json;
}

void print_ways(const std::vector<HiddenWay>& ways, std::ostream& out) {
    out << fmt::format("\n{:<14}{:>11}{:>13}{:>8}{:>9}{:>11}{:>8}\n", "hidden", "triangles",
                       "comparisons", "splits", "squares", "memory", "wrong");
    for (const HiddenWay& way : ways) {
        if (!way.is_possible) {
            out << fmt::format("{:<14}  not possible with this scene\n", word_of(way.way));
            continue;
        }
        out << fmt::format("{:<14}{:>11}{:>13}{:>8}{:>9}{:>11}{:>8}\n", word_of(way.way),
                           way.triangles, way.counts.comparisons, way.counts.splits,
                           way.counts.squares, way.counts.memory, way.wrong);
    }
}

Json to_json(const RayStats& rays) {
    return {{"box_tests", rays.count.boxes},
            {"missed", rays.missed},
            {"rays", rays.count.rays},
            {"triangle_tests", rays.count.triangles}};
}

void print_rays(const RayStats& rays, std::ostream& out) {
    out << fmt::format("{:<24}{}\n{:<24}{}\n{:<24}{}\n{:<24}{}\n", "rays", rays.count.rays,
                       "rays.triangle_tests", rays.count.triangles, "rays.box_tests",
                       rays.count.boxes, "rays.missed", rays.missed);
}

void print_model(const ObjReport& report, std::ostream& out, std::ostream& err) {
    for (const ObjCountInfo& info : obj_count_list)
        out << fmt::format("model.{:<18}{}\n", info.name, report.counts.*info.count);
    for (const std::string& line : skipped_lines(report))
        err << "rasterwalk: " << line << '\n';
}

} // namespace

void render_command(const RenderOptions& options, std::ostream& err) {
    const Session session = open_view(options.view);
    const Frame frame = shown_frame(session);
    Framebuffer framebuffer;
    const Cursor to = in_frame(session.cursor, frame.pass);
    draw_by_engine(frame, to, framebuffer);
    write_png(view_image(framebuffer, session.view, session.depth_range), options.output);
    report_warnings(frame, count_left_out(frame), drawing_engine(*frame.scene, frame.settings, to),
                    err);
}

std::string stats_footer() {
    std::string text = "What is counted:";
    for (const StatInfo& info : stat_list)
        text += fmt::format("\n  {:<24}{}", info.name, info.help);
    for (const CostInfo& info : further_costs())
        text += fmt::format("\n  {:<24}{}", info.name, info.help);
    text += "\n  left_out                with --json: triangles that are not drawn, by reason"
            "\nWith --time, for each measure against useless work, in each way: triangles left "
            "out, fragments and\ndepth tests (with a pre-pass, of both drawings), shaded "
            "fragments, the "
            "median time of a frame in\nmilliseconds, and that time as a fraction of the time of "
            "its plain way, which comes first. Each fragment is drawn separately; with\n--json as "
            "measures, and the ways of culling "
            "as culling_times.";
    text +=
        "\nWith --hidden, for each way to remove hidden surfaces: the triangles it draws, and the "
        "pixels\nthat show what the depth buffer shows neither there nor next to it; with "
        "--json as ways.";
    text +=
        "\nWith engine=rays, with --json as rays: the rays of pixels and of mirrors, their tests "
        "against triangles\nand against boxes, and the pixels whose ray meets nothing.";
    text +=
        "\nFor a model (.obj), with --json as model; its hints name settings that would show more:";
    for (const ObjCountInfo& info : obj_count_list)
        text += fmt::format("\n  model.{:<18}{}", info.name, info.help);
    return text;
}

void stats_command(const StatsOptions& options, const Clock& clock, std::ostream& out,
                   std::ostream& err) {
    if (options.time && !clock) throw UsageError("--time: no clock is available here.");
    const Session session = open_view(options.view);
    const Frame frame = shown_frame(session);
    Framebuffer framebuffer;
    const Cursor to = in_frame(session.cursor, frame.pass);
    const FrameStats stats = frame_stats(frame, to, framebuffer);
    const std::optional<ObjReport>& model = session.scene->model_report;
    std::vector<std::string> hints;
    if (session.cursor == cursor_end) {
        for (const VisibilityHint& hint : visibility_hints(frame, framebuffer))
            hints.push_back(hint.finding + "; " + hint.help);
    }
    const DrawCost work = draw_cost(frame, to);
    std::optional<MeasureCosts> costs;
    if (options.time) costs = measure_costs(*session.scene, frame.settings, to, clock);
    std::optional<RayStats> rays;
    if (frame.settings.engine == Engine::rays && to == cursor_end) rays = ray_stats(frame);
    std::vector<HiddenWay> ways;
    if (options.hidden) ways = hidden_ways(*session.scene, frame.settings);
    if (options.json) {
        Json json = to_json(stats, work);
        if (options.hidden) json["ways"] = to_json(ways);
        if (costs) {
            json["culling_times"] = culling_json(*costs);
            json["measures"] = to_json(*costs);
        }
        if (rays) json["rays"] = to_json(*rays);
        if (model) {
            json["model"] = to_json(*model);
            json["model"]["hints"] = hints;
        }
        print_json(json, out);
    } else {
        for (const StatInfo& info : stat_list)
            out << fmt::format("{:<24}{}\n", info.name, info.read(stats));
        for (const CostInfo& info : further_costs())
            out << fmt::format("{:<24}{}\n", info.name, work.*info.count);
        if (rays) print_rays(*rays, out);
        if (model) print_model(*model, out, err);
        if (costs) print_costs(*costs, out);
        if (options.hidden) print_ways(ways, out);
    }
    report_warnings(frame, stats.left_out, Engine::steps, err);
    for (const std::string& hint : hints)
        err << "rasterwalk: " << hint << '\n';
}

} // namespace rasterwalk
