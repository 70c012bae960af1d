#include "facts/fact_groups.h"

namespace rasterwalk {

namespace {

/// What was asked at the picked pixel; null where nothing was.
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

/// A number of the map; none where no map was asked.
template <auto read>
Value map_number(const Facts& facts, int) {
    const ShadowTerms* const terms = asked_there(facts);
    return terms != nullptr && terms->face >= 0 ? number(read(*terms)) : Value();
}

/// How far the lamp saw in a texel; none where nothing was there.
std::optional<float> depth_in(const ShadowTexel& texel) {
    if (!(texel.inv_depth > 0.0f)) return std::nullopt;
    return 1.0f / texel.inv_depth;
}

template <auto member>
Value frame_count(const Facts& facts, int) {
    return number(facts.shadows().all.*member);
}

/// The same of the part of the scene to which the triangle on show belongs.
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
                     "to 1; none where nothing is asked: without shadows, and where the surface "
                     "faces away.",
                     real(0, 1), shadow_number<[](const ShadowTerms& s) { return s.lit; }>});
    table.push_back({"pixel.occluder",
                     "Triangle that the ray from there to the lamp meets first; -1: none. Only "
                     "where shadows are found by rays.",
                     whole(-1, endless), [](const Facts& f, int) {
                         const ShadowTerms* const terms = asked_there(f);
                         if (terms == nullptr || terms->face >= 0) return Value();
                         return number(terms->hit.triangle);
                     }});
    table.push_back({"pixel.occluder_way",
                     "Where on its way the ray meets that triangle: 0 at the surface, 1 at the "
                     "lamp.",
                     real(0), [](const Facts& f, int) {
                         const ShadowTerms* const terms = asked_there(f);
                         if (terms == nullptr || !terms->hit.is_hit()) return Value();
                         return number(terms->hit.t);
                     }});
    table.push_back({"pixel.lamp_z",
                     "How deep it lies as the lamp sees it, along the axis of the face of the "
                     "shadow map, world units.",
                     real(0), map_number<[](const ShadowTerms& s) { return s.seen.z; }>});
    table.push_back({"pixel.shadow_bias", "The bias that is subtracted from that.", real(0),
                     map_number<[](const ShadowTerms& s) { return s.bias; }>});
    table.push_back({"pixel.map_z",
                     "How deep the lamp saw there: what the shadow map holds, world units; none "
                     "where it saw nothing. Of four texels the first.",
                     real(0),
                     map_number<[](const ShadowTerms& s) { return depth_in(s.texels[0]); }>});
    table.push_back({"pixel.map_face",
                     "Face of the shadow map in which it lies: 0 to 5 for +x, -x, +y, -y, +z, -z.",
                     whole(0, shadow_face_count - 1),
                     map_number<[](const ShadowTerms& s) { return s.face; }>});
    table.push_back({"pixel.map_column", "Column of that face in which it lies; of four the first.",
                     natural(),
                     map_number<[](const ShadowTerms& s) { return s.texels[0].column; }>});
    table.push_back({"pixel.map_row", "Row of that face in which it lies; of four the first.",
                     natural(), map_number<[](const ShadowTerms& s) { return s.texels[0].row; }>});
    table.push_back({"frame.pixels", "Pixels of the finished picture on which something is seen.",
                     natural(), frame_count<&ShadowCount::pixels>});
    table.push_back({"frame.facing_lamp",
                     "Pixels of the finished picture whose surface faces the lamp.", natural(),
                     frame_count<&ShadowCount::facing>});
    table.push_back({"frame.in_shadow",
                     "Pixels of the finished picture that face the lamp and lie in shadow, wholly "
                     "or partly.",
                     natural(), frame_count<&ShadowCount::in_shadow>});
    table.push_back({"frame.acne",
                     "Pixels that the setting in force puts in shadow though nothing stands "
                     "between, as a right ray finds.",
                     natural(), frame_count<&ShadowCount::acne>});
    table.push_back({"frame.light_leaks",
                     "Pixels that the setting in force lights though something stands between.",
                     natural(), frame_count<&ShadowCount::leaks>});
    table.push_back({"part.pixels",
                     "Pixels of the finished picture that show the part of the scene to which the "
                     "triangle on show belongs.",
                     natural(), part_count<&ShadowCount::pixels>});
    table.push_back({"part.in_shadow", "Those of them that face the lamp and lie in shadow.",
                     natural(), part_count<&ShadowCount::in_shadow>});
}

} // namespace rasterwalk
