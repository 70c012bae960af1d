#include "ui/hosts/llvmpipe_shaders.h"

namespace rasterwalk {

namespace {

constexpr const char* vertex_head = R"(
in vec3 position, normal;
uniform vec3 camera, lamp, power, indirect;
const float four_pi = 12.5663706;
)";

constexpr const char* fragment_head = R"(
uniform vec3 lamp, power, indirect;
const float four_pi = 12.5663706;
out vec4 colour;
)";

constexpr const char* vertex_of_flat = R"(
flat out float slant; // r . n / (4 pi): the same on the whole triangle
out vec3 to_lamp;
void main() {
    gl_Position = clip_place(position - camera);
    to_lamp = lamp - position;
    slant = max(dot(normal, to_lamp), 0.0) / four_pi;
    PASS_COLOUR
}
)";

constexpr const char* fragment_of_flat = R"(
flat in float slant;
in vec3 to_lamp;
void main() {
    float by_distance = inversesqrt(dot(to_lamp, to_lamp));
    float share = slant * by_distance * by_distance * by_distance;
    colour = vec4(COLOUR * (power * share + indirect), 1.0);
}
)";

constexpr const char* vertex_of_bent = R"(
out vec3 to_lamp, bent_normal;
void main() {
    gl_Position = clip_place(position - camera);
    to_lamp = lamp - position;
    bent_normal = normal;
    PASS_COLOUR
}
)";

constexpr const char* fragment_of_bent = R"(
in vec3 to_lamp, bent_normal;
void main() {
    float by_distance = inversesqrt(dot(to_lamp, to_lamp));
    float by_length = inversesqrt(dot(bent_normal, bent_normal));
    float slant = max(dot(bent_normal, to_lamp), 0.0) * by_length / four_pi;
    float share = slant * by_distance * by_distance * by_distance;
    colour = vec4(COLOUR * (power * share + indirect), 1.0);
}
)";

constexpr const char* vertex_of_vertex_light = R"(
out vec3 illumination;
void main() {
    gl_Position = clip_place(position - camera);
    vec3 to_lamp = lamp - position;
    float distance2 = dot(to_lamp, to_lamp);
    float cosine = max(dot(normal, to_lamp), 0.0) * inversesqrt(distance2);
    illumination = COLOUR * (power * (cosine / (four_pi * distance2)) + indirect);
}
)";

constexpr const char* fragment_of_vertex_light = R"(
in vec3 illumination;
void main() { colour = vec4(illumination, 1.0); }
)";

/// The source of the colour, in each of the two shaders.
ShaderTexts with_colour(const ShaderTexts& texts, bool is_uniform, bool is_lit_at_vertices) {
    ShaderTexts result{std::string(shader_version) + clip_space_text + vertex_head,
                       std::string(shader_version) + fragment_head};
    if (is_uniform) {
        result.vertex += "uniform vec3 reflectance;\n";
        result.fragment += "uniform vec3 reflectance;\n";
    } else {
        result.vertex += "in vec3 reflectance;\n";
        if (!is_lit_at_vertices) {
            result.vertex += "flat out vec3 flat_colour;\n";
            result.fragment += "flat in vec3 flat_colour;\n";
        }
    }
    result.vertex += replaced(
        replaced(texts.vertex, "PASS_COLOUR", is_uniform ? "" : "flat_colour = reflectance;"),
        "COLOUR", "reflectance");
    result.fragment +=
        replaced(texts.fragment, "COLOUR", is_uniform ? "reflectance" : "flat_colour");
    return result;
}

} // namespace

SurfaceFacts surface_facts(const Scene& scene) {
    SurfaceFacts facts;
    facts.is_flat = !scene.mesh.differences().normals;
    for (const Vertex& vertex : scene.mesh.vertices()) {
        if (vertex.reflectance != scene.mesh.vertices().front().reflectance)
            facts.has_one_colour = false;
    }
    return facts;
}

ShaderTexts shader_texts(Workload workload, const SurfaceFacts& facts) {
    if (workload == Workload::w3) {
        return with_colour({vertex_of_vertex_light, fragment_of_vertex_light}, facts.has_one_colour,
                           true);
    }
    return with_colour(facts.is_flat ? ShaderTexts{vertex_of_flat, fragment_of_flat}
                                     : ShaderTexts{vertex_of_bent, fragment_of_bent},
                       facts.has_one_colour, false);
}

} // namespace rasterwalk
