#include "facts/fact_groups.h"

#include <algorithm>
#include <array>
#include <utility>

#include "inspect/triangle_sides.h"

namespace rasterwalk {

namespace {

const ValueRange outcode_bits = whole(0, (1 << clip_plane_count) - 1);

/// The triangle shown, and its frame.
struct ShownTriangle {
    const Frame& frame;
    int triangle;
};

std::optional<ShownTriangle> shown_triangle(const Facts& facts) {
    const RunResults& run = facts.results().a;
    if (!run.triangle) return std::nullopt;
    return ShownTriangle{run.frame, *run.triangle};
}

/// Its sides.
std::optional<TriangleSides> sides_shown(const Facts& facts) {
    const std::optional<ShownTriangle> shown = shown_triangle(facts);
    if (!shown) return std::nullopt;
    return triangle_sides(shown->frame, shown->triangle);
}

/// Its arrows on the screen.
std::optional<ArrowProducts> arrows_shown(const Facts& facts) {
    const std::optional<ShownTriangle> shown = shown_triangle(facts);
    if (!shown) return std::nullopt;
    const auto [frame, triangle] = *shown;
    // For a culled back it has not been checked yet whether all corners have a pixel.
    const auto has_pixel = [&frame = frame, triangle = triangle](int v) {
        return frame.given_vertex(triangle, v).has_pixel;
    };
    const bool has_pixels =
        frame.is_drawn(triangle) || (frame.rejection(triangle) == Rejection::back_facing &&
                                     has_pixel(0) && has_pixel(1) && has_pixel(2));
    return has_pixels ? arrows_of(frame.triangle_vertices(triangle)) : std::nullopt;
}

/// The words of the reasons why a triangle is not drawn.
constexpr auto rejection_names = [] {
    std::array<std::string_view, rejection_list.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = rejection_list[i].name;
    return names;
}();

/// The selected vertex, projected or not.
const ShadedVertex* shaded_vertex(const Facts& facts) {
    const VertexReport* const vertex = facts.vertex();
    return vertex != nullptr ? &vertex->shaded : nullptr;
}

/// The same if it is projected.
const ShadedVertex* projected_vertex(const Facts& facts) {
    const ShadedVertex* const vertex = shaded_vertex(facts);
    return vertex != nullptr && vertex->rejection == Rejection::none ? vertex : nullptr;
}

/// The outcode of the selected vertex.
std::optional<unsigned> outcode_of_vertex(const Facts& facts) {
    const std::optional<int>& vertex = facts.session().selection.vertex;
    const std::optional<TriangleSides> sides = sides_shown(facts);
    if (!sides || !vertex || *vertex < 0 || *vertex >= triangle_corners) return std::nullopt;
    return sides->codes.of_corner[static_cast<std::size_t>(*vertex)];
}

} // namespace

void add_side_facts(std::vector<Fact>& table) {
    const FactAdder<shown_triangle> add(table);
    const FactAdder<sides_shown> add_sides(table);
    const FactAdder<arrows_shown> add_arrows(table);
    using Sides = const TriangleSides&;
    add("triangle.rejection", "Why the triangle shown is not drawn, or none.",
        words(rejection_names), [](const ShownTriangle& shown) {
            return words(shown.frame.rejection(shown.triangle)).name;
        });
    add("triangle.corners",
        "Corners of what is drawn of the triangle shown: 3 unless it is cut; 0 if nothing is "
        "drawn.",
        natural(), [](const ShownTriangle& shown) {
            const auto corners = shown.frame.triangle_vertices(shown.triangle).size();
            return shown.frame.is_drawn(shown.triangle) ? corners : 0;
        });
    add_sides("triangle.away",
              "dot(n, v0 - camera) of the triangle shown, or dot(n, forward) as far as the rays "
              "are parallel, in world units; positive if it faces away.",
              real(), [](Sides sides) { return sides.away; });
    add_sides("triangle.near_t",
              "t of its first edge that the near plane cuts; 0 at the corner in front.", real(),
              [](Sides sides) { return sides.near_t; });
    add_arrows("triangle.dot",
               "Dot product of its two arrows on the screen, from vertices[0] to vertices[1] and "
               "from vertices[0] to vertices[2], in pixels.",
               real(), [](const ArrowProducts& arrows) { return arrows.dot; });
    add_arrows("triangle.cross",
               "Cross product of the same two arrows, which is twice the area; positive if the "
               "corners go round clockwise.",
               real(), [](const ArrowProducts& arrows) { return arrows.cross; });
    add_arrows("triangle.base",
               "Length of the first of these arrows, from vertices[0] to vertices[1], in pixels.",
               real(), [](const ArrowProducts& arrows) { return arrows.base; });
    add_sides("triangle.outcode_and",
              "Bits that the outcodes of its three vertices have in common: near 1, far 2, left 4, "
              "right 8, top 16, bottom 32.",
              outcode_bits, [](Sides sides) { return sides.codes.common(); });
    add_sides("triangle.outcode_or", "Bits that at least one of its outcodes has.", outcode_bits,
              [](Sides sides) { return sides.codes.any(); });
}

void add_clip_facts(std::vector<Fact>& table) {
    const FactAdder<&Facts::clip> add(table);
    using History = const ClipHistory&;
    add("polygon.planes", "Planes that cut the triangle shown.",
        whole(0, static_cast<int>(clip_plane_count)), [](History c) { return c.planes.size(); });
    add("polygon.cuts", "Number of cuts of its edges, over all planes.", natural(), [](History c) {
        std::ptrdiff_t cuts = 0;
        for (const PlaneHistory& plane : c.planes)
            cuts += std::count_if(plane.steps.begin(), plane.steps.end(),
                                  [](const ClipStep& step) { return step.is_cut; });
        return cuts;
    });
    add("polygon.corners", "Corners that clipping leaves of it; 0 if nothing is left.",
        whole(0, most_polygon_corners), [](History c) { return c.polygon.size(); });
    add("polygon.triangles", "Number of triangles it is drawn as, the fan of what is left.",
        whole(0, most_polygon_corners - 2), [](History c) { return c.fan.size(); });
    add("polygon.culled", "1 if the triangle shown is culled.", yes_or_no(),
        [](History c) { return c.cull.is_back; });
}

void add_outline_facts(std::vector<Fact>& table) {
    const FactAdder<&Facts::outline> add(table);
    using Ways = const CoverageComparison&;
    add("outline.corners", "Corners of the scene's polygon that the triangle shown belongs to.",
        natural(), [](Ways w) { return w.corners; });
    add("outline.inside", "Pixels whose centres lie inside it, found by the list of active edges.",
        natural(), [](Ways w) { return w.inside; });
    add("outline.table", "Pixels of its row table, with one left and one right end per row.",
        natural(), [](Ways w) { return w.table; });
    add("outline.wrong_rows", "Rows in which that table has pixels that lie outside the polygon.",
        natural(), [](Ways w) { return w.wrong_rows; });
    add("outline.fan", "Pixels that a fan of triangles around its first corner covers.", natural(),
        [](Ways w) { return w.fan; });
    add("outline.fan_laid",
        "The same, with each pixel counted as often as triangles of the fan cover it.", natural(),
        [](Ways w) { return w.fan_writes; });
    add("outline.area", "Its area in square pixels.", real(0), [](Ways w) { return w.area; });
    add("outline.fan_area", "The areas of the triangles of its fan, added up, in square pixels.",
        real(0), [](Ways w) { return w.fan_area; });
}

void add_shared_edge_facts(std::vector<Fact>& table) {
    const FactAdder<&Facts::shared_edge> add(table);
    using Edge = const CountedEdge&;
    add("shared.edge",
        "Edge of the triangle shown that it shares with a neighbour, the nearest to the picked "
        "pixel. Only if coverage is not rows.",
        natural(), [](Edge counted) { return counted.shared.edge; });
    add("shared.neighbour", "That neighbour, from 0.", natural(),
        [](Edge counted) { return counted.shared.neighbour; });
    for (std::size_t i = 0; i < compared_fill_rules.size(); ++i) {
        const std::string rule(word_of(compared_fill_rules[i]));
        add(
            "shared.twice_" + rule,
            "Pixels that both triangles draw with fill_rule " + rule + ", at that edge.", natural(),
            [](Edge counted, int which) {
                return counted.rules[static_cast<std::size_t>(which)].twice;
            },
            static_cast<int>(i));
        add(
            "shared.holes_" + rule,
            "Pixels on that edge, without its ends, that neither of them draws with fill_rule " +
                rule + ".",
            natural(),
            [](Edge counted, int which) {
                return counted.rules[static_cast<std::size_t>(which)].holes;
            },
            static_cast<int>(i));
    }
}

void add_vertex_facts(std::vector<Fact>& table) {
    const FactAdder<shaded_vertex> add(table);
    const FactAdder<projected_vertex> add_projected(table);
    using Shaded = const ShadedVertex&;
    add_projected("vertex.column", "Column of the selected vertex of the triangle shown.",
                  whole(-endless, endless), [](Shaded v) { return v.pixel.column; });
    add_projected("vertex.row", "Its row.", whole(-endless, endless),
                  [](Shaded v) { return v.pixel.row; });
    add_projected("vertex.zinv", "Its 1/z; 1/w under any other projection.", real(),
                  [](Shaded v) { return v.pixel.inv_w; });
    add_projected("vertex.depth", "Its value for the depth buffer, before it is rounded.", real(),
                  [](Shaded v) { return v.pixel.depth; });
    add("vertex.z", "Its z in camera space; negative behind the camera.", real(),
        [](Shaded v) { return v.in("rotated").z; });
    FactAdder<outcode_of_vertex>{table}(
        "vertex.outcode",
        "Outcode of the selected vertex of the triangle shown: the sides of the view that it lies "
        "beyond, by two pixels at least.",
        outcode_bits, [](unsigned outcode) { return outcode; });
    FactAdder<everything>{table}(
        "vertex.z_ndc", "Its NDC z: 0 at the near plane, 1 at the far one.", real(),
        [](const Facts& f) {
            const ShadedVertex* const vertex = projected_vertex(f);
            return vertex != nullptr ? z_ndc(f, vertex->in("rotated").z) : Value();
        });
    for (int i = 0; i < 3; ++i) {
        add(
            "vertex.world_" + axis_name(i), axis_name(i) + " of its position in the world.", real(),
            [](Shaded v, int axis) { return v.in("world")[axis]; }, i);
    }
    for (int i = 0; i < 3; ++i) {
        add(
            "vertex.camera_" + axis_name(i),
            axis_name(i) + " of its position seen from the camera.", real(),
            [](Shaded v, int axis) { return v.in("rotated")[axis]; }, i);
    }
    add_projected("vertex.projected_x",
                  "Pixels from the middle of the picture to the right, before int().", real(),
                  [](Shaded v) { return v.in("projected").x; });
    add_projected("vertex.projected_y",
                  "Pixels from the middle of the picture downward, before int().", real(),
                  [](Shaded v) { return v.in("projected").y; });
}

} // namespace rasterwalk
