#include "picture/pixel_facts.h"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>

#include <glm/geometric.hpp>

#include "pipeline/draw.h"
#include "pipeline/observer.h"
#include "pipeline/surface.h"
#include "stages/pixel_shader.h"
#include "stages/samples.h"

namespace rasterwalk {

namespace {

/// The frame with the same fragments and the same depth test, but without light, to save time.
Frame unlit_frame(const Frame& frame, Interpolation interpolation) {
    Settings settings = frame.settings;
    settings.interpolation = interpolation;
    settings.stage = std::min(settings.stage, Stage::depth);
    return prepare_frame(*frame.given, settings, frame.replace);
}

/// A side of a triangle: the two points it joins, the smaller one first.
struct Side {
    std::array<float, 6> points;
    int triangle;
    int opposite; ///< corner of the triangle that is not on the side
};

Side side_of(const Scene& scene, int triangle, int from) {
    glm::vec3 a = scene.corner(triangle, from).position;
    glm::vec3 b = scene.corner(triangle, (from + 1) % triangle_corners).position;
    const auto comes_before = [](const glm::vec3& p, const glm::vec3& q) {
        return std::array{p.x, p.y, p.z} < std::array{q.x, q.y, q.z};
    };
    if (comes_before(b, a)) std::swap(a, b);
    return {{a.x, a.y, a.z, b.x, b.y, b.z}, triangle, (from + 2) % triangle_corners};
}

/// Where a corner is for the pixels of its triangle: walks go from whole pixel to whole pixel,
/// other methods from where the corner was snapped.
GridPoint standing_point(const Frame& frame, const ScreenVertex& vertex) {
    return walks_edges(frame.stages) ? snap_to_centre(vertex) : frame.stages.snap(vertex);
}

/// The side of the line from a to b that p is on in the picture; 0: on the line.
int side_of_line(const GridPoint& a, const GridPoint& b, const GridPoint& p) {
    const std::int64_t area = double_area(a, b, p);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// For each triangle, the earlier ones that share an edge with it and are not folded over it. Those
/// of triangle t run from begin[t] up to, not including, begin[t + 1].
struct Neighbours {
    std::vector<int> begin;
    std::vector<int> earlier;

    std::span<const int> of(int triangle) const {
        const auto t = static_cast<std::size_t>(triangle);
        return {earlier.data() + begin[t], static_cast<std::size_t>(begin[t + 1] - begin[t])};
    }
};

Neighbours find_neighbours(const Frame& frame) {
    std::vector<Side> sides;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        // The sides that are drawn of a clipped triangle are not those of the scene.
        const bool is_whole = frame.is_drawn(t) && !frame.is_cut(t);
        for (int v = 0; is_whole && v < triangle_corners; ++v)
            sides.push_back(side_of(*frame.scene, t, v));
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return a.points != b.points ? a.points < b.points : a.triangle < b.triangle;
    });
    std::vector<std::pair<int, int>> pairs; // later, earlier
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Side& later = sides[i];
        const PolygonCorners v = frame.triangle_vertices(later.triangle);
        const GridPoint a = standing_point(frame, v[(later.opposite + 1) % triangle_corners]);
        const GridPoint b = standing_point(frame, v[(later.opposite + 2) % triangle_corners]);
        const int on_side = side_of_line(a, b, standing_point(frame, v[later.opposite]));
        for (std::size_t j = i; j > 0 && i - j < most_on_an_edge; --j) {
            const Side& earlier = sides[j - 1];
            if (earlier.points != later.points) break;
            const ScreenVertex& p = frame.triangle_vertices(earlier.triangle)[earlier.opposite];
            if (earlier.triangle != later.triangle &&
                on_side * side_of_line(a, b, standing_point(frame, p)) < 0)
                pairs.emplace_back(later.triangle, earlier.triangle);
        }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    Neighbours neighbours;
    neighbours.begin.assign(static_cast<std::size_t>(frame.triangle_count()) + 1, 0);
    for (const auto& [later, earlier] : pairs) {
        ++neighbours.begin[static_cast<std::size_t>(later) + 1];
        neighbours.earlier.push_back(earlier);
    }
    for (std::size_t t = 1; t < neighbours.begin.size(); ++t)
        neighbours.begin[t] += neighbours.begin[t - 1];
    return neighbours;
}

/// The mip level of the texels that a fragment took: where two levels were mixed, between them.
float level_of(const SampledTexels& taken) {
    int low = INT_MAX, high = INT_MIN;
    for (const SampledTexel& texel : taken) {
        low = std::min(low, texel.level);
        high = std::max(high, texel.level);
    }
    if (taken.count == 0) return no_mip_level;
    if (low == high) return static_cast<float>(low);
    float sum = 0.0f, of_high = 0.0f;
    for (const SampledTexel& texel : taken) {
        sum += texel.weight;
        if (texel.level == high) of_high += texel.weight;
    }
    return static_cast<float>(low) + static_cast<float>(high - low) * of_high / sum;
}

/// Reads the textures of fragments again, to see at which level.
class LevelReader {
  public:
    /// @param frame as it is lit: the fragments come from its unlit copy, the surfaces from this
    explicit LevelReader(const Frame& frame) : frame_(frame), is_textured_(is_textured(frame)) {}

    float read(int triangle, const Fragment& fragment) {
        if (!is_textured_) return no_mip_level;
        if (triangle != surface_of_) {
            surface_ = lit_surface_of(frame_, triangle);
            surface_of_ = triangle;
        }
        if (surface_.texture == nullptr) return no_mip_level;
        // A height map shifts the place, but not the footprint, which decides the level.
        SampledTexels taken;
        frame_.stages.sample_texture(*surface_.texture,
                                     carried_place(fragment, surface_, frame_.stages),
                                     frame_.stages, &taken);
        return level_of(taken);
    }

  private:
    const Frame& frame_;
    bool is_textured_;
    int surface_of_ = -1; ///< the triangle whose surface is kept
    Surface surface_;
};

/// Notes the planes while the frame is drawn.
class FactsWriter {
  public:
    /// @param lit the frame whose textures are read
    /// @param now the planes to note; of the affine error, the positions
    FactsWriter(const Frame& frame, const Frame& lit, const FactsWanted& now, PixelFacts& facts)
        : frame_(frame), facts_(facts), now_(now), levels_(lit),
          width_(frame.settings.viewport.width),
          marks_twice_(now.drawn_twice && frame.squares == nullptr) {
        if (marks_twice_) neighbours_ = find_neighbours(frame);
        if (now.affine_error) positions.assign(facts.affine_error.size(), glm::vec3(0.0f));
    }

    void note(const FragmentEvent& event) {
        const Fragment& f = event.fragment;
        const std::size_t pixel = static_cast<std::size_t>(f.row) * width_ + f.column;
        if (marks_twice_) record_neighbours(event, pixel);
        if (now_.depth && !facts_.depth.empty()) {
            DepthVerdicts& verdicts = facts_.depth[pixel];
            if (is_depth_tested(event.fate))
                ++(event.fate == Fate::written ? verdicts.passed : verdicts.failed);
        }
        if (!positions.empty() && event.fate == Fate::written) {
            positions[pixel] = recover_varyings(f, frame_.stages).position_world;
        }
        if (now_.mip_level && event.fate == Fate::written)
            facts_.mip_level[pixel] = levels_.read(event.cursor.triangle, f);
    }

    std::vector<glm::vec3> positions; ///< of the visible fragments, if the error is wanted

  private:
    void record_neighbours(const FragmentEvent& event, std::size_t pixel) {
        const Fragment& fragment = event.fragment;
        const int triangle = event.cursor.triangle;
        if (triangle != rows_of_) make_rows(triangle);
        for (std::size_t n = 0; n < rows_.size() && n < count_; ++n) {
            const PolygonRows& rows = rows_[n];
            const int row = fragment.row - rows.first_row;
            if (row < 0 || row >= rows.size()) continue;
            if (rows.is_empty_row(row)) continue;
            if (frame_.has_samples()) {
                // Along a shared edge each of the two has its own samples of a pixel.
                if ((covered_samples(rows, row, fragment.column) & event.covered) == 0) continue;
            } else {
                const RowSpan span = row_span(frame_.stages, rows, row);
                const int step = fragment.column - span.left;
                if (step < 0 || step >= span.drawn) continue;
            }
            facts_.drawn_twice[pixel] = {neighbours_.of(triangle)[n], triangle};
        }
    }

    /// The row tables of the triangle's neighbours, which have been drawn because they are earlier.
    void make_rows(int triangle) {
        rows_of_ = triangle;
        const std::span<const int> earlier = neighbours_.of(triangle);
        count_ = earlier.size();
        if (rows_.size() < count_) rows_.resize(count_);
        for (std::size_t n = 0; n < count_; ++n) {
            compute_rows(frame_, earlier[n], rows_[n]);
        }
    }

    const Frame& frame_;
    PixelFacts& facts_;
    FactsWanted now_;
    LevelReader levels_;
    std::size_t width_;
    bool marks_twice_; ///< not of squares, in each of which one triangle is drawn
    Neighbours neighbours_;
    int rows_of_ = -1;
    std::vector<PolygonRows> rows_; ///< of the neighbours; only the first count_ are in use
    std::size_t count_ = 0;
};

/// Draws the frame under another interpolation, or its own.
/// @param now the planes to note
/// @return the positions, if the affine error is among them
std::vector<glm::vec3> draw_again(const Frame& given, Interpolation interpolation, const Cursor& to,
                                  const FactsWanted& now, PixelFacts& facts) {
    const Frame frame = unlit_frame(given, interpolation);
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    FactsWriter writer(frame, given, now, facts);
    const Observer observer{.fragment = [&](const FragmentEvent& event) { writer.note(event); }};
    draw(frame, {.from = cursor_begin, .to = to, .scissor = {}}, framebuffer, &observer);
    return std::move(writer.positions);
}

} // namespace

PixelFacts pixel_facts(const Frame& frame, const Cursor& to, const FactsWanted& wanted) {
    PixelFacts facts;
    facts.known = wanted;
    const Viewport size = frame.settings.viewport;
    const std::size_t count =
        static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    if (wanted.drawn_twice) facts.drawn_twice.resize(count);
    if (wanted.depth && depth_rule(frame.settings) != DepthTest::off) facts.depth.resize(count);
    if (wanted.affine_error) facts.affine_error.resize(count);
    if (wanted.mip_level) facts.mip_level.resize(count, no_mip_level);
    if (!wanted.any() || !has_fragments(frame.settings.stage)) return facts;

    // A texture that cuts holes is read at the place that was interpolated, so which fragments stay
    // can depend on how: only the levels are read under the frame's own interpolation.
    const Interpolation own = frame.settings.interpolation;
    const bool is_own_right = own == Interpolation::perspective;
    FactsWanted first = wanted;
    first.mip_level = wanted.mip_level && is_own_right;
    std::vector<glm::vec3> right, affine;
    if (first.any()) right = draw_again(frame, Interpolation::perspective, to, first, facts);
    if (wanted.mip_level && !is_own_right) {
        const bool is_affine = own == Interpolation::affine;
        affine = draw_again(frame, own, to,
                            {.affine_error = wanted.affine_error && is_affine, .mip_level = true},
                            facts);
    }
    if (!wanted.affine_error) return facts;
    if (affine.empty())
        affine = draw_again(frame, Interpolation::affine, to, {.affine_error = true}, facts);
    for (std::size_t i = 0; i < count; ++i) {
        const float error = glm::distance(right[i], affine[i]);
        facts.affine_error[i] = std::isfinite(error) ? error : 0.0f;
    }
    return facts;
}

} // namespace rasterwalk
