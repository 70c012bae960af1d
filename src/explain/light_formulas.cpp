#include "explain/light_formulas.h"

#include "explain/highlight_formulas.h"
#include "explain/shadow_formulas.h"
#include "mistakes/light.h"
#include "mistakes/put_pixel.h"

namespace rasterwalk {

namespace {

/// The cosine, by the rule in use.
void add_cosine(FormulaWriter& write, const LitPoint& point, LightDirection direction) {
    Formula& cosine =
        write.add("cosine", "cosine",
                  "How steeply the light falls on the surface: r · n with both at unit length "
                  "(Lambert). No light comes from behind.",
                  "max(0, (r.x · n.x + r.y · n.y + r.z · n.z) / sqrt(r²))",
                  joined(write.vector("r").parts("r"), point.normal.parts("n")),
                  {point.light.diffuse.cosine});
    cosine.section = point.prefix + "lamp";
    if (direction == LightDirection::not_normalized) {
        cosine.help = "How steeply the light falls on the surface, by mistake with r at its full "
                      "length.";
        cosine.expression = "max(0, r.x · n.x + r.y · n.y + r.z · n.z)";
    } else {
        cosine.inputs.push_back(write.input("r²", "r2"));
    }
    if (!has_direction(point.light.diffuse)) {
        cosine.help = "0, because r² is not above 0, so there is no direction to the lamp.";
        cosine.expression = "0";
        cosine.inputs.clear();
    }
}

/// The area the power is spread over, by the rule in use.
void add_area(FormulaWriter& write, const LitPoint& point, LightFalloff falloff) {
    Formula& area = write.add(
        "area", "4πr²", "The sphere over which the lamp's power has spread at this distance.",
        "4 · π · r²", {{"π", {3.14159265f}, from_words("the constant π")}, write.input("r²", "r2")},
        {point.light.diffuse.sphere_area});
    area.section = point.prefix + "lamp";
    switch (falloff) {
    case LightFalloff::sphere:
        break;
    case LightFalloff::no_4pi:
        area.name = "r²";
        area.help = "What the power is divided by; the sphere is 4π times as large.";
        area.expression = "r²";
        area.inputs.erase(area.inputs.begin());
        break;
    case LightFalloff::linear:
        area.name = "r";
        area.help = "What the power is divided by: the distance, once.";
        area.expression = "sqrt(r²)";
        area.inputs.erase(area.inputs.begin());
        break;
    case LightFalloff::none:
        area.name = "fall-off";
        area.help = "What the power is divided by; the distance does not matter.";
        area.expression = "1";
        area.inputs.clear();
        break;
    case LightFalloff::pi_of_atan:
        area.help = "The sphere over which the power has spread, with a π that is 16 times too "
                    "small.";
        area.inputs.front() = {"π", {pi_of_atan}, from_words("atan(1) / 4, by mistake")};
        break;
    case LightFalloff::pi_three:
        area.help = "The sphere over which the power has spread, with 3 for π.";
        area.inputs.front() = {"π", {3.0f, true}, from_words("3, by mistake")};
        break;
    case LightFalloff::cubed:
        area.name = "4πr³";
        area.help = "What the power is divided by: a sphere's area times the distance once more.";
        area.expression = "4 · π · r² · sqrt(r²)";
        break;
    }
}

/// D = P (cosine / area): for grey light one line is listed.
void add_direct(FormulaWriter& write, const LitPoint& point, const Light& light) {
    const LightTerms& terms = point.light.diffuse;
    const bool is_grey = is_grey_light(terms.direct);
    for (int i = 0; i < 3; ++i) {
        const std::string name = channel_name(i);
        Formula& direct = write.add(
            "D." + name, "D " + name,
            "Direct light: the lamp's power spread over the sphere, weakened by the slant.",
            "P · (cosine / area)",
            {{"P", {light.power[i]}, from_setting("light.power")},
             write.input("cosine", "cosine"),
             write.input("area", "area")},
            {terms.direct[i]});
        if (!is_grey || i == 0) direct.section = point.prefix + "reflected";
        if (is_grey) direct.label = "D";
        if (point.light.shadow.is_tested) {
            direct.help += " Only the share s of it arrives.";
            direct.expression = "P · s · (cosine / area)";
            direct.inputs.push_back(write.input("s", "lit"));
        }
        if (!has_direction(terms)) {
            direct.help = "Direct light: none, because there is no direction to the lamp.";
            direct.expression = "0";
            direct.inputs.clear();
        }
    }
}

/// R = rho (D + N), and what comes on top of it.
void add_reflected(FormulaWriter& write, const LitPoint& point, const Light& light, LightSum rule) {
    for (int i = 0; i < 3; ++i) {
        const std::string name = channel_name(i);
        Formula& sum = write.add(
            "R." + name, "R " + name,
            "Reflected light: what the surface reflects of the direct and the indirect light.",
            "ρ · (D + N)",
            {point.reflectance.part("ρ", i),
             write.input("D", "D." + name),
             {"N", {light.indirect[i]}, from_setting("light.indirect")}},
            {point.light.reflected[i]});
        sum.section = point.prefix + "reflected";
        sum.warns = sum.result.value > 1.0f;
        if (rule == LightSum::reflectance_plus) {
            sum.help = "The direct light with, by mistake, the reflectance added to it.";
            sum.expression = "D + ρ";
            sum.inputs.pop_back();
        }
        if (rule == LightSum::reflectance_twice) {
            sum.help += " By mistake it includes the reflectance twice.";
            sum.expression = "ρ · ρ · (D + N)";
        }
        if (light.model == LightModel::lambert) continue;
        sum.help += " The highlight comes on top of it.";
        sum.expression += " + S";
        sum.inputs.push_back(write.input("S", "S." + name));
    }
}

/// The vector to the lamp, r, in the space where the light is worked out.
void add_way(FormulaWriter& write, const LitPoint& point, const Light& light,
             bool is_turned_round) {
    const std::string lamp_setting =
        light.place == LampPlace::camera ? "camera.position" : "light.position";
    const auto lamp = [&](int i) {
        return FormulaInput{"L." + axis_name(i), {light.position[i]}, from_setting(lamp_setting)};
    };
    const auto ends = [&](int i) {
        return FormulaInputs{lamp(i), point.position.part("p." + axis_name(i), i)};
    };
    const glm::vec3& to_light = point.light.diffuse.to_light;
    if (!point.space) {
        write.add_vector("r", "r",
                         is_turned_round ? "From the lamp to the point, the wrong way round."
                                         : "From the point to the lamp.",
                         is_turned_round ? "p.{} − L.{}" : "L.{} − p.{}", to_light, ends);
        return;
    }
    const SourcedVector world_vector =
        write.add_vector("way", "w", "From the point to the lamp, in the world.", "L.{} − p.{}",
                         light.position - point.position.value, ends);
    add_along_axes(write, "r", "r", "From the point to the lamp in tangent space: how far along ",
                   "w", world_vector, to_light);
    if (!is_turned_round) return;
    for (int i = 0; i < 3; ++i) {
        Formula& along = write.formula("r." + axis_name(i));
        along.help = "From the lamp to the point in tangent space, the wrong way round.";
        along.expression = "0 − (" + along.expression + ")";
    }
}

/// What the screen shows of a channel.
/// @param about before its help
void add_shown_channel(FormulaWriter& write, const std::string& name, const std::string& about,
                       const FormulaInput& channel, const Frame& frame) {
    const ScreenRules& screen = frame.stages.screen;
    const Encoding encoding = frame.settings.encoding;
    const std::string encoded = encoding == Encoding::srgb ? "srgb(" + channel.symbol + ")"
                                : encoding == Encoding::gamma
                                    ? "pow(max(0, " + channel.symbol + "), 1 / γ)"
                                    : channel.symbol;
    Formula& formula = write.add(name, name, about + "As the screen can show it: clamped to 0..1.",
                                 "clamp(" + encoded + ", 0, 1)", {channel},
                                 {screen.visible_channel(screen.encode(channel.number.value))});
    // "pixel_light.colour." is listed as pixel_light.colour.
    formula.section = write.prefix().substr(0, write.prefix().size() - 1);
    if (frame.settings.colour_over_one == ColourOverOne::wrap) {
        formula.help =
            about + "As the screen shows it: the lowest 8 bits of 255 times the channel.";
        formula.expression = "wrap(int(255 · " + encoded + "), 256) / 255";
    }
    if (encoding == Encoding::srgb)
        formula.help += " Before that, the light is encoded by the sRGB curve, which the screen "
                        "undoes.";
    if (encoding == Encoding::gamma) {
        formula.help += " Before that, by mistake, it is raised to the power of 1/γ.";
        formula.inputs.push_back({"γ", {gamma_of_screens}, from_words("the gamma of screens")});
    }
}

} // namespace

bool has_direction(const LightTerms& terms) {
    return terms.distance2 > 0.0f && terms.sphere_area > 0.0f;
}

bool is_grey_light(const glm::vec3& light) {
    return light.r == light.g && light.g == light.b;
}

SourcedVector add_along_axes(FormulaWriter& write, const std::string& id, const std::string& symbol,
                             const std::string& help, const std::string& from_symbol,
                             const SourcedVector& from, const glm::vec3& result) {
    for (int i = 0; i < 3; ++i) {
        const std::string along = tangent_names[static_cast<std::size_t>(i)];
        write.add_dot(id + "." + axis_name(i), symbol + "." + axis_name(i), help + along + ".",
                      from_symbol, from, along, write.under("bump.square.").vector(along),
                      result[i]);
    }
    return write.vector(id);
}

FormulaInput append_painted(FormulaWriter& write, const std::string& help, int channel,
                            const FormulaInput& light, float texture) {
    const std::string name = channel_name(channel), id = "painted." + name;
    write
        .add(id, "R " + name, help, "R · t",
             {light, {"t", {texture}, from_formula("texture." + name)}},
             {light.number.value * texture})
        .section = write.prefix() + "reflected";
    return write.input(light.symbol, id);
}

void append_shown_colour(const std::string& prefix, const std::array<FormulaInput, 3>& channels,
                         const std::string& about, const Frame& frame,
                         std::vector<Formula>& formulas) {
    const bool is_turned = frame.settings.channel_order == ChannelOrder::bgr;
    FormulaWriter write(formulas, prefix);
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const std::string name = channel_names[i];
        const std::size_t from = is_turned ? channels.size() - 1 - i : i;
        add_shown_channel(write, name, about, channels[from], frame);
        if (from != i)
            write.formula(name).help += std::string(" By mistake the screen takes ") +
                                        channel_names[from] + " for " + name + ".";
    }
}

void append_side_formulas(LitPoint& point, const SourcedVector& surface, const Frame& frame,
                          std::vector<Formula>& formulas) {
    if (frame.settings.light_rules.sides == LightSides::one) return;
    const SightRays rays = pixel_rules(frame).rays;
    const std::string section = point.prefix + "lamp";
    FormulaWriter write(formulas, point.prefix);
    SourcedVector ray{sight_ray(point.position.value, rays), {}};
    ray.sources.fill(from_words("the ray of sight, from the eye to the point"));
    write
        .add_dot("away", "n · s",
                 "Above 0 if the normal points away from the eye; s is the ray of sight, from the "
                 "eye to the point.",
                 "n", surface, "s", ray, glm::dot(surface.value, ray.value))
        .section = section;
    const float side = frame.stages.light_side(point.position.value, surface.value, rays);
    const bool is_turned = side < 0.0f;
    write
        .add("side", "side",
             is_turned ? "The surface faces away from the eye, so its normal is negated, because "
                         "both sides are lit."
                       : "The surface faces the eye, so its normal stays as it is.",
             is_turned ? "−1" : "1", {}, {side})
        .section = section;
    const SourcedVector normal = point.normal;
    point.normal = write.add_vector(
        "lit_n", "n",
        "The normal on the side that the eye sees; the light is computed with this one.",
        "side · n.{}", side * normal.value, [&](int i) {
            return FormulaInputs{write.input("side", "side"), normal.part("n." + axis_name(i), i)};
        });
    if (point.space) point.space->normal_world = side * point.space->normal_world;
}

void append_light_formulas(const LitPoint& point, const Frame& frame,
                           std::vector<Formula>& formulas) {
    const LightTerms& terms = point.light.diffuse;
    const LightRules& rules = frame.settings.light_rules;
    const Light light = light_rule(frame.settings);
    FormulaWriter write(formulas, point.prefix);
    add_way(write, point, light, rules.direction == LightDirection::from_light);
    Formula& square =
        write.add("r2", "r²", "The distance to the lamp, squared.", "r.x² + r.y² + r.z²",
                  write.vector("r").parts("r"), {terms.distance2});
    square.section = point.prefix + "lamp";
    if (rules.direction == LightDirection::with_w) {
        square.help += " By mistake it includes the square of w, which is 1.";
        square.expression += " + 1";
    }
    add_cosine(write, point, rules.direction);
    add_area(write, point, rules.falloff);
    append_shadow_formulas(point, frame, formulas);
    add_direct(write, point, light);
    if (light.model != LightModel::lambert) append_highlight_formulas(point, frame, formulas);
    add_reflected(write, point, light, rules.sum);
    std::array<FormulaInput, 3> channels;
    for (int i = 0; i < 3; ++i) {
        FormulaInput& channel = channels[static_cast<std::size_t>(i)];
        channel = write.input("R", "R." + channel_name(i));
        if (point.paint)
            channel = append_painted(write, "The reflected light, multiplied by the texture.", i,
                                     channel, (*point.paint)[i]);
    }
    append_shown_colour(point.prefix + "colour.", channels, "", frame, formulas);
}

} // namespace rasterwalk
