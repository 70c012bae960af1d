#include "facts/fact_groups.h"

#include <algorithm>
#include <array>
#include <utility>

#include "inspect/triangle_sides.h"

namespace rasterwalk {

namespace {

const ValueRange outcode_bits = whole(0, (1 << clip_plane_count) - 1);

/// Calls `read` with the frame of run A and the triangle shown; none without one.
template <class Read>
Value of_shown_triangle(const Facts& facts, Read read) {
    const RunResults& run = facts.results().a;
    return run.triangle ? read(run.frame, *run.triangle) : Value();
}

/// The words of the reasons why a triangle is not drawn.
constexpr auto rejection_names = [] {
    std::array<std::string_view, rejection_list.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = rejection_list[i].name;
    return names;
}();

Value triangle_arrows(const Facts& facts, int is_cross) {
    return of_shown_triangle(facts, [&](const Frame& frame, int triangle) {
        // For a culled back it has not been checked yet whether all corners have a pixel.
        const auto has_pixel = [&](int v) { return frame.given_vertex(triangle, v).has_pixel; };
        const bool has_pixels =
            frame.is_drawn(triangle) || (frame.rejection(triangle) == Rejection::back_facing &&
                                         has_pixel(0) && has_pixel(1) && has_pixel(2));
        const std::optional<ArrowProducts> arrows =
            has_pixels ? arrows_of(frame.triangle_vertices(triangle)) : std::nullopt;
        if (!arrows) return Value();
        return number(is_cross != 0 ? arrows->cross : arrows->dot);
    });
}

Value triangle_outcode(const Facts& facts, int is_any) {
    return of_shown_triangle(facts, [&](const Frame& frame, int triangle) {
        const TriangleCodes codes = triangle_sides(frame, triangle).codes;
        return number(is_any != 0 ? codes.any() : codes.common());
    });
}

Value vertex_outcode(const Facts& facts, int) {
    const std::optional<int>& vertex = facts.session().selection.vertex;
    if (!vertex || *vertex < 0 || *vertex >= triangle_corners) return {};
    return of_shown_triangle(facts, [&](const Frame& frame, int triangle) {
        return number(
            triangle_sides(frame, triangle).codes.of_corner[static_cast<std::size_t>(*vertex)]);
    });
}

template <class Read>
void add_clip_fact(std::vector<Fact>& table, const char* name, const char* help, ValueRange range,
                   Read) {
    table.push_back({name, help, std::move(range), [](const Facts& f, int) {
                         const ClipHistory* const clip = f.clip();
                         return clip != nullptr ? Read{}(*clip) : Value();
                     }});
}

/// One of its numbers: 0 to 2 in the world, 3 to 5 seen from the camera, then projected x and y.
Value vertex_place(const Facts& facts, int which) {
    const ShadedVertex* const vertex = facts.vertex();
    if (vertex == nullptr) return {};
    if (which < 3) return number(vertex->in("world")[which]);
    if (which < 6) return number(vertex->in("rotated")[which - 3]);
    if (vertex->rejection != Rejection::none) return {};
    return number(which == 6 ? vertex->in("projected").x : vertex->in("projected").y);
}

} // namespace

void add_side_facts(std::vector<Fact>& table) {
    table.push_back({"triangle.rejection", "Why the triangle shown is not drawn, or none.",
                     words(rejection_names), [](const Facts& f, int) {
                         return of_shown_triangle(f, [](const Frame& frame, int triangle) {
                             return Value(std::string(words(frame.rejection(triangle)).name));
                         });
                     }});
    table.push_back({"triangle.corners",
                     "Corners of what is drawn of the triangle shown: 3 unless it is cut; 0 if "
                     "nothing is drawn.",
                     natural(), [](const Facts& f, int) {
                         return of_shown_triangle(f, [](const Frame& frame, int triangle) {
                             const auto corners = frame.triangle_vertices(triangle).size();
                             return number(frame.is_drawn(triangle) ? static_cast<int>(corners)
                                                                    : 0);
                         });
                     }});
    table.push_back(
        {"triangle.away",
         "dot(n, v0 - camera) of the triangle shown, or dot(n, forward) as far as the rays are "
         "parallel, in world units; positive if it faces away.",
         real(), [](const Facts& f, int) {
             return of_shown_triangle(f, [](const Frame& frame, int triangle) {
                 return number(triangle_sides(frame, triangle).away);
             });
         }});
    table.push_back({"triangle.near_t",
                     "t of its first edge that the near plane cuts; 0 at the corner in front.",
                     real(), [](const Facts& f, int) {
                         return of_shown_triangle(f, [](const Frame& frame, int triangle) {
                             return number(triangle_sides(frame, triangle).near_t);
                         });
                     }});
    table.push_back({"triangle.dot",
                     "Dot product of its two arrows on the screen, from vertices[0] to vertices[1] "
                     "and from vertices[0] to vertices[2], in pixels.",
                     real(), triangle_arrows, 0});
    table.push_back({"triangle.cross",
                     "Cross product of the same two arrows, which is twice the area; positive if "
                     "the corners go round clockwise.",
                     real(), triangle_arrows, 1});
    table.push_back({"triangle.outcode_and",
                     "Bits that the outcodes of its three vertices have in common: near 1, far 2, "
                     "left 4, right 8, top 16, bottom 32.",
                     outcode_bits, triangle_outcode, 0});
    table.push_back({"triangle.outcode_or", "Bits that at least one of its outcodes has.",
                     outcode_bits, triangle_outcode, 1});
}

void add_clip_facts(std::vector<Fact>& table) {
    add_clip_fact(table, "polygon.planes", "Planes that cut the triangle shown.",
                  whole(0, static_cast<int>(clip_plane_count)),
                  [](const ClipHistory& c) { return number(std::ssize(c.planes)); });
    add_clip_fact(table, "polygon.cuts", "Number of cuts of its edges, over all planes.", natural(),
                  [](const ClipHistory& c) {
                      std::ptrdiff_t cuts = 0;
                      for (const PlaneHistory& plane : c.planes)
                          cuts += std::count_if(plane.steps.begin(), plane.steps.end(),
                                                [](const ClipStep& step) { return step.is_cut; });
                      return number(cuts);
                  });
    add_clip_fact(table, "polygon.corners",
                  "Corners that clipping leaves of it; 0 if nothing is "
                  "left.",
                  whole(0, most_polygon_corners),
                  [](const ClipHistory& c) { return number(std::ssize(c.polygon)); });
    add_clip_fact(table, "polygon.triangles",
                  "Number of triangles it is drawn as, the fan of what is left.",
                  whole(0, most_polygon_corners - 2),
                  [](const ClipHistory& c) { return number(std::ssize(c.fan)); });
    add_clip_fact(table, "polygon.culled", "1 if the triangle shown is culled.", yes_or_no(),
                  [](const ClipHistory& c) { return number(c.cull.is_back ? 1 : 0); });
}

void add_outline_facts(std::vector<Fact>& table) {
    const auto add = [&](const char* name, const char* help, ValueRange range, auto read) {
        table.push_back({name, help, std::move(range), [](const Facts& f, int) {
                             const PolygonWays* const ways = f.outline();
                             return ways != nullptr ? decltype(read){}(*ways) : Value();
                         }});
    };
    add("outline.corners", "Corners of the scene's polygon that the triangle shown belongs to.",
        natural(), [](const PolygonWays& w) { return number(w.corners); });
    add("outline.inside", "Pixels whose centres lie inside it, found by the list of active edges.",
        natural(), [](const PolygonWays& w) { return number(w.inside); });
    add("outline.table", "Pixels of its row table, with one left and one right end per row.",
        natural(), [](const PolygonWays& w) { return number(w.table); });
    add("outline.wrong_rows", "Rows in which that table has pixels that lie outside the polygon.",
        natural(), [](const PolygonWays& w) { return number(w.wrong_rows); });
    add("outline.fan", "Pixels that a fan of triangles around its first corner covers.", natural(),
        [](const PolygonWays& w) { return number(w.fan); });
    add("outline.fan_laid",
        "The same, with each pixel counted as often as triangles of the fan "
        "cover it.",
        natural(), [](const PolygonWays& w) { return number(w.fan_laid); });
    add("outline.area", "Its area in square pixels.", real(0),
        [](const PolygonWays& w) { return number(w.area); });
    add("outline.fan_area", "The areas of the triangles of its fan, added up, in square pixels.",
        real(0), [](const PolygonWays& w) { return number(w.fan_area); });
}

void add_shared_edge_facts(std::vector<Fact>& table) {
    const auto add = [&](std::string name, std::string help, Value (*read)(const Facts&, int),
                         int number = 0) {
        table.push_back({std::move(name), std::move(help), natural(), read, number});
    };
    add("shared.edge",
        "Edge of the triangle shown that it shares with a neighbour, the nearest to the picked "
        "pixel. Only if coverage is not rows.",
        [](const Facts& f, int) {
            const CountedEdge* const counted = f.shared_edge();
            return counted != nullptr ? number(counted->shared.edge) : Value();
        });
    add("shared.neighbour", "That neighbour, from 0.", [](const Facts& f, int) {
        const CountedEdge* const counted = f.shared_edge();
        return counted != nullptr ? number(counted->shared.neighbour) : Value();
    });
    for (std::size_t i = 0; i < compared_fill_rules.size(); ++i) {
        const std::string rule(word_of(compared_fill_rules[i]));
        add(
            "shared.twice_" + rule,
            "Pixels that both triangles draw with fill_rule " + rule + ", at that edge.",
            [](const Facts& f, int which) {
                const CountedEdge* const counted = f.shared_edge();
                if (counted == nullptr) return Value();
                return number(counted->rules[static_cast<std::size_t>(which)].twice);
            },
            static_cast<int>(i));
        add(
            "shared.holes_" + rule,
            "Pixels on that edge, without its ends, that neither of them draws with fill_rule " +
                rule + ".",
            [](const Facts& f, int which) {
                const CountedEdge* const counted = f.shared_edge();
                if (counted == nullptr) return Value();
                return number(counted->rules[static_cast<std::size_t>(which)].holes);
            },
            static_cast<int>(i));
    }
}

void add_vertex_facts(std::vector<Fact>& table) {
    const auto with_pixel = [](const Facts& f) {
        const ShadedVertex* const vertex = f.vertex();
        return vertex != nullptr && vertex->rejection == Rejection::none ? vertex : nullptr;
    };
    using WithPixel = decltype(with_pixel);
    table.push_back({"vertex.column", "Column of the selected vertex of the triangle shown.",
                     whole(-endless, endless), [](const Facts& f, int) {
                         const ShadedVertex* const vertex = WithPixel{}(f);
                         return vertex != nullptr ? number(vertex->pixel.column) : Value();
                     }});
    table.push_back({"vertex.row", "Its row.", whole(-endless, endless), [](const Facts& f, int) {
                         const ShadedVertex* const vertex = WithPixel{}(f);
                         return vertex != nullptr ? number(vertex->pixel.row) : Value();
                     }});
    table.push_back({"vertex.zinv", "Its 1/z; 1/w under any other projection.", real(),
                     [](const Facts& f, int) {
                         const ShadedVertex* const vertex = WithPixel{}(f);
                         return vertex != nullptr ? number(vertex->pixel.inv_w) : Value();
                     }});
    table.push_back({"vertex.depth", "Its value for the depth buffer, before it is rounded.",
                     real(), [](const Facts& f, int) {
                         const ShadedVertex* const vertex = WithPixel{}(f);
                         return vertex != nullptr ? number(vertex->pixel.depth) : Value();
                     }});
    table.push_back({"vertex.z", "Its z in camera space; negative behind the camera.", real(),
                     vertex_place, 5});
    table.push_back({"vertex.outcode",
                     "Outcode of the selected vertex of the triangle shown: the sides of the "
                     "view that it lies beyond, by two pixels at least.",
                     outcode_bits, vertex_outcode});
    table.push_back({"vertex.z_ndc", "Its NDC z: 0 at the near plane, 1 at the far one.", real(),
                     [](const Facts& f, int) {
                         const ShadedVertex* const vertex = WithPixel{}(f);
                         return vertex != nullptr ? z_ndc(f, vertex->in("rotated").z) : Value();
                     }});
    constexpr std::array<const char*, 8> names{"world_x",     "world_y",    "world_z",
                                               "camera_x",    "camera_y",   "camera_z",
                                               "projected_x", "projected_y"};
    constexpr std::array<const char*, 8> helps{
        "x of its position in the world.",
        "y of its position in the world.",
        "z of its position in the world.",
        "x of its position seen from the camera.",
        "y of its position seen from the camera.",
        "z of its position seen from the camera.",
        "Pixels from the middle of the picture to the right, before int().",
        "Pixels from the middle of the picture downward, before int()."};
    for (std::size_t i = 0; i < names.size(); ++i) {
        table.push_back({std::string("vertex.").append(names[i]), helps[i], real(), vertex_place,
                         static_cast<int>(i)});
    }
}

} // namespace rasterwalk
