#include "cli/commands.h"

#include <map>
#include <ostream>
#include <string_view>

#include "base/numbers.h"
#include "cli/json.h"
#include "inspect/stats.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"

namespace rasterwalk {

namespace {

void report_left_out(const LeftOut& left_out, std::ostream& err) {
    for (const RejectionWords& reason : rejection_list) {
        const int count = left_out.of(reason.rejection);
        if (count == 0) continue;
        err << "rasterwalk: " << counted(count, "triangle is", "triangles are")
            << " left out: " << reason.sentence << ".\n";
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

Json to_json(const FrameStats& stats) {
    Json object{{"clip_triangles", stats.clip_triangles},
                {"clipped", stats.clipped},
                {"culled", stats.left_out.of(Rejection::back_facing)},
                {"depth_outside", stats.depth_outside},
                {"fragments", stats.fragments},
                {"fragments_outside", stats.fragments_outside},
                {"left_out", to_json(stats.left_out)},
                {"max_overdraw", stats.max_overdraw},
                {"rejected", stats.left_out.of(Rejection::outside)},
                {"rows_looked_at", stats.rows_looked_at},
                {"rows_outside", stats.rows_outside},
                {"rows_outside_triangles", stats.rows_outside_triangles},
                {"shaded", stats.shaded},
                {"triangles", stats.triangles},
                {"uncovered", stats.uncovered},
                {"unset_rows", stats.unset_rows}};
    if (stats.pixels_tested > 0) object["pixels_tested"] = stats.pixels_tested;
    return object;
}

} // namespace

void render_command(const RenderOptions& options, std::ostream& err) {
    const Session session = open_view(options.view);
    const Frame frame = prepare_frame(*session.scene, session.a.settings);
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    draw(frame, {.from = cursor_begin, .to = session.cursor, .scissor = {}}, framebuffer);
    write_png(view_image(framebuffer, session.view, session.depth_range), options.output);
    report_left_out(count_left_out(frame), err);
}

void stats_command(const StatsOptions& options, std::ostream& out, std::ostream& err) {
    const Session session = open_view(options.view);
    const Frame frame = prepare_frame(*session.scene, session.a.settings);
    Framebuffer framebuffer;
    const FrameStats stats = frame_stats(frame, session.cursor, framebuffer);
    if (options.json) {
        print_json(to_json(stats), out);
    } else {
        out << "triangles               " << stats.triangles << '\n'
            << "rejected                " << stats.left_out.of(Rejection::outside) << '\n'
            << "clipped                 " << stats.clipped << '\n'
            << "clip_triangles          " << stats.clip_triangles << '\n'
            << "culled                  " << stats.left_out.of(Rejection::back_facing) << '\n'
            << "fragments               " << stats.fragments << '\n'
            << "fragments_outside       " << stats.fragments_outside << '\n'
            << "max_overdraw            " << stats.max_overdraw << '\n'
            << "uncovered               " << stats.uncovered << '\n'
            << "rows_outside            " << stats.rows_outside << '\n'
            << "rows_outside_triangles  " << stats.rows_outside_triangles << '\n'
            << "shaded                  " << stats.shaded << '\n'
            << "rows_looked_at          " << stats.rows_looked_at << '\n'
            << "unset_rows              " << stats.unset_rows << '\n'
            << "depth_outside           " << stats.depth_outside << '\n';
        if (stats.pixels_tested > 0)
            out << "pixels_tested           " << stats.pixels_tested << '\n';
    }
    report_left_out(stats.left_out, err);
}

} // namespace rasterwalk
