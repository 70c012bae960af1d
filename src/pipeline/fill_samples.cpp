#include "pipeline/fill_samples.h"

#include <algorithm>
#include <optional>

namespace rasterwalk {

namespace {

/// A fragment of a pixel with several samples.
struct SampledFragment {
    Cursor cursor;
    Fragment at_centre;
    OfSamples<Fragment> at_samples; ///< only of those that are covered
    SampleMask covered = 0;
    std::size_t pixel = 0; ///< in the planes
};

/// What becomes of a fragment, as it is reported.
struct SampledFate {
    SampleMask passed = 0;
    Fate fate = Fate::depth_failed; ///< if none has passed
    float alpha = 1.0f;
    SampleDepths depths{}; ///< for the depth buffer
};

/// The columns of a row that is not empty which lie in the window and in the scissor, as columns of
/// the picture.
ColumnRange sampled_columns(const Drawing& d, const Cursor& row, const PolygonRows& rows) {
    const auto i = static_cast<std::size_t>(row.index);
    const int left = rows.left[i].column;
    const PieceRange columns =
        clamp_to_window(d.window, row, &Cursor::step, rows.right[i].column - left + 1);
    return in_columns({left + columns.first, left + columns.last - 1}, d.scissor);
}

glm::vec3 shade_fragment(Drawing& d, const Fragment& fragment, const Surface& surface) {
    ++d.tally.shaded;
    return d.stages.pixel_shader(fragment, surface, d.pixels, d.stages);
}

DepthResult test_sample(Drawing& d, const SampledFragment& of, std::size_t sample, bool is_stored) {
    d.tally.samples_compared += is_stored ? 1 : 0;
    d.depth.owner = d.target.owner[of.pixel];
    return d.stages.depth_test(d.stages.fragment_at_sample(of.at_centre, of.at_samples[sample]),
                               d.target.sample_depth[of.pixel][sample], d.depth);
}

/// Lays a colour over a sample, and shows sample 0.
void put_sample(Drawing& d, const SampledFragment& of, std::size_t sample, const glm::vec3& colour,
                float alpha) {
    glm::vec3& stored = d.target.sample_colour[of.pixel][sample];
    stored = alpha < 1.0f ? d.stages.blend(colour, alpha, stored) : colour;
    std::int32_t& owner = d.target.owner[of.pixel];
    if (sample == 0 || owner < 0) owner = of.cursor.triangle;
    if (sample == 0) d.target.colour[of.pixel] = stored;
}

void store_depth(Drawing& d, std::size_t pixel, std::size_t sample, float depth) {
    d.target.sample_depth[pixel][sample] = depth;
    if (sample == 0) d.target.depth[pixel] = depth;
}

/// Is a fragment left out before the depth test, and why?
std::optional<Fate> left_out(const Drawing& d, const Fragment& fragment,
                             const FragmentAlpha& alpha) {
    if (d.culls_fragments && d.stages.cull_fragment(fragment, d.rays, d.stages))
        return Fate::back_facing;
    if (alpha.is_cut) return Fate::cut_out;
    return std::nullopt;
}

/// One colour, of the pixel's centre, for all samples that pass.
SampledFate draw_multisampled(Drawing& d, const SampledFragment& of, const Surface& surface,
                              bool is_stored) {
    SampledFate result;
    const FragmentAlpha alpha = fragment_alpha(of.at_centre, surface, d.pixels, d.stages);
    result.alpha = alpha.alpha;
    if (const std::optional<Fate> fate = left_out(d, of.at_centre, alpha)) {
        result.fate = *fate;
        return result;
    }
    for (int s = 0; s < sample_count; ++s) {
        const auto sample = static_cast<std::size_t>(s);
        if (!has_sample(of.covered, s)) continue;
        const DepthResult test = test_sample(d, of, sample, is_stored);
        result.depths[sample] = test.depth;
        if (!test.passed) continue;
        result.passed |= mask_of(s);
        if (is_stored) store_depth(d, of.pixel, sample, test.depth);
    }
    if (result.passed == 0 && !d.shades_first) return result;
    const glm::vec3 colour = shade_fragment(d, of.at_centre, surface);
    for (int s = 0; s < sample_count; ++s) {
        if (has_sample(result.passed, s))
            put_sample(d, of, static_cast<std::size_t>(s), colour, alpha.alpha);
    }
    return result;
}

/// Each sample is a fragment of its own.
SampledFate draw_supersampled(Drawing& d, const SampledFragment& of, const Surface& surface,
                              bool is_stored) {
    SampledFate result;
    bool is_tested = false;
    for (int s = 0; s < sample_count; ++s) {
        const auto sample = static_cast<std::size_t>(s);
        if (!has_sample(of.covered, s)) continue;
        const Fragment& fragment = of.at_samples[sample];
        const FragmentAlpha alpha = fragment_alpha(fragment, surface, d.pixels, d.stages);
        if (const std::optional<Fate> fate = left_out(d, fragment, alpha)) {
            if (!is_tested) result.fate = *fate;
            continue;
        }
        is_tested = true;
        result.fate = Fate::depth_failed;
        if (result.passed == 0) result.alpha = alpha.alpha;
        const DepthResult test = test_sample(d, of, sample, is_stored);
        result.depths[sample] = test.depth;
        if (!test.passed && !d.shades_first) continue;
        const glm::vec3 colour = shade_fragment(d, fragment, surface);
        if (!test.passed) continue;
        result.passed |= mask_of(s);
        if (is_stored) store_depth(d, of.pixel, sample, test.depth);
        put_sample(d, of, sample, colour, alpha.alpha);
    }
    return result;
}

void draw_sampled(Drawing& d, const SampledFragment& of, const Surface& surface,
                  bool is_supersampled) {
    const Fragment& place = of.at_centre;
    const bool is_stored = d.all_have_cells || has_depth_cell(d.stages, place.column, place.row,
                                                              d.frame.settings.viewport);
    if (!is_stored && d.is_depth_tested) ++d.tally.depth_outside;
    ++d.tally.fragments;
    ++d.target.overdraw[of.pixel];
    const bool is_watched = d.observer != nullptr && d.observer->fragment != nullptr;
    const SampleColours before = is_watched ? d.target.sample_colour[of.pixel] : SampleColours{};
    const SampleDepths stored = is_watched ? d.target.sample_depth[of.pixel] : SampleDepths{};
    const SampledFate became = is_supersampled ? draw_supersampled(d, of, surface, is_stored)
                                               : draw_multisampled(d, of, surface, is_stored);
    if (!is_watched) return;
    const SampleMask shown = became.passed != 0 ? became.passed : of.covered;
    const auto sample = static_cast<std::size_t>(first_sample(shown));
    const Fate fate = became.passed != 0 ? Fate::written : became.fate;
    d.observer->fragment({of.cursor, of.at_centre, fate,
                          is_depth_tested(fate) ? became.depths[sample] : of.at_centre.depth,
                          stored[sample], before[sample], d.target.sample_colour[of.pixel][sample],
                          became.alpha, of.covered, became.passed});
}

/// The values of a fragment at each sample that it covers.
/// @param carried the varyings that are wanted there; none if only the depth is
void find_samples(const Drawing& d, const PolygonRows& rows, VaryingSet carried,
                  SampledFragment& of) {
    for (int s = 0; s < sample_count; ++s) {
        if (!has_sample(of.covered, s)) continue;
        const auto sample = static_cast<std::size_t>(s);
        const GridPoint& place = rows.tested.samples[sample];
        const int column = of.at_centre.column, row = of.at_centre.row;
        of.at_samples[sample] =
            weighted_fragment(rows.tested, triangle_of_point(rows.tested, column, row, place),
                              column, row, place, d.stages, carried);
    }
}

} // namespace

void fill_sample_rows(Drawing& d, const PolygonRows& rows, const Surface& surface,
                      const Cursor& begin) {
    const bool is_supersampled = sampling_rule(d.frame.settings) == Sampling::supersample;
    const VaryingSet at_samples = is_supersampled ? d.carried : VaryingSet{};
    d.depth.triangle = begin.triangle;
    const PieceRange range = clamp_to_window(d.window, begin, &Cursor::index, rows.size());
    // The row above the first that begins in the window may end in it; its columns decide.
    const int first_row = std::max({range.first - 1, d.scissor.top - rows.first_row, 0});
    const int last_row = std::min(range.last, d.scissor.bottom - rows.first_row);
    SampledFragment of;
    for (int r = first_row; r < last_row; ++r) {
        of.cursor = begin;
        of.cursor.index = r;
        if (rows.is_empty_row(r)) continue;
        const auto i = static_cast<std::size_t>(r);
        const int left = rows.left[i].column;
        const ColumnRange columns = sampled_columns(d, of.cursor, rows);
        const Row row{rows.left[i], rows.right[i], rows.first_row + r,
                      rows.right[i].column - left + 1, &rows.tested};
        for (int column = columns.first; column <= columns.last; ++column) {
            of.covered = covered_samples(rows, r, column);
            if (of.covered == 0) continue;
            const std::span<LineSample> centre = samples_of(d.fragments, 1);
            d.stages.row_fragments(d.stages, row, column - left, d.carried, centre);
            of.cursor.step = column - left;
            of.at_centre = centre.front().fragment;
            of.pixel = d.target.at(column, row.row);
            find_samples(d, rows, at_samples, of);
            draw_sampled(d, of, surface, is_supersampled);
        }
    }
}

void resolve_pixels(Drawing& d) {
    Cursor cursor = moment_of_resolve(0, 0);
    const Viewport& picture = d.frame.settings.viewport;
    const PieceRange rows = clamp_to_window(d.window, cursor, &Cursor::index, picture.height);
    const bool is_watched = d.observer != nullptr && d.observer->resolve != nullptr;
    const int first = std::max(rows.first - 1, d.scissor.top);
    const int last = std::min(rows.last, d.scissor.bottom);
    for (int row = first; row < last; ++row) {
        cursor.index = row;
        const PieceRange part = clamp_to_window(d.window, cursor, &Cursor::step, picture.width);
        const ColumnRange columns = in_columns({part.first, part.last - 1}, d.scissor);
        for (int column = columns.first; column <= columns.last; ++column) {
            const std::size_t pixel = d.target.at(column, row);
            const SampleColours& samples = d.target.sample_colour[pixel];
            d.target.colour[pixel] = d.stages.resolve(samples);
            if (!is_watched) continue;
            cursor.step = column;
            d.observer->resolve({cursor, column, row, samples, d.target.colour[pixel]});
        }
    }
}

} // namespace rasterwalk
