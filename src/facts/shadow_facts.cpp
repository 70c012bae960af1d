#include "facts/fact_groups.h"

namespace rasterwalk {

namespace {

/// The shadow test at the picked pixel; null if there was none.
const ShadowTerms* asked_there(const Facts& facts) {
    const FragmentReport* const report = facts.light();
    if (report == nullptr) return nullptr;
    const SurfaceLight& light =
        report->shading == Shading::flat ? report->light_per_triangle : report->light;
    return light.shadow.is_asked ? &light.shadow : nullptr;
}

template <auto read>
Value shadow_number(const Facts& facts, int) {
    const ShadowTerms* const terms = asked_there(facts);
    return terms != nullptr ? number(read(*terms)) : Value();
}

/// A number of the map; none if no map was used.
template <auto read>
Value map_number(const Facts& facts, int) {
    const ShadowTerms* const terms = asked_there(facts);
    return terms != nullptr && terms->face >= 0 ? number(read(*terms)) : Value();
}

/// How far the lamp saw in a texel; none if nothing was there.
std::optional<float> depth_in(const ShadowTexel& texel) {
    if (!(texel.inv_depth > 0.0f)) return std::nullopt;
    return 1.0f / texel.inv_depth;
}

template <auto member>
Value frame_count(const Facts& facts, int) {
    return number(facts.shadows().all.*member);
}

/// The same for the part of the scene that the triangle shown belongs to.
template <auto member>
Value part_count(const Facts& facts, int) {
    const RunResults& run = facts.results().a;
    if (!run.triangle) return {};
    const int part = part_of(*run.frame.scene, *run.triangle);
    if (part < 0) return {};
    return number(facts.shadows().parts[static_cast<std::size_t>(part)].*member);
}

} // namespace

void add_shadow_facts(std::vector<Fact>& table) {
    table.push_back({"pixel.lit",
                     "The share of the lamp's light that arrives at what the picked pixel shows, 0 "
                     "to 1; none without shadows and where the surface faces away from the lamp.",
                     real(0, 1), shadow_number<[](const ShadowTerms& s) { return s.lit; }>});
    table.push_back({"pixel.occluder",
                     "Triangle that the ray from there to the lamp meets first; -1 if none. Only "
                     "if shadows are found by rays.",
                     whole(-1, endless), [](const Facts& f, int) {
                         const ShadowTerms* const terms = asked_there(f);
                         if (terms == nullptr || terms->face >= 0) return Value();
                         return number(terms->hit.triangle);
                     }});
    table.push_back({"pixel.occluder_way",
                     "How far along the ray it meets that triangle: 0 at the surface, 1 at the "
                     "lamp.",
                     real(0), [](const Facts& f, int) {
                         const ShadowTerms* const terms = asked_there(f);
                         if (terms == nullptr || !terms->hit.is_hit()) return Value();
                         return number(terms->hit.t);
                     }});
    table.push_back({"pixel.lamp_z",
                     "Its depth as seen from the lamp, along the axis of the shadow map's face, in "
                     "world units.",
                     real(0), map_number<[](const ShadowTerms& s) { return s.seen.z; }>});
    table.push_back({"pixel.shadow_bias", "The bias that is subtracted from that depth.", real(0),
                     map_number<[](const ShadowTerms& s) { return s.bias; }>});
    table.push_back({"pixel.map_z",
                     "The depth that the lamp saw there, which the shadow map holds, in world "
                     "units; none if it saw nothing. The first one, if four texels are compared.",
                     real(0),
                     map_number<[](const ShadowTerms& s) { return depth_in(s.texels[0]); }>});
    table.push_back({"pixel.map_face",
                     "Face of the shadow map that it falls on: 0 to 5 for +x, -x, +y, -y, +z, -z.",
                     whole(0, shadow_face_count - 1),
                     map_number<[](const ShadowTerms& s) { return s.face; }>});
    table.push_back({"pixel.map_column",
                     "Column of that face in which it falls; the first of "
                     "four.",
                     natural(),
                     map_number<[](const ShadowTerms& s) { return s.texels[0].column; }>});
    table.push_back({"pixel.map_row", "Row of that face in which it falls; the first of four.",
                     natural(), map_number<[](const ShadowTerms& s) { return s.texels[0].row; }>});
    table.push_back({"frame.pixels", "Pixels of the finished picture that show something.",
                     natural(), frame_count<&ShadowCount::pixels>});
    table.push_back({"frame.facing_lamp",
                     "Pixels of the finished picture whose surface faces the lamp.", natural(),
                     frame_count<&ShadowCount::facing>});
    table.push_back({"frame.in_shadow",
                     "Pixels of the finished picture whose surface faces the lamp and is in "
                     "shadow, fully or partly.",
                     natural(), frame_count<&ShadowCount::in_shadow>});
    table.push_back({"frame.acne",
                     "Pixels that the current setting puts in shadow although a correct ray finds "
                     "nothing in between.",
                     natural(), frame_count<&ShadowCount::acne>});
    table.push_back({"frame.light_leaks",
                     "Pixels that the current setting lights although a correct ray finds "
                     "something in between.",
                     natural(), frame_count<&ShadowCount::leaks>});
    table.push_back({"part.pixels",
                     "Pixels of the finished picture that show the part of the scene that the "
                     "triangle shown belongs to.",
                     natural(), part_count<&ShadowCount::pixels>});
    table.push_back({"part.in_shadow",
                     "Those of them whose surface faces the lamp and is in "
                     "shadow.",
                     natural(), part_count<&ShadowCount::in_shadow>});
}

} // namespace rasterwalk
