#include "pipeline/draw_cost.h"

#include <algorithm>

#include "pipeline/draw.h"
#include "pipeline/observe_tests.h"
#include "pipeline/surface.h"

namespace rasterwalk {

namespace {

constexpr std::int64_t depth_size = sizeof(float), colour_size = sizeof(glm::vec3);

/// Counts the samples of edges.
struct SampleCounter : SampleSink {
    std::int64_t count = 0;

    void edge_sample(const EdgeSample&) override { ++count; }
};

/// The shadow tests for a point that is lit. A ray is not followed again: there is one for each
/// point that faces the lamp.
std::int64_t shadow_tests_at(const SurfacePoint& point, const PixelRules& rules,
                             const Stages& stages) {
    if (rules.occluders == nullptr) return 0;
    const SurfaceLight unshadowed = surface_light(point, rules.light, rules.rays, nullptr, stages);
    if (!(unshadowed.diffuse.cosine > 0.0f)) return 0;
    if (rules.occluders->map == nullptr) return 1;
    return surface_light(point, rules.light, rules.rays, rules.occluders, stages)
        .shadow.texel_count;
}

/// The lamp's light for a whole triangle, as surface_of() works it out.
void add_flat_light(const Frame& frame, int triangle, DrawCost& cost) {
    if (shading_rule(frame.settings) != Shading::flat) return;
    ++cost.vertex_lights;
    cost.shadow_tests +=
        shadow_tests_at(flat_point(frame, triangle), pixel_rules(frame), frame.stages);
}

/// Watches a drawing, and works out again what the shader does.
class CostCounter {
  public:
    CostCounter(const Frame& frame, DrawCost& cost, std::vector<PixelCost>* pixels)
        : frame_(frame), stages_(frame.stages), rules_(pixel_rules(frame)),
          rays_(sight_rays(vertex_rules(frame))),
          has_depth_test_(depth_rule(frame.settings) != DepthTest::off),
          shades_first_(frame.settings.depth_order == DepthOrder::before_depth_test),
          is_supersampled_(frame.has_samples() &&
                           sampling_rule(frame.settings) == Sampling::supersample),
          cost_(cost), pixels_(pixels) {}

    void note(const FragmentEvent& event) {
        if (event.cursor.triangle != triangle_) take(event.cursor.triangle);
        PixelCost one;
        one.fragments = 1;
        one.written = event.fate == Fate::written ? 1 : 0;
        if (is_supersampled_) {
            add_samples(event, one);
        } else {
            add_fragment(event.fragment, event.fate, std::max(count_samples(event.covered), 1),
                         one);
        }
        add(event, one);
    }

  private:
    void take(int triangle) {
        triangle_ = triangle;
        surface_ = surface_of(frame_, triangle);
        if (is_supersampled_) compute_rows(frame_, triangle, rows_);
    }

    /// @param tested depth tests, if there are any
    void add_fragment(const Fragment& fragment, Fate fate, int tested, PixelCost& one) {
        // Of a pixel with samples, alpha is read before the fragment is culled.
        const bool reads_alpha = surface_.texture_alpha != TextureAlpha::off &&
                                 (fate != Fate::back_facing || frame_.has_samples());
        if (reads_alpha) one.texels += texels_of(fragment, surface_.texture);
        if (!is_depth_tested(fate)) return;
        if (has_depth_test_ &&
            has_depth_cell(stages_, fragment.column, fragment.row, frame_.settings.viewport))
            one.depth_tests += static_cast<std::uint32_t>(tested);
        if (fate == Fate::written || shades_first_) shade(fragment, one);
    }

    /// Each sample is a fragment of its own, with its own values.
    void add_samples(const FragmentEvent& event, PixelCost& one) {
        for (int s = 0; s < sample_count; ++s) {
            if (!has_sample(event.covered, s)) continue;
            const GridPoint& place = rows_.tested.samples[static_cast<std::size_t>(s)];
            const int column = event.fragment.column, row = event.fragment.row;
            const Fragment sample =
                weighted_fragment(rows_.tested, triangle_of_point(rows_.tested, column, row, place),
                                  column, row, place, stages_, VaryingSet::all());
            add_fragment(sample, fate_of(sample, has_sample(event.passed, s)), 1, one);
        }
    }

    Fate fate_of(const Fragment& sample, bool has_passed) const {
        if (has_passed) return Fate::written;
        if (stages_.cull_fragment(sample, rays_, stages_)) return Fate::back_facing;
        return fragment_alpha(sample, surface_, rules_, stages_).is_cut ? Fate::cut_out
                                                                        : Fate::depth_failed;
    }

    /// What pixel_shader() and surface_shader() do for a fragment.
    void shade(const Fragment& fragment, PixelCost& one) {
        ++one.shaded;
        one.texels +=
            texels_of(fragment, surface_.texture) + texels_of(fragment, surface_.normal_map);
        if (rules_.shading != Shading::phong) return;
        ++one.lights;
        if (rules_.occluders == nullptr) return;
        one.shadow_tests += static_cast<std::uint32_t>(
            shadow_tests_at(lit_point(fragment, surface_, rules_, stages_), rules_, stages_));
    }

    /// A lookup in a map, and the one in the height map that shifts it.
    std::uint32_t texels_of(const Fragment& fragment, const Texture* map) const {
        if (map == nullptr) return 0;
        SampledTexels taken;
        stages_.sample_texture(*map, place_in_texture(fragment, surface_, rules_, stages_), stages_,
                               &taken);
        SampledTexels heights;
        if (surface_.heights.map != nullptr)
            parallax_terms(fragment, surface_, rules_, stages_, &heights);
        return static_cast<std::uint32_t>(taken.count + heights.count);
    }

    void add(const FragmentEvent& event, const PixelCost& one) {
        cost_.fragments += one.fragments;
        cost_.depth_tests += one.depth_tests;
        cost_.shaded += one.shaded;
        cost_.pixel_lights += one.lights;
        cost_.shadow_tests += one.shadow_tests;
        cost_.texels += one.texels;
        cost_.written += one.written;
        const std::int64_t put = frame_.has_samples() ? count_samples(event.passed) : one.written;
        const bool has_cell = has_depth_cell(stages_, event.fragment.column, event.fragment.row,
                                             frame_.settings.viewport);
        const std::int64_t stored = has_depth_test_ && has_cell ? put : 0;
        cost_.depth_bytes += depth_size * (one.depth_tests + stored);
        cost_.colour_bytes += colour_size * (event.alpha < 1.0f ? 2 * put : put);
        cost_.texture_bytes += colour_size * one.texels;
        if (pixels_ == nullptr) return;
        const auto width = static_cast<std::size_t>(frame_.settings.viewport.width);
        PixelCost& pixel = (*pixels_)[static_cast<std::size_t>(event.fragment.row) * width +
                                      static_cast<std::size_t>(event.fragment.column)];
        for (std::uint32_t PixelCost::*const count :
             {&PixelCost::fragments, &PixelCost::depth_tests, &PixelCost::shaded,
              &PixelCost::lights, &PixelCost::shadow_tests, &PixelCost::texels,
              &PixelCost::written})
            pixel.*count += one.*count;
    }

    const Frame& frame_;
    const Stages& stages_;
    PixelRules rules_;
    SightRays rays_;
    bool has_depth_test_, shades_first_, is_supersampled_;
    DrawCost& cost_;
    std::vector<PixelCost>* pixels_;
    int triangle_ = -1; ///< whose surface and rows these are
    Surface surface_;
    PolygonRows rows_;
};

/// Draws under a counter.
void count_drawing(const Frame& frame, const DrawWindow& window, Framebuffer& framebuffer,
                   DrawCost& cost, std::vector<PixelCost>* pixels) {
    CostCounter counter(frame, cost, pixels);
    const Observer observer{.fragment = [&](const FragmentEvent& event) { counter.note(event); }};
    // Before the fill stage the marks on the screen are reported as fragments.
    const bool has_any = has_fragments(frame.settings.stage);
    draw(frame, window, framebuffer, has_any ? &observer : nullptr);
}

/// What a triangle takes until it has fragments.
void add_triangle(const Frame& frame, int triangle, PolygonRows& rows, DrawCost& cost) {
    if (!frame.is_drawn(triangle) || frame.settings.stage == Stage::points) return;
    SampleCounter samples;
    compute_rows(frame, triangle, rows, &samples, {});
    cost.edge_samples += walks_edges(frame.stages) ? samples.count : 0;
    cost.pixels_tested += count_pixel_tests(frame, rows.tested);
    if (has_fragments(frame.settings.stage)) add_flat_light(frame, triangle, cost);
}

} // namespace

const std::array<CostInfo, cost_count>& cost_list() {
    static constexpr std::array<CostInfo, cost_count> list{{
        {"vertices", "vertices", "vertices taken through the vertex shader, each once",
         &DrawCost::vertices, false},
        {"vertex_lights", "lights at vertices",
         "vertices, or under flat shading triangles, whose light is computed",
         &DrawCost::vertex_lights, false},
        {"edge_samples", "edge samples", "samples of edges that make the row tables",
         &DrawCost::edge_samples},
        {"pixels_tested", "pixels tested",
         "pixels of the picture that edge functions test; 0 with any other coverage",
         &DrawCost::pixels_tested},
        {"fragments", "fragments", "fragments that fall inside the picture", &DrawCost::fragments},
        {"depth_tests", "depth tests",
         "fragments, or samples of fragments, compared with the depth buffer",
         &DrawCost::depth_tests},
        {"shaded", "colours", "fragments, or samples of fragments, whose colour is computed",
         &DrawCost::shaded},
        {"pixel_lights", "lights at pixels",
         "fragments, or samples of fragments, whose light is computed", &DrawCost::pixel_lights},
        {"shadow_tests", "shadow tests",
         "rays from a surface to the lamp, or texels of the shadow map that are compared",
         &DrawCost::shadow_tests},
        {"texels", "texels", "texels read from textures, normal maps and height maps",
         &DrawCost::texels},
        {"written", "written", "fragments that are put into the picture", &DrawCost::written},
        {"depth_bytes", "depth bytes",
         "bytes of the depth buffer read and written, 4 for each depth", &DrawCost::depth_bytes},
        {"colour_bytes", "colour bytes",
         "bytes of the picture written, and read to blend, 12 for each colour",
         &DrawCost::colour_bytes},
        {"texture_bytes", "texture bytes", "bytes of the texels read, 12 for each",
         &DrawCost::texture_bytes},
    }};
    return list;
}

void add_vertex_cost(const Frame& frame, std::size_t first, std::size_t end, DrawCost& cost) {
    const auto count = static_cast<std::int64_t>(end - first);
    cost.vertices += count;
    const VertexRules rules = vertex_rules(frame);
    if (rules.shading != Shading::gouraud) return;
    cost.vertex_lights += count;
    if (rules.occluders == nullptr) return;
    for (std::size_t v = first; v < end; ++v) {
        const Vertex& vertex = frame.scene->mesh.vertices()[v];
        const ShadowTerms shadow = light_at_vertex(vertex, rules, frame.stages).shadow;
        if (shadow.is_tested) cost.shadow_tests += shadow.face >= 0 ? shadow.texel_count : 1;
    }
}

void add_cost(const Frame& frame, const Cursor& from, const Cursor& to, Framebuffer& framebuffer,
              DrawCost& cost, std::vector<PixelCost>* pixels) {
    count_drawing(frame, {.from = from, .to = to, .scissor = {}}, framebuffer, cost, pixels);
    PolygonRows rows;
    for (int t = 0; t < frame.triangle_count(); ++t) {
        const Cursor begins = frame.squares != nullptr ? moment_of_square(0) : beginning_of(t);
        if (from <= begins && begins < to) add_triangle(frame, t, rows, cost);
    }
}

DrawCost draw_cost(const Frame& frame, const Cursor& to, std::vector<PixelCost>* pixels) {
    DrawCost cost;
    add_vertex_cost(frame, 0, frame.shaded.size(), cost);
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    if (pixels != nullptr) pixels->assign(framebuffer.owner.size(), {});
    add_cost(frame, cursor_begin, to, framebuffer, cost, pixels);
    return cost;
}

DrawCost triangle_cost(const Frame& frame, int triangle) {
    DrawCost cost;
    PolygonRows rows;
    add_triangle(frame, triangle, rows, cost);
    Framebuffer framebuffer;
    clear(framebuffer, frame);
    DrawWindow window{.from = cursor_begin, .to = cursor_end, .scissor = {}};
    if (frame.squares != nullptr) {
        window.only = triangle;
        count_drawing(frame, window, framebuffer, cost, nullptr);
        return cost;
    }
    window.to = beginning_of(triangle);
    draw(frame, window, framebuffer);
    window.from = window.to;
    window.to = beginning_of(triangle + 1);
    count_drawing(frame, window, framebuffer, cost, nullptr);
    return cost;
}

} // namespace rasterwalk
