#include "ui/hosts/llvmpipe.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include "base/error.h"
#include "engines/workload.h"
#include "ui/hosts/llvmpipe_shaders.h"
#include "ui/hosts/memory_context.h"
#include "ui/hosts/opengl_program.h"

namespace rasterwalk {

namespace {

/// The ends of the view volume in front of the camera, world units: every workload lies entirely
/// between them.
constexpr float near_plane = 0.1f, far_plane = 10.0f;

constexpr int depth_bits = 24;

/// The attributes, in the order in which they lie in the one buffer.
constexpr const char* attribute_names[] = {"position", "normal", "reflectance"};
constexpr GLsizei floats_of_attribute = 3;

/// All vertices in one buffer, one after another, and the corners of the triangles in another. Both
/// stay bound.
void upload(const Mesh& mesh, bool has_colours) {
    std::vector<float> floats;
    const auto add = [&floats](const glm::vec3& v) {
        floats.insert(floats.end(), {v.x, v.y, v.z});
    };
    for (const Vertex& vertex : mesh.vertices()) {
        add(vertex.position);
        add(vertex.normal);
        if (has_colours) add(vertex.reflectance);
    }
    std::vector<GLuint> indices;
    for (const TriangleIndices& triangle : mesh.triangles())
        for (const int vertex : triangle)
            indices.push_back(static_cast<GLuint>(vertex));
    filled_buffer(GL_ARRAY_BUFFER, floats);
    filled_buffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    const GLuint attributes = has_colours ? 3 : 2;
    const auto bytes = static_cast<GLsizei>(sizeof(float)) * floats_of_attribute;
    for (GLuint attribute = 0; attribute < attributes; ++attribute) {
        const auto offset =
            static_cast<std::uintptr_t>(attribute) * static_cast<std::uintptr_t>(bytes);
        glVertexAttribPointer(attribute, floats_of_attribute, GL_FLOAT, GL_FALSE,
                              static_cast<GLsizei>(attributes) * bytes,
                              reinterpret_cast<const void*>(offset));
        glEnableVertexAttribArray(attribute);
    }
}

} // namespace

LlvmpipeDrawing::LlvmpipeDrawing(const PeerTask& task, const Scene& scene)
    : size_(task.size), settings_(workload_settings(task.workload, scene, task.size)) {
    // With 0 it draws on the calling thread.
    setenv("LP_NUM_THREADS", task.threads == 1 ? "0" : std::to_string(task.threads).c_str(), 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    context_ = make_memory_context(size_, depth_bits);
    context_->enter();
    if (!name().starts_with("llvmpipe"))
        throw AccessError(fmt::format("OpenGL is {} here, not llvmpipe.", name()));
    const SurfaceFacts facts = surface_facts(scene);
    const GLuint program =
        linked_program(shader_texts(task.workload, facts), {attribute_names, {}});
    glUseProgram(program);
    upload(scene.mesh, !facts.has_one_colour);
    indices_ = scene.triangle_count() * triangle_corners;
    constexpr float depth = far_plane - near_plane;
    set_projection(program, size_, settings_.camera.focal_length,
                   {(far_plane + near_plane) / depth, -2.0f * far_plane * near_plane / depth},
                   -1.0f);
    set_uniform(uniform(program, "camera"), settings_.camera.position);
    lamp_ = uniform(program, "lamp");
    set_uniform(uniform(program, "power"), settings_.light.power);
    set_uniform(uniform(program, "indirect"), settings_.light.indirect);
    if (facts.has_one_colour)
        set_uniform(uniform(program, "reflectance"), scene.mesh.vertices().front().reflectance);
    glViewport(0, 0, size_.width, size_.height);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_DITHER);
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
}

LlvmpipeDrawing::~LlvmpipeDrawing() = default;

std::string LlvmpipeDrawing::name() const {
    return renderer_name();
}

void LlvmpipeDrawing::draw(int number) {
    set_uniform(lamp_, lamp_in_picture(settings_.light.position, number));
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_INT, nullptr);
    glFinish();
}

Milliseconds LlvmpipeDrawing::time_pictures(int first, int count) {
    const Milliseconds begin = milliseconds_now();
    for (int i = 0; i < count; ++i)
        draw(first + i);
    return milliseconds_since(begin);
}

EnginePicture LlvmpipeDrawing::picture(int number) {
    draw(number);
    const auto width = static_cast<std::ptrdiff_t>(size_.width);
    std::vector<std::uint32_t> colour(static_cast<std::size_t>(size_.width) *
                                      static_cast<std::size_t>(size_.height));
    glReadPixels(0, 0, size_.width, size_.height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                 colour.data());
    // OpenGL counts rows from below.
    for (auto top = colour.begin(), bottom = colour.end() - width; top < bottom;
         top += width, bottom -= width)
        std::swap_ranges(top, top + width, bottom);
    return {size_, std::move(colour)};
}

} // namespace rasterwalk
