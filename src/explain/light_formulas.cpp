#include "explain/light_formulas.h"

#include "explain/highlight_formulas.h"
#include "explain/shadow_formulas.h"
#include "mistakes/light.h"
#include "mistakes/put_pixel.h"

namespace rasterwalk {

namespace {

SourcedVector ray(const LitPoint& point) {
    SourcedVector r{point.light.diffuse.to_light, {}};
    for (std::size_t i = 0; i < 3; ++i)
        r.sources[i] = from_formula(point.prefix + "r." + axis_names[i]);
    return r;
}

/// The cosine, by the rule in use.
Formula cosine_formula(const LitPoint& point, LightDirection direction) {
    Formula cosine{point.prefix + "cosine",
                   "cosine",
                   "How steeply the light falls on the surface: r · n with both at unit length "
                   "(Lambert). No light comes from behind.",
                   "max(0, (r.x · n.x + r.y · n.y + r.z · n.z) / sqrt(r²))",
                   parts_of_vector("r", ray(point)),
                   {point.light.diffuse.cosine}};
    for (const FormulaInput& n : parts_of_vector("n", point.normal))
        cosine.inputs.push_back(n);
    if (direction == LightDirection::not_normalized) {
        cosine.help = "How steeply the light falls on the surface, by mistake with r at its full "
                      "length.";
        cosine.expression = "max(0, r.x · n.x + r.y · n.y + r.z · n.z)";
    } else {
        cosine.inputs.push_back(
            {"r²", {point.light.diffuse.distance2}, from_formula(point.prefix + "r2")});
    }
    if (!has_direction(point.light.diffuse)) {
        cosine.help = "0, because r² is not above 0, so there is no direction to the lamp.";
        cosine.expression = "0";
        cosine.inputs.clear();
    }
    return cosine;
}

/// The area the power is spread over, by the rule in use.
Formula area_formula(const LitPoint& point, LightFalloff falloff) {
    Formula area{point.prefix + "area",
                 "4πr²",
                 "The sphere over which the lamp's power has spread at this distance.",
                 "4 · π · r²",
                 {{"π", {3.14159265f}, from_words("the constant π")},
                  {"r²", {point.light.diffuse.distance2}, from_formula(point.prefix + "r2")}},
                 {point.light.diffuse.sphere_area}};
    if (falloff == LightFalloff::no_4pi) {
        area.name = "r²";
        area.help = "What the power is divided by; the sphere is 4π times as large.";
        area.expression = "r²";
        area.inputs.erase(area.inputs.begin());
    }
    if (falloff == LightFalloff::linear) {
        area.name = "r";
        area.help = "What the power is divided by: the distance, once.";
        area.expression = "sqrt(r²)";
        area.inputs.erase(area.inputs.begin());
    }
    if (falloff == LightFalloff::none) {
        area.name = "fall-off";
        area.help = "What the power is divided by; the distance does not matter.";
        area.expression = "1";
        area.inputs.clear();
    }
    if (falloff == LightFalloff::pi_of_atan) {
        area.help = "The sphere over which the power has spread, with a π that is 16 times too "
                    "small.";
        area.inputs.front() = {"π", {pi_of_atan}, from_words("atan(1) / 4, by mistake")};
    }
    if (falloff == LightFalloff::pi_three) {
        area.help = "The sphere over which the power has spread, with 3 for π.";
        area.inputs.front() = {"π", {3.0f, true}, from_words("3, by mistake")};
    }
    if (falloff == LightFalloff::cubed) {
        area.name = "4πr³";
        area.help = "What the power is divided by: a sphere's area times the distance once more.";
        area.expression = "4 · π · r² · sqrt(r²)";
    }
    return area;
}

/// D = P (cosine / area), and R = rho (D + N), for one channel.
void append_channel(const LitPoint& point, const Light& light, int channel,
                    std::vector<Formula>& formulas) {
    const std::string name = channel_names[channel];
    const LightTerms& terms = point.light.diffuse;
    Formula direct{point.prefix + "D." + name,
                   "D " + name,
                   "Direct light: the lamp's power spread over the sphere, weakened by the slant.",
                   "P · (cosine / area)",
                   {{"P", {light.power[channel]}, from_setting("light.power")},
                    {"cosine", {terms.cosine}, from_formula(point.prefix + "cosine")},
                    {"area", {terms.sphere_area}, from_formula(point.prefix + "area")}},
                   {terms.direct[channel]}};
    if (point.light.shadow.is_asked) {
        direct.help += " Only the share s of it arrives.";
        direct.expression = "P · s · (cosine / area)";
        direct.inputs.push_back(
            {"s", {point.light.shadow.lit}, from_formula(point.prefix + "lit")});
    }
    if (!has_direction(terms)) {
        direct.help = "Direct light: none, because there is no direction to the lamp.";
        direct.expression = "0";
        direct.inputs.clear();
    }
    formulas.push_back(direct);
}

} // namespace

bool has_direction(const LightTerms& terms) {
    return terms.distance2 > 0.0f && terms.sphere_area > 0.0f;
}

std::vector<FormulaInput> parts_of_vector(const std::string& symbol, const SourcedVector& vector) {
    std::vector<FormulaInput> inputs;
    for (int i = 0; i < 3; ++i) {
        inputs.push_back({symbol + "." + axis_names[static_cast<std::size_t>(i)],
                          {vector.value[i]},
                          vector.sources[static_cast<std::size_t>(i)]});
    }
    return inputs;
}

SourcedVector axis_of_space(const TangentFrame& axes, std::size_t axis) {
    SourcedVector vector{axis == 0 ? axes.tangent : axis == 1 ? axes.bitangent : axes.normal, {}};
    for (std::size_t i = 0; i < 3; ++i)
        vector.sources[i] =
            from_formula(std::string("bump.square.") + tangent_names[axis] + "." + axis_names[i]);
    return vector;
}

Formula along_axis_formula(const std::string& id, const std::string& name, const std::string& help,
                           const std::string& symbol, const SourcedVector& way,
                           const TangentFrame& axes, std::size_t axis, float result) {
    const std::string along = tangent_names[axis];
    Formula formula{id,
                    name,
                    help,
                    symbol + ".x · " + along + ".x + " + symbol + ".y · " + along + ".y + " +
                        symbol + ".z · " + along + ".z",
                    parts_of_vector(symbol, way),
                    {result}};
    for (const FormulaInput& part : parts_of_vector(along, axis_of_space(axes, axis)))
        formula.inputs.push_back(part);
    return formula;
}

FormulaInput append_painted(const std::string& prefix, const std::string& help, int channel,
                            const FormulaInput& light, float texture,
                            std::vector<Formula>& formulas) {
    const std::string name = channel_names[static_cast<std::size_t>(channel)];
    const std::string id = prefix + "painted." + name;
    const Number result{light.number.value * texture};
    formulas.push_back({id,
                        "R " + name,
                        help,
                        "R · t",
                        {light, {"t", {texture}, from_formula("texture." + name)}},
                        result});
    return {light.symbol, result, from_formula(id)};
}

namespace {

/// What the screen shows of a channel.
Formula shown_channel(std::string id, std::string name, const FormulaInput& channel,
                      const Frame& frame) {
    const ScreenRules& screen = frame.stages.screen;
    const Encoding encoding = frame.settings.encoding;
    const std::string encoded = encoding == Encoding::srgb ? "srgb(" + channel.symbol + ")"
                                : encoding == Encoding::gamma
                                    ? "pow(max(0, " + channel.symbol + "), 1 / γ)"
                                    : channel.symbol;
    Formula formula{std::move(id),
                    std::move(name),
                    "As the screen can show it: clamped to 0..1.",
                    "clamp(" + encoded + ", 0, 1)",
                    {channel},
                    {screen.visible_channel(screen.encode(channel.number.value))}};
    if (frame.settings.colour_over_one == ColourOverOne::wrap) {
        formula.help = "As the screen shows it: the lowest 8 bits of 255 times the channel.";
        formula.expression = "wrap(int(255 · " + encoded + "), 256) / 255";
    }
    if (encoding == Encoding::srgb)
        formula.help += " Before that, the light is encoded by the sRGB curve, which the screen "
                        "undoes.";
    if (encoding == Encoding::gamma) {
        formula.help += " Before that, by mistake, it is raised to the power of 1/γ.";
        formula.inputs.push_back({"γ", {gamma_of_screens}, from_words("the gamma of screens")});
    }
    return formula;
}

} // namespace

void append_shown_colour(const std::string& prefix, const std::array<FormulaInput, 3>& channels,
                         const std::string& about, const Frame& frame,
                         std::vector<Formula>& formulas) {
    const bool is_turned = frame.settings.channel_order == ChannelOrder::bgr;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const std::string name = channel_names[i];
        const std::size_t from = is_turned ? channels.size() - 1 - i : i;
        Formula shown = shown_channel(prefix + name, name, channels[from], frame);
        shown.help.insert(0, about);
        if (from != i)
            shown.help += std::string(" By mistake the screen takes ") + channel_names[from] +
                          " for " + name + ".";
        formulas.push_back(shown);
    }
}

void append_side_formulas(LitPoint& point, const SourcedVector& surface, const Frame& frame,
                          std::vector<Formula>& formulas) {
    if (frame.settings.light_rules.sides == LightSides::one) return;
    const SightRays rays = pixel_rules(frame).rays;
    const glm::vec3 ray = sight_ray(point.position.value, rays);
    const float side = frame.stages.light_side(point.position.value, surface.value, rays);
    Formula away{point.prefix + "away",
                 "n · s",
                 "Above 0 if the normal points away from the eye; s is the ray of sight, from the "
                 "eye to the point.",
                 "n.x · s.x + n.y · s.y + n.z · s.z",
                 parts_of_vector("n", surface),
                 {glm::dot(surface.value, ray)}};
    for (int i = 0; i < 3; ++i) {
        away.inputs.push_back({std::string("s.") + axis_names[static_cast<std::size_t>(i)],
                               {ray[i]},
                               from_words("the ray of sight, from the eye to the point")});
    }
    formulas.push_back(away);
    const bool is_turned = side < 0.0f;
    formulas.push_back({point.prefix + "side",
                        "side",
                        is_turned ? "The surface faces away from the eye, so its normal is "
                                    "negated, because both sides are lit."
                                  : "The surface faces the eye, so its normal stays as it is.",
                        is_turned ? "−1" : "1",
                        {},
                        {side}});
    for (int i = 0; i < 3; ++i) {
        const auto part = static_cast<std::size_t>(i);
        const std::string axis = axis_names[part], id = point.prefix + "lit_n." + axis;
        const float lit = side * point.normal.value[i];
        formulas.push_back({id,
                            "n." + axis,
                            "The normal on the side that the eye sees; the light is computed with "
                            "this one.",
                            "side · n." + axis,
                            {{"side", {side}, from_formula(point.prefix + "side")},
                             {"n." + axis, {point.normal.value[i]}, point.normal.sources[part]}},
                            {lit}});
        point.normal.value[i] = lit;
        point.normal.sources[part] = from_formula(id);
    }
    if (point.space) point.space->normal_world = side * point.space->normal_world;
}

namespace {

/// The vector to the lamp in tangent space: first in the world, then along each axis.
void append_way_along_axes(const LitPoint& point, const Light& light, bool is_turned_round,
                           std::vector<Formula>& formulas) {
    const SourcedVector& place = point.position;
    SourcedVector way{light.position - place.value, {}};
    for (int i = 0; i < 3; ++i) {
        const auto part = static_cast<std::size_t>(i);
        const std::string axis = axis_names[part], id = point.prefix + "way." + axis;
        formulas.push_back({id,
                            "w." + axis,
                            "From the point to the lamp, in the world.",
                            "L." + axis + " − p." + axis,
                            {{"L." + axis,
                              {light.position[i]},
                              from_setting(light.place == LampPlace::camera ? "camera.position"
                                                                            : "light.position")},
                             {"p." + axis, {place.value[i]}, place.sources[part]}},
                            {way.value[i]}});
        way.sources[part] = from_formula(id);
    }
    for (int i = 0; i < 3; ++i) {
        const auto part = static_cast<std::size_t>(i);
        Formula along = along_axis_formula(
            point.prefix + "r." + axis_names[part], std::string("r.") + axis_names[part],
            std::string("From the point to the lamp in tangent space: how far along ") +
                tangent_names[part] + ".",
            "w", way, point.space->axes, part, point.light.diffuse.to_light[i]);
        if (is_turned_round) {
            along.help = "From the lamp to the point in tangent space, the wrong way round.";
            along.expression = "0 − (" + along.expression + ")";
        }
        formulas.push_back(along);
    }
}

/// The vector to the lamp in the world.
void append_way(const LitPoint& point, const Light& light, bool is_turned_round,
                std::vector<Formula>& formulas) {
    const bool is_at_camera = light.place == LampPlace::camera;
    for (int i = 0; i < 3; ++i) {
        const std::string axis = axis_names[i];
        const std::string lamp = "L." + axis, place = "p." + axis;
        formulas.push_back({point.prefix + "r." + axis,
                            "r." + axis,
                            is_turned_round ? "From the lamp to the point, the wrong way round."
                                            : "From the point to the lamp.",
                            is_turned_round ? place + " − " + lamp : lamp + " − " + place,
                            {{lamp,
                              {light.position[i]},
                              from_setting(is_at_camera ? "camera.position" : "light.position")},
                             {place,
                              {point.position.value[i]},
                              point.position.sources[static_cast<std::size_t>(i)]}},
                            {point.light.diffuse.to_light[i]}});
    }
}

} // namespace

void append_light_formulas(const LitPoint& point, const Frame& frame,
                           std::vector<Formula>& formulas) {
    const Settings& settings = frame.settings;
    const LightTerms& terms = point.light.diffuse;
    const LightRules& rules = settings.light_rules;
    const Light light = light_rule(settings);
    const bool is_turned_round = rules.direction == LightDirection::from_light;
    if (point.space)
        append_way_along_axes(point, light, is_turned_round, formulas);
    else
        append_way(point, light, is_turned_round, formulas);
    Formula square{point.prefix + "r2",
                   "r²",
                   "The distance to the lamp, squared.",
                   "r.x² + r.y² + r.z²",
                   parts_of_vector("r", ray(point)),
                   {terms.distance2}};
    if (rules.direction == LightDirection::with_w) {
        square.help += " By mistake it includes the square of w, which is 1.";
        square.expression += " + 1";
    }
    formulas.push_back(square);
    formulas.push_back(cosine_formula(point, rules.direction));
    formulas.push_back(area_formula(point, rules.falloff));
    append_shadow_formulas(point, frame, formulas);
    for (int i = 0; i < 3; ++i)
        append_channel(point, light, i, formulas);
    const bool has_highlight = light.model != LightModel::lambert;
    if (has_highlight) append_highlight_formulas(point, frame, formulas);
    for (int i = 0; i < 3; ++i) {
        const std::string name = channel_names[i];
        Formula sum{point.prefix + "R." + name,
                    "R " + name,
                    "Reflected light: what the surface reflects of the direct and the indirect "
                    "light.",
                    "ρ · (D + N)",
                    {{"ρ",
                      {point.reflectance.value[i]},
                      point.reflectance.sources[static_cast<std::size_t>(i)]},
                     {"D", {terms.direct[i]}, from_formula(point.prefix + "D." + name)},
                     {"N", {light.indirect[i]}, from_setting("light.indirect")}},
                    {point.light.reflected[i]}};
        if (rules.sum == LightSum::reflectance_plus) {
            sum.help = "The direct light with, by mistake, the reflectance added to it.";
            sum.expression = "D + ρ";
            sum.inputs.pop_back();
        }
        if (rules.sum == LightSum::reflectance_twice) {
            sum.help += " By mistake it includes the reflectance twice.";
            sum.expression = "ρ · ρ · (D + N)";
        }
        if (has_highlight) {
            sum.help += " The highlight comes on top of it.";
            sum.expression += " + S";
            sum.inputs.push_back({"S",
                                  {point.light.highlight.reflected[i]},
                                  from_formula(point.prefix + "S." + name)});
        }
        formulas.push_back(sum);
    }
    std::array<FormulaInput, 3> channels;
    for (int i = 0; i < 3; ++i) {
        FormulaInput& channel = channels[static_cast<std::size_t>(i)];
        channel = {
            "R", {point.light.reflected[i]}, from_formula(point.prefix + "R." + channel_names[i])};
        if (point.paint) {
            channel = append_painted(point.prefix,
                                     "The reflected light, multiplied by the "
                                     "texture.",
                                     i, channel, (*point.paint)[i], formulas);
        }
    }
    append_shown_colour(point.prefix + "colour.", channels, "", frame, formulas);
}

} // namespace rasterwalk
