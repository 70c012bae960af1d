#include "explain/shadow_formulas.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/element_names.h"

namespace rasterwalk {

namespace {

/// What casts the shadow: shadows are cast by the scene as it is, whatever list is drawn.
std::string occluder_words(const Frame& frame, int triangle) {
    return fmt::format("{}{} ({})", frame.list == nullptr ? "" : "the scene's ",
                       triangle_name(triangle), part_name(*frame.in_order, triangle));
}

/// Writes the formulas of one point.
class ShadowFormulas {
  public:
    ShadowFormulas(const LitPoint& point, const Frame& frame, std::vector<Formula>& formulas)
        : point_(point), terms_(point.light.shadow), frame_(frame), write_(formulas, point.prefix),
          section_(point.prefix + "shadow"), lamp_(light_rule(frame.settings)) {}

    void add_all() {
        if (terms_.face < 0)
            add_ray();
        else
            add_map();
    }

  private:
    /// Adds a formula that is listed.
    void list(const std::string& id, std::string name, std::string help, std::string expression,
              FormulaInputs inputs, Number result) {
        write_
            .add(id, std::move(name), std::move(help), std::move(expression), std::move(inputs),
                 result)
            .section = section_;
    }
    void add_lit(const std::string& expression, FormulaInputs inputs) {
        list("lit", "s",
             "The share of the lamp's light that arrives. " + shadow_text(terms_, frame_) + ".",
             expression, std::move(inputs), {terms_.lit});
    }

    FormulaInput lamp(int i) const {
        const char* const name =
            lamp_.place == LampPlace::camera ? "camera.position" : "light.position";
        return {"L." + axis_name(i), {lamp_.position[i]}, from_setting(name)};
    }
    FormulaInput place(int i) const { return point_.position.part("p." + axis_name(i), i); }

    void add_ray() {
        // The ray runs through the world, wherever the light is worked out.
        SourcedVector normal = point_.normal;
        if (point_.space) {
            normal.value = point_.space->normal_world;
            normal.sources.fill(from_words("the bent normal in the world, on the lit side"));
        }
        write_.add_vector(
            "shadow.from", "o",
            "Where the ray to the lamp starts: a little above the surface, along the normal.",
            "p.{} + ε · n.{}", terms_.ray.from, [&](int i) {
                return FormulaInputs{
                    place(i),
                    {"ε", {frame_.settings.shadow_rules.offset}, from_setting("shadow_offset")},
                    normal.part("n." + axis_name(i), i)};
            });
        write_.add_vector(
            "shadow.way", "w", "From the start of the ray to the lamp.", "L.{} − o.{}",
            terms_.ray.direction, [&](int i) {
                return FormulaInputs{lamp(i), write_.part("o." + axis_name(i), "shadow.from", i)};
            });
        if (terms_.hit.is_hit()) {
            const int triangle = terms_.hit.triangle;
            list("shadow.t", "t",
                 "How far along the ray it first meets a triangle: 0 is the start of the ray, 1 is "
                 "the lamp.",
                 "t",
                 {{"t",
                   {terms_.hit.t},
                   from_words("o + t · w meets " + occluder_words(frame_, triangle))}},
                 {terms_.hit.t});
        }
        add_lit(terms_.is_dark() ? "0" : "1", {});
    }

    /// One coordinate of the point seen from the lamp: each face looks along an axis of the world.
    void add_from_face(int part, const std::string& id, const std::string& name) {
        const glm::vec3& axis =
            frame_.occluders.map->faces[static_cast<std::size_t>(terms_.face)].axes[part];
        const int i = axis.x != 0.0f ? 0 : axis.y != 0.0f ? 1 : 2;
        const std::string world = axis_name(i);
        const bool is_along = axis[i] > 0.0f;
        Formula& seen =
            write_.add("shadow.seen." + id, name,
                       fmt::format("The point as seen from the lamp, which looks along {} there.",
                                   face_name()),
                       is_along ? "p." + world + " − L." + world : "L." + world + " − p." + world,
                       {place(i), lamp(i)}, {terms_.from_face[part]});
        if (part == 2) seen.section = section_;
    }

    std::string face_name() const {
        return shadow_face_names[static_cast<std::size_t>(terms_.face)];
    }

    void add_place(int part, const std::string& id, const std::string& seen) {
        const int resolution = frame_.occluders.map->resolution;
        const int half = resolution / 2;
        write_.add(
            "shadow." + id, id,
            "Where the point falls on the face, in texels. It is projected as by a camera at the "
            "lamp with a 90-degree view, so f is half of a side.",
            "f · " + seen + " · (1 / z) + m",
            {{"f", {0.5f * static_cast<float>(resolution)}, from_setting("shadow_resolution")},
             write_.input(seen, "shadow.seen." + seen),
             write_.input("z", "shadow.seen.z"),
             {"m", {static_cast<float>(half), true}, from_setting("shadow_resolution")}},
            {terms_.place[part]});
    }

    void add_bias() {
        const ShadowRules& rules = frame_.settings.shadow_rules;
        if (rules.slope_bias == 0.0f) return;
        const float texel =
            2.0f * terms_.from_face.z / static_cast<float>(frame_.occluders.map->resolution);
        list("shadow.bias", "bias",
             "How far the point may lie behind the depth that the lamp saw. It is more where the "
             "surface slopes away from the lamp.",
             "b + k · texel · slope",
             {{"b", {rules.bias}, from_setting("shadow_bias")},
              {"k", {rules.slope_bias}, from_setting("shadow_slope_bias")},
              {"texel", {texel}, from_words("the width of a texel at that depth, 2 z / n")},
              {"slope",
               {shadow_slope(terms_.point.cosine)},
               from_words("the tangent of the angle between the light and the normal")}},
             {terms_.bias});
    }

    /// The value of a texel of the map.
    void add_texel(const std::string& id, const ShadowTexel& texel) {
        if (!(texel.inv_depth > 0.0f)) return;
        Formula& map = write_.add(
            id, "z in the map",
            "How far the lamp saw in that direction. The map is a depth buffer, so it holds 1/z.",
            "1 / h", {{"h", {texel.inv_depth}, from_texel(terms_.face, texel.column, texel.row)}},
            {1.0f / texel.inv_depth});
        if (terms_.texel_count == 1) map.section = section_;
    }

    void add_map() {
        add_from_face(0, "right", "right");
        add_from_face(1, "down", "down");
        add_from_face(2, "z", "z");
        add_place(0, "column", "right");
        add_place(1, "row", "down");
        add_bias();
        const bool has_slope = frame_.settings.shadow_rules.slope_bias != 0.0f;
        list("shadow.compared", "z − bias", "The depth that is compared with the one in the map.",
             "z − b",
             {write_.input("z", "shadow.seen.z"),
              {"b",
               {terms_.bias},
               has_slope ? from_formula(point_.prefix + "shadow.bias")
                         : from_setting("shadow_bias")}},
             {terms_.compared});
        std::string sum;
        FormulaInputs inputs;
        for (int i = 0; i < terms_.texel_count; ++i) {
            const ShadowTexel& texel = terms_.texels[static_cast<std::size_t>(i)];
            const std::string id =
                terms_.texel_count == 1 ? "shadow.map" : fmt::format("shadow.map.{}", i);
            add_texel(id, texel);
            const std::string symbol = fmt::format("lit{}", i);
            sum += (i == 0 ? "" : " + ") + symbol;
            inputs.push_back(
                {symbol,
                 {texel.is_lit ? 1.0f : 0.0f, true},
                 from_words(fmt::format(
                     "column {}, row {} of face {}: {}", texel.column, texel.row, face_name(),
                     texel.is_lit ? "nothing nearer was seen" : "something nearer was seen"))});
        }
        if (terms_.texel_count > 1) sum = fmt::format("({}) / {}", sum, terms_.texel_count);
        add_lit(sum, inputs);
    }

    const LitPoint& point_;
    const ShadowTerms& terms_;
    const Frame& frame_;
    FormulaWriter write_;
    std::string section_; ///< where the numbers to look at are listed
    Light lamp_;
};

/// With enough digits to tell depths apart.
std::string depth_text(float depth) {
    return fmt::format("{:.4f}", depth);
}

std::string ray_text(const TriangleHit& hit, const Frame& frame) {
    if (!hit.is_hit()) return "Lit: nothing is between here and the lamp";
    const std::string who = occluder_words(frame, hit.triangle);
    if (hit.t > 1.0f)
        return fmt::format("In shadow by mistake: {} is behind the lamp, {:.2f} times as far away",
                           who, hit.t);
    return fmt::format("In shadow: {} is in between, {:.2f} of the way to the lamp", who, hit.t);
}

std::string map_text(const ShadowTerms& terms) {
    const std::string here =
        fmt::format("this is at {} − {}", depth_text(terms.from_face.z), depth_text(terms.bias));
    const char* const face = shadow_face_names[static_cast<std::size_t>(terms.face)];
    if (terms.texel_count > 1) {
        const auto* const end = terms.texels.begin() + terms.texel_count;
        const auto dark = std::count_if(terms.texels.begin(), end,
                                        [](const ShadowTexel& texel) { return !texel.is_lit; });
        return fmt::format("{}: in {} of {} texels the lamp saw something nearer; {} (face {})",
                           dark == 0          ? "Lit"
                           : terms.lit > 0.0f ? "Partly lit"
                                              : "In shadow",
                           dark, terms.texel_count, here, face);
    }
    const ShadowTexel& texel = terms.texels[0];
    const std::string where =
        fmt::format("face {}, column {}, row {}", face, texel.column, texel.row);
    if (!(texel.inv_depth > 0.0f))
        return fmt::format("Lit: the lamp saw nothing there ({})", where);
    return fmt::format("{}: the lamp saw as far as {}; {} ({})",
                       terms.is_dark() ? "In shadow" : "Lit", depth_text(1.0f / texel.inv_depth),
                       here, where);
}

} // namespace

void append_shadow_formulas(const LitPoint& point, const Frame& frame,
                            std::vector<Formula>& formulas) {
    if (point.light.shadow.is_tested) ShadowFormulas(point, frame, formulas).add_all();
}

std::string shadow_text(const ShadowTerms& terms, const Frame& frame) {
    if (occluders_of(frame) == nullptr) return {};
    if (!terms.is_tested) return "Unlit: the surface faces away from the lamp";
    return terms.face < 0 ? ray_text(terms.hit, frame) : map_text(terms);
}

} // namespace rasterwalk
