#include "mine/functions/projection_rules.h"

#include "mistakes/project.h"
#include "settings/choose_stages.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

/// In the slot perspective_divide: no division.
glm::vec2 leave_undivided(const glm::vec4& clip, float) {
    return {clip.x, clip.y};
}

/// In the slot to_clip_space: y up.
glm::vec4 clip_with_y_up(const glm::vec3& rotated, const VertexRules& rules) {
    return to_clip_space({rotated.x, -rotated.y, rotated.z}, rules);
}

/// In the slot to_clip_space: half the focal length.
glm::vec4 clip_with_half_focal_length(const glm::vec3& rotated, const VertexRules& rules) {
    return to_clip_space({0.5f * rotated.x, 0.5f * rotated.y, rotated.z}, rules);
}

/// In the slot viewport_middle: W and H for W/2 and H/2.
glm::ivec2 whole_size(const VertexRules& rules) {
    return {rules.viewport.width, rules.viewport.height};
}

Vertex vertex_of(const VertexQuestion& question) {
    Vertex vertex;
    vertex.position = question.position;
    vertex.normal = question.normal;
    vertex.reflectance = question.colour;
    return vertex;
}

glm::mat3 rotation_of(const KnownProgram& program) {
    return program.rotation ? *program.rotation : camera_rotation(program.camera);
}

} // namespace

ProjectionRule projection_with(std::string_view name, std::string_view value,
                               std::string_view bug) {
    ProjectionRule rule;
    if (!name.empty()) {
        rule.settings = {{std::string(name), std::string(value)}};
        set_value(rule.chosen, *find_setting(name), value);
    }
    rule.bug = bug;
    rule.stages = choose_stages(rule.chosen);
    return rule;
}

std::vector<ProjectionRule> make_mistaken_projections() {
    std::vector<ProjectionRule> rules = {
        projection_with("rotation", "transposed", "B24"),
        projection_with("camera_move", "added", "B70"),
        projection_with("camera_move", "rotated_first", "B71"),
        projection_with("image_axes", "mirrored", "B25"),
        projection_with("image_axes", "exchanged", "B73"),
        projection_with("image_axes", "uncentred", "B74"),
        projection_with("divided_by", "distance", "B75"),
        projection_with("outside_picture", "clamped", "B15"),
    };
    const auto trap = [&](std::string_view cause) -> Stages& {
        ProjectionRule& rule = rules.emplace_back(projection_with({}, {}, {}));
        rule.cause = cause;
        return rule.stages;
    };
    trap("x and y are not divided by z.").perspective_divide = leave_undivided;
    trap("y is turned upside down: in this room y points down.").to_clip_space = clip_with_y_up;
    trap("x and y are multiplied by half the focal length.").to_clip_space =
        clip_with_half_focal_length;
    trap("W and H are added where W/2 and H/2 belong.").viewport_middle = whole_size;
    // A program that puts a vertex behind the camera divides all the same.
    for (ProjectionRule& rule : rules)
        rule.stages.is_in_front = is_in_front_unasked;
    return rules;
}

ShadedVertex shade_by(const ProjectionRule& rule, std::size_t index, const Questions& questions) {
    Settings settings = rule.chosen;
    settings.camera = questions.program.camera;
    settings.viewport = questions.program.viewport;
    settings.light = questions.program.light;
    const VertexRules rules = vertex_rules(settings, SceneSpace::world);
    return shade_vertex(vertex_of(questions.vertices[index]), rotation_of(questions.program), rules,
                        rule.stages);
}

} // namespace rasterwalk
