#include <array>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "facts/fact_groups.h"

namespace rasterwalk {

namespace {

/// The light of the picked pixel, as if it were worked out there: under flat
/// shading in the middle of its triangle.
const SurfaceLight* light_there(const Facts& facts) {
    const FragmentReport* const report = facts.light();
    if (report == nullptr) return nullptr;
    return report->shading == Shading::flat ? &report->light_per_triangle : &report->light;
}

/// The length of the interpolated normal.
const Formula* normal_length(const Facts& facts) {
    const FragmentReport* const report = facts.light();
    return report != nullptr ? find_formula(report->formulas, "pixel_light.n_length") : nullptr;
}

/// The normal map that bends the normal there.
const BumpReport* bump_there(const Facts& facts) {
    const FragmentReport* const report = facts.light();
    return report != nullptr && report->bump ? &*report->bump : nullptr;
}

/// How a height map shifts the place in the texture there.
const ParallaxReport* parallax_there(const Facts& facts) {
    const FragmentReport* const report = facts.light();
    return report != nullptr && report->parallax ? &*report->parallax : nullptr;
}

void add_parallax_facts(std::vector<Fact>& table) {
    const FactAdder<parallax_there> add(table);
    using Shift = const ParallaxReport&;
    add("pixel.height",
        "How high above the surface the height map says that it is at the picked pixel, in world "
        "units; none if no height map acts on the surface.",
        real(), [](Shift shift) { return shift.terms.height; });
    add("pixel.view_z",
        "The part along the normal of the unit direction from there to the eye: 1 straight ahead, "
        "0 at a grazing angle. Only where a height map acts.",
        real(-1), [](Shift shift) { return shift.terms.view.z; });
    add("pixel.step",
        "How far the height map shifts the place on the surface there, in world units.", real(0),
        [](Shift shift) { return glm::length(shift.terms.step); });
    add("pixel.shift_u", "How far the height map shifts u there.", real(),
        [](Shift shift) { return shift.terms.shift.x; });
    add("pixel.shift_v", "How far the height map shifts v there.", real(),
        [](Shift shift) { return shift.terms.shift.y; });
}

/// The normals of the picked pixel, and how a normal map bends them.
void add_normal_facts(std::vector<Fact>& table) {
    const FactAdder<&Facts::light> add(table);
    const FactAdder<bump_there> add_bump(table);
    for (int i = 0; i < 3; ++i) {
        add(
            "pixel.normal." + axis_name(i),
            axis_name(i) + " of the normal used for the light at the picked pixel.", real(),
            [](const FragmentReport& report, int axis) { return report.normal[axis]; }, i);
    }
    for (int i = 0; i < 3; ++i) {
        add_bump(
            "pixel.bump." + channel_name(i),
            "The " + channel_name(i) + " of the normal map there, 0 to 1.", real(0),
            [](const BumpReport& bump, int channel) { return bump.colour[channel]; }, i);
    }
    add_bump("pixel.tilt",
             "How far the normal map bends the normal there, in degrees; none if "
             "no normal map "
             "acts on the surface.",
             real(0), [](const BumpReport& bump) { return bump.tilt(); });
    add_bump("pixel.handedness",
             "The sign of the bitangent there: 1, or -1 where the texture is "
             "mirrored.",
             real(-1), [](const BumpReport& bump) { return bump.sign; });
}

} // namespace

void add_light_facts(std::vector<Fact>& table) {
    const FactAdder<light_there> add(table);
    using Lit = const SurfaceLight&;
    add("pixel.lamp_distance", "Distance to the lamp from there, in world units.", real(0),
        [](Lit light) { return std::sqrt(light.diffuse.distance2); });
    add("pixel.cosine",
        "n · l there, at least 0: how steeply the lamp's light falls on the "
        "picked pixel's "
        "surface.",
        real(0), [](Lit light) { return light.diffuse.cosine; });
    FactAdder<normal_length>{table}(
        "pixel.normal_length",
        "Length of the interpolated normal there, before it is made unit length; "
        "none if the "
        "normals of the corners are the same.",
        real(0), [](const Formula& length) { return length.result.value; });
    add("pixel.n_dot_h",
        "n · h there, at least 0: how close the normal is to the direction "
        "halfway between lamp "
        "and eye.",
        real(0), [](Lit light) { return light.highlight.n_dot_h; });
    add("pixel.shine", "n · h there to the power of the exponent.", real(0),
        [](Lit light) { return light.highlight.power; });
    for (int i = 0; i < 3; ++i) {
        add(
            "pixel.highlight." + channel_name(i),
            "The " + channel_name(i) + " of the highlight there, not clamped at 1.", real(0),
            [](Lit light, int channel) { return light.highlight.reflected[channel]; }, i);
    }
    add_normal_facts(table);
    add_parallax_facts(table);
}

} // namespace rasterwalk
