#include "explain/bump_formulas.h"

#include <cmath>

#include <fmt/format.h>

namespace rasterwalk {

namespace {

/// Makes the formulas of a surface's axes, in order.
class AxesFormulas {
  public:
    AxesFormulas(const AxesReport& report, const Frame& frame, int triangle,
                 const SourcedVector& normal, std::vector<Formula>& formulas)
        : report_(report), frame_(frame), triangle_(triangle), normal_(normal),
          write_(formulas, "bump.") {}

    void append() {
        add_sides();
        add_directions();
        add_tangent();
        add_bitangent();
    }

  private:
    /// Two sides of the triangle, in the world and in the texture.
    void add_sides() {
        const std::array<Vertex, triangle_corners> corners = corners_of(*frame_.scene, triangle_);
        for (int s = 1; s < triangle_corners; ++s) {
            const Vertex &from = corners[0], &to = corners[static_cast<std::size_t>(s)];
            write_.add_vector(fmt::format("side_{}", s), fmt::format("e{}", s),
                              fmt::format("From vertex 0 of the triangle to vertex {}.", s),
                              "b − a", to.position - from.position, [&](int i) {
                                  const std::string world = "world." + axis_name(i);
                                  return FormulaInputs{
                                      {"b", {to.position[i]}, from_vertex(triangle_, s, world)},
                                      {"a", {from.position[i]}, from_vertex(triangle_, 0, world)}};
                              });
            for (int i = 0; i < 2; ++i) {
                const char u = i == 0 ? 'u' : 'v';
                write_.add(
                    fmt::format("{}_{}", u, s), fmt::format("{}{}", u, s),
                    fmt::format("The same side in the texture, that is, how much {} grows "
                                "along it.",
                                u),
                    "b − a",
                    {{"b", {to.texcoord[i]}, from_words(fmt::format("{} of vertex {}", u, s))},
                     {"a", {from.texcoord[i]}, from_words(fmt::format("{} of vertex 0", u))}},
                    {to.texcoord[i] - from.texcoord[i]});
            }
        }
    }

    /// The directions in which u and v grow.
    void add_directions() {
        const FormulaInput u1 = write_.input("u1", "u_1"), v1 = write_.input("v1", "v_1"),
                           u2 = write_.input("u2", "u_2"), v2 = write_.input("v2", "v_2");
        write_.add("area", "area",
                   "Twice the area that the triangle has in the texture, with its sign.",
                   "u1 · v2 − u2 · v1", {u1, v2, u2, v1},
                   {u1.number.value * v2.number.value - u2.number.value * v1.number.value});
        for (int i = 0; i < 3; ++i) {
            const FormulaInput e1 = write_.part("e1", "side_1", i),
                               e2 = write_.part("e2", "side_2", i),
                               area = write_.input("area", "area");
            write_.add("along_u." + axis_name(i), "U." + axis_name(i),
                       "The vector along the surface as u grows by 1: a sum of the two sides, "
                       "weighted so that v stays the same.",
                       "(e1 · v2 − e2 · v1) / area", {e1, v2, e2, v1, area},
                       {report_.uv.along_u[i]});
            write_.add("along_v." + axis_name(i), "V." + axis_name(i),
                       "The vector along the surface as v grows by 1: a sum of the two sides, "
                       "weighted so that u stays the same.",
                       "(e2 · u1 − e1 · u2) / area", {e2, u1, e1, u2, area},
                       {report_.uv.along_v[i]});
        }
    }

    void add_tangent() {
        write_.add_dot("lean", "n · U", "How much of the direction of u runs along the normal.",
                       "n", normal_, "U", write_.vector("along_u"),
                       glm::dot(normal_.value, report_.uv.along_u));
        const glm::vec3 flat = tangent_on_surface(report_.uv, normal_.value);
        const SourcedVector on_surface = write_.add_vector(
            "flat", "T", "The direction of u without the part that runs along the normal.",
            "U − n · (n · U)", flat, [&](int i) {
                return FormulaInputs{write_.part("U", "along_u", i), normal_.part("n", i),
                                     write_.input("(n · U)", "lean")};
            });
        write_.add_length("flat_length", "|T|", "Its length.", "T", on_surface, glm::length(flat));
        write_.add_vector("tangent", "t",
                          "The tangent: the direction in which u grows, made unit length.",
                          "T / |T|", report_.axes.tangent, [&](int i) {
                              return FormulaInputs{write_.part("T", "flat", i),
                                                   write_.input("|T|", "flat_length")};
                          });
    }

    void add_bitangent() {
        const SourcedVector tangent = write_.vector("tangent");
        const glm::vec3 cross = glm::cross(report_.axes.normal, report_.axes.tangent);
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            write_.add("across." + axis_name(i), "c." + axis_name(i),
                       "n × t, the cross product: perpendicular to both, on one of two sides.",
                       fmt::format("n.{0} · t.{1} − t.{0} · n.{1}", axis_name(j), axis_name(k)),
                       {normal_.part("n." + axis_name(j), j), tangent.part("t." + axis_name(k), k),
                        tangent.part("t." + axis_name(j), j), normal_.part("n." + axis_name(k), k)},
                       {cross[i]});
        }
        write_.add_dot("v_across", "c · V",
                       "How v grows along c: below 0 because c points toward the texture's top, "
                       "but above 0 where the texture is mirrored.",
                       "c", write_.vector("across"), "V", write_.vector("along_v"),
                       v_across(report_.uv, report_.axes));
        const bool is_unasked = frame_.settings.normal_map_rule == NormalMapRule::mirror_missed;
        Formula& handedness = write_.add(
            "handedness", "handedness", "1, or −1 where the texture is mirrored.",
            "(0 − (c · V)) / abs((c · V))", {write_.input("(c · V)", "v_across")}, {report_.sign});
        if (is_unasked) {
            handedness.help = "Taken to be 1, by mistake, without checking whether the texture is "
                              "mirrored.";
            handedness.expression = "1";
            handedness.inputs.clear();
        }
        handedness.section = "bump";
        write_.add_vector("bitangent", "b",
                          "The bitangent: the direction toward the texture's top, of unit length.",
                          "c · handedness", report_.axes.bitangent, [&](int i) {
                              return FormulaInputs{write_.part("c", "across", i),
                                                   write_.input("handedness", "handedness")};
                          });
    }

    const AxesReport& report_;
    const Frame& frame_;
    int triangle_;
    const SourcedVector& normal_;
    FormulaWriter write_;
};

/// Makes the formulas of one fragment's bent normal, in order.
class BumpFormulas {
  public:
    BumpFormulas(const BumpReport& report, const Frame& frame, const SourcedVector& normal,
                 std::vector<Formula>& formulas)
        : report_(report), frame_(frame), normal_(normal), write_(formulas, "bump.") {}

    void append() {
        if (report_.sign == 0.0f) {
            write_.add_vector("normal", "n",
                              "The normal of the surface, not bent, because the triangle has no "
                              "area in the texture and so u has no direction on it.",
                              "n.{}", report_.normal, [&](int i) {
                                  return FormulaInputs{normal_.part("n." + axis_name(i), i)};
                              });
            return;
        }
        add_arrow();
        add_sum();
        if (report_.space) add_square();
    }

  private:
    void add_arrow() {
        for (int i = 0; i < 3; ++i) {
            const std::string channel = channel_name(i);
            const TexelSum mean = texel_sum(report_.taken, i, "normal map");
            write_.add("colour." + channel, channel,
                       "The colour of the normal map at the fragment's position.", mean.expression,
                       mean.inputs, {report_.colour[i]});
            const NormalMapRule rule = frame_.settings.normal_map_rule;
            const bool is_turned = rule == NormalMapRule::green_turned && i == 1;
            const bool is_bare = rule == NormalMapRule::undecoded;
            write_.add("arrow." + axis_name(i), "a." + axis_name(i),
                       is_bare     ? "The colour itself, by mistake, so it is never below 0."
                       : is_turned ? "The colour mapped to −1 to 1, by mistake the wrong way round."
                                   : "What the colour stands for: a number from −1 to 1 along one "
                                     "of the surface's own axes.",
                       is_bare     ? "c"
                       : is_turned ? "1 − 2 · c"
                                   : "2 · c − 1",
                       {write_.input("c", "colour." + channel)}, {report_.arrow[i]});
        }
    }

    void add_sum() {
        const TangentFrame& axes = report_.axes;
        const glm::vec3& a = report_.arrow;
        const glm::vec3 sum = a.x * axes.tangent + a.y * axes.bitangent + a.z * axes.normal;
        const SourcedVector arrow = write_.add_vector(
            "sum", "s", "The arrow in the world: the sum of its parts along t, b and n.",
            "a.x · t + a.y · b + a.z · n", sum, [&](int i) {
                return FormulaInputs{
                    write_.input("a.x", "arrow.x"), write_.part("t", "tangent", i),
                    write_.input("a.y", "arrow.y"), write_.part("b", "bitangent", i),
                    write_.input("a.z", "arrow.z"), normal_.part("n", i)};
            });
        const float length = glm::length(sum);
        write_.add_length("sum_length", "|s|",
                          "Its length, only about 1 because bytes and mixed texels are not exact.",
                          "s", arrow, length);
        if (!(length > 0.0f)) {
            write_.add_vector(
                "normal", "n", "The arrow has no length, so the normal of the surface stays.", "n",
                report_.normal, [&](int i) { return FormulaInputs{normal_.part("n", i)}; });
            return;
        }
        write_.add_vector(
            "normal", "n",
            report_.space ? "The bent normal in the world, made unit length."
                          : "The bent normal, made unit length; the light is computed with "
                            "this one.",
            "s / |s|", report_.normal, [&](int i) {
                return FormulaInputs{write_.part("s", "sum", i), write_.input("|s|", "sum_length")};
            });
    }

    /// The axes made perpendicular and of unit length, and the arrow along them.
    void add_square() {
        const SquaredAxes squared = squared_axes(report_.axes);
        write_.add_dot("square.lean", "t · n",
                       "How much of the tangent runs along the normal: only a rounding error, "
                       "unless the normal is not of unit length.",
                       "t", write_.vector("tangent"), "n", normal_, squared.lean);
        write_.add_length("square.width", "|b|", "The length of the bitangent.", "b",
                          write_.vector("bitangent"), squared.width);
        const SourcedVector upright = write_.add_vector(
            "square.upright", "u", "The normal without the part that runs along the tangent.",
            "n − t · (t · n)", squared.upright, [&](int i) {
                return FormulaInputs{normal_.part("n", i), write_.part("t", "tangent", i),
                                     write_.input("(t · n)", "square.lean")};
            });
        write_.add_length("square.height", "|u|", "Its length.", "u", upright, squared.height);
        write_.add_vector("square.t", "t",
                          "The axis along which x of tangent space is measured: the tangent.", "t",
                          squared.axes.tangent,
                          [&](int i) { return FormulaInputs{write_.part("t", "tangent", i)}; });
        write_.add_vector("square.b", "b", "The y axis: the bitangent, of unit length.", "b / |b|",
                          squared.axes.bitangent, [&](int i) {
                              return FormulaInputs{write_.part("b", "bitangent", i),
                                                   write_.input("|b|", "square.width")};
                          });
        write_.add_vector("square.n", "n", "The z axis: away from the surface, of unit length.",
                          "u / |u|", squared.axes.normal, [&](int i) {
                              return FormulaInputs{write_.part("u", "square.upright", i),
                                                   write_.input("|u|", "square.height")};
                          });
        add_local_normal(squared.arrow(report_.arrow));
    }

    /// @param arrow along the axes
    void add_local_normal(const glm::vec3& arrow) {
        const std::string help = "The arrow along these axes. It stays as it is if they were "
                                 "already perpendicular and of unit length.";
        const FormulaInput z = write_.input("a.z", "arrow.z");
        write_.add("square.arrow.x", "m.x", help, "a.x + a.z · (t · n)",
                   {write_.input("a.x", "arrow.x"), z, write_.input("(t · n)", "square.lean")},
                   {arrow.x});
        write_.add("square.arrow.y", "m.y", help, "a.y · |b|",
                   {write_.input("a.y", "arrow.y"), write_.input("|b|", "square.width")},
                   {arrow.y});
        write_.add("square.arrow.z", "m.z", help, "a.z · |u|",
                   {z, write_.input("|u|", "square.height")}, {arrow.z});
        write_.add_length("square.length", "|m|", "Its length.", "m", write_.vector("square.arrow"),
                          glm::length(arrow));
        write_.add_vector(
            "square.normal", "n",
            "The normal in tangent space, made unit length; the light is computed with this one.",
            "m / |m|", report_.space->normal, [&](int i) {
                return FormulaInputs{write_.part("m", "square.arrow", i),
                                     write_.input("|m|", "square.length")};
            });
    }

    const BumpReport& report_;
    const Frame& frame_;
    const SourcedVector& normal_;
    FormulaWriter write_;
};

} // namespace

TexelSum texel_sum(const SampledTexels& taken, int channel, std::string_view map) {
    TexelSum sum;
    for (int k = 0; k < taken.count; ++k) {
        const SampledTexel& texel = taken.list[static_cast<std::size_t>(k)];
        sum.expression += fmt::format("{}c{} · w{}", k == 0 ? "" : " + ", k, k);
        sum.inputs.push_back({fmt::format("c{}", k),
                              {texel.colour[channel]},
                              from_words(fmt::format("{} of the {}, level {}, column {}, row {}",
                                                     channel_name(channel), map, texel.level,
                                                     texel.column, texel.row))});
        sum.inputs.push_back({fmt::format("w{}", k),
                              {texel.weight},
                              from_words("the weight of that texel, from the texture filter")});
    }
    return sum;
}

double BumpReport::tilt() const {
    const glm::dvec3 from(axes.normal), to(normal);
    constexpr double degrees = 57.29577951308232;
    return degrees * std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to));
}

AxesReport axes_report(const Surface& surface, const glm::vec3& normal, const Frame& frame) {
    AxesReport report{surface.uv_directions,
                      frame.stages.tangent_frame(surface.uv_directions, normal)};
    const float side =
        glm::dot(glm::cross(report.axes.normal, report.axes.tangent), report.axes.bitangent);
    report.sign = side > 0.0f ? 1.0f : side < 0.0f ? -1.0f : 0.0f;
    return report;
}

BumpReport bump_report(const Fragment& fragment, const Surface& surface, const glm::vec3& normal,
                       const Frame& frame) {
    BumpReport report{axes_report(surface, normal, frame)};
    report.map = surface.normal_map;
    report.place = place_in_texture(fragment, surface, pixel_rules(frame), frame.stages);
    report.colour =
        normal_map_colour(fragment, surface, pixel_rules(frame), frame.stages, &report.taken);
    report.arrow = frame.stages.arrow_of_texel(report.colour);
    report.normal = bent_normal(report.arrow, report.axes);
    report.space = frame.stages.light_space(report.arrow, report.axes);
    return report;
}

void append_axes_formulas(const AxesReport& report, const Frame& frame, int triangle,
                          const SourcedVector& normal, std::vector<Formula>& formulas) {
    if (report.sign == 0.0f) return;
    AxesFormulas(report, frame, triangle, normal, formulas).append();
}

void append_bump_formulas(const BumpReport& report, const Frame& frame, int triangle,
                          LitPoint& point, std::vector<Formula>& formulas) {
    const SourcedVector normal = point.normal;
    if (find_formula(formulas, "bump.handedness") == nullptr)
        append_axes_formulas(report, frame, triangle, normal, formulas);
    BumpFormulas(report, frame, normal, formulas).append();
    if (report.space) point.space = {report.space->axes, report.normal};
    point.normal =
        FormulaWriter(formulas, "bump.").vector(report.space ? "square.normal" : "normal");
}

} // namespace rasterwalk
