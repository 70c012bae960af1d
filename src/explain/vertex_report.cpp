#include "explain/vertex_report.h"

#include <fmt/format.h>

#include "base/element_names.h"
#include "explain/light_formulas.h"
#include "explain/projection_formulas.h"
#include "explain/vertex_maker.h"

namespace rasterwalk {

namespace {

std::string given_text(const VertexMaker& made) {
    return fmt::format("given by the scene: {} of {}, {}", vertex_name(made.report.vertex),
                       triangle_name(made.report.triangle),
                       part_name(*made.frame.scene, made.report.triangle));
}

void add_given(VertexMaker& made, const std::string& space, const std::array<const char*, 3>& names,
               const glm::vec3& value, const std::string& help) {
    for (int i = 0; i < 3; ++i) {
        made.add({space + "." + names[i],
                  names[i],
                  help,
                  "v",
                  {{"v", {value[i]}, from_words(given_text(made))}},
                  {value[i]}});
    }
}

std::string rotation_id(int row, int column) {
    return fmt::format("R.{}.{}", row, column);
}
std::string rotation_symbol(int row, int column) {
    static constexpr const char* digits[] = {"₀", "₁", "₂"};
    return fmt::format("R{}{}", digits[row], digits[column]);
}

/// One coordinate of a point that is turned: d R, or by mistake R d.
/// @param symbol of the point, "d"
/// @param space  where it is
void set_turned(const VertexMaker& made, const std::string& symbol, const std::string& space, int i,
                Formula& formula) {
    const bool is_row_vector = made.frame.settings.rotation == Rotation::row_vector;
    for (int k = 0; k < 3; ++k) {
        const std::string axis = axis_names[k], d = symbol + "." + axis;
        const int row = is_row_vector ? k : i, column = is_row_vector ? i : k;
        const std::string r = rotation_symbol(row, column);
        formula.expression += (k == 0 ? "" : " + ") + d + " · " + r;
        formula.inputs.push_back(
            {d, {made.report.shaded.in(space)[k]}, from_formula(space + "." + axis)});
        formula.inputs.push_back(
            {r, {made.rotation[column][row]}, from_formula(rotation_id(row, column))});
    }
}

/// A coordinate of a space and the camera's, with a sign between them.
/// @param space where the point is before the move
void set_moved(const VertexMaker& made, const std::string& symbol, const std::string& space,
               const char* sign, int i, Formula& formula) {
    const std::string axis = axis_names[i], point = symbol + "." + axis, camera = "C." + axis;
    formula.expression = point + " " + sign + " " + camera;
    formula.inputs = {
        {point, {made.report.shaded.in(space)[i]}, from_formula(space + "." + axis)},
        {camera, {made.frame.settings.camera.position[i]}, from_setting("camera.position")}};
}

void add_camera_space(VertexMaker& made) {
    const ShadedVertex& shaded = made.report.shaded;
    for (int i = 0; i < 3; ++i) {
        const std::string axis = axis_names[i];
        Formula formula{"minus_camera." + axis,
                        axis,
                        "The world moved so that the camera is at the origin: P − C.",
                        "",
                        {},
                        {shaded.in("minus_camera")[i]}};
        if (made.is_bench()) {
            formula.help = "The bench gives its vertices in pixels, so there is no camera.";
            formula.expression = "P." + axis;
            formula.inputs = {
                {"P." + axis, {shaded.in("world")[i]}, from_formula("world." + axis)}};
            made.add(formula);
            continue;
        }
        switch (camera_move_rule(made.frame.settings)) {
        case CameraMove::subtracted:
            set_moved(made, "P", "world", "−", i, formula);
            break;
        case CameraMove::added:
            formula.help = "The world moved the wrong way: P + C, by mistake.";
            set_moved(made, "P", "world", "+", i, formula);
            break;
        case CameraMove::rotated_first:
            formula.help = "By mistake, turned before it is moved.";
            set_turned(made, "P", "world", i, formula);
            break;
        }
        made.add(formula);
    }
}

/// R of the camera for row vectors: row and column from 0, each a product of sines and cosines.
void add_rotation(VertexMaker& made) {
    static constexpr const char* expressions[3][3] = {
        {"cos(yaw)", "sin(pitch) · sin(yaw)", "cos(pitch) · sin(yaw)"},
        {"0", "cos(pitch)", "−sin(pitch)"},
        {"−sin(yaw)", "sin(pitch) · cos(yaw)", "cos(pitch) · cos(yaw)"}};
    static constexpr const char* axes[] = {"right", "down", "forward"};
    const Camera& camera = made.frame.settings.camera;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            if (camera.aim == CameraAim::look_at) {
                const std::string axis = fmt::format("{}.{}", axes[column], axis_names[row]);
                made.add({rotation_id(row, column),
                          rotation_symbol(row, column),
                          "An entry of R, the camera's rotation, by row and column; the columns of "
                          "R are the camera's right, down and forward axes in the world.",
                          axis,
                          {{axis,
                            {made.rotation[column][row]},
                            from_words("forward points to the target, right is forward × up, and "
                                       "down is forward × right")}},
                          {made.rotation[column][row]}});
                continue;
            }
            made.add({rotation_id(row, column),
                      rotation_symbol(row, column),
                      "An entry of R, the camera's rotation, by row and column; the columns of R "
                      "are the camera's right, down and forward axes in the world.",
                      expressions[row][column],
                      {{"yaw", {camera.yaw}, from_setting("camera.yaw")},
                       {"pitch", {camera.pitch}, from_setting("camera.pitch")}},
                      {made.rotation[column][row]}});
        }
    }
}

constexpr const char* transposed_help =
    "Turned by R d, with d = P − C: the same turn as d R, but the other way round";

void add_rotated(VertexMaker& made) {
    const ShadedVertex& shaded = made.report.shaded;
    for (int i = 0; i < 3; ++i) {
        const std::string axis = axis_names[i];
        Formula formula{"rotated." + axis,
                        axis,
                        "Turned so that the camera looks along +z: d R, with d = P − C.",
                        "",
                        {},
                        {shaded.in("rotated")[i]}};
        if (i == 2) formula.help += " How far in front of the camera.";
        if (made.is_bench()) {
            formula.help = "The bench gives its vertices in pixels, so there is no camera.";
            formula.expression = "P." + axis;
            formula.inputs = {
                {"P." + axis, {shaded.in("world")[i]}, from_formula("world." + axis)}};
            made.add(formula);
            continue;
        }
        if (made.is_by_matrices()) {
            formula.expression = axis;
            formula.inputs = {by_matrix(axis, shaded.in("rotated")[i], "Tv · P")};
            made.add(formula);
            continue;
        }
        const CameraMove move = camera_move_rule(made.frame.settings);
        const std::string distance_help = i == 2 ? " How far in front of the camera." : "";
        if (move == CameraMove::rotated_first) {
            formula.help = "By mistake, moved after it was turned, by a C that was not turned." +
                           distance_help;
            set_moved(made, "d", "minus_camera", "−", i, formula);
        } else {
            const bool is_row_vector = made.frame.settings.rotation == Rotation::row_vector;
            if (!is_row_vector) formula.help.replace(0, formula.help.find('.'), transposed_help);
            if (move == CameraMove::added)
                formula.help.replace(formula.help.find("P − C"), std::string("P − C").size(),
                                     "P + C");
            set_turned(made, "d", "minus_camera", i, formula);
        }
        made.add(formula);
    }
}

void add_inverse_z(VertexMaker& made) {
    const ShadedVertex& shaded = made.report.shaded;
    Formula formula{"zinv",
                    "1/z",
                    made.has_own_depth() ? "The weight used for interpolation."
                                         : "What the depth buffer holds; larger is nearer.",
                    "1 / z",
                    {{"z", {shaded.in("rotated").z}, from_formula("rotated.z")}},
                    {shaded.pixel.inv_w}};
    if (!made.is_bench() && divided_by_rule(made.frame.settings) == DividedBy::distance) {
        formula.help += " By mistake it is 1 over the distance from the camera.";
        formula.expression = "1 / sqrt(x² + y² + z²)";
        for (const char* const axis : {"x", "y"}) {
            const int i = *axis == 'x' ? 0 : 1;
            formula.inputs.push_back(
                {axis, {shaded.in("rotated")[i]}, from_formula(std::string("rotated.") + axis)});
        }
    }
    made.add(formula);
}

/// The normal as the light has it, if it was transformed to camera space as a point.
void add_moved_normal(VertexMaker& made, const glm::vec3& normal) {
    for (int i = 0; i < 3; ++i) {
        const std::string axis = axis_names[i];
        made.add(
            {light_normal_id(made.frame.settings, i),
             axis,
             "Taken to camera space with w = 1 and so moved as if it were a position, then made "
             "unit length again. A direction has w = 0.",
             axis,
             {{axis, {normal[i]}, from_words("(n − C) / |n − C|")}},
             {normal[i]}});
    }
}

void add_light(VertexMaker& made, const glm::vec3& normal) {
    VertexReport& report = made.report;
    LitPoint point;
    point.prefix = "light.";
    point.position.value = made.vertex.position;
    point.normal.value = normal;
    point.reflectance.value = made.vertex.reflectance;
    point.shine = made.vertex.shine;
    point.light = report.light;
    for (std::size_t i = 0; i < 3; ++i) {
        point.position.sources[i] = from_formula(std::string("world.") + axis_names[i]);
        point.normal.sources[i] =
            from_formula(light_normal_id(made.frame.settings, static_cast<int>(i)));
        point.reflectance.sources[i] = from_formula(std::string("reflectance.") + channel_names[i]);
    }
    append_side_formulas(point, SourcedVector(point.normal), made.frame, report.formulas);
    append_light_formulas(point, made.frame, report.formulas);
}

} // namespace

VertexReport vertex_report(const Frame& frame, int triangle, int vertex) {
    const Vertex& given = frame.scene->corner(triangle, vertex);
    const glm::mat3 rotation = camera_rotation(frame.settings.camera);
    const VertexRules rules = vertex_rules(frame);
    VertexReport report;
    report.triangle = triangle;
    report.vertex = vertex;
    report.shaded = shade_vertex(given, rotation, rules, frame.stages);
    report.transposed = shade_vertex(given, glm::transpose(rotation), rules, frame.stages);
    for (std::size_t i = 0; i < report.by_rounding.size(); ++i) {
        VertexRules other = rules;
        other.rounding = static_cast<VertexRounding>(i);
        report.by_rounding[i] = shade_vertex(given, rotation, other, frame.stages);
    }
    const glm::vec3 normal = frame.stages.light_normal(given.normal, rules.camera);
    report.light = light_at_vertex(given, rules, frame.stages);

    VertexMaker made{frame, given, rotation, report};
    add_given(made, "world", axis_names, report.shaded.in("world"),
              "The vertex, where the scene places it.");
    add_camera_space(made);
    if (!made.is_bench()) add_rotation(made);
    add_rotated(made);
    if (made.is_mixed()) add_mixed_w(made);
    if (made.is_mixed() || made.is_by_matrices()) {
        add_clip_place(made, 0);
        add_clip_place(made, 1);
    }
    if (report.shaded.has_pixel) {
        if (!made.is_mixed()) add_inverse_z(made);
        add_projected(made, 0);
        add_projected(made, 1);
    }
    if (made.has_own_depth()) add_clip_depth(made);
    add_given(made, "normal", axis_names, given.normal,
              "Perpendicular to the surface, of unit "
              "length.");
    if (frame.settings.normal_w == NormalW::one) add_moved_normal(made, normal);
    add_given(made, "reflectance", channel_names, given.reflectance,
              "The fraction of the light that the surface reflects.");
    add_light(made, normal);
    return report;
}

Number vertex_number(const ShadedVertex& vertex, std::string_view id) {
    const auto part = [&](const glm::vec3& vector) {
        return Number{id.back() == 'x' ? vector.x : id.back() == 'y' ? vector.y : vector.z};
    };
    if (id.starts_with("world.")) return part(vertex.in("world"));
    if (id.starts_with("minus_camera.")) return part(vertex.in("minus_camera"));
    if (id.starts_with("rotated.")) return part(vertex.in("rotated"));
    if (id == "zinv") return {vertex.pixel.inv_w};
    if (id == "depth") return {vertex.pixel.depth};
    if (id == "clip.x") return {vertex.position_clip.x};
    if (id == "clip.y") return {vertex.position_clip.y};
    if (id == "clip.z") return {vertex.position_clip.z};
    if (id == "clip.w") return {vertex.position_clip.w};
    if (id == "projected.x") return {vertex.in("projected").x};
    if (id == "projected.y") return {vertex.in("projected").y};
    if (id == "pixel.column") return {static_cast<float>(vertex.pixel.column), true};
    if (id == "pixel.row") return {static_cast<float>(vertex.pixel.row), true};
    return {};
}

std::string light_normal_id(const Settings& settings, int axis) {
    const char* const normal = settings.normal_w == NormalW::zero ? "normal." : "light_normal.";
    return std::string(normal) + axis_names[axis];
}

bool depends_on_rotation(std::string_view id) {
    return id.starts_with("rotated.") || id.starts_with("clip.") || id == "zinv" || id == "depth" ||
           id.starts_with("projected.") || id.starts_with("pixel.");
}

std::string how_made_whole(const Settings& settings, SceneSpace space) {
    constexpr auto whole = [](VertexRounding rounding) {
        switch (rounding) {
        case VertexRounding::floor:
            return "rounded down to a whole number";
        case VertexRounding::round:
            return "rounded to the nearest whole number";
        case VertexRounding::truncate:
        case VertexRounding::truncate_sum:
            break;
        }
        return "cut toward 0 to a whole number";
    };
    std::string text = whole(settings.vertex_rounding);
    const std::string moved = "shifted by half the picture's size";
    if (space == SceneSpace::world && settings.image_axes == ImageAxes::uncentred) {
        text += " and, by mistake, not shifted by half the picture's size";
    } else if (space == SceneSpace::world) {
        const bool is_moved_first = settings.vertex_rounding == VertexRounding::truncate_sum;
        text = is_moved_first ? moved + " and " + text : text + " and " + moved;
    }
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
    text += ".";
    if (settings.outside_picture == OutsidePicture::clamped) {
        text += " If it is outside the picture, it is moved inside.";
    }
    return text;
}

std::string_view rounding_function(VertexRounding rounding) {
    switch (rounding) {
    case VertexRounding::truncate:
    case VertexRounding::truncate_sum:
        return "int";
    case VertexRounding::floor:
        return "floor";
    case VertexRounding::round:
        return "round";
    }
    return {};
}

} // namespace rasterwalk
