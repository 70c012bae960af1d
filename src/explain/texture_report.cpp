#include "explain/texture_report.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "explain/fragment_report.h"
#include "explain/light_formulas.h"
#include "inspect/carried_row.h"
#include "pipeline/surface.h"

namespace rasterwalk {

namespace {

/// One of the two directions in a texture.
struct TextureAxis {
    int index;
    const char* coordinate; ///< "u"
    const char* place;      ///< "x": in texels
    const char* count;      ///< "width"
    const char* line;       ///< "column": of a texel
    TextureDirection direction;
};
constexpr std::array texture_axes{TextureAxis{0, "u", "x", "width", "column", TextureDirection::u},
                                  TextureAxis{1, "v", "y", "height", "row", TextureDirection::v}};

int size_of(const TextureLevel& level, const TextureAxis& axis) {
    return axis.index == 0 ? level.width : level.height;
}

int line_of(const SampledTexel& texel, const TextureAxis& axis) {
    return axis.index == 0 ? texel.column : texel.row;
}

std::string level_id(int level, const std::string& what) {
    return fmt::format("level.{}.{}", level, what);
}

std::string texel_id(int number, const std::string& what) {
    return fmt::format("texel.{}.{}", number, what);
}

FormulaInput whole_input(std::string symbol, int value, const std::string& words) {
    return {std::move(symbol), {static_cast<float>(value), true}, from_words(words)};
}

/// Makes the formulas of one fragment's texture, in order.
class TextureFormulas {
  public:
    TextureFormulas(const TextureReport& report, const Frame& frame, int triangle,
                    std::array<std::string, 2> coordinate_ids, std::vector<Formula>& formulas)
        : report_(report), frame_(frame), triangle_(triangle),
          coordinate_ids_(std::move(coordinate_ids)), formulas_(formulas),
          write_(formulas, "texture.") {}

    void append() {
        const TextureLevel& base = report_.surface.texture->base();
        for (const TextureAxis& axis : texture_axes)
            add_place(axis.place, axis, base, "the texture").section = "texture";
        add_side("right", "the next column", report_.place.footprint.right,
                 report_.surface.texture_slope.texcoord_right,
                 report_.surface.texture_slope.weight_right, report_.right);
        add_side("down", "the next row", report_.place.footprint.down,
                 report_.surface.texture_slope.texcoord_down,
                 report_.surface.texture_slope.weight_down, report_.down);
        add_level();
        if (is_nearest())
            add_nearest();
        else
            add_texels();
        for (int channel = 0; channel < 3; ++channel)
            add_colour(channel);
    }

  private:
    bool is_nearest() const { return frame_.settings.texture_filter == TextureFilter::nearest; }

    /// Where the texture is read.
    FormulaInput coordinate(const TextureAxis& axis) const {
        const std::string shifted = std::string("parallax.") + axis.coordinate;
        if (find_formula(formulas_, shifted) == nullptr) return carried(axis);
        return {axis.coordinate, {report_.place.texcoord[axis.index]}, from_formula(shifted)};
    }

    /// The same before a height map shifts it.
    FormulaInput carried(const TextureAxis& axis) const {
        return {axis.coordinate,
                {report_.carried[axis.index]},
                from_formula(coordinate_ids_[static_cast<std::size_t>(axis.index)])};
    }

    /// Where the position is among the texels.
    float among(const TextureAxis& axis, int count) const {
        return frame_.stages.texel_place(report_.place.texcoord[axis.index], axis.direction, count);
    }

    /// The same as an expression.
    std::string among_expression(const TextureAxis& axis) const {
        const TexelRule rule = frame_.settings.texel_rule;
        if (rule == TexelRule::upside_down && axis.direction == TextureDirection::v)
            return fmt::format("(1 − {}) · {}", axis.coordinate, axis.count);
        return fmt::format("{} · {}{}", axis.coordinate, axis.count,
                           rule == TexelRule::whole_centres ? " + 1/2" : "");
    }

    Formula& add_place(const std::string& id, const TextureAxis& axis, const TextureLevel& level,
                       const std::string& of) {
        const int count = size_of(level, axis);
        const float place = among(axis, count);
        Formula& formula = write_.add(
            id, axis.place,
            fmt::format("The position in {}, counted in texels; texel i goes from i to i + 1.", of),
            among_expression(axis),
            {coordinate(axis),
             whole_input(axis.count, count, fmt::format("{} of {}, texels", axis.count, of))},
            {place});
        if (evaluate(formula) != place) {
            formula.help = "The position is not a number that can be counted in texels, so 0 is "
                           "used.";
            formula.expression =
                frame_.settings.texel_rule == TexelRule::whole_centres ? "1/2" : "0";
            formula.inputs.clear();
        }
        return formula;
    }

    /// How far u and v move from one pixel to the next, and how far that is in texels.
    void add_side(const std::string& name, const std::string& next, const glm::vec2& side,
                  const glm::vec2& slope, float weight_slope, float length) {
        const Interpolation mode = frame_.settings.interpolation;
        const bool is_divided = mode != Interpolation::affine;
        const bool has_weight = is_divided && mode != Interpolation::undivided;
        const bool is_squared = mode == Interpolation::divided_twice;
        const bool is_mixed = mode == Interpolation::mixed;
        const TextureLevel& base = report_.surface.texture->base();
        const std::string weight(is_mixed ? "the weight" : weight_name(frame_));
        for (const TextureAxis& axis : texture_axes) {
            const std::string u = axis.coordinate;
            const Quantity quantity = quantity_of(&Varyings::texcoord, axis.index);
            write_.add(
                fmt::format("{}.{}", name, u),
                fmt::format("d{}/d{}", u, name == "right" ? "x" : "y"),
                fmt::format("How fast {} changes toward {}: the derivative of a quotient.", u,
                            next),
                fmt::format("(d − {} · e) / w", u),
                {{"d",
                  {slope[axis.index]},
                  from_words(
                      fmt::format("how much {} grows by to {}, the same over the whole triangle",
                                  is_mixed     ? std::string(u) + " times the weight"
                                  : is_divided ? carried_name_in(frame_, quantity)
                                               : std::string(u),
                                  next))},
                 carried(axis),
                 {"e",
                  {weight_slope},
                  from_words(is_squared ? "how much " + weight + " times " + weight +
                                              " grows by to " + next + ", as if in equal steps"
                             : has_weight ? "how much " + weight + " grows by to " + next
                                          : "there is no weight to change")},
                 {"w",
                  {report_.weight},
                  is_squared   ? from_words(weight + " times " + weight + ", by mistake")
                  : is_mixed   ? from_words("the weight here, (1 − m) + m d/z")
                  : has_weight ? from_formula("zinv")
                  : is_divided ? from_words("nothing is divided, by mistake")
                               : from_words("affine values have no weight")}},
                {side[axis.index]});
        }
        write_
            .add(name, name,
                 fmt::format("How far a pixel reaches toward {}, in texels of the texture.", next),
                 "sqrt(du · width · (du · width) + dv · height · (dv · height))",
                 {write_.input("du", name + ".u"),
                  whole_input("width", base.width, "width of the texture, texels"),
                  write_.input("dv", name + ".v"),
                  whole_input("height", base.height, "height of the texture, texels")},
                 {length})
            .section = "texture";
    }

    void add_level() {
        Formula& level = write_.add(
            "level", "level",
            "The mip level whose texels are as large as the pixel. Each level is half as wide and "
            "high as the previous one.",
            "min(log2(max(1, max(right, down))), last)",
            {write_.input("right", "right"), write_.input("down", "down"),
             whole_input("last", report_.surface.texture->last_level(),
                         "the last level, of one texel")},
            {report_.level});
        const TextureFilter filter = frame_.settings.texture_filter;
        if (filter == TextureFilter::mipmap || filter == TextureFilter::trilinear)
            level.section = "texture";
        if (frame_.settings.texel_rule != TexelRule::level_along_x) return;
        level.help += " By mistake only the reach toward the next column counts.";
        level.expression = "min(log2(max(1, right)), last)";
        level.inputs.erase(level.inputs.begin() + 1);
    }

    /// The number of a texel after wrapping, as an expression in `texel`.
    std::string wrapped(const std::string& texel) const {
        switch (frame_.settings.texture_wrap) {
        case TextureWrap::repeat:
            if (frame_.settings.texel_rule == TexelRule::remainder)
                return fmt::format("{0} − n · int({0} / n)", texel);
            break;
        case TextureWrap::clamp:
            return fmt::format("clamp({}, 0, n − 1)", texel);
        case TextureWrap::mirror:
            return fmt::format("min(wrap({0}, 2 · n), 2 · n − 1 − wrap({0}, 2 · n))", texel);
        }
        return fmt::format("wrap({}, n)", texel);
    }

    /// @param offset from the previous texel: 0 or 1; -1: the texel in which it lies
    void add_line(int number, const TextureAxis& axis, int offset) {
        const SampledTexel& texel = report_.taken.list[static_cast<std::size_t>(number)];
        const TextureLevel& level =
            report_.surface.texture->levels[static_cast<std::size_t>(texel.level)];
        const std::string x = axis.place;
        const std::string id = offset < 0 ? x : level_id(texel.level, x);
        const std::string place = offset < 0    ? fmt::format("floor({})", x)
                                  : offset == 0 ? fmt::format("floor({} − 1/2)", x)
                                                : fmt::format("(floor({} − 1/2) + 1)", x);
        write_.add(
            texel_id(number, axis.line), fmt::format("{} of texel {}", axis.line, number),
            offset < 0 ? "The texel that contains the position, wrapped at the borders."
                       : "A texel whose centre is next to the position, wrapped at the borders.",
            wrapped(place),
            {write_.input(x, id), whole_input("n", size_of(level, axis),
                                              fmt::format("{} of the level, texels", axis.count))},
            {static_cast<float>(line_of(texel, axis)), true});
    }

    void add_nearest() {
        for (const TextureAxis& axis : texture_axes)
            add_line(0, axis, -1);
        write_.add(texel_id(0, "weight"), "weight of texel 0", "One texel alone colours the pixel.",
                   "1", {}, {1.0f, true});
    }

    /// How far the position lies beyond the centre of the previous texel.
    float beyond_centre(int level, const TextureAxis& axis) const {
        const TextureLevel& texels =
            report_.surface.texture->levels[static_cast<std::size_t>(level)];
        const float place = among(axis, size_of(texels, axis)) - 0.5f;
        return place - std::floor(place);
    }

    void add_texels() {
        int before = -1;
        for (int k = 0; k < report_.taken.count; ++k) {
            const SampledTexel& texel = report_.taken.list[static_cast<std::size_t>(k)];
            if (texel.level != before) add_place_in_level(texel.level);
            before = texel.level;
            // From left to right, then the row below.
            add_line(k, texture_axes[0], k % 2);
            add_line(k, texture_axes[1], k / 2 % 2);
            add_weight(k);
        }
    }

    void add_place_in_level(int level) {
        const TextureLevel& texels =
            report_.surface.texture->levels[static_cast<std::size_t>(level)];
        for (const TextureAxis& axis : texture_axes) {
            const std::string x = axis.place;
            add_place(level_id(level, x), axis, texels, fmt::format("level {}", level));
            write_.add(level_id(level, "f" + x), "f" + x,
                       "How far the position is beyond the centre of the previous texel: 0 is that "
                       "centre, 1 is the next.",
                       fmt::format("{0} − 1/2 − floor({0} − 1/2)", x),
                       {write_.input(x, level_id(level, x))}, {beyond_centre(level, axis)});
        }
    }

    void add_weight(int number) {
        const SampledTexel& texel = report_.taken.list[static_cast<std::size_t>(number)];
        const bool is_right = number % 2 == 1, is_below = number / 2 % 2 == 1;
        Formula& formula = write_.add(
            texel_id(number, "weight"), fmt::format("weight of texel {}", number),
            "How close the position is to the texel's centre, along both directions.",
            fmt::format("{} · {}", is_right ? "fx" : "(1 − fx)", is_below ? "fy" : "(1 − fy)"),
            {write_.input("fx", level_id(texel.level, "fx")),
             write_.input("fy", level_id(texel.level, "fy"))},
            {texel.weight});
        if (frame_.settings.texture_filter == TextureFilter::trilinear) {
            formula.help += " Times the weight of its level, that is, how close it is to the level "
                            "wanted.";
            const bool is_first = number < 4;
            formula.expression +=
                is_first ? " · (1 − (level − floor(level)))" : " · (level − floor(level))";
            formula.inputs.push_back(write_.input("level", "level"));
        }
    }

    void add_colour(int channel) {
        const std::string name = channel_name(channel);
        std::string expression;
        FormulaInputs inputs;
        for (int k = 0; k < report_.taken.count; ++k) {
            const SampledTexel& texel = report_.taken.list[static_cast<std::size_t>(k)];
            const std::string colour = fmt::format("c{}", k), weight = fmt::format("w{}", k);
            expression += fmt::format("{}{} · {}", k > 0 ? " + " : "", colour, weight);
            inputs.push_back(
                {colour,
                 {texel.colour[channel]},
                 from_words(fmt::format("{} of the texel in column {}, row {} of level {}", name,
                                        texel.column, texel.row, texel.level))});
            inputs.push_back(write_.input(weight, texel_id(k, "weight")));
        }
        write_.add(name, "texture's " + name,
                   "The texels that were taken, each multiplied by its weight.", expression, inputs,
                   {report_.colour[channel]});
        const float reflectance = report_.reflectance[channel];
        write_.under("surface.")
            .add(name, "surface's " + name,
                 "The reflectance of the surface, multiplied by its texture.", "ρ · t",
                 {{"ρ", {reflectance}, reflectance_source(channel, name)}, write_.input("t", name)},
                 {reflectance * report_.colour[channel]});
    }

    /// Where the colour of the surface itself comes from.
    Source reflectance_source(int channel, const std::string& name) const {
        if (!report_.surface.differences.colours)
            return from_vertex(triangle_, 0, "reflectance." + name);
        const std::string id =
            formula_id(quantity_of(&Varyings::colour, channel), frame_.settings.interpolation);
        return find_formula(formulas_, id) != nullptr
                   ? from_formula(id)
                   : from_words("the colours of the vertices, interpolated");
    }

    const TextureReport& report_;
    const Frame& frame_;
    int triangle_;
    std::array<std::string, 2> coordinate_ids_;
    const std::vector<Formula>& formulas_;
    FormulaWriter write_;
};

} // namespace

const SampledTexel& TextureReport::heaviest() const {
    return *std::max_element(
        taken.begin(), taken.end(),
        [](const SampledTexel& a, const SampledTexel& b) { return a.weight < b.weight; });
}

std::optional<TextureReport> texture_report(const Frame& frame, int triangle,
                                            const Fragment& fragment) {
    TextureReport report;
    report.surface = lit_surface_of(frame, triangle);
    if (report.surface.texture == nullptr) return std::nullopt;
    const Texture& texture = *report.surface.texture;
    report.weight = weight_of(fragment, frame.stages);
    report.place = place_in_texture(fragment, report.surface, pixel_rules(frame), frame.stages);
    report.carried = carried_place(fragment, report.surface, frame.stages).texcoord;
    report.reflectance = reflectance_at(fragment, report.surface, frame.stages);
    report.right = side_in_texels(report.place.footprint.right, texture.base());
    report.down = side_in_texels(report.place.footprint.down, texture.base());
    report.level = frame.stages.texture_level(report.place.footprint, texture);
    report.colour = frame.stages.sample_texture(texture, report.place, frame.stages, &report.taken);
    return report;
}

std::optional<TextureReport> texture_report(const Frame& frame, const Cursor& cursor) {
    const bool is_fragment = cursor.phase == Phase::rows && cursor.triangle >= 0 &&
                             cursor.triangle < frame.triangle_count() &&
                             frame.is_drawn(cursor.triangle);
    if (!is_textured(frame) || !is_fragment) return std::nullopt;
    const std::optional<CarriedRow> row = carried_row(frame, cursor.triangle, cursor.index);
    if (!row || cursor.step < 0 || cursor.step >= row->count) return std::nullopt;
    return texture_report(frame, cursor.triangle,
                          row->at(frame.settings.interpolation, cursor.step));
}

void append_texture_formulas(const TextureReport& report, const Frame& frame, int triangle,
                             const std::string& u_id, const std::string& v_id,
                             std::vector<Formula>& formulas) {
    TextureFormulas(report, frame, triangle, {u_id, v_id}, formulas).append();
}

} // namespace rasterwalk
