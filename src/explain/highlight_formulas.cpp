#include "explain/highlight_formulas.h"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "stages/surface_shader.h"

namespace rasterwalk {

namespace {

/// Writes the formulas of one highlight.
class HighlightFormulas {
  public:
    HighlightFormulas(const LitPoint& point, const Frame& frame, std::vector<Formula>& formulas)
        : point_(point), frame_(frame), write_(formulas, point.prefix),
          rays_(pixel_rules(frame.settings, frame.scene->space).rays),
          is_there_(!(point.light.highlight.to_eye == glm::vec3(0.0f))) {}

    void add_all() {
        if (is_there_) {
            add_directions();
            add_half();
        }
        add_power();
        for (int i = 0; i < 3; ++i)
            add_channel(i);
    }

  private:
    const HighlightTerms& terms() const { return point_.light.highlight; }

    glm::vec3 eye_ray_in_world() const { return -sight_ray(point_.position.value, rays_); }
    /// In the space where the light is worked out.
    glm::vec3 eye_ray() const {
        return point_.space ? along_axes(eye_ray_in_world(), point_.space->axes)
                            : eye_ray_in_world();
    }
    float eye_distance2() const { return glm::dot(eye_ray(), eye_ray()); }

    SourcedVector add_to_eye(const std::string& id, const std::string& symbol) {
        return append_to_eye(write_, id, symbol, point_.position, rays_);
    }

    void add_directions() {
        write_.add_vector("l", "l", "To the lamp, of unit length.", "r.{} / sqrt(r²)",
                          terms().to_light, [&](int i) {
                              return FormulaInputs{write_.part("r." + axis_name(i), "r", i),
                                                   write_.input("r²", "r2")};
                          });
        if (point_.space) {
            add_along_axes(write_, "e", "e",
                           "From the point to the eye in tangent space: how far along ", "q",
                           add_to_eye("eye", "q"), eye_ray());
        } else {
            add_to_eye("e", "e");
        }
        write_.add("e2", "e²", "The distance to the eye, squared.", "e.x² + e.y² + e.z²",
                   write_.vector("e").parts("e"), {eye_distance2()});
        write_.add_vector("v", "v", "To the eye, of unit length.", "e.{} / sqrt(e²)",
                          terms().to_eye, [&](int i) {
                              return FormulaInputs{write_.part("e." + axis_name(i), "e", i),
                                                   write_.input("e²", "e2")};
                          });
    }

    void add_half() {
        const glm::vec3 sum = terms().to_light + terms().to_eye;
        const float sum2 = glm::dot(sum, sum);
        write_.add("s2", "s²", "The sum of l and v: its length, squared.",
                   "(l.x + v.x)² + (l.y + v.y)² + (l.z + v.z)²",
                   joined(write_.vector("l").parts("l"), write_.vector("v").parts("v")), {sum2});
        std::string help = "Halfway between l and v, of unit length.",
                    expression = "(l.{} + v.{}) / sqrt(s²)";
        const bool is_long = frame_.settings.light_rules.highlight == HighlightRule::long_half;
        const bool has_direction = sum2 > 0.0f;
        if (is_long) {
            help = "Halfway between l and v, by mistake as long as their sum.";
            expression = "l.{} + v.{}";
        } else if (!has_direction) {
            help = "0, because s² is not above 0, so there is no direction halfway between l and "
                   "v.";
            expression = "0";
        }
        write_.add_vector("h", "h", help, expression, terms().half, [&](int i) {
            FormulaInputs inputs{write_.part("l." + axis_name(i), "l", i),
                                 write_.part("v." + axis_name(i), "v", i)};
            if (!is_long && !has_direction) return FormulaInputs{};
            if (!is_long) inputs.push_back(write_.input("s²", "s2"));
            return inputs;
        });
    }

    void add_power() {
        const std::string section = point_.prefix + "reflected";
        Formula& n_dot_h =
            write_.add("n_dot_h", "n · h",
                       "How close the normal is to h: 1 where a mirror would show the lamp.",
                       "max(0, n.x · h.x + n.y · h.y + n.z · h.z)", {}, {terms().n_dot_h});
        n_dot_h.section = section;
        if (is_there_)
            n_dot_h.inputs = joined(point_.normal.parts("n"), write_.vector("h").parts("h"));
        Formula& power = write_.add(
            "power", "(n · h)^e", "The larger the exponent, the faster the highlight falls off.",
            "pow(n·h, e)",
            {write_.input("n·h", "n_dot_h"),
             {"e",
              {exponent_of(point_.shine, frame_.settings.light)},
              frame_.settings.light.exponent > 0.0f ? from_setting("light.exponent")
                                                    : from_words("the exponent of the material")}},
            {terms().power});
        power.section = section;
        if (is_there_) return;
        const bool has_sights = has_direction(point_.light.diffuse) && eye_distance2() > 0.0f;
        for (const char* const id : {"n_dot_h", "power"}) {
            Formula& none = write_.formula(id);
            none.help = has_sights
                            ? "The lamp is behind the surface (n · l is not above 0), so there is "
                              "no highlight."
                            : "There is no direction to the lamp or to the eye, so there is no "
                              "highlight.";
            none.expression = "0";
            none.inputs.clear();
        }
    }

    void add_channel(int i) {
        const std::string name = channel_name(i);
        const bool is_grey = is_grey_light(terms().reflected);
        Formula& shine = write_.add(
            "S." + name, "S " + name, "The highlight: the specular part of the light that arrives.",
            "k · (P · (power / area))",
            {{"k", {point_.shine.specular[i]}, from_words("the specular colour of the material")},
             {"P", {frame_.settings.light.power[i]}, from_setting("light.power")},
             write_.input("power", "power"),
             write_.input("area", "area")},
            {terms().reflected[i]});
        if (!is_grey || i == 0) shine.section = point_.prefix + "reflected";
        if (is_grey) shine.label = "S";
        if (point_.light.shadow.is_tested) {
            shine.expression = "k · (P · s · (power / area))";
            shine.inputs.push_back(write_.input("s", "lit"));
        }
        if (!is_there_) {
            shine.help = "There is no highlight.";
            shine.expression = "0";
            shine.inputs.clear();
        }
    }

    const LitPoint& point_;
    const Frame& frame_;
    FormulaWriter write_;
    SightRays rays_;
    bool is_there_; ///< the highlight
};

} // namespace

SourcedVector append_to_eye(FormulaWriter& write, const std::string& id, const std::string& symbol,
                            const SourcedVector& position, const SightRays& rays) {
    const bool is_mixed = rays.mix > 0.0f;
    // In this order, as in the shader: C − p would be 0 where this is −0.
    return write.add_vector(
        id, symbol, "From the point to the eye.",
        is_mixed ? "−((1 − mix) · (p.{} − C.{}) + mix · forward.{})" : "−(p.{} − C.{})",
        -sight_ray(position.value, rays), [&](int i) {
            const std::string axis = axis_name(i);
            FormulaInputs inputs{{"C." + axis, {rays.camera[i]}, from_setting("camera.position")},
                                 position.part("p." + axis, i)};
            if (!is_mixed) return inputs;
            inputs.push_back({"forward." + axis,
                              {rays.forward[i]},
                              from_words("the direction in which the camera looks, of unit "
                                         "length")});
            inputs.push_back({"mix", {rays.mix}, from_setting("projection_mix")});
            return inputs;
        });
}

void append_highlight_formulas(const LitPoint& point, const Frame& frame,
                               std::vector<Formula>& formulas) {
    HighlightFormulas(point, frame, formulas).add_all();
}

void append_normal_formulas(LitPoint& point, const SourcedVector& interpolated, const Frame& frame,
                            std::vector<Formula>& formulas) {
    FormulaWriter write(formulas, point.prefix);
    const float length2 = glm::dot(interpolated.value, interpolated.value);
    const float length = std::sqrt(length2);
    write
        .add_length("n_length", "|n|",
                    "How long the interpolated normal is. Between vertices whose normals differ it "
                    "is shorter than 1.",
                    "n", interpolated, length)
        .section = point.prefix + "normal";
    std::string help = "The interpolated normal, made unit length again.",
                expression = "n.{} / |n|";
    const bool is_kept = frame.settings.light_rules.renormalize == Renormalize::off;
    const bool is_zero = !is_kept && !(length > 0.0f);
    const bool is_moved = frame.settings.normal_w == NormalW::one;
    if (is_kept) {
        help = "The interpolated normal, by mistake not made unit length again.";
        expression = "n.{}";
    } else if (is_zero) {
        help = "0, because the interpolated normal has length 0 and so no direction.";
        expression = "0";
    }
    if (is_moved) {
        help += " Then taken to camera space with w = 1, as if it were a position.";
        expression = "n.{}";
    }
    const glm::vec3 normal = point.normal.value;
    point.normal = write.add_vector("n", "n", help, expression, normal, [&](int i) {
        const std::string symbol = "n." + axis_name(i);
        if (is_moved) return FormulaInputs{{symbol, {normal[i]}, from_words("(n − C) / |n − C|")}};
        if (is_zero) return FormulaInputs{};
        FormulaInputs inputs{interpolated.part(symbol, i)};
        if (!is_kept) inputs.push_back(write.input("|n|", "n_length"));
        return inputs;
    });
}

} // namespace rasterwalk
