#include "facts/fact_groups.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/element_names.h"

namespace rasterwalk {

namespace {

/// The comparison of the whole frames; null without a second run, and until it is done.
const Comparison* comparison(const Facts& facts) {
    const Results& results = facts.results();
    return results.b && results.comparison.work.is_done() ? &results.comparison.whole() : nullptr;
}

template <class Read>
void add_compare_fact(std::vector<Fact>& table, const char* name, const char* help,
                      ValueRange range, Read) {
    table.push_back({name, help, std::move(range), [](const Facts& f, int) {
                         const Comparison* const whole = comparison(f);
                         return whole != nullptr ? Read{}(*whole) : Value();
                     }});
}

/// Vertices of the scene's triangles, uncut and drawn in both runs, whose pixel is a different one
/// in run B.
Value vertices_elsewhere(const Facts& facts, int) {
    const Results& results = facts.results();
    if (!facts.has_same_triangles_in_b()) return {};
    const Frame &a = results.a.frame, &b = results.b->frame;
    int elsewhere = 0;
    for (int t = 0; t < std::min(a.triangle_count(), b.triangle_count()); ++t) {
        if (!a.is_drawn(t) || !b.is_drawn(t) || a.is_cut(t) || b.is_cut(t)) continue;
        const PolygonCorners in_a = a.triangle_vertices(t);
        const PolygonCorners in_b = b.triangle_vertices(t);
        for (std::size_t v = 0; v < std::min(in_a.size(), in_b.size()); ++v)
            elsewhere += in_a[v].column != in_b[v].column || in_a[v].row != in_b[v].row ? 1 : 0;
    }
    return number(elsewhere);
}

} // namespace

void add_compare_facts(std::vector<Fact>& table) {
    table.push_back({"comparing", "1 while a second run is compared.", yes_or_no(),
                     [](const Facts& f, int) { return number(f.session().b ? 1 : 0); }});
    add_compare_fact(table, "compare.different_pixels", "Pixels whose colour differs in run B.",
                     natural(), [](const Comparison& c) { return number(c.pixels.different); });
    add_compare_fact(
        table, "compare.largest_difference",
        "Largest difference of a pixel, in the channel that differs most; linear, or as shown if "
        "only one run encodes or wraps colours.",
        real(0), [](const Comparison& c) { return number(c.pixels.largest); });
    add_compare_fact(table, "compare.mean_difference", "The same, averaged over all pixels.",
                     real(0), [](const Comparison& c) { return number(c.pixels.mean); });
    table.push_back({"compare.samples", "Edge samples that fall on a different pixel in run B.",
                     natural(), [](const Facts& f, int) { return number(f.different_samples()); }});
    for (int edge = 0; edge < triangle_corners; ++edge) {
        table.push_back(
            {fmt::format("compare.e{}.samples", edge),
             fmt::format("The same for {} of the triangle shown.", edge_name(edge)), natural(),
             [](const Facts& f, int e) { return number(f.different_samples(e)); }, edge});
    }
    table.push_back({"compare.vertices_elsewhere",
                     "Corners of triangles that fall on a different pixel in run B.", natural(),
                     vertices_elsewhere});
    add_compare_fact(table, "compare.rows", "Rows of row tables that differ.", natural(),
                     [](const Comparison& c) { return number(c.different_rows); });
    add_compare_fact(table, "compare.first", "First moment at which the runs differ, or none.",
                     moment(), [](const Comparison& c) {
                         const std::optional<Divergence>& first = c.divergences.first;
                         return first ? Value(first->cursor) : Value();
                     });
}

} // namespace rasterwalk
