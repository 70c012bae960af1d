#include <string>

#include "session/bench.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

void edit_vertices(Ui& ui) {
    const std::array<Vertex, 3> vertices = ui.session.scene->triangles[0].vertices;
    const float width =
        (ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x) / 3.0f;
    for (int v = 0; v < 3; ++v) {
        int place[2] = {static_cast<int>(vertices[v].position.x),
                        static_cast<int>(vertices[v].position.y)};
        ImGui::PushID(v);
        ImGui::SetNextItemWidth(width);
        if (ImGui::DragInt2("##vertex", place, 0.1f, -1000, 1000, "%d",
                            ImGuiSliderFlags_AlwaysClamp)) {
            move_bench_vertex(ui.session, 0, v, {place[0], place[1]});
        }
        name_widget(ui, "bench.vertex." + std::to_string(v),
                    "Column and row of a vertex. Drag, double click to type, or drag the vertex "
                    "itself in the picture.");
        ImGui::PopID();
        if (v < 2) ImGui::SameLine();
    }
}

/// The example whose vertices the triangle has now, or null.
const BenchExample* current_example(const Scene& scene) {
    for (const BenchExample& example : scene.examples) {
        bool same = true;
        for (int v = 0; v < 3; ++v) {
            same = same && example.positions[v] == scene.triangles[0].vertices[v].position;
        }
        if (same) return &example;
    }
    return nullptr;
}

} // namespace

void draw_bench_examples(Ui& ui) {
    const std::shared_ptr<const Scene> scene = ui.session.scene;
    if (!is_bench(*scene) || scene->triangles.empty()) return;
    const BenchExample* current = current_example(*scene);
    ImGui::SetNextItemWidth(-1.0f);
    const bool open =
        ImGui::BeginCombo("##example", current != nullptr ? current->name.c_str() : "your own");
    name_widget(ui, "bench.examples", "Triangles that are worth a look.");
    if (open) {
        for (const BenchExample& example : scene->examples) {
            if (ImGui::Selectable(example.name.c_str(), &example == current)) {
                show_bench_example(ui.session, example);
            }
            name_widget(ui, "bench.example." + example.name, example.about);
        }
        ImGui::EndCombo();
    }
    if (current != nullptr) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.options.theme).dim);
        wrapped_text(current->about);
        ImGui::PopStyleColor();
    }
    edit_vertices(ui);
}

} // namespace rasterwalk
