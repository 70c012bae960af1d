#include "inspect/light_formulas.h"

#include <algorithm>

namespace rasterwalk {

namespace {

using Inputs = std::vector<FormulaInput>;

Inputs parts(const char* symbol, const SourcedVector& vector) {
    Inputs inputs;
    for (int i = 0; i < 3; ++i) {
        inputs.push_back({std::string(symbol) + "." + axis_names[i],
                          {vector.value[i]},
                          vector.sources[static_cast<std::size_t>(i)]});
    }
    return inputs;
}

SourcedVector ray(const LitPoint& point) {
    SourcedVector r{point.terms.to_light, {}};
    for (std::size_t i = 0; i < 3; ++i)
        r.sources[i] = from_formula(point.prefix + "r." + axis_names[i]);
    return r;
}

/// D = P (cosine / area), and R = rho (D + N), of one channel.
void append_channel(const LitPoint& point, const Light& light, int channel,
                    std::vector<Formula>& formulas) {
    const std::string name = channel_names[channel];
    const LightTerms& terms = point.terms;
    Formula direct{point.prefix + "D." + name,
                   "D " + name,
                   "Direct light: the lamp's power spread over the sphere, weakened by the slant.",
                   "P · (cosine / area)",
                   {{"P", {light.power[channel]}, from_setting("light.power")},
                    {"cosine", {terms.cosine}, from_formula(point.prefix + "cosine")},
                    {"area", {terms.sphere_area}, from_formula(point.prefix + "area")}},
                   {terms.direct[channel]}};
    if (!(terms.distance2 > 0.0f)) {
        direct.help = "Direct light: none where the lamp itself stands.";
        direct.expression = "0";
        direct.inputs.clear();
    }
    formulas.push_back(direct);
}

} // namespace

glm::vec3 clamped(const glm::vec3& colour) {
    glm::vec3 result;
    for (int i = 0; i < 3; ++i)
        result[i] = std::min(std::max(colour[i], 0.0f), 1.0f);
    return result;
}

void append_light_formulas(const LitPoint& point, const Light& light,
                           std::vector<Formula>& formulas) {
    const LightTerms& terms = point.terms;
    for (int i = 0; i < 3; ++i) {
        const std::string axis = axis_names[i];
        formulas.push_back({point.prefix + "r." + axis,
                            "r." + axis,
                            "From the point to the lamp.",
                            "L." + axis + " − p." + axis,
                            {{"L." + axis, {light.position[i]}, from_setting("light.position")},
                             {"p." + axis,
                              {point.position.value[i]},
                              point.position.sources[static_cast<std::size_t>(i)]}},
                            {terms.to_light[i]}});
    }
    const Inputs r = parts("r", ray(point));
    formulas.push_back({point.prefix + "r2",
                        "r²",
                        "The distance to the lamp, squared.",
                        "r.x² + r.y² + r.z²",
                        r,
                        {terms.distance2}});
    Formula cosine{point.prefix + "cosine",
                   "cosine",
                   "How slanted the light falls: r · n at unit length; nothing comes from behind.",
                   "max(0, (r.x · n.x + r.y · n.y + r.z · n.z) / sqrt(r²))",
                   r,
                   {terms.cosine}};
    for (const FormulaInput& n : parts("n", point.normal))
        cosine.inputs.push_back(n);
    cosine.inputs.push_back({"r²", {terms.distance2}, from_formula(point.prefix + "r2")});
    if (!(terms.distance2 > 0.0f)) {
        cosine.help = "The lamp itself stands here: there is no direction to it.";
        cosine.expression = "0";
        cosine.inputs.clear();
    }
    formulas.push_back(cosine);
    formulas.push_back({point.prefix + "area",
                        "4πr²",
                        "The sphere over which the lamp's power has spread at this distance.",
                        "4 · π · r²",
                        {{"π", {3.14159265f}, from_words("the constant π")},
                         {"r²", {terms.distance2}, from_formula(point.prefix + "r2")}},
                        {terms.sphere_area}});
    for (int i = 0; i < 3; ++i)
        append_channel(point, light, i, formulas);
    for (int i = 0; i < 3; ++i) {
        const std::string name = channel_names[i];
        formulas.push_back(
            {point.prefix + "R." + name,
             "R " + name,
             "Reflected light: what the surface gives back of the direct and the indirect light.",
             "ρ · (D + N)",
             {{"ρ",
               {point.reflectance.value[i]},
               point.reflectance.sources[static_cast<std::size_t>(i)]},
              {"D", {terms.direct[i]}, from_formula(point.prefix + "D." + name)},
              {"N", {light.indirect[i]}, from_setting("light.indirect")}},
             {terms.reflected[i]}});
    }
    const glm::vec3 colour = clamped(terms.reflected);
    for (int i = 0; i < 3; ++i) {
        const std::string name = channel_names[i];
        formulas.push_back({point.prefix + "colour." + name,
                            name,
                            "As the screen can show it: cut to 0..1.",
                            "clamp(R, 0, 1)",
                            {{"R", {terms.reflected[i]}, from_formula(point.prefix + "R." + name)}},
                            {colour[i]}});
    }
}

} // namespace rasterwalk
