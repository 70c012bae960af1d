#include "explain/shadow_formulas.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/element_names.h"

namespace rasterwalk {

namespace {

/// Writes the formulas of one point.
class ShadowMaker {
  public:
    ShadowMaker(const LitPoint& point, const Frame& frame, std::vector<Formula>& formulas)
        : point_(point), terms_(point.light.shadow), frame_(frame), formulas_(formulas),
          lamp_(light_rule(frame.settings)) {}

    void add_all() {
        if (terms_.face < 0)
            add_ray();
        else
            add_map();
    }

  private:
    void add(const std::string& id, std::string name, std::string help, std::string expression,
             std::vector<FormulaInput> inputs, float result) {
        formulas_.push_back({point_.prefix + id,
                             std::move(name),
                             std::move(help),
                             std::move(expression),
                             std::move(inputs),
                             {result}});
    }

    FormulaInput own(const std::string& symbol, const std::string& id, float value) const {
        return {symbol, {value}, from_formula(point_.prefix + id)};
    }
    FormulaInput lamp(std::size_t axis) const {
        const char* const name =
            lamp_.place == LampPlace::camera ? "camera.position" : "light.position";
        return {std::string("L.") + axis_names[axis],
                {lamp_.position[static_cast<int>(axis)]},
                from_setting(name)};
    }
    FormulaInput place(std::size_t axis) const {
        return {std::string("p.") + axis_names[axis],
                {point_.position.value[static_cast<int>(axis)]},
                point_.position.sources[axis]};
    }

    void add_ray() {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string axis = axis_names[i], normal = "n." + axis;
            // The ray runs through the world, wherever the light is worked out.
            const FormulaInput lifted =
                point_.space
                    ? FormulaInput{normal,
                                   {point_.space->normal_world[static_cast<int>(i)]},
                                   from_words("the bent normal in the world, on the lit side")}
                    : FormulaInput{normal,
                                   {point_.normal.value[static_cast<int>(i)]},
                                   point_.normal.sources[i]};
            add("shadow.from." + axis, "o." + axis,
                "Where the ray to the lamp starts: a little above the surface, along the normal.",
                "p." + axis + " + ε · " + normal,
                {place(i),
                 {"ε", {frame_.settings.shadow_rules.offset}, from_setting("shadow_offset")},
                 lifted},
                terms_.ray.from[static_cast<int>(i)]);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string axis = axis_names[i], from = "o." + axis;
            add("shadow.way." + axis, "w." + axis, "From the start of the ray to the lamp.",
                "L." + axis + " − " + from,
                {lamp(i), own(from, "shadow.from." + axis, terms_.ray.from[static_cast<int>(i)])},
                terms_.ray.way[static_cast<int>(i)]);
        }
        if (terms_.hit.is_hit()) {
            const int triangle = terms_.hit.triangle;
            add("shadow.t", "t",
                "How far along the ray it first meets a triangle: 0 is the start of the ray, 1 is "
                "the lamp.",
                "t",
                {{"t",
                  {terms_.hit.t},
                  from_words(fmt::format("o + t · w meets {} ({})", triangle_name(triangle),
                                         part_name(*frame_.scene, triangle)))}},
                terms_.hit.t);
        }
        const std::string help = shadow_text(terms_, frame_) + ".";
        add("lit", "s", "The share of the lamp's light that arrives. " + help,
            terms_.is_dark() ? "0" : "1", {}, terms_.lit);
    }

    /// One coordinate of the point seen from the lamp: each face looks along an axis of the world.
    void add_seen(int part, const std::string& id, const std::string& name) {
        const glm::vec3& axis =
            frame_.occluders.map->faces[static_cast<std::size_t>(terms_.face)].axes[part];
        const std::size_t i = axis.x != 0.0f ? 0 : axis.y != 0.0f ? 1 : 2;
        const std::string world = axis_names[i];
        const bool is_along = axis[static_cast<int>(i)] > 0.0f;
        add("shadow.seen." + id, name,
            fmt::format("The point as seen from the lamp, which looks along {} there.",
                        face_name()),
            is_along ? "p." + world + " − L." + world : "L." + world + " − p." + world,
            {place(i), lamp(i)}, terms_.seen[part]);
    }

    std::string face_name() const {
        return shadow_face_names[static_cast<std::size_t>(terms_.face)];
    }

    void add_place(int part, const std::string& id, const std::string& seen) {
        const int resolution = frame_.occluders.map->resolution;
        const int half = resolution / 2;
        add("shadow." + id, id,
            "Where the point falls on the face, in texels. It is projected as by a camera at the "
            "lamp with a 90-degree view, so f is half of a side.",
            "f · " + seen + " · (1 / z) + m",
            {{"f", {0.5f * static_cast<float>(resolution)}, from_setting("shadow_resolution")},
             own(seen, "shadow.seen." + seen, terms_.seen[part]),
             own("z", "shadow.seen.z", terms_.seen.z),
             {"m", {static_cast<float>(half), true}, from_setting("shadow_resolution")}},
            terms_.place[part]);
    }

    void add_bias() {
        const ShadowRules& rules = frame_.settings.shadow_rules;
        if (rules.slope_bias == 0.0f) return;
        const float texel =
            2.0f * terms_.seen.z / static_cast<float>(frame_.occluders.map->resolution);
        add("shadow.bias", "bias",
            "How far the point may lie behind the depth that the lamp saw. It is more where the "
            "surface slopes away from the lamp.",
            "b + k · texel · slope",
            {{"b", {rules.bias}, from_setting("shadow_bias")},
             {"k", {rules.slope_bias}, from_setting("shadow_slope_bias")},
             {"texel", {texel}, from_words("the width of a texel at that depth, 2 z / n")},
             {"slope",
              {shadow_slope(terms_.point.cosine)},
              from_words("the tangent of the angle between the light and the normal")}},
            terms_.bias);
    }

    /// The value of a texel of the map.
    void add_texel(const std::string& id, const ShadowTexel& texel) {
        if (!(texel.inv_depth > 0.0f)) return;
        add(id, "z in the map",
            "How far the lamp saw in that direction. The map is a depth buffer, so it holds 1/z.",
            "1 / h",
            {{"h",
              {texel.inv_depth},
              from_words(fmt::format("column {}, row {} of face {}", texel.column, texel.row,
                                     face_name()))}},
            1.0f / texel.inv_depth);
    }

    void add_map() {
        add_seen(0, "right", "right");
        add_seen(1, "down", "down");
        add_seen(2, "z", "z");
        add_place(0, "column", "right");
        add_place(1, "row", "down");
        add_bias();
        const bool has_slope = frame_.settings.shadow_rules.slope_bias != 0.0f;
        add("shadow.compared", "z − bias", "The depth that is compared with the one in the map.",
            "z − b",
            {own("z", "shadow.seen.z", terms_.seen.z),
             {"b",
              {terms_.bias},
              has_slope ? from_formula(point_.prefix + "shadow.bias")
                        : from_setting("shadow_bias")}},
            terms_.compared);
        std::string sum;
        std::vector<FormulaInput> inputs;
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
        add("lit", "s",
            "The share of the lamp's light that arrives. " + shadow_text(terms_, frame_) + ".", sum,
            inputs, terms_.lit);
    }

    const LitPoint& point_;
    const ShadowTerms& terms_;
    const Frame& frame_;
    std::vector<Formula>& formulas_;
    Light lamp_;
};

/// With enough digits to tell depths apart.
std::string depth_text(float depth) {
    return fmt::format("{:.4f}", depth);
}

std::string ray_text(const TriangleHit& hit, const Frame& frame) {
    if (!hit.is_hit()) return "Lit: nothing is between here and the lamp";
    const std::string who =
        fmt::format("{} ({})", triangle_name(hit.triangle), part_name(*frame.scene, hit.triangle));
    if (hit.t > 1.0f)
        return fmt::format("In shadow by mistake: {} is behind the lamp, {:.2f} times as far away",
                           who, hit.t);
    return fmt::format("In shadow: {} is in between, {:.2f} of the way to the lamp", who, hit.t);
}

std::string map_text(const ShadowTerms& terms) {
    const std::string here =
        fmt::format("this is at {} − {}", depth_text(terms.seen.z), depth_text(terms.bias));
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
    if (point.light.shadow.is_asked) ShadowMaker(point, frame, formulas).add_all();
}

std::string shadow_text(const ShadowTerms& terms, const Frame& frame) {
    if (occluders_of(frame) == nullptr) return {};
    if (!terms.is_asked) return "Unlit: the surface faces away from the lamp";
    return terms.face < 0 ? ray_text(terms.hit, frame) : map_text(terms);
}

} // namespace rasterwalk
