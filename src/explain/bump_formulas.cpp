#include "explain/bump_formulas.h"

#include <cmath>

#include <fmt/format.h>

namespace rasterwalk {

namespace {

/// Makes the formulas of one fragment's bent normal, in order.
class BumpFormulas {
  public:
    BumpFormulas(const BumpReport& report, const Frame& frame, int triangle,
                 const SourcedVector& normal, std::vector<Formula>& formulas)
        : report_(report), frame_(frame), triangle_(triangle), normal_(normal),
          formulas_(formulas) {}

    void append() {
        if (report_.sign == 0.0f) return add_unbent();
        add_directions();
        add_tangent();
        add_bitangent();
        add_arrow();
        add_sum();
        if (report_.space) add_square();
    }

  private:
    using Corners = std::array<Vertex, triangle_corners>;

    void add(const std::string& id, const std::string& name, const std::string& help,
             const std::string& expression, const std::vector<FormulaInput>& inputs, float result) {
        formulas_.push_back({"bump." + id, name, help, expression, inputs, {result}});
    }

    static FormulaInput of_formula(const std::string& symbol, const std::string& id, float value) {
        return {symbol, {value}, from_formula("bump." + id)};
    }

    /// A vector whose parts have formulas bump.ID.x ...
    static SourcedVector vector_of(const std::string& id, const glm::vec3& value) {
        SourcedVector vector{value, {}};
        for (std::size_t i = 0; i < 3; ++i)
            vector.sources[i] = from_formula("bump." + id + "." + axis_names[i]);
        return vector;
    }

    static void append_parts(std::vector<FormulaInput>& inputs, const std::string& symbol,
                             const SourcedVector& vector) {
        for (const FormulaInput& part : parts_of_vector(symbol, vector))
            inputs.push_back(part);
    }

    void add_unbent() {
        for (int i = 0; i < 3; ++i) {
            const auto part = static_cast<std::size_t>(i);
            const std::string symbol = std::string("n.") + axis_names[part];
            add(std::string("normal.") + axis_names[part], symbol,
                "The normal of the surface, not bent, because the triangle has no area in the "
                "texture and so u has no direction on it.",
                symbol, {{symbol, {normal_.value[i]}, normal_.sources[part]}}, report_.normal[i]);
        }
    }

    /// Sides of the triangle in the world and in the texture, and the directions of u and v.
    void add_directions() {
        const Corners corners = corners_of(*frame_.scene, triangle_);
        std::array<glm::vec3, 2> sides;
        std::array<glm::vec2, 2> uvs;
        for (int s = 0; s < 2; ++s) {
            const auto side = static_cast<std::size_t>(s);
            const Vertex& to = corners[side + 1];
            sides[side] = to.position - corners[0].position;
            uvs[side] = to.texcoord - corners[0].texcoord;
            const std::string name = fmt::format("e{}", s + 1);
            for (int i = 0; i < 3; ++i) {
                const std::string axis = axis_names[static_cast<std::size_t>(i)];
                const std::string world = "world." + axis;
                add(fmt::format("side_{}.{}", s + 1, axis), name + "." + axis,
                    fmt::format("From vertex 0 of the triangle to vertex {}.", s + 1), "b − a",
                    {{"b", {to.position[i]}, from_vertex(triangle_, s + 1, world)},
                     {"a", {corners[0].position[i]}, from_vertex(triangle_, 0, world)}},
                    sides[side][i]);
            }
            for (int i = 0; i < 2; ++i) {
                const std::string axis = i == 0 ? "u" : "v";
                add(fmt::format("{}_{}", axis, s + 1), fmt::format("{}{}", axis, s + 1),
                    fmt::format("The same side in the texture, that is, how much {} grows along "
                                "it.",
                                axis),
                    "b − a",
                    {{"b",
                      {to.texcoord[i]},
                      from_words(fmt::format("{} of vertex {}", axis, s + 1))},
                     {"a", {corners[0].texcoord[i]}, from_words(axis + " of vertex 0")}},
                    uvs[side][i]);
            }
        }
        const FormulaInput u1 = of_formula("u1", "u_1", uvs[0].x),
                           v1 = of_formula("v1", "v_1", uvs[0].y),
                           u2 = of_formula("u2", "u_2", uvs[1].x),
                           v2 = of_formula("v2", "v_2", uvs[1].y);
        const float area = uvs[0].x * uvs[1].y - uvs[1].x * uvs[0].y;
        add("area", "area", "Twice the area that the triangle has in the texture, with its sign.",
            "u1 · v2 − u2 · v1", {u1, v2, u2, v1}, area);
        const FormulaInput of_area = of_formula("area", "area", area);
        for (int i = 0; i < 3; ++i) {
            const std::string axis = axis_names[static_cast<std::size_t>(i)];
            const FormulaInput e1 = of_formula("e1", "side_1." + axis, sides[0][i]),
                               e2 = of_formula("e2", "side_2." + axis, sides[1][i]);
            add("along_u." + axis, "U." + axis,
                "The vector along the surface as u grows by 1: a sum of the two sides, weighted so "
                "that v stays the same.",
                "(e1 · v2 − e2 · v1) / area", {e1, v2, e2, v1, of_area}, report_.uv.along_u[i]);
            add("along_v." + axis, "V." + axis,
                "The vector along the surface as v grows by 1: a sum of the two sides, weighted so "
                "that u stays the same.",
                "(e2 · u1 − e1 · u2) / area", {e2, u1, e1, u2, of_area}, report_.uv.along_v[i]);
        }
    }

    void add_tangent() {
        const glm::vec3& u = report_.uv.along_u;
        const float lean = glm::dot(normal_.value, u);
        std::vector<FormulaInput> inputs = parts_of_vector("n", normal_);
        append_parts(inputs, "U", vector_of("along_u", u));
        add("lean", "n · U", "How much of the direction of u runs along the normal.",
            "n.x · U.x + n.y · U.y + n.z · U.z", inputs, lean);
        const glm::vec3 flat = tangent_on_surface(report_.uv, normal_.value);
        for (int i = 0; i < 3; ++i) {
            const auto part = static_cast<std::size_t>(i);
            const std::string axis = axis_names[part];
            add("flat." + axis, "T." + axis,
                "The direction of u without the part that runs along the normal.",
                "U − n · (n · U)",
                {of_formula("U", "along_u." + axis, u[i]),
                 {"n", {normal_.value[i]}, normal_.sources[part]},
                 of_formula("(n · U)", "lean", lean)},
                flat[i]);
        }
        const float length = glm::length(flat);
        add("flat_length", "|T|", "Its length.", "sqrt(T.x² + T.y² + T.z²)",
            parts_of_vector("T", vector_of("flat", flat)), length);
        for (int i = 0; i < 3; ++i) {
            const std::string axis = axis_names[static_cast<std::size_t>(i)];
            add("tangent." + axis, "t." + axis,
                "The tangent: the direction in which u grows, made unit length.", "T / |T|",
                {of_formula("T", "flat." + axis, flat[i]),
                 of_formula("|T|", "flat_length", length)},
                report_.axes.tangent[i]);
        }
    }

    void add_bitangent() {
        const glm::vec3 across = glm::cross(report_.axes.normal, report_.axes.tangent);
        const SourcedVector tangent = vector_of("tangent", report_.axes.tangent);
        for (int i = 0; i < 3; ++i) {
            const auto j = static_cast<std::size_t>((i + 1) % 3),
                       k = static_cast<std::size_t>((i + 2) % 3);
            const auto part = [&](const char* symbol, const SourcedVector& vector, std::size_t a) {
                return FormulaInput{std::string(symbol) + "." + axis_names[a],
                                    {vector.value[static_cast<int>(a)]},
                                    vector.sources[a]};
            };
            const std::string axis = axis_names[static_cast<std::size_t>(i)];
            add("across." + axis, "c." + axis,
                "n × t, the cross product: perpendicular to both, on one of two sides.",
                fmt::format("n.{0} · t.{1} − t.{0} · n.{1}", axis_names[j], axis_names[k]),
                {part("n", normal_, j), part("t", tangent, k), part("t", tangent, j),
                 part("n", normal_, k)},
                across[i]);
        }
        const float v_grows = v_across(report_.uv, report_.axes);
        std::vector<FormulaInput> inputs = parts_of_vector("c", vector_of("across", across));
        append_parts(inputs, "V", vector_of("along_v", report_.uv.along_v));
        add("v_across", "c · V",
            "How v grows along c: below 0 because c points toward the texture's top, but above 0 "
            "where the texture is mirrored.",
            "c.x · V.x + c.y · V.y + c.z · V.z", inputs, v_grows);
        const bool is_unasked = frame_.settings.normal_map_rule == NormalMapRule::mirror_missed;
        const std::vector<FormulaInput> of_v{of_formula("(c · V)", "v_across", v_grows)};
        add("handedness", "handedness",
            is_unasked ? "Taken to be 1, by mistake, without checking whether the texture is "
                         "mirrored."
                       : "1, or −1 where the texture is mirrored.",
            is_unasked ? "1" : "(0 − (c · V)) / abs((c · V))",
            is_unasked ? std::vector<FormulaInput>{} : of_v, report_.sign);
        for (int i = 0; i < 3; ++i) {
            const std::string axis = axis_names[static_cast<std::size_t>(i)];
            add("bitangent." + axis, "b." + axis,
                "The bitangent: the direction toward the texture's top, of unit length.",
                "c · handedness",
                {of_formula("c", "across." + axis, across[i]),
                 of_formula("handedness", "handedness", report_.sign)},
                report_.axes.bitangent[i]);
        }
    }

    void add_arrow() {
        for (int i = 0; i < 3; ++i) {
            const auto part = static_cast<std::size_t>(i);
            const std::string channel = channel_names[part], axis = axis_names[part];
            std::string expression;
            std::vector<FormulaInput> inputs;
            for (int k = 0; k < report_.taken.count; ++k) {
                const TakenTexel& texel = report_.taken.list[static_cast<std::size_t>(k)];
                expression += fmt::format("{}c{} · w{}", k == 0 ? "" : " + ", k, k);
                inputs.push_back(
                    {fmt::format("c{}", k),
                     {texel.colour[i]},
                     from_words(fmt::format("{} of the normal map, level {}, column "
                                            "{}, row {}",
                                            channel, texel.level, texel.column, texel.row))});
                inputs.push_back({fmt::format("w{}", k),
                                  {texel.weight},
                                  from_words("the weight of that texel, from the texture filter")});
            }
            add("colour." + channel, channel,
                "The colour of the normal map at the fragment's position.", expression, inputs,
                report_.colour[i]);
            const NormalMapRule rule = frame_.settings.normal_map_rule;
            const bool is_turned = rule == NormalMapRule::green_turned && i == 1;
            const bool is_bare = rule == NormalMapRule::undecoded;
            add("arrow." + axis, "a." + axis,
                is_bare     ? "The colour itself, by mistake, so it is never below 0."
                : is_turned ? "The colour mapped to −1 to 1, by mistake the wrong way round."
                            : "What the colour stands for: a number from −1 to 1 along one of the "
                              "surface's own axes.",
                is_bare     ? "c"
                : is_turned ? "1 − 2 · c"
                            : "2 · c − 1",
                {of_formula("c", "colour." + channel, report_.colour[i])}, report_.arrow[i]);
        }
    }

    void add_sum() {
        const TangentFrame& axes = report_.axes;
        const glm::vec3& a = report_.arrow;
        const glm::vec3 sum = a.x * axes.tangent + a.y * axes.bitangent + a.z * axes.normal;
        for (int i = 0; i < 3; ++i) {
            const auto part = static_cast<std::size_t>(i);
            const std::string axis = axis_names[part];
            add("sum." + axis, "s." + axis,
                "The arrow in the world: the sum of its parts along t, b and n.",
                "a.x · t + a.y · b + a.z · n",
                {of_formula("a.x", "arrow.x", a.x),
                 of_formula("t", "tangent." + axis, axes.tangent[i]),
                 of_formula("a.y", "arrow.y", a.y),
                 of_formula("b", "bitangent." + axis, axes.bitangent[i]),
                 of_formula("a.z", "arrow.z", a.z),
                 {"n", {normal_.value[i]}, normal_.sources[part]}},
                sum[i]);
        }
        const float length = glm::length(sum);
        add("sum_length", "|s|",
            "Its length, only about 1 because bytes and mixed texels are not exact.",
            "sqrt(s.x² + s.y² + s.z²)", parts_of_vector("s", vector_of("sum", sum)), length);
        for (int i = 0; i < 3; ++i) {
            const std::string axis = axis_names[static_cast<std::size_t>(i)];
            const bool has_length = length > 0.0f;
            Formula bent{
                "bump.normal." + axis,
                "n." + axis,
                report_.space ? "The bent normal in the world, made unit length."
                              : "The bent normal, made unit length; the light is computed with "
                                "this one.",
                "s / |s|",
                {of_formula("s", "sum." + axis, sum[i]), of_formula("|s|", "sum_length", length)},
                {report_.normal[i]}};
            if (!has_length) {
                bent.help = "The arrow has no length, so the normal of the surface stays.";
                bent.expression = "n";
                bent.inputs = {
                    {"n", {normal_.value[i]}, normal_.sources[static_cast<std::size_t>(i)]}};
            }
            formulas_.push_back(bent);
        }
    }

    /// A vector of three formulas, each with the expression and the inputs of its axis.
    template <class Inputs>
    void add_vector(const std::string& id, const std::string& symbol, const std::string& help,
                    const std::string& expression, const glm::vec3& value, Inputs inputs) {
        for (int i = 0; i < 3; ++i) {
            const std::string axis = axis_names[static_cast<std::size_t>(i)];
            add("square." + id + "." + axis, symbol + "." + axis, help, expression, inputs(i, axis),
                value[i]);
        }
    }

    /// The axes made perpendicular and of unit length, and the arrow along them.
    void add_square() {
        const SquaredAxes squared = squared_axes(report_.axes);
        const glm::vec3 &t = report_.axes.tangent, &b = report_.axes.bitangent, &a = report_.arrow;
        const SourcedVector tangent = vector_of("tangent", t);
        std::vector<FormulaInput> inputs = parts_of_vector("t", tangent);
        append_parts(inputs, "n", normal_);
        add("square.lean", "t · n",
            "How much of the tangent runs along the normal: only a rounding error, unless the "
            "normal is not of unit length.",
            "t.x · n.x + t.y · n.y + t.z · n.z", inputs, squared.lean);
        add("square.width", "|b|", "The length of the bitangent.", "sqrt(b.x² + b.y² + b.z²)",
            parts_of_vector("b", vector_of("bitangent", b)), squared.width);
        add_vector("upright", "u", "The normal without the part that runs along the tangent.",
                   "n − t · (t · n)", squared.upright, [&](int i, const std::string& axis) {
                       return std::vector<FormulaInput>{
                           {"n", {normal_.value[i]}, normal_.sources[static_cast<std::size_t>(i)]},
                           of_formula("t", "tangent." + axis, t[i]),
                           of_formula("(t · n)", "square.lean", squared.lean)};
                   });
        add("square.height", "|u|", "Its length.", "sqrt(u.x² + u.y² + u.z²)",
            parts_of_vector("u", vector_of("square.upright", squared.upright)), squared.height);
        add_vector("t", "t", "The axis along which x of tangent space is measured: the tangent.",
                   "t", squared.axes.tangent, [&](int i, const std::string& axis) {
                       return std::vector<FormulaInput>{of_formula("t", "tangent." + axis, t[i])};
                   });
        add_vector("b", "b", "The y axis: the bitangent, of unit length.", "b / |b|",
                   squared.axes.bitangent, [&](int i, const std::string& axis) {
                       return std::vector<FormulaInput>{
                           of_formula("b", "bitangent." + axis, b[i]),
                           of_formula("|b|", "square.width", squared.width)};
                   });
        add_vector("n", "n", "The z axis: away from the surface, of unit length.", "u / |u|",
                   squared.axes.normal, [&](int i, const std::string& axis) {
                       return std::vector<FormulaInput>{
                           of_formula("u", "square.upright." + axis, squared.upright[i]),
                           of_formula("|u|", "square.height", squared.height)};
                   });
        add_local_normal(squared, a);
    }

    void add_local_normal(const SquaredAxes& squared, const glm::vec3& a) {
        const glm::vec3 arrow = squared.arrow(a);
        const FormulaInput z = of_formula("a.z", "arrow.z", a.z);
        const std::string help = "The arrow along these axes. It stays as it is if they were "
                                 "already perpendicular and of unit length.";
        add("square.arrow.x", "m.x", help, "a.x + a.z · (t · n)",
            {of_formula("a.x", "arrow.x", a.x), z,
             of_formula("(t · n)", "square.lean", squared.lean)},
            arrow.x);
        add("square.arrow.y", "m.y", help, "a.y · |b|",
            {of_formula("a.y", "arrow.y", a.y), of_formula("|b|", "square.width", squared.width)},
            arrow.y);
        add("square.arrow.z", "m.z", help, "a.z · |u|",
            {z, of_formula("|u|", "square.height", squared.height)}, arrow.z);
        const float length = glm::length(arrow);
        add("square.length", "|m|", "Its length.", "sqrt(m.x² + m.y² + m.z²)",
            parts_of_vector("m", vector_of("square.arrow", arrow)), length);
        add_vector(
            "normal", "n",
            "The normal in tangent space, made unit length; the light is computed with this one.",
            "m / |m|", report_.space->normal, [&](int i, const std::string& axis) {
                return std::vector<FormulaInput>{of_formula("m", "square.arrow." + axis, arrow[i]),
                                                 of_formula("|m|", "square.length", length)};
            });
    }

    const BumpReport& report_;
    const Frame& frame_;
    int triangle_;
    const SourcedVector& normal_;
    std::vector<Formula>& formulas_;
};

} // namespace

double BumpReport::tilt() const {
    const glm::dvec3 from(axes.normal), to(normal);
    constexpr double degrees = 57.29577951308232;
    return degrees * std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to));
}

BumpReport bump_report(const Fragment& fragment, const Surface& surface, const glm::vec3& normal,
                       const Frame& frame) {
    BumpReport report;
    report.uv = surface.uv_directions;
    report.axes = frame.stages.tangent_frame(surface.uv_directions, normal);
    const float side =
        glm::dot(glm::cross(report.axes.normal, report.axes.tangent), report.axes.bitangent);
    report.sign = side > 0.0f ? 1.0f : side < 0.0f ? -1.0f : 0.0f;
    report.colour = normal_map_colour(fragment, surface, frame.stages, &report.taken);
    report.arrow = frame.stages.arrow_of_texel(report.colour);
    report.normal = bent_normal(report.arrow, report.axes);
    report.space = frame.stages.light_space(report.arrow, report.axes);
    return report;
}

void append_bump_formulas(const BumpReport& report, const Frame& frame, int triangle,
                          LitPoint& point, std::vector<Formula>& formulas) {
    const SourcedVector normal = point.normal;
    BumpFormulas(report, frame, triangle, normal, formulas).append();
    if (report.space) point.space = {report.space->axes, report.normal};
    point.normal.value = report.space ? report.space->normal : report.normal;
    const std::string id = report.space ? "bump.square.normal." : "bump.normal.";
    for (std::size_t i = 0; i < 3; ++i)
        point.normal.sources[i] = from_formula(id + axis_names[i]);
}

} // namespace rasterwalk
