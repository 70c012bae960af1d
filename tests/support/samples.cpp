#include "support/samples.h"

#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"

namespace rasterwalk::test {

Scene lab_room() {
    return read_scene(lessons_folder() + "/scenes/lab-room.toml");
}

Vertex pixel_vertex(float column, float row, float z) {
    Vertex vertex;
    vertex.position = {column, row, z};
    vertex.normal = {0.0f, 0.0f, -1.0f};
    return vertex;
}

Scene pixel_scene(const std::vector<std::array<glm::vec3, 3>>& triangles, Viewport viewport) {
    Scene scene;
    scene.space = SceneSpace::pixels;
    scene.viewport = viewport;
    // A lamp in front of the picture, strong enough to give every pixel a different colour.
    scene.light = {{8.0f, 6.0f, -5.0f}, {900.0f, 700.0f, 500.0f}, {0.1f, 0.2f, 0.3f}};
    for (const auto& corners : triangles) {
        const int number = scene.triangle_count();
        std::array<Vertex, triangle_corners> vertices;
        for (std::size_t v = 0; v < 3; ++v) {
            vertices[v] = pixel_vertex(corners[v].x, corners[v].y, corners[v].z);
            vertices[v].reflectance = {0.2f + 0.1f * static_cast<float>(number % 7),
                                       0.9f - 0.1f * static_cast<float>(number % 5),
                                       0.3f + 0.2f * static_cast<float>(v)};
        }
        scene.parts.push_back({"part " + std::to_string(number), number, 1});
        scene.mesh.add_triangle_of(vertices);
    }
    return scene;
}

Scene small_scene() {
    return pixel_scene({{{{2, 1, 1}, {13, 4, 3}, {5, 9, 2}}},
                        {{{-4, 3, 2}, {8, -3, 1}, {19, 7, 2}}},
                        {{{1, 1, 1}, {2, 2, -1}, {3, 1, 1}}},
                        {{{0, 2, 1}, {3, 1, 2}, {6, 2, 4}}},
                        {{{7, 7, 1}, {7, 7, 1}, {7, 7, 1}}},
                        {{{-9, -9, 1}, {-3, -5, 1}, {-7, -2, 1}}},
                        {{{2, 8, 1}, {9, 8, 4}, {14, 8, 1}}},
                        {{{10, 12, 1}, {4, 2, 2}, {12, -2, 4}}},
                        {{{6, 14, 1}, {9, 15, 1}, {2, 19, 1}}}},
                       {16, 11});
}

std::array<glm::vec3, 3> random_triangle(Random& random, Viewport viewport) {
    std::array<glm::vec3, 3> corners;
    for (glm::vec3& corner : corners) {
        corner = {random.integer(-viewport.width / 2, 3 * viewport.width / 2),
                  random.integer(-viewport.height / 2, 3 * viewport.height / 2),
                  random.real(0.5, 8.0)};
    }
    switch (random.integer(0, 15)) {
    case 0:
        corners[1] = corners[0];
        break;
    case 1:
        corners[2].y = corners[1].y = corners[0].y;
        break;
    case 2:
        corners[2].x = corners[1].x = corners[0].x;
        break;
    default:
        break;
    }
    return corners;
}

const std::vector<Variant>& rule_variants() {
    static const std::vector<Variant> variants = [] {
        std::vector<Variant> all{{"handout", [](Settings&) {}}};
        for (const Setting& setting : setting_table()) {
            const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
            // A part is tried with its whole.
            if (choice == nullptr || setting.name == "stage" || !setting.ties.part_of.empty())
                continue;
            // The scenes of these tests have no textures; tests/pipeline/test_textures.cpp has.
            if (!is_of_use(setting, Scene{})) continue;
            // The engine is not a rule of the steps: tests/engines compares it with them.
            if (setting.ties.is_of_engine) continue;
            // Six more pictures each time: tests/pipeline/test_shadows.cpp tries them.
            if (setting.group == "Shadow") continue;
            // By its old name, which the goldens have: the words must set the new one.
            const std::string_view name = setting.name == "depth_order" ? "shading" : setting.name;
            for (const std::string_view word : choice->words.subspan(1)) {
                const std::string assignment = std::string(name).append("=").append(word);
                all.push_back(
                    {assignment, [assignment](Settings& s) { set_from_text(s, assignment); }});
            }
        }
        all.push_back({"depth_clear=0.3", [](Settings& s) { s.depth_clear = 0.3f; }});
        all.push_back({"depth_epsilon=0.02", [](Settings& s) { s.depth_epsilon = 0.02f; }});
        all.push_back({"everything changed", [](Settings& s) {
                           set_rounding(s, Rounding::floor);
                           s.line_walk = LineWalk::exact;
                           s.edge_samples = EdgeSamples::rows;
                           s.depth_test = DepthTest::linear_z;
                           s.interpolation = Interpolation::affine;
                       }});
        all.push_back(
            {"many mistakes", [](Settings& s) {
                 for (const char* mistake :
                      {"edge_samples=shifted", "row_start=window", "empty_rows=overflow",
                       "row_search=all_rows", "spans=last_dropped", "bounds=excludes_zero",
                       "depth_test=reversed", "depth_clear=0.6", "depth_index=transposed",
                       "shading=before_depth_test", "interpolation=zinv_twice",
                       "image_axes=mirrored", "rotation=transposed", "behind_camera=drawn",
                       "outside_picture=clamped", "light.direction=not_normalized",
                       "light.falloff=cubed", "light.sum=reflectance_plus", "colour_over_one=wrap"})
                     set_from_text(s, mistake);
             }});
        return all;
    }();
    return variants;
}

const std::vector<Pose>& room_poses() {
    static const std::vector<Pose> poses{
        {"the handout's", {{0.0f, 0.0f, -3.001f}, 0.0f, 0.0f, 500.0f}, {500, 500}},
        {"turned", {{0.5f, -0.3f, -3.4f}, -0.2f, 0.1f, 300.0f}, {280, 210}},
        {"from below", {{-0.6f, 0.7f, -2.9f}, 0.25f, 0.3f, 260.0f}, {241, 183}},
        {"close, much of it off the picture",
         {{0.1f, 0.2f, -1.6f}, 0.05f, -0.1f, 200.0f},
         {230, 215}},
        {"from far away through a long lens",
         {{3.0f, -2.0f, -16.0f}, -0.19f, -0.12f, 1900.0f},
         {263, 263}},
    };
    return poses;
}

} // namespace rasterwalk::test
