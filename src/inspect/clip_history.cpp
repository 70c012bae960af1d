#include "inspect/clip_history.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "stages/fan.h"

namespace rasterwalk {

namespace {

std::string four_digits(float value) {
    return significant(static_cast<double>(value), 4);
}

/// Records what clipping reports.
class ClipWriter : public ClipSink {
  public:
    explicit ClipWriter(ClipHistory& into) : history_(into) {}

    void begin_planes(const ClipPlanes& planes, std::size_t count) override {
        history_.cuts = count > 0;
        history_.codes = triangle_codes(history_.corners, planes, std::min(count, planes.size()));
    }
    void begin_plane(ClipPlane plane, std::span<const ClipVertex> corners) override {
        PlaneHistory& of_plane = history_.planes.emplace_back();
        of_plane.plane = plane;
        of_plane.before.assign(corners.begin(), corners.end());
    }
    void clip_step(const ClipStep& step) override {
        if (history_.planes.empty() || history_.planes.back().plane != step.plane)
            begin_plane(step.plane, {});
        history_.planes.back().steps.push_back(step);
    }
    void end_plane(ClipPlane plane, std::span<const ClipVertex> corners) override {
        if (history_.planes.empty() || history_.planes.back().plane != plane) return;
        history_.planes.back().after.assign(corners.begin(), corners.end());
    }

  private:
    ClipHistory& history_;
};

std::vector<std::array<int, triangle_corners>> fan_of(std::size_t corners) {
    std::vector<std::array<int, triangle_corners>> fan;
    for_each_fan_corners(corners, [&](std::size_t a, std::size_t b, std::size_t c) {
        fan.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
    });
    return fan;
}

/// Culling, and what is left for the division.
void cull(const Frame& frame, const VertexRules& rules, ClipHistory& history) {
    history.fan = fan_of(history.polygon.size());
    history.is_cull_tested = frame.stages.cull != cull_nothing;
    const Rejection rejection =
        frame.stages.cull(history.polygon, rules, sight_rays(rules), &history.cull);
    history.cull.is_back = rejection != Rejection::none;
}

} // namespace

TriangleCodes triangle_codes(std::span<const ClipVertex> corners, const ClipPlanes& planes,
                             std::size_t count) {
    TriangleCodes codes{planes, count, {}};
    const unsigned tested_planes = (1u << count) - 1u;
    for (std::size_t i = 0; i < codes.of_corner.size(); ++i)
        codes.of_corner[i] = static_cast<Outcode>(outcode(corners[i], planes) & tested_planes);
    return codes;
}

Outcode TriangleCodes::common() const {
    return static_cast<Outcode>(of_corner[0] & of_corner[1] & of_corner[2]);
}

Outcode TriangleCodes::any() const {
    return static_cast<Outcode>(of_corner[0] | of_corner[1] | of_corner[2]);
}

ClipHistory clip_history(const Frame& frame, int triangle) {
    ClipHistory history;
    history.triangle = triangle;
    history.rejection = frame.rejection(triangle);
    const ViewVolume volume(vertex_rules(frame.settings, frame.scene->space));
    history.corners = frame.given_clip_vertices(triangle);
    std::vector<ClipVertex> corners(history.corners.begin(), history.corners.end());
    for (int corner = 0; corner < triangle_corners; ++corner)
        history.projected[static_cast<std::size_t>(corner)] = frame.given_vertex(triangle, corner);
    if (volume.rules.space == SceneSpace::world) {
        history.codes = triangle_codes(history.corners, volume.view);
        history.outer_codes = triangle_codes(history.corners, volume.outer);
    }
    history.rejected = frame.stages.reject(corners, volume);
    ClipWriter writer(history);
    if (history.rejected == Rejection::none)
        history.clipped = frame.stages.clip(corners, volume, &writer);
    const bool is_left = history.rejected == Rejection::none &&
                         history.clipped.rejection == Rejection::none &&
                         corners.size() >= least_corners;
    if (!is_left) return history;
    history.polygon = std::move(corners);
    cull(frame, volume.rules, history);
    return history;
}

std::string plane_name(int plane) {
    if (plane < 0 || plane >= static_cast<int>(clip_plane_count))
        return element_name(plane_form, plane);
    return std::string(word_of(static_cast<ClipPlane>(plane))) + " plane";
}

std::string clip_step_text(const ClipStep& step) {
    std::string text =
        fmt::format("corner {} is {}", step.from, step.is_from_inside ? "inside" : "outside");
    // A stage can keep a corner that lies outside; then the text says so.
    text += step.keeps_from ? " and kept" : " and left out";
    if (!step.is_cut) return text;
    const glm::vec4& p = step.cut.position_clip;
    return fmt::format("{}, the edge {} at t = {:.4f}: ({}, {}, {}, {})", text,
                       step.is_from_inside ? "leaves" : "enters", step.t, four_digits(p.x),
                       four_digits(p.y), four_digits(p.z), four_digits(p.w));
}

std::string culling_text(const CullTest& test) {
    std::string text = test.is_back ? "culls" : "does not cull";
    std::string_view separator = ": ";
    if (!test.values.empty() && !test.measure.empty()) {
        text.append(separator).append(test.measure).append(" = ");
        for (std::size_t i = 0; i < test.values.size(); ++i)
            text.append(i > 0 ? ", " : "").append(four_digits(test.values[i]));
        separator = ", ";
    }
    if (!test.reason.empty()) text.append(separator).append(test.reason);
    return text;
}

std::string code_text(Outcode code) {
    std::string text;
    for (std::size_t i = 0; i < clip_plane_count; ++i) {
        if ((code >> i & 1u) == 0) continue;
        if (!text.empty()) text += ' ';
        text += word_of(static_cast<ClipPlane>(i));
    }
    return text.empty() ? "inside" : text;
}

} // namespace rasterwalk
