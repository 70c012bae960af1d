#include "facts/fact_groups.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/element_names.h"

namespace rasterwalk {

namespace {

/// The comparison of the whole frames; null without a second run, and until it
/// is done.
const Comparison* comparison(const Facts& facts) {
    const Results& results = facts.results();
    return results.b && results.comparison.work.is_done() ? &results.comparison.whole() : nullptr;
}

/// The same if only pictures were compared.
const Comparison* picture_comparison(const Facts& facts) {
    const Comparison* const found = comparison(facts);
    return found != nullptr && !found->only_pictures.empty() ? found : nullptr;
}

/// Vertices of the scene's triangles, uncut and drawn in both runs, whose pixel
/// is a different one in run B.
std::optional<int> vertices_elsewhere(const Facts& facts) {
    const Results& results = facts.results();
    if (!facts.has_same_triangles_in_b()) return std::nullopt;
    const Frame &a = results.a.frame, &b = results.b->frame;
    int elsewhere = 0;
    for (int t = 0; t < std::min(a.triangle_count(), b.triangle_count()); ++t) {
        if (!a.is_drawn(t) || !b.is_drawn(t) || a.is_cut(t) || b.is_cut(t)) continue;
        const PolygonCorners in_a = a.triangle_vertices(t);
        const PolygonCorners in_b = b.triangle_vertices(t);
        for (std::size_t v = 0; v < std::min(in_a.size(), in_b.size()); ++v)
            elsewhere += in_a[v].column != in_b[v].column || in_a[v].row != in_b[v].row ? 1 : 0;
    }
    return elsewhere;
}

} // namespace

void add_compare_facts(std::vector<Fact>& table) {
    const FactAdder<everything> add(table);
    const FactAdder<comparison> add_compared(table);
    const FactAdder<picture_comparison> add_pictures(table);
    using Compared = const Comparison&;
    add("comparing", "1 while a second run is compared.", yes_or_no(),
        [](const Facts& f) { return f.session().b.has_value(); });
    add_compared("compare.different_pixels", "Pixels whose colour differs in run B.", natural(),
                 [](Compared c) { return c.pixels.different; });
    add_compared("compare.largest_difference",
                 "Largest difference of a pixel, in the channel that differs "
                 "most; linear, or as "
                 "shown if only one run encodes or wraps colours.",
                 real(0), [](Compared c) { return c.pixels.largest; });
    add_compared("compare.mean_difference", "The same, averaged over all pixels.", real(0),
                 [](Compared c) { return c.pixels.mean; });
    for (const PixelReasonWords& words : pixel_reason_list()) {
        add_pictures(
            fmt::format("compare.by.{}", words.name),
            fmt::format("Pixels that differ {}, where only pictures are compared. {}", words.title,
                        words.help),
            natural(),
            [](Compared c, int reason) {
                return c.reasons.count(static_cast<PixelReason>(reason));
            },
            static_cast<int>(words.reason));
    }
    add("compare.samples", "Edge samples that fall on a different pixel in run B.", natural(),
        [](const Facts& f) { return f.different_samples(); });
    for (int edge = 0; edge < triangle_corners; ++edge) {
        add(
            fmt::format("compare.e{}.samples", edge),
            fmt::format("The same for {} of the triangle shown.", edge_name(edge)), natural(),
            [](const Facts& f, int e) { return f.different_samples(e); }, edge);
    }
    add("compare.vertices_elsewhere",
        "Corners of triangles that fall on a different pixel in run B.", natural(),
        [](const Facts& f) { return vertices_elsewhere(f); });
    add_compared("compare.rows", "Rows of row tables that differ.", natural(),
                 [](Compared c) { return c.different_rows; });
    add_compared("compare.first", "First moment at which the runs differ, or none.", moment(),
                 [](Compared c) {
                     const std::optional<Divergence>& first = c.divergences.first;
                     return first ? Value(first->cursor) : Value();
                 });
}

} // namespace rasterwalk
