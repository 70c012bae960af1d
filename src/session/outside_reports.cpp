#include "session/outside_reports.h"

#include <algorithm>

namespace rasterwalk {

namespace {

SeenCorner seen_corner(const CutCorner& corner) {
    SeenCorner seen;
    seen.place = corner.vertex.varyings.position_world;
    if (corner.is_new()) seen.plane = corner.plane;
    seen.edge = corner.edge;
    return seen;
}

/// The plane to show, as an index in the history: the one at work, the chosen one if it cuts, or
/// the first that does; -1: none does.
int plane_on_show(const ClipHistory& history, const std::optional<ClipProgress>& progress,
                  std::optional<ClipPlane> chosen) {
    if (progress) return progress->planes;
    const auto& planes = history.planes;
    const auto found = std::find_if(planes.begin(), planes.end(),
                                    [&](const PlaneHistory& p) { return p.plane == chosen; });
    if (found != planes.end()) return static_cast<int>(found - planes.begin());
    return planes.empty() ? -1 : 0;
}

} // namespace

SeenClipping clipping_outside(const Frame& frame, const ClipHistory& history,
                              const std::optional<Cursor>& done, std::optional<ClipPlane> chosen) {
    SeenClipping seen;
    if (history.cuts || depth_kind(frame) != ClipDepth::inv_z)
        seen.ends = glm::dvec2(frame.settings.near, frame.settings.far);
    seen.is_cut = history.clipped.is_cut || !history.planes.empty();
    if (!seen.is_cut) return seen;
    const std::optional<ClipProgress> progress = clip_progress(history, done);
    // Until the last edge is done the plane has not taken anything away.
    const bool is_at_work =
        progress &&
        progress->steps <
            static_cast<int>(
                history.planes[static_cast<std::size_t>(progress->planes)].steps.size());
    const int planes = progress ? progress->planes + (is_at_work ? 0 : 1) : INT_MAX;
    for (const CutCorner& corner : corners_before(history, planes))
        seen.corners.push_back(seen_corner(corner));
    if (history.clipped.rejection != Rejection::none && !progress) seen.corners.clear();
    const std::vector<CutCorner> passed =
        progress ? corners_passed(history, *progress) : corners_before(history);
    for (const CutCorner& corner : passed) {
        if (corner.is_new()) seen.made.push_back(seen_corner(corner));
    }
    const int at = plane_on_show(history, progress, chosen);
    if (at < 0) return seen;
    const PlaneHistory& plane = history.planes[static_cast<std::size_t>(at)];
    SeenPlane& shown = seen.plane.emplace();
    shown.plane = plane.plane;
    shown.depth = plane.plane == ClipPlane::far ? frame.settings.far : frame.settings.near;
    shown.coefficients = history.codes.planes[static_cast<std::size_t>(plane.plane)];
    for (const ClipStep& step : plane.steps) {
        if (step.is_cut) shown.cuts.emplace_back(step.cut.varyings.position_world);
    }
    return seen;
}

std::optional<SeenLampWay> lamp_way_outside(const Frame& frame,
                                            const std::optional<FragmentReport>& fragment) {
    if (!fragment || occluders_of(frame) == nullptr) return std::nullopt;
    const ShadowTerms& shadow = fragment->shading == Shading::flat
                                    ? fragment->light_per_triangle.shadow
                                    : fragment->light.shadow;
    if (!shadow.is_asked) return std::nullopt;
    SeenLampWay way{glm::dvec3(shadow.point.position_world), {}};
    if (shadow.hit.is_hit())
        way.met = glm::dvec3(shadow.ray.from) + double{shadow.hit.t} * glm::dvec3(shadow.ray.way);
    // On the way from the lamp, at the depth it saw.
    const glm::dvec3 lamp(shadow.point.lamp);
    for (int i = 0; i < shadow.texel_count && !way.met; ++i) {
        const ShadowTexel& texel = shadow.texels[static_cast<std::size_t>(i)];
        if (!texel.is_lit)
            way.met = lamp + (way.from - lamp) / (double{texel.inv_depth} * double{shadow.seen.z});
    }
    return way;
}

} // namespace rasterwalk
