#include "explain/highlight_formulas.h"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "stages/surface_shader.h"

namespace rasterwalk {

namespace {

/// A vector whose components are formulas of the point: "l.x".
SourcedVector part_formulas(const LitPoint& point, const std::string& symbol,
                            const glm::vec3& value) {
    SourcedVector vector{value, {}};
    for (std::size_t i = 0; i < 3; ++i)
        vector.sources[i] = from_formula(point.prefix + symbol + "." + axis_names[i]);
    return vector;
}

/// Writes the formulas of one highlight.
class HighlightMaker {
  public:
    HighlightMaker(const LitPoint& point, const Frame& frame, std::vector<Formula>& formulas)
        : point_(point), frame_(frame), formulas_(formulas),
          rays_(pixel_rules(frame.settings, frame.scene->space).rays) {}

    void add_all() {
        const bool is_there = !(terms().to_eye == glm::vec3(0.0f));
        if (is_there) {
            add_directions();
            add_half();
        }
        add_power(is_there);
        for (int i = 0; i < 3; ++i)
            add_channel(i, is_there);
    }

  private:
    const HighlightTerms& terms() const { return point_.light.highlight; }

    void add(std::string id, std::string name, std::string help, std::string expression,
             std::vector<FormulaInput> inputs, float result) {
        formulas_.push_back({point_.prefix + std::move(id),
                             std::move(name),
                             std::move(help),
                             std::move(expression),
                             std::move(inputs),
                             {result}});
    }

    FormulaInput own(const std::string& symbol, const std::string& id, float value) const {
        return {symbol, {value}, from_formula(point_.prefix + id)};
    }

    std::vector<FormulaInput> own_parts(const std::string& symbol, const glm::vec3& value) const {
        return parts_of_vector(symbol, part_formulas(point_, symbol, value));
    }

    glm::vec3 way_in_world() const { return -sight_ray(point_.position.value, rays_); }
    /// In the space where the light is worked out.
    glm::vec3 way_to_eye() const {
        return point_.space ? along_axes(way_in_world(), point_.space->axes) : way_in_world();
    }
    float eye_distance2() const { return glm::dot(way_to_eye(), way_to_eye()); }

    /// From the point to the eye in tangent space: how far along each axis.
    void add_ways_along_axes() {
        const SourcedVector way = part_formulas(point_, "eye", way_in_world());
        const glm::vec3 along = way_to_eye();
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string symbol = std::string("e.") + axis_names[i];
            formulas_.push_back(along_axis_formula(
                point_.prefix + symbol, symbol,
                std::string("From the point to the eye in tangent space: how far along ") +
                    tangent_names[i] + ".",
                "q", way, point_.space->axes, i, along[static_cast<int>(i)]));
        }
    }

    /// From the point to the eye in the world, by the sight rays.
    /// @param id, symbol of the vector, without its axis
    void add_way_to_eye(int i, const std::string& id, const std::string& symbol) {
        const std::string axis = axis_names[static_cast<std::size_t>(i)];
        const std::string camera = "C." + axis, place = "p." + axis;
        // In this order, as in the shader: C − p would be 0 where this is −0.
        std::string expression = "−(" + place + " − " + camera + ")";
        std::vector<FormulaInput> inputs{
            {camera, {rays_.camera[i]}, from_setting("camera.position")},
            {place,
             {point_.position.value[i]},
             point_.position.sources[static_cast<std::size_t>(i)]}};
        if (rays_.mix > 0.0f) {
            const std::string forward = "forward." + axis;
            expression = "−((1 − mix) · (" + place + " − " + camera + ") + mix · " + forward + ")";
            inputs.push_back({forward,
                              {rays_.forward[i]},
                              from_words("the direction in which the camera looks, of unit "
                                         "length")});
            inputs.push_back({"mix", {rays_.mix}, from_setting("projection_mix")});
        }
        add(id + "." + axis, symbol + "." + axis, "From the point to the eye.", expression, inputs,
            way_in_world()[i]);
    }

    void add_directions() {
        const LightTerms& light = point_.light.diffuse;
        const glm::vec3 to_eye = way_to_eye();
        for (int i = 0; i < 3; ++i) {
            const std::string axis = axis_names[static_cast<std::size_t>(i)];
            add("l." + axis, "l." + axis, "To the lamp, of unit length.",
                "r." + axis + " / sqrt(r²)",
                {own("r." + axis, "r." + axis, light.to_light[i]),
                 own("r²", "r2", light.distance2)},
                terms().to_light[i]);
        }
        for (int i = 0; i < 3; ++i)
            add_way_to_eye(i, point_.space ? "eye" : "e", point_.space ? "q" : "e");
        if (point_.space) add_ways_along_axes();
        const float eye2 = eye_distance2();
        add("e2", "e²", "The distance to the eye, squared.", "e.x² + e.y² + e.z²",
            own_parts("e", to_eye), eye2);
        for (int i = 0; i < 3; ++i) {
            const std::string axis = axis_names[static_cast<std::size_t>(i)];
            add("v." + axis, "v." + axis, "To the eye, of unit length.",
                "e." + axis + " / sqrt(e²)",
                {own("e." + axis, "e." + axis, to_eye[i]), own("e²", "e2", eye2)},
                terms().to_eye[i]);
        }
    }

    void add_half() {
        const glm::vec3 &l = terms().to_light, &v = terms().to_eye;
        const glm::vec3 sum = l + v;
        const float sum2 = glm::dot(sum, sum);
        const bool is_long = frame_.settings.light_rules.highlight == HighlightRule::long_half;
        std::vector<FormulaInput> both = own_parts("l", l);
        for (const FormulaInput& input : own_parts("v", v))
            both.push_back(input);
        add("s2", "s²", "The sum of l and v: its length, squared.",
            "(l.x + v.x)² + (l.y + v.y)² + (l.z + v.z)²", both, sum2);
        for (int i = 0; i < 3; ++i) {
            const std::string axis = axis_names[static_cast<std::size_t>(i)];
            std::vector<FormulaInput> inputs{own("l." + axis, "l." + axis, l[i]),
                                             own("v." + axis, "v." + axis, v[i])};
            std::string expression = "l." + axis + " + v." + axis;
            std::string help = "Halfway between l and v, by mistake as long as their sum.";
            if (!is_long && sum2 > 0.0f) {
                help = "Halfway between l and v, of unit length.";
                expression = "(" + expression + ") / sqrt(s²)";
                inputs.push_back(own("s²", "s2", sum2));
            } else if (!is_long) {
                help = "0, because s² is not above 0, so there is no direction halfway between l "
                       "and v.";
                expression = "0";
                inputs.clear();
            }
            add("h." + axis, "h." + axis, help, expression, inputs, terms().half[i]);
        }
    }

    void add_power(bool is_there) {
        const bool has_ways = has_direction(point_.light.diffuse) && eye_distance2() > 0.0f;
        const std::string none =
            has_ways ? "The lamp is behind the surface (n · l is not above 0), so there is no "
                       "highlight."
                     : "There is no direction to the lamp or to the eye, so there is no highlight.";
        if (!is_there) {
            add("n_dot_h", "n · h", none, "0", {}, terms().n_dot_h);
            add("power", "(n · h)^e", none, "0", {}, terms().power);
            return;
        }
        std::vector<FormulaInput> inputs = parts_of_vector("n", point_.normal);
        for (const FormulaInput& input : own_parts("h", terms().half))
            inputs.push_back(input);
        add("n_dot_h", "n · h",
            "How close the normal is to h: 1 where a mirror would show the lamp.",
            "max(0, n.x · h.x + n.y · h.y + n.z · h.z)", inputs, terms().n_dot_h);
        add("power", "(n · h)^e", "The larger the exponent, the faster the highlight falls off.",
            "pow(n·h, e)",
            {own("n·h", "n_dot_h", terms().n_dot_h),
             {"e", {point_.shine.exponent}, from_words("the exponent of the material")}},
            terms().power);
    }

    void add_channel(int i, bool is_there) {
        const std::string name = channel_names[static_cast<std::size_t>(i)];
        Formula shine{point_.prefix + "S." + name,
                      "S " + name,
                      "The highlight: the specular part of the light that arrives.",
                      "k · (P · (power / area))",
                      {{"k",
                        {point_.shine.specular[i]},
                        from_words("the specular colour of the "
                                   "material")},
                       {"P", {frame_.settings.light.power[i]}, from_setting("light.power")},
                       own("power", "power", terms().power),
                       own("area", "area", point_.light.diffuse.sphere_area)},
                      {terms().reflected[i]}};
        if (point_.light.shadow.is_asked) {
            shine.expression = "k · (P · s · (power / area))";
            shine.inputs.push_back(own("s", "lit", point_.light.shadow.lit));
        }
        if (!is_there) {
            shine.help = "There is no highlight.";
            shine.expression = "0";
            shine.inputs.clear();
        }
        formulas_.push_back(shine);
    }

    const LitPoint& point_;
    const Frame& frame_;
    std::vector<Formula>& formulas_;
    SightRays rays_;
};

} // namespace

void append_highlight_formulas(const LitPoint& point, const Frame& frame,
                               std::vector<Formula>& formulas) {
    HighlightMaker(point, frame, formulas).add_all();
}

void append_normal_formulas(LitPoint& point, const SourcedVector& interpolated, const Frame& frame,
                            std::vector<Formula>& formulas) {
    const LightRules& rules = frame.settings.light_rules;
    const bool is_moved = frame.settings.normal_w == NormalW::one;
    const float length2 = glm::dot(interpolated.value, interpolated.value);
    const float length = std::sqrt(length2);
    const std::string length_id = point.prefix + "n_length";
    formulas.push_back({length_id,
                        "|n|",
                        "How long the interpolated normal is. Between vertices whose normals "
                        "differ it is shorter than 1.",
                        "sqrt(n.x² + n.y² + n.z²)",
                        parts_of_vector("n", interpolated),
                        {length}});
    for (int i = 0; i < 3; ++i) {
        const auto part = static_cast<std::size_t>(i);
        const std::string axis = axis_names[part], symbol = "n." + axis;
        Formula normal{point.prefix + symbol,
                       symbol,
                       "The interpolated normal, made unit length again.",
                       symbol + " / |n|",
                       {{symbol, {interpolated.value[i]}, interpolated.sources[part]},
                        {"|n|", {length}, from_formula(length_id)}},
                       {point.normal.value[i]}};
        if (rules.renormalize == Renormalize::off) {
            normal.help = "The interpolated normal, by mistake not made unit length again.";
            normal.expression = symbol;
            normal.inputs.pop_back();
        } else if (!(length > 0.0f)) {
            normal.help = "0, because the interpolated normal has length 0 and so no direction.";
            normal.expression = "0";
            normal.inputs.clear();
        }
        if (is_moved) {
            normal.help += " Then taken to camera space with w = 1, as if it were a position.";
            normal.expression = symbol;
            normal.inputs = {{symbol, {point.normal.value[i]}, from_words("(n − C) / |n − C|")}};
        }
        formulas.push_back(normal);
        point.normal.sources[part] = from_formula(point.prefix + symbol);
    }
}

} // namespace rasterwalk
