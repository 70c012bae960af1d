#include "facts/facts.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "inspect/carried_row.h"
#include "inspect/depth_prepass.h"
#include "picture/pixel_facts.h"
#include "pipeline/draw.h"
#include "pipeline/surface.h"

namespace rasterwalk {

namespace {

double largest_component(const glm::vec3& v) {
    return static_cast<double>(std::max({v.x, v.y, v.z}));
}

/// The colour that the pixel shader gives a fragment interpolated one way.
/// @param stages of that way
glm::vec3 colour_of(const Frame& frame, const Fragment& fragment, Interpolation mode,
                    const Stages& stages, int triangle) {
    Surface surface = surface_of(frame, triangle);
    // The footprint, too, is interpolated that way.
    if (surface.texture != nullptr || surface.normal_map != nullptr) {
        Settings settings = frame.settings;
        settings.interpolation = mode;
        surface.texture_slope = texture_slope(polygon_under(frame, triangle, settings), stages);
    }
    return frame.stages.pixel_shader(fragment, surface, pixel_rules(frame), stages);
}

std::optional<InterpolationError> error_of(const Frame& frame, const Cursor& at) {
    if (at.phase != Phase::rows || !has_fragments(frame.settings.stage)) return std::nullopt;
    if (frame.has_samples()) return std::nullopt; // what a pixel shows is no single fragment
    const std::optional<CarriedRow> row = carried_row(frame, at.triangle, at.index);
    if (!row || at.step >= row->count) return std::nullopt;
    struct Values {
        glm::vec3 colour, position;
    };
    const auto by = [&](Interpolation interpolation) {
        const Fragment fragment = row->at(interpolation, at.step);
        const Stages& stages = row->stages[static_cast<std::size_t>(interpolation)];
        return Values{colour_of(frame, fragment, interpolation, stages, at.triangle),
                      recover_varyings(fragment, stages).position_world};
    };
    const Values right = by(Interpolation::perspective), wrong = by(Interpolation::affine);
    return InterpolationError{largest_component(glm::abs(wrong.colour - right.colour)),
                              static_cast<double>(glm::length(wrong.position - right.position))};
}

} // namespace

Facts::Facts(const Session& session, const Results& results, FactCache* cache)
    : session_(&session), results_(&results), cache_(cache) {}

FactCache& Facts::cache() const {
    FactCache& cache = cache_ != nullptr ? *cache_ : own_;
    if (cache.frame_number != results_->a.frame_number) {
        cache = FactCache{};
        cache.frame_number = results_->a.frame_number;
    }
    return cache;
}

const FrameStats& Facts::frame_stats() const {
    FactCache& known = cache();
    if (!known.frame) known.frame = rasterwalk::frame_stats(results_->a.frame);
    return *known.frame;
}

const DrawCost& Facts::draw_cost() const {
    FactCache& known = cache();
    if (!known.cost) known.cost = rasterwalk::draw_cost(results_->a.frame);
    return *known.cost;
}

std::optional<std::int64_t> Facts::prepass_shaded() const {
    const Frame& frame = results_->a.frame;
    if (!can_have_prepass(frame)) return std::nullopt;
    FactCache& known = cache();
    if (!known.prepass_shaded) {
        Framebuffer drawn;
        known.prepass_shaded =
            draw_with_prepass(prepare_prepass(*frame.given, frame.settings, frame.replace),
                              cursor_end, drawn)
                .picture.shaded;
    }
    return known.prepass_shaded;
}

const ClipHistory* Facts::clip() const {
    const std::optional<int>& triangle = results_->a.triangle;
    if (!triangle) return nullptr;
    FactCache& known = cache();
    if (!known.clip || known.clip->triangle != *triangle)
        known.clip = clip_history(results_->a.frame, *triangle);
    return &*known.clip;
}

const CoverageComparison* Facts::outline() const {
    const std::optional<int>& triangle = results_->a.triangle;
    if (!triangle) return nullptr;
    FactCache& known = cache();
    if (known.outline_triangle != triangle) {
        known.outline = coverage_comparison(results_->a.frame, *triangle);
        known.outline_triangle = triangle;
    }
    return known.outline ? &*known.outline : nullptr;
}

const CountedEdge* Facts::shared_edge() const {
    const std::optional<int>& triangle = results_->a.triangle;
    const std::optional<glm::ivec2>& pixel = session_->selection.pixel;
    if (!triangle) return nullptr;
    FactCache& known = cache();
    if (known.shared_triangle != triangle || known.shared_pixel != pixel) {
        const Frame& frame = results_->a.frame;
        const std::optional<SharedEdge> shared = shared_edge_at(frame, *triangle, pixel);
        known.shared.reset();
        if (shared) known.shared = {*shared, count_by_rules(frame, *shared)};
        known.shared_triangle = triangle;
        known.shared_pixel = pixel;
    }
    return known.shared ? &*known.shared : nullptr;
}

const EdgeEnds& Facts::edge_ends() const {
    FactCache& known = cache();
    if (!known.edge_ends) known.edge_ends = count_edge_ends(results_->a.frame);
    return *known.edge_ends;
}

const FrameShadows& Facts::shadows() const {
    FactCache& known = cache();
    if (!known.shadows) known.shadows = count_shadows(results_->a.frame);
    return *known.shadows;
}

const HiddenWay* Facts::hidden_way() const {
    FactCache& known = cache();
    const Frame& frame = results_->a.frame;
    if (!known.hidden_way) {
        known.hidden_way =
            hidden_ways(*frame.given, frame.settings, hidden_rule(frame.settings)).back();
    }
    return known.hidden_way->is_possible ? &*known.hidden_way : nullptr;
}

const RayStats* Facts::rays() const {
    FactCache& known = cache();
    if (!known.rays) known.rays = ray_stats(results_->a.frame);
    return known.rays ? &*known.rays : nullptr;
}

std::int64_t Facts::drawn_twice() const {
    FactCache& known = cache();
    if (!known.drawn_twice) {
        const PixelFacts pixels = pixel_facts(results_->a.frame, cursor_end, {.drawn_twice = true});
        known.drawn_twice = std::count_if(pixels.drawn_twice.begin(), pixels.drawn_twice.end(),
                                          [](const DrawnTwice& pair) { return bool(pair); });
    }
    return *known.drawn_twice;
}

const std::vector<int>& Facts::column_owners() const {
    FactCache& known = cache();
    const int column = results_->history->pixel.x;
    if (known.column != column) {
        const Frame& frame = results_->a.frame;
        Framebuffer drawn;
        clear(drawn, frame, {1, frame.settings.viewport.height}, {column, 0});
        draw(frame, {}, drawn);
        known.column = column;
        known.column_owners = drawn.owner;
    }
    return known.column_owners;
}

/// Forgets the counts made with another frame of run B.
FactCache& Facts::cache_with_b() const {
    FactCache& known = cache();
    if (known.samples_of != results_->b->frame_number) {
        known.different_samples.reset();
        known.different_triangle.reset();
        known.samples_of = results_->b->frame_number;
    }
    return known;
}

bool Facts::has_same_triangles_in_b() const {
    return results_->b && have_same_triangles(results_->a.frame, results_->b->frame);
}

std::optional<std::int64_t> Facts::different_samples() const {
    if (!has_same_triangles_in_b()) return std::nullopt;
    FactCache& known = cache_with_b();
    if (!known.different_samples) {
        known.different_samples =
            rasterwalk::different_samples(results_->a.frame, results_->b->frame);
    }
    return known.different_samples;
}

std::optional<std::int64_t> Facts::different_samples(int edge) const {
    const std::optional<int>& triangle = results_->a.triangle;
    if (!has_same_triangles_in_b() || !triangle) return std::nullopt;
    FactCache& known = cache_with_b();
    if (known.different_triangle != triangle) {
        known.different_edges =
            rasterwalk::different_samples(results_->a.frame, results_->b->frame, *triangle);
        known.different_triangle = triangle;
    }
    const auto i = static_cast<std::size_t>(edge);
    if (i >= known.different_edges.size()) return std::nullopt;
    return known.different_edges[i];
}

std::optional<LineDecision> Facts::decision() const {
    const Cursor& at = results_->a.cursor;
    const Frame& frame = results_->a.frame;
    if (at == cursor_end || at.phase != Phase::edges || !frame.is_drawn(at.triangle) ||
        frame.stages.line == line_by_interpolate)
        return std::nullopt;
    FactCache& known = cache();
    if (known.decision_at != at) {
        known.decision.reset();
        Cursor after = at;
        ++after.step;
        const RowHistory history = row_history(frame, at.triangle, after);
        if (history.last && history.last->edge == at.index && history.last->sample == at.step)
            known.decision = history.last->decision;
        known.decision_at = at;
    }
    return known.decision;
}

std::optional<PixelTest> Facts::pixel_test() const {
    return test_at(results_->a.frame, results_->a.cursor);
}

const RowHistory* Facts::table() const {
    const std::optional<int>& triangle = results_->a.triangle;
    const Frame& frame = results_->a.frame;
    if (!triangle || !frame.is_drawn(*triangle)) return nullptr;
    FactCache& known = cache();
    if (known.table_triangle != triangle) {
        known.table = row_history(frame, *triangle);
        known.table_triangle = triangle;
    }
    return &known.table;
}

std::optional<int> Facts::table_row() const {
    const RowHistory* const history = table();
    const std::optional<int>& row = session_->selection.row;
    if (history == nullptr || !row) return std::nullopt;
    const int index = *row - history->rows.first_row;
    return index >= 0 && index < history->rows.size() ? std::optional(index) : std::nullopt;
}

const PixelEntry* Facts::winner() const {
    const std::optional<PixelHistory>& history = results_->history;
    if (!history || history->winner < 0) return nullptr;
    return &history->entries[static_cast<std::size_t>(history->winner)];
}

std::optional<InterpolationError> Facts::interpolation_error() const {
    const PixelEntry* const entry = winner();
    if (entry == nullptr) return std::nullopt;
    FactCache& known = cache();
    if (known.error_at != entry->cursor) {
        known.error = error_of(results_->a.frame, entry->cursor);
        known.error_at = entry->cursor;
    }
    return known.error;
}

const TextureReport* Facts::texture() const {
    const PixelEntry* const entry = winner();
    if (entry == nullptr) return nullptr;
    FactCache& known = cache();
    if (known.texture_at != entry->cursor) {
        known.texture = texture_report(results_->a.frame, entry->cursor);
        known.texture_at = entry->cursor;
    }
    return known.texture ? &*known.texture : nullptr;
}

const FragmentReport* Facts::fragment() const {
    const PixelEntry* const entry = winner();
    if (entry == nullptr) return nullptr;
    FactCache& known = cache();
    if (known.fragment_at != entry->cursor) {
        known.fragment = fragment_report(results_->a.frame, entry->cursor);
        known.fragment_at = entry->cursor;
    }
    return known.fragment ? &*known.fragment : nullptr;
}

const FragmentReport* Facts::light() const {
    const bool is_lit = shading_rule(results_->a.frame.settings) != Shading::unlit;
    return is_lit ? fragment() : nullptr;
}

const VertexReport* Facts::vertex() const {
    const std::optional<int>& vertex = session_->selection.vertex;
    const std::vector<VertexReport>& reports = results_->a.inspected.vertices;
    if (!vertex || *vertex < 0 || static_cast<std::size_t>(*vertex) >= reports.size()) {
        return nullptr;
    }
    return &reports[static_cast<std::size_t>(*vertex)];
}

} // namespace rasterwalk
