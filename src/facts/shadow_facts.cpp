#include "facts/fact_groups.h"

namespace rasterwalk {

namespace {

/// The shadow test at the picked pixel; null if there was none.
const ShadowTerms* shadow_test_at_pixel(const Facts& facts) {
    const FragmentReport* const report = facts.light();
    if (report == nullptr) return nullptr;
    const SurfaceLight& light =
        report->shading == Shading::flat ? report->light_per_triangle : report->light;
    return light.shadow.is_tested ? &light.shadow : nullptr;
}

/// The same if a map was used.
const ShadowTerms* map_there(const Facts& facts) {
    const ShadowTerms* const terms = shadow_test_at_pixel(facts);
    return terms != nullptr && terms->face >= 0 ? terms : nullptr;
}

/// The same if a ray was used.
const ShadowTerms* ray_there(const Facts& facts) {
    const ShadowTerms* const terms = shadow_test_at_pixel(facts);
    return terms != nullptr && terms->face < 0 ? terms : nullptr;
}

/// How far the lamp saw in a texel; none if nothing was there.
std::optional<float> depth_in(const ShadowTexel& texel) {
    if (!(texel.inv_depth > 0.0f)) return std::nullopt;
    return 1.0f / texel.inv_depth;
}

const ShadowCount* frame_count(const Facts& facts) {
    return &facts.shadows().all;
}

/// The same for the part of the scene that the triangle shown belongs to.
const ShadowCount* part_count(const Facts& facts) {
    const RunResults& run = facts.results().a;
    const int part = run.triangle ? part_of(*run.frame.scene, *run.triangle) : -1;
    return part < 0 ? nullptr : &facts.shadows().parts[static_cast<std::size_t>(part)];
}

} // namespace

void add_shadow_facts(std::vector<Fact>& table) {
    const FactAdder<shadow_test_at_pixel> add(table);
    const FactAdder<ray_there> add_of_ray(table);
    const FactAdder<map_there> add_of_map(table);
    const FactAdder<frame_count> add_counted(table);
    const FactAdder<part_count> add_of_part(table);
    using Shadow = const ShadowTerms&;
    using Count = const ShadowCount&;
    add("pixel.lit",
        "The share of the lamp's light that arrives at what the picked pixel "
        "shows, 0 to 1; none "
        "without shadows and where the surface faces away from the lamp.",
        real(0, 1), [](Shadow s) { return s.lit; });
    add_of_ray("pixel.occluder",
               "Triangle that the ray from there to the lamp meets first; -1 if "
               "none. Only if "
               "shadows are found by rays.",
               whole(-1, endless), [](Shadow s) { return s.hit.triangle; });
    add("pixel.occluder_way",
        "How far along the ray it meets that triangle: 0 at the surface, 1 at "
        "the lamp.",
        real(0), [](Shadow s) { return s.hit.is_hit() ? number(s.hit.t) : Value(); });
    add_of_map("pixel.lamp_z",
               "Its depth as seen from the lamp, along the axis of the shadow "
               "map's face, in world "
               "units.",
               real(0), [](Shadow s) { return s.from_face.z; });
    add_of_map("pixel.shadow_bias", "The bias that is subtracted from that depth.", real(0),
               [](Shadow s) { return s.bias; });
    add_of_map("pixel.map_z",
               "The depth that the lamp saw there, which the shadow map holds, in world "
               "units; "
               "none if it saw nothing. The first one, if four texels are compared.",
               real(0), [](Shadow s) { return depth_in(s.texels[0]); });
    add_of_map("pixel.map_face",
               "Face of the shadow map that it falls on: 0 to 5 for +x, -x, +y, "
               "-y, +z, -z.",
               whole(0, shadow_face_count - 1), [](Shadow s) { return s.face; });
    add_of_map("pixel.map_column", "Column of that face in which it falls; the first of four.",
               natural(), [](Shadow s) { return s.texels[0].column; });
    add_of_map("pixel.map_row", "Row of that face in which it falls; the first of four.", natural(),
               [](Shadow s) { return s.texels[0].row; });
    add_counted("frame.pixels", "Pixels of the finished picture that show something.", natural(),
                [](Count c) { return c.pixels; });
    add_counted("frame.facing_lamp", "Pixels of the finished picture whose surface faces the lamp.",
                natural(), [](Count c) { return c.facing; });
    add_counted("frame.in_shadow",
                "Pixels of the finished picture whose surface faces the lamp and "
                "is in shadow, "
                "fully or partly.",
                natural(), [](Count c) { return c.in_shadow; });
    add_counted("frame.acne",
                "Pixels that the current setting puts in shadow although a "
                "correct ray finds "
                "nothing in between.",
                natural(), [](Count c) { return c.acne; });
    add_counted("frame.light_leaks",
                "Pixels that the current setting lights although a correct ray "
                "finds something in "
                "between.",
                natural(), [](Count c) { return c.leaks; });
    add_of_part("part.pixels",
                "Pixels of the finished picture that show the part of the scene "
                "that the triangle "
                "shown belongs to.",
                natural(), [](Count c) { return c.pixels; });
    add_of_part("part.in_shadow", "Those of them whose surface faces the lamp and is in shadow.",
                natural(), [](Count c) { return c.in_shadow; });
}

} // namespace rasterwalk
