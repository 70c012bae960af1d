#include <array>
#include <cmath>
#include <string_view>

#include "facts/fact_groups.h"

namespace rasterwalk {

namespace {

/// The light of the picked pixel, as if it were worked out there: under flat shading in the middle
/// of its triangle.
const SurfaceLight* light_there(const Facts& facts) {
    const FragmentReport* const report = facts.light();
    if (report == nullptr) return nullptr;
    return report->shading == Shading::flat ? &report->light_per_triangle : &report->light;
}

/// A number of the light; none if no light is computed.
template <auto read>
Value light_number(const Facts& facts, int part) {
    const SurfaceLight* const light = light_there(facts);
    return light != nullptr ? number(read(*light, part)) : Value();
}

/// The number that a formula of the fragment shows; none if it has no such formula.
Value formula_number(const Facts& facts, std::string_view id) {
    const FragmentReport* const report = facts.light();
    if (report == nullptr) return {};
    const Formula* const formula = find_formula(report->formulas, id);
    return formula != nullptr ? number(formula->result.value) : Value();
}

/// A number of the normal map that bends the normal there; none if there is no map.
template <auto read>
Value bump_number(const Facts& facts, int part) {
    const FragmentReport* const report = facts.light();
    return report != nullptr && report->bump ? number(read(*report->bump, part)) : Value();
}

/// The normals of the picked pixel, and how a normal map bends them.
void add_normal_facts(std::vector<Fact>& table) {
    using Bump = const BumpReport&;
    constexpr std::array<std::string_view, 3> axes{"x", "y", "z"}, channels{"red", "green", "blue"};
    for (int i = 0; i < 3; ++i) {
        const std::string axis(axes[static_cast<std::size_t>(i)]);
        table.push_back({"pixel.normal." + axis,
                         axis + " of the normal used for the light at the picked pixel.", real(),
                         [](const Facts& facts, int part) {
                             const FragmentReport* const report = facts.light();
                             return report != nullptr ? number(report->normal[part]) : Value();
                         },
                         i});
    }
    for (int i = 0; i < 3; ++i) {
        const std::string channel(channels[static_cast<std::size_t>(i)]);
        table.push_back({"pixel.bump." + channel,
                         "The " + channel + " of the normal map there, 0 to 1.", real(0),
                         bump_number<[](Bump bump, int part) { return bump.colour[part]; }>, i});
    }
    table.push_back({"pixel.tilt",
                     "How far the normal map bends the normal there, in degrees; none if no normal "
                     "map acts on the surface.",
                     real(0), bump_number<[](Bump bump, int) { return bump.tilt(); }>});
    table.push_back({"pixel.handedness",
                     "The sign of the bitangent there: 1, or -1 where the texture is mirrored.",
                     real(-1), bump_number<[](Bump bump, int) { return bump.sign; }>});
}

} // namespace

void add_light_facts(std::vector<Fact>& table) {
    table.push_back({"pixel.lamp_distance", "Distance to the lamp from there, in world units.",
                     real(0), light_number<[](const SurfaceLight& light, int) {
                         return std::sqrt(light.diffuse.distance2);
                     }>});
    table.push_back(
        {"pixel.cosine",
         "n · l there, at least 0: how steeply the lamp's light falls on the picked pixel's "
         "surface.",
         real(0),
         light_number<[](const SurfaceLight& light, int) { return light.diffuse.cosine; }>});
    table.push_back({"pixel.normal_length",
                     "Length of the interpolated normal there, before it is made unit length; none "
                     "if the normals of the corners are the same.",
                     real(0), [](const Facts& facts, int) {
                         return formula_number(facts, "pixel_light.n_length");
                     }});
    table.push_back(
        {"pixel.n_dot_h",
         "n · h there, at least 0: how close the normal is to the direction halfway between lamp "
         "and eye.",
         real(0),
         light_number<[](const SurfaceLight& light, int) { return light.highlight.n_dot_h; }>});
    table.push_back(
        {"pixel.shine", "n · h there to the power of the exponent.", real(0),
         light_number<[](const SurfaceLight& light, int) { return light.highlight.power; }>});
    constexpr std::array<std::string_view, 3> channels{"red", "green", "blue"};
    for (int i = 0; i < 3; ++i) {
        const std::string channel(channels[static_cast<std::size_t>(i)]);
        table.push_back({"pixel.highlight." + channel,
                         "The " + channel + " of the highlight there, not clamped at 1.", real(0),
                         light_number<[](const SurfaceLight& light, int part) {
                             return light.highlight.reflected[part];
                         }>,
                         i});
    }
    add_normal_facts(table);
}

} // namespace rasterwalk
