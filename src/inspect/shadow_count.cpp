#include "inspect/shadow_count.h"

#include "pipeline/draw.h"
#include "pipeline/surface.h"

namespace rasterwalk {

namespace {

/// The light at the point that a fragment shows; under flat shading in the middle of its triangle.
SurfaceLight light_there(const Frame& frame, const Fragment& fragment, int triangle,
                         const Surface& surface, const PixelRules& rules) {
    const SurfacePoint point = rules.shading == Shading::flat
                                   ? flat_point(frame, triangle)
                                   : lit_point(fragment, surface, rules, frame.stages);
    return surface_light(point, rules.light, rules.rays, rules.occluders, frame.stages);
}

void add(const SurfaceLight& light, const Frame& frame, ShadowCount& count) {
    ++count.pixels;
    if (!(light.diffuse.cosine > 0.0f)) return;
    ++count.facing;
    const ShadowTerms& shadow = light.shadow;
    count.in_shadow += shadow.is_dark() ? 1 : 0;
    if (!shadow.is_tested) return;
    ShadowRules usual;
    const WorldRay ray = shadow_ray(shadow.point, usual.offset);
    const bool is_blocked = frame.occluders.triangles->first_hit(ray).is_hit();
    count.acne += shadow.is_dark() && !is_blocked ? 1 : 0;
    count.leaks += !shadow.is_dark() && is_blocked ? 1 : 0;
}

void operator+=(ShadowCount& sum, const ShadowCount& part) {
    sum.pixels += part.pixels;
    sum.facing += part.facing;
    sum.in_shadow += part.in_shadow;
    sum.acne += part.acne;
    sum.leaks += part.leaks;
}

} // namespace

FrameShadows count_shadows(const Frame& frame) {
    FrameShadows result;
    result.parts.resize(frame.scene->parts.size());
    if (!has_fragments(frame.settings.stage)) return result;
    Framebuffer picture;
    clear(picture, frame);
    std::vector<Fragment> shown(picture.owner.size()); // finally, by each pixel
    const Observer keep_last{.fragment = [&](const FragmentEvent& event) {
        const Fragment& fragment = event.fragment;
        const std::size_t pixel = picture.at(fragment.column, fragment.row);
        // A pixel with several samples may have been written where it does not show it.
        if (event.fate == Fate::written && picture.owner[pixel] == event.cursor.triangle)
            shown[pixel] = fragment;
    }};
    draw(frame, {}, picture, &keep_last);
    const PixelRules rules = pixel_rules(frame);
    int known = -1;
    Surface surface;
    for (std::size_t i = 0; i < picture.owner.size(); ++i) {
        const int triangle = picture.owner[i];
        if (triangle < 0) continue;
        if (triangle != known) {
            surface = lit_surface_of(frame, triangle);
            known = triangle;
        }
        ShadowCount one;
        add(light_there(frame, shown[i], triangle, surface, rules), frame, one);
        result.all += one;
        const int part = part_of(*frame.scene, triangle);
        if (part >= 0) result.parts[static_cast<std::size_t>(part)] += one;
    }
    return result;
}

} // namespace rasterwalk
