#include "explain/vertex_spaces.h"

#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "explain/formula.h"
#include "stages/matrices.h"
#include "stages/orthographic.h"

namespace rasterwalk {

namespace {

constexpr std::array<const char*, 4> homogeneous_names{"x", "y", "z", "w"};

std::string in_text(double value) {
    return shown({static_cast<float>(value)});
}

/// The number as a factor: negative numbers are in parentheses, unless they come first.
std::string factor_text(double value, bool begins) {
    const std::string text = in_text(value);
    return value < 0.0 && !begins ? "(" + text + ")" : text;
}

/// One coordinate of a product, with numbers.
std::string product_text(const SpacePlace& to, const glm::dvec4& from, MatrixOrder order, int i) {
    std::string sum;
    for (int k = 0; k < 4; ++k) {
        const double of_matrix = (*to.matrix)[k][i];
        if (of_matrix == 0.0) continue;
        const bool is_row = order == MatrixOrder::row_vectors;
        const bool begins = sum.empty();
        if (!begins) sum += " + ";
        sum += factor_text(is_row ? from[k] : of_matrix, begins) + " · " +
               factor_text(is_row ? of_matrix : from[k], false);
    }
    return std::string(homogeneous_names[static_cast<std::size_t>(i)]) + " = " +
           (sum.empty() ? "0" : sum + " = " + in_text(to.place[i]));
}

/// Goes on to the next space by a matrix.
void add_product(SpacesOfVertex& spaces, SpacePlace place, const glm::dmat4& matrix) {
    const glm::dvec4 from = spaces.places.back().place;
    place.matrix = matrix;
    place.place = matrix * from;
    for (int i = 0; i < 4; ++i)
        place.formulas[static_cast<std::size_t>(i)] = product_text(place, from, spaces.order, i);
    spaces.places.push_back(std::move(place));
}

void add_division(SpacesOfVertex& spaces) {
    const glm::dvec4 clip = spaces.places.back().place;
    SpacePlace ndc{"ndc",
                   "Divided by w. The view volume is now a box, x and y from −1 to 1, z from 0 at "
                   "the near plane to 1 at the far one.",
                   "",
                   std::nullopt,
                   clip / clip.w,
                   {}};
    for (int i = 0; i < 4; ++i) {
        ndc.formulas[static_cast<std::size_t>(i)] =
            std::string(homogeneous_names[static_cast<std::size_t>(i)]) + " = " + in_text(clip[i]) +
            " / " + factor_text(clip.w, false) + " = " + in_text(ndc.place[i]);
    }
    spaces.places.push_back(std::move(ndc));
}

/// The rules that the vertex is drawn by, with the mistakes that a matrix can contain.
struct MatrixRules {
    VertexRules rules;
    glm::mat3 rotation;
};

MatrixRules matrix_rules(const Frame& frame) {
    const Settings& settings = frame.settings;
    MatrixRules drawn{vertex_rules(settings, frame.scene->space), camera_rotation(settings.camera)};
    if (settings.rotation == Rotation::transposed) drawn.rotation = glm::transpose(drawn.rotation);
    return drawn;
}

/// Tp, with the mistake that it can contain.
glm::dmat4 drawn_projection(const Frame& frame, const VertexRules& rules) {
    glm::dmat4 projection = projection_matrix(rules);
    if (frame.settings.image_axes == ImageAxes::mirrored)
        projection = glm::dmat4(glm::dmat3{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}) * projection;
    if (frame.settings.image_axes == ImageAxes::exchanged) {
        // Pixels are swapped, and the picture need not be square.
        const double aspect = static_cast<double>(rules.viewport.width) / rules.viewport.height;
        projection =
            glm::dmat4(glm::dmat3{{0, aspect, 0}, {1 / aspect, 0, 0}, {0, 0, 1}}) * projection;
    }
    return projection;
}

/// Ts, with the mistake that it can contain.
glm::dmat4 drawn_viewport(const Frame& frame, const VertexRules& rules) {
    glm::dmat4 viewport = viewport_matrix(rules);
    const glm::dvec2 middle(frame.stages.viewport_middle(rules));
    viewport[3] = glm::dvec4(middle, viewport[3].z, viewport[3].w);
    return viewport;
}

/// What Tp does to x and y if view_box says what fills the picture.
std::string box_text(const Frame& frame, const VertexRules& rules) {
    if (!rules.projection.box) return {};
    const ViewBox& box = *rules.projection.box;
    const float mix = rules.projection.mix;
    const std::string factor = mix == 0.0f ? "2n" : mix == 1.0f ? "2" : "2w(n)";
    return fmt::format(
        " With view_box, x = {0} / (r − l) · x − (r + l) / (r − l) · w and, as y points down, "
        "y = {0} / (t − b) · y + (t + b) / (t − b) · w, where l = {1}, r = {2}, b = {3}, t = "
        "{4}{5}.{6}",
        factor, in_text(box.left), in_text(box.right), in_text(box.bottom), in_text(box.top),
        mix == 0.0f   ? fmt::format(" and n = near = {}", in_text(rules.near))
        : mix == 1.0f ? ""
                      : fmt::format(" and w(n) = {} is w at the near plane",
                                    in_text(clip_w(rules.near, mix))),
        frame.settings.image_axes == ImageAxes::mirrored
            ? " Both have the opposite sign here, by mistake."
        : frame.settings.image_axes == ImageAxes::exchanged
            ? " Here, by mistake, their pixels x' and y' are swapped."
            : "");
}

glm::dvec3 unit(const glm::dvec3& direction) {
    const double length = glm::length(direction);
    return length > 0.0 ? direction / length : direction;
}

NormalPlace normal_of(const std::array<glm::dvec3, triangle_corners>& object,
                      const glm::dmat4& model) {
    NormalPlace normal;
    // The corners of a mirrored object are in the order they go round in the world.
    const double side = is_mirrored(model) ? -1.0 : 1.0;
    normal.object = unit(side * glm::cross(object[2] - object[0], object[1] - object[0]));
    normal.world = unit(normal_matrix(model) * normal.object);
    normal.as_point = unit(transform_direction(model, normal.object));
    return normal;
}

/// The model of the part that a triangle belongs to; null if it belongs to none.
const Model* model_of(const Scene& scene, int triangle) {
    const int part = part_of(scene, triangle);
    return part >= 0 ? &scene.parts[static_cast<std::size_t>(part)].model : nullptr;
}

} // namespace

std::array<glm::dvec3, triangle_corners> object_corners(const Scene& scene, int triangle) {
    const Model* const model = model_of(scene, triangle);
    std::array<glm::dvec3, triangle_corners> corners;
    for (int i = 0; i < triangle_corners; ++i)
        corners[static_cast<std::size_t>(i)] = glm::dvec3(scene.corner(triangle, i).position);
    if (model == nullptr || model->positions.empty()) return corners;
    const auto part = static_cast<std::size_t>(part_of(scene, triangle));
    const int in_part = scene_triangle(scene, triangle) - scene.parts[part].first_triangle;
    for (int i = 0; i < triangle_corners; ++i)
        corners[static_cast<std::size_t>(i)] =
            glm::dvec3(model->positions[static_cast<std::size_t>(triangle_corners * in_part + i)]);
    if (scene.sources.empty()) return corners;
    const std::array<glm::dvec3, triangle_corners> whole = corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 weights(scene.sources[static_cast<std::size_t>(triangle)].weights[i]);
        corners[i] = weights.x * whole[0] + weights.y * whole[1] + weights.z * whole[2];
    }
    return corners;
}

SpaceMatrices space_matrices(const Frame& frame, int triangle) {
    const MatrixRules drawn = matrix_rules(frame);
    const Model* const model = model_of(*frame.scene, triangle);
    return {model != nullptr ? model_matrix(model->steps) : glm::dmat4(1.0),
            frame.stages.view_matrix(glm::dvec3(drawn.rules.camera.position),
                                     glm::dmat3(drawn.rotation)),
            drawn_projection(frame, drawn.rules), drawn_viewport(frame, drawn.rules)};
}

SpacesOfVertex spaces_of_vertex(const Frame& frame, int triangle, int vertex, MatrixOrder order) {
    const Scene& scene = *frame.scene;
    SpacesOfVertex spaces;
    spaces.triangle = triangle;
    spaces.vertex = vertex;
    spaces.order = order;
    if (scene.space == SceneSpace::pixels) {
        const glm::dvec4 given(glm::dvec3(scene.corner(triangle, vertex).position), 1.0);
        spaces.places.push_back(
            {"window", "The scene gives its vertices in pixels.", "", std::nullopt, given, {}});
        return spaces;
    }
    spaces.chain = order == MatrixOrder::column_vectors
                       ? "window = Ts · (Tp · Tv · Tm · p) / w, read from right to left"
                       : "window = (p · Tm · Tv · Tp) / w · Ts, read from left to right";
    const SpaceMatrices matrices = space_matrices(frame, triangle);
    const std::array<glm::dvec3, triangle_corners> object = object_corners(scene, triangle);
    spaces.normal = normal_of(object, matrices.to_world);
    spaces.places.push_back({"object",
                             "Where the scene file places it, before its model transformation.",
                             "",
                             std::nullopt,
                             glm::dvec4(object[static_cast<std::size_t>(vertex)], 1.0),
                             {}});
    add_product(
        spaces,
        {"world", "Where the object is in the world: moved, turned and scaled.", "Tm", {}, {}, {}},
        matrices.to_world);
    add_product(
        spaces,
        {"camera", "The camera is at the origin: x right, y down, z forward.", "Tv", {}, {}, {}},
        matrices.to_camera);
    add_product(spaces,
                {"clip",
                 "Before the division. Inside the view, −w ≤ x ≤ w, −w ≤ y ≤ w and 0 ≤ z ≤ w. The "
                 "lab and the Clip tab count in pixels instead: x' = W/2 · x, y' = H/2 · y." +
                     box_text(frame, matrix_rules(frame).rules),
                 "Tp",
                 {},
                 {},
                 {}},
                matrices.to_clip);
    if (!(spaces.places.back().place.w > 0.0)) return spaces;
    add_division(spaces);
    add_product(
        spaces,
        {"window", "Pixels from the left and from the top, before rounding.", "Ts", {}, {}, {}},
        matrices.to_window);
    return spaces;
}

double entry(const glm::dmat4& matrix, MatrixOrder order, int row, int column) {
    return order == MatrixOrder::column_vectors ? matrix[column][row] : matrix[row][column];
}

} // namespace rasterwalk
