#include "session/outside_reports.h"

#include <algorithm>

namespace rasterwalk {

namespace {

WorldCorner world_corner(const CutCorner& corner) {
    WorldCorner result;
    result.place = corner.vertex.varyings.position_world;
    if (corner.is_new()) result.plane = corner.plane;
    result.edge = corner.edge;
    return result;
}

/// The plane to show, as an index in the history: the one at work, the chosen one if it cuts, or
/// the first that does; -1: none does.
int shown_plane(const ClipHistory& history, const std::optional<ClipProgress>& progress,
                std::optional<ClipPlane> chosen) {
    if (progress) return progress->planes;
    const auto& planes = history.planes;
    const auto found = std::find_if(planes.begin(), planes.end(),
                                    [&](const PlaneHistory& p) { return p.plane == chosen; });
    if (found != planes.end()) return static_cast<int>(found - planes.begin());
    return planes.empty() ? -1 : 0;
}

} // namespace

WorldClipping clipping_outside(const Frame& frame, const ClipHistory& history,
                               const std::optional<Cursor>& done, std::optional<ClipPlane> chosen) {
    WorldClipping result;
    if (history.cuts || depth_kind(frame) != ClipDepth::inv_z)
        result.ends = glm::dvec2(frame.settings.near, frame.settings.far);
    result.is_cut = history.clipped.is_cut || !history.planes.empty();
    if (!result.is_cut) return result;
    const std::optional<ClipProgress> progress = clip_progress(history, done);
    // Until the last edge is done the plane has not taken anything away.
    const bool is_at_work =
        progress &&
        progress->steps <
            static_cast<int>(
                history.planes[static_cast<std::size_t>(progress->planes)].steps.size());
    const int planes = progress ? progress->planes + (is_at_work ? 0 : 1) : INT_MAX;
    for (const CutCorner& corner : corners_before(history, planes))
        result.corners.push_back(world_corner(corner));
    if (history.clipped.rejection != Rejection::none && !progress) result.corners.clear();
    const std::vector<CutCorner> passed =
        progress ? corners_passed(history, *progress) : corners_before(history);
    for (const CutCorner& corner : passed) {
        if (corner.is_new()) result.made.push_back(world_corner(corner));
    }
    const int at = shown_plane(history, progress, chosen);
    if (at < 0) return result;
    const PlaneHistory& plane = history.planes[static_cast<std::size_t>(at)];
    WorldPlane& shown = result.plane.emplace();
    shown.plane = plane.plane;
    shown.depth = plane.plane == ClipPlane::far ? frame.settings.far : frame.settings.near;
    shown.coefficients = history.codes.planes[static_cast<std::size_t>(plane.plane)];
    for (const ClipStep& step : plane.steps) {
        if (step.is_cut) shown.cuts.emplace_back(step.cut.varyings.position_world);
    }
    return result;
}

std::optional<LampRay> lamp_ray_outside(const Frame& frame,
                                        const std::optional<FragmentReport>& fragment) {
    if (!fragment || occluders_of(frame) == nullptr) return std::nullopt;
    const ShadowTerms& shadow = fragment->shading == Shading::flat
                                    ? fragment->light_per_triangle.shadow
                                    : fragment->light.shadow;
    if (!shadow.is_tested) return std::nullopt;
    LampRay lamp_ray{glm::dvec3(shadow.point.position_world), {}};
    if (shadow.hit.is_hit())
        lamp_ray.met =
            glm::dvec3(shadow.ray.from) + double{shadow.hit.t} * glm::dvec3(shadow.ray.direction);
    // On the way from the lamp, at the depth it saw.
    const glm::dvec3 lamp(shadow.point.lamp);
    for (int i = 0; i < shadow.texel_count && !lamp_ray.met; ++i) {
        const ShadowTexel& texel = shadow.texels[static_cast<std::size_t>(i)];
        if (!texel.is_lit)
            lamp_ray.met = lamp + (lamp_ray.from - lamp) /
                                      (double{texel.inv_depth} * double{shadow.from_face.z});
    }
    return lamp_ray;
}

std::optional<SightShift> sight_shift_outside(const std::optional<FragmentReport>& fragment) {
    if (!fragment || !fragment->parallax || fragment->parallax->sign == 0.0f) return std::nullopt;
    const ParallaxTerms& terms = fragment->parallax->terms;
    const glm::dvec3 seen(fragment->under(fragment->interpolation).position_world);
    const glm::dvec3 texel = seen + double{terms.step.x} * glm::dvec3(terms.axes.tangent) +
                             double{terms.step.y} * glm::dvec3(terms.axes.bitangent);
    return SightShift{seen, texel, texel + double{terms.height} * glm::dvec3(terms.axes.normal)};
}

OutsideVectors vectors_outside(const std::optional<VectorReport>& report, const OutsideEye& eye,
                               double length, double angle) {
    OutsideVectors result;
    if (!report || report->vectors.empty()) return result;
    const double depth = eye.in_eye(report->vectors.front().from).z;
    const double pixel = std::max(depth, eye.near_distance) / eye.focal_length; // in the world
    result.arrows = vector_lines(*report, length * pixel, angle * pixel);
    if (report->sides) {
        const auto corners = report->sides->corners();
        result.span.assign(corners.begin(), corners.end());
    }
    return result;
}

std::optional<TexturedPixel> textured_pixel_outside(const std::optional<FragmentReport>& fragment) {
    if (!fragment || !fragment->texture) return std::nullopt;
    return TexturedPixel{fragment->pixel, fragment->cursor.triangle};
}

} // namespace rasterwalk
