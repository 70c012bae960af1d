// Run by add_varying.sh, compiled with a varying `heat` that no file of the core has heard of.

#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "compare/divergence.h"
#include "inspect/row_graph.h"
#include "pipeline/draw.h"

using namespace rasterwalk;

namespace {

int faults = 0;

void check(bool right, const char* what) {
    if (right) return;
    std::printf("%s\n", what);
    ++faults;
}

Scene one_triangle() {
    Scene scene;
    scene.name = "one triangle";
    scene.viewport = {60, 40};
    scene.camera = {{0.0f, 0.0f, -3.0f}, 0.0f, 0.0f, 40.0f};
    scene.parts.push_back({"wall", 0, 1});
    std::array<Vertex, triangle_corners> corners;
    corners[0].position = {-1.0f, -1.0f, 0.0f};
    corners[1].position = {2.0f, -0.8f, 2.0f};
    corners[2].position = {-0.5f, 1.0f, 0.5f};
    for (Vertex& vertex : corners)
        vertex.normal = {0.0f, 0.0f, -1.0f};
    scene.mesh.add_triangle_of(corners);
    return scene;
}

/// The value that pixels must have: a plane in the world, so that it is linear on the triangle.
glm::vec2 heat_at(const glm::vec3& place) {
    return {1.0f + place.x, 2.0f - place.y};
}

template <int warmer>
ClipVertex hot_vertex_shader(const Vertex& vertex, const glm::mat3& rotation,
                             const VertexRules& rules, const Stages& stages, VertexSpaces* spaces) {
    ClipVertex clip = vertex_shader(vertex, rotation, rules, stages, spaces);
    clip.varyings.heat = heat_at(vertex.position) + glm::vec2(static_cast<float>(warmer));
    return clip;
}

/// What was interpolated reaches the pixel shader, even without an observer.
glm::vec3 heat_shader(const Fragment& fragment, const Surface&, const PixelRules&,
                      const Stages& stages) {
    return {recover_varyings(fragment, stages).heat, 0.0f};
}

template <int warmer>
void hot_stages(Stages& stages) {
    stages.vertex_shader = hot_vertex_shader<warmer>;
    stages.pixel_shader = heat_shader;
}

void check_interpolated(const Frame& frame) {
    const Framebuffer picture = draw_frame(frame);
    const std::optional<int> row = widest_row(frame, 0);
    check(row.has_value(), "the triangle has no row");
    if (!row) return;
    const RowGraph graph = *row_graph(frame, 0, *row);
    const Quantity heat_in = quantity_of(&Varyings::heat, 0);
    const Quantity heat_out = quantity_of(&Varyings::heat, 1);
    int compared = 0;
    for (int i = 0; i < graph.count(); ++i) {
        const Fragment& fragment = graph.at(Interpolation::perspective, i);
        const glm::vec3 place = recover_varyings(fragment, frame.stages).position_world;
        const glm::vec2 truth = heat_at(place);
        check(std::abs(true_value(graph, heat_in, i) - truth.x) < 1e-4f, "heat in is not there");
        check(std::abs(true_value(graph, heat_out, i) - truth.y) < 1e-4f, "heat out is not there");
        const glm::vec3& seen = picture.colour[picture.at(fragment.column, fragment.row)];
        check(std::abs(seen.x - truth.x) < 1e-4f, "the pixel shader was not given the heat");
        ++compared;
    }
    check(compared > 20, "hardly a fragment was looked at");
    check(affine_value(graph, heat_in, graph.count() / 2) !=
              true_value(graph, heat_in, graph.count() / 2),
          "affine and perspective heat are the same");
}

void check_shown(const Frame& frame) {
    bool in = false, out = false, normal = false;
    for (const QuantityInfo& info : shown_quantities(frame)) {
        in = in || info.words.id == "heat_in";
        out = out || info.words.name == "heat out";
        normal = normal || info.words.id == "normal_x";
    }
    check(in && out, "the new varying is not among the quantities shown");
    check(!normal, "a varying that no stage uses is shown");
}

void check_compared(const Frame& frame, const Frame& warmer) {
    check(!next_divergence(frame, frame, cursor_begin), "a run differs from itself");
    const std::optional<Divergence> first = next_divergence(frame, warmer, cursor_begin);
    check(first && first->cursor == cursor_begin, "a warmer vertex is not found");
    if (!first) return;
    const std::string said = "its heat is (0, 3) in A, (1, 4) in B.";
    const bool is_said = first->text.find(said) != std::string::npos;
    check(is_said, first->text.c_str());
}

} // namespace

int main() {
    const Scene scene = one_triangle();
    Settings settings = default_settings(scene);
    settings.stage = Stage::depth;
    const Frame frame = prepare_frame(scene, settings, hot_stages<0>);
    check_interpolated(frame);
    check_shown(frame);
    check_compared(frame, prepare_frame(scene, settings, hot_stages<1>));
    if (faults > 0) std::printf("%d faults\n", faults);
    return faults > 0 ? 1 : 0;
}
