#include "explain/vertex_report.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/element_names.h"
#include "explain/light_formulas.h"
#include "explain/projection_formulas.h"
#include "explain/vertex_formula_builder.h"

namespace rasterwalk {

namespace {

std::string given_text(const VertexFormulaBuilder& made) {
    return fmt::format("given by the scene: {} of {}, {}", vertex_name(made.report.vertex),
                       triangle_name(made.report.triangle),
                       part_words(*made.frame.scene, made.report.triangle));
}

void add_given(VertexFormulaBuilder& made, const std::string& space,
               const std::array<const char*, 3>& names, const glm::vec3& value,
               const std::string& help) {
    for (int i = 0; i < 3; ++i) {
        const std::string name = names[static_cast<std::size_t>(i)];
        made.write.add(space + "." + name, name, help, "v",
                       {{"v", {value[i]}, from_words(given_text(made))}}, {value[i]});
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
void set_turned(const VertexFormulaBuilder& made, const std::string& symbol,
                const std::string& space, int i, Formula& formula) {
    const bool is_row_vector = made.frame.settings.rotation == Rotation::row_vector;
    formula.expression.clear();
    for (int k = 0; k < 3; ++k) {
        const std::string d = symbol + "." + axis_name(k);
        const int row = is_row_vector ? k : i, column = is_row_vector ? i : k;
        const std::string r = rotation_symbol(row, column);
        formula.expression += (k == 0 ? "" : " + ") + d + " · " + r;
        formula.inputs.push_back(made.write.part(d, space, k));
        formula.inputs.push_back(made.write.input(r, rotation_id(row, column)));
    }
}

/// A coordinate of a space and the camera's, with a sign between them.
/// @param space where the point is before the move
void set_moved(const VertexFormulaBuilder& made, const std::string& symbol,
               const std::string& space, const char* sign, int i, Formula& formula) {
    const std::string point = symbol + "." + axis_name(i), camera = "C." + axis_name(i);
    formula.expression = point + " " + sign + " " + camera;
    formula.inputs = {
        made.write.part(point, space, i),
        {camera, {made.frame.settings.camera.position[i]}, from_setting("camera.position")}};
}

/// A scene in pixels has no camera: its points stay.
void set_unmoved(const VertexFormulaBuilder& made, int i, Formula& formula) {
    formula.help = "The bench gives its vertices in pixels, so there is no camera.";
    formula.expression = "P." + axis_name(i);
    formula.inputs = {made.write.part(formula.expression, "world", i)};
}

void add_camera_space(VertexFormulaBuilder& made) {
    for (int i = 0; i < 3; ++i) {
        Formula& formula =
            made.write.add("minus_camera." + axis_name(i), axis_name(i),
                           "The world moved so that the camera is at the origin: P − C.", "", {},
                           {made.report.shaded.in("minus_camera")[i]});
        if (made.is_bench()) {
            set_unmoved(made, i, formula);
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
    }
}

/// R of the camera for row vectors: row and column from 0, each a product of sines and cosines.
void add_rotation(VertexFormulaBuilder& made) {
    static constexpr const char* expressions[3][3] = {
        {"cos(yaw)", "sin(pitch) · sin(yaw)", "cos(pitch) · sin(yaw)"},
        {"0", "cos(pitch)", "−sin(pitch)"},
        {"−sin(yaw)", "sin(pitch) · cos(yaw)", "cos(pitch) · cos(yaw)"}};
    static constexpr const char* axes[] = {"right", "down", "forward"};
    const Camera& camera = made.frame.settings.camera;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            Formula& formula = made.write.add(
                rotation_id(row, column), rotation_symbol(row, column),
                "An entry of R, the camera's rotation, by row and column; the columns of R are the "
                "camera's right, down and forward axes in the world.",
                expressions[row][column],
                {{"yaw", {camera.yaw}, from_setting("camera.yaw")},
                 {"pitch", {camera.pitch}, from_setting("camera.pitch")}},
                {made.rotation[column][row]});
            if (camera.aim != CameraAim::look_at) continue;
            formula.expression = fmt::format("{}.{}", axes[column], axis_name(row));
            formula.inputs = {{formula.expression, formula.result,
                               from_words("forward points to the target, right is forward × up, "
                                          "and down is forward × right")}};
        }
    }
}

constexpr const char* transposed_help =
    "Turned by R d, with d = P − C: the same turn as d R, but the other way round";

void add_rotated(VertexFormulaBuilder& made) {
    const Settings& settings = made.frame.settings;
    const CameraMove move = camera_move_rule(settings);
    for (int i = 0; i < 3; ++i) {
        const std::string axis = axis_name(i);
        Formula& formula =
            made.write.add("rotated." + axis, axis,
                           "Turned so that the camera looks along +z: d R, with d = P − C.", "", {},
                           {made.report.shaded.in("rotated")[i]});
        const std::string distance_help = i == 2 ? " How far in front of the camera." : "";
        if (made.is_bench()) {
            set_unmoved(made, i, formula);
            continue;
        }
        if (made.is_by_matrices()) {
            formula.help += distance_help;
            formula.expression = axis;
            formula.inputs = {by_matrix(axis, formula.result.value, "Tv · P")};
            continue;
        }
        if (move == CameraMove::rotated_first) {
            formula.help = "By mistake, moved after it was turned, by a C that was not turned.";
            set_moved(made, "d", "minus_camera", "−", i, formula);
        } else {
            if (settings.rotation != Rotation::row_vector)
                formula.help.replace(0, formula.help.find('.'), transposed_help);
            if (move == CameraMove::added)
                formula.help.replace(formula.help.find("P − C"), std::string("P − C").size(),
                                     "P + C");
            set_turned(made, "d", "minus_camera", i, formula);
        }
        formula.help += distance_help;
    }
}

void add_inverse_z(VertexFormulaBuilder& made) {
    Formula& formula = made.write.add(
        "zinv", "1/z",
        made.has_own_depth() ? "The weight used for interpolation."
                             : "What the depth buffer holds; larger is nearer.",
        "1 / z", {made.write.input("z", "rotated.z")}, {made.report.shaded.pixel.inv_w});
    if (made.is_bench() || divided_by_rule(made.frame.settings) != DividedBy::distance) return;
    formula.help += " By mistake it is 1 over the distance from the camera.";
    formula.expression = "1 / sqrt(x² + y² + z²)";
    formula.inputs.push_back(made.write.input("x", "rotated.x"));
    formula.inputs.push_back(made.write.input("y", "rotated.y"));
}

/// The normal as the light has it, if it was transformed to camera space as a point.
void add_moved_normal(VertexFormulaBuilder& made, const glm::vec3& normal) {
    for (int i = 0; i < 3; ++i) {
        const std::string axis = axis_name(i);
        made.write.add(
            light_normal_id(made.frame.settings, i), axis,
            "Taken to camera space with w = 1 and so moved as if it were a position, then made "
            "unit length again. A direction has w = 0.",
            axis, {{axis, {normal[i]}, from_words("(n − C) / |n − C|")}}, {normal[i]});
    }
}

void add_light(VertexFormulaBuilder& made) {
    LitPoint point;
    point.prefix = "light.";
    point.position = made.write.vector("world");
    point.normal = made.write.vector(light_normal_id(made.frame.settings));
    point.reflectance.value = made.vertex.reflectance;
    for (std::size_t i = 0; i < 3; ++i)
        point.reflectance.sources[i] = from_formula(std::string("reflectance.") + channel_names[i]);
    point.shine = made.vertex.shine;
    point.light = made.report.light;
    append_side_formulas(point, SourcedVector(point.normal), made.frame, made.report.formulas);
    append_light_formulas(point, made.frame, made.report.formulas);
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

    VertexFormulaBuilder made{frame, given, rotation, report};
    add_given(made, "world", axis_names, report.shaded.in("world"),
              "The vertex, where the scene places it.");
    if (!made.is_bench()) add_rotation(made); // a mistake turns before it moves
    add_camera_space(made);
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
    for (Formula& formula : report.formulas) {
        formula.section = "vertex";
        // Each space has an x: "rotated x".
        const std::string_view space = first_part(formula.id);
        if (space != formula.id && space != "R")
            formula.label = fmt::format("{} {}", space == "minus_camera" ? "minus camera" : space,
                                        formula.name);
    }
    add_light(made);
    return report;
}

bool is_vertex_formula(std::string_view id) {
    constexpr std::array<std::string_view, 2> whole{"zinv", "depth"};
    constexpr std::array<std::string_view, 11> first_parts{
        "world",  "minus_camera", "R",           "rotated", "clip", "projected", "pixel",
        "normal", "light_normal", "reflectance", "light"};
    return is_possible_id(id, whole, first_parts);
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

std::string light_normal_id(const Settings& settings) {
    return settings.normal_w == NormalW::zero ? "normal" : "light_normal";
}

std::string light_normal_id(const Settings& settings, int axis) {
    return light_normal_id(settings) + "." + axis_name(axis);
}

bool depends_on_rotation(std::string_view id) {
    return id.starts_with("rotated.") || id.starts_with("clip.") || id == "zinv" || id == "depth" ||
           id.starts_with("projected.") || id.starts_with("pixel.");
}

std::string how_rounded(const Settings& settings, SceneSpace space) {
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
