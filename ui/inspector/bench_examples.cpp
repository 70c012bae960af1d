#include <algorithm>
#include <string>

#include "base/element_names.h"
#include "session/bench.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// One coordinate of a vertex, with its label in the box: "x0 10".
bool edit_coordinate(Ui& ui, const char* axis, int vertex, float width, int& value) {
    const std::string label = axis + std::to_string(vertex);
    ImGui::SetNextItemWidth(width);
    constexpr DragRange<int> range{0.1f, -1000, 1000};
    bool is_changed = drag_number(("##" + label).c_str(), value, range, label);
    const char* const what = *axis == 'x' ? "Column x of " : "Row y of ";
    const std::string name = "bench.vertex." + std::to_string(vertex) + "." + axis;
    register_widget(ui, name,
                    what + vertex_name(vertex) +
                        ". Drag, double click to type, or drag the vertex itself in the picture.");
    if (const int more = take_arrows(ui, name).more(); more != 0) {
        value = std::clamp(value + more, range.smallest, range.largest);
        is_changed = true;
    }
    return is_changed;
}

/// All six on one line; if that is too narrow, a line for x and one for y.
void edit_vertices(Ui& ui) {
    const std::array<Vertex, 3> vertices = corners_of(*ui.session.scene, 0);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float room = ImGui::GetContentRegionAvail().x;
    const float needed = text_width("x0 −10") + 10.0f * ui.options.text_scale;
    const bool is_one_line = room >= 6.0f * needed + 5.0f * gap;
    const int columns = is_one_line ? 6 : 3;
    const float width = std::max(
        (room - static_cast<float>(columns - 1) * gap) / static_cast<float>(columns), 1.0f);
    for (int i = 0; i < 6; ++i) {
        const int v = is_one_line ? i / 2 : i % 3;
        const int axis = is_one_line ? i % 2 : i / 3;
        glm::ivec2 place(vertices[v].position.x, vertices[v].position.y);
        if (i % columns > 0) ImGui::SameLine(0.0f, gap);
        if (edit_coordinate(ui, axis == 0 ? "x" : "y", v, width, place[axis])) {
            move_bench_vertex(ui.session, 0, v, place);
        }
    }
}

/// The example whose vertices the triangle has now, or null.
const BenchExample* current_example(const Scene& scene) {
    for (const BenchExample& example : scene.examples) {
        bool same = true;
        for (int v = 0; v < 3; ++v) {
            same = same && example.positions[v] == scene.corner(0, v).position;
        }
        if (same) return &example;
    }
    return nullptr;
}

} // namespace

void draw_bench_examples(Ui& ui) {
    const std::shared_ptr<const Scene> scene = ui.session.scene;
    if (!is_bench(*scene) || scene->triangle_count() == 0) return;
    const BenchExample* current = current_example(*scene);
    ImGui::SetNextItemWidth(-1.0f);
    const bool open =
        ImGui::BeginCombo("##example", current != nullptr ? current->name.c_str() : "your own");
    register_widget(ui, "bench.examples", "Triangles worth a look.");
    if (open) {
        for (const BenchExample& example : scene->examples) {
            if (list_entry(ui, "bench.example." + example.name, example.name, &example == current,
                           example.about)) {
                show_bench_example(ui.session, example);
            }
        }
        ImGui::EndCombo();
    }
    if (current != nullptr) wrapped_text_in(palette(ui.options.theme).dim, current->about);
    edit_vertices(ui);
}

} // namespace rasterwalk
