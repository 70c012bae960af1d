#include "ui/hosts/llvmpipe.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>

#include <GL/glext.h>
#include <fmt/format.h>
#include <glm/vec3.hpp>

#include "base/error.h"
#include "engines/workload.h"
#include "ui/hosts/llvmpipe_shaders.h"

namespace rasterwalk {

namespace {

/// The ends of the view volume in front of the camera, world units: every workload lies entirely
/// between them.
constexpr float near_plane = 0.1f, far_plane = 10.0f;

/// The numbers of the attributes, and how they lie in the one buffer.
enum Attribute : GLuint { position_attribute, normal_attribute, reflectance_attribute };
constexpr GLsizei floats_of_attribute = 3;

GLuint compiled(GLenum kind, const std::string& text) {
    const GLuint shader = glCreateShader(kind);
    const char* const source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint is_good = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &is_good);
    if (is_good == GL_TRUE) return shader;
    std::array<char, 1024> log{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw AccessError(std::string("llvmpipe cannot compile a shader: ") + log.data());
}

GLuint linked_program(const ShaderTexts& texts) {
    const GLuint program = glCreateProgram();
    glAttachShader(program, compiled(GL_VERTEX_SHADER, texts.vertex));
    glAttachShader(program, compiled(GL_FRAGMENT_SHADER, texts.fragment));
    glBindAttribLocation(program, position_attribute, "position");
    glBindAttribLocation(program, normal_attribute, "normal");
    glBindAttribLocation(program, reflectance_attribute, "reflectance");
    glLinkProgram(program);
    GLint is_good = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &is_good);
    if (is_good != GL_TRUE) throw AccessError("llvmpipe cannot link its shaders.");
    return program;
}

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
    std::array<GLuint, 2> buffers{};
    glGenBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
    const auto fill = [](GLenum target, GLuint buffer, const auto& values) {
        glBindBuffer(target, buffer);
        glBufferData(target, static_cast<GLsizeiptr>(sizeof(values[0]) * values.size()),
                     values.data(), GL_STATIC_DRAW);
    };
    fill(GL_ARRAY_BUFFER, buffers[0], floats);
    fill(GL_ELEMENT_ARRAY_BUFFER, buffers[1], indices);
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

void set_uniform(GLint place, const glm::vec3& value) {
    glUniform3f(place, value.x, value.y, value.z);
}

/// Sets what is the same in all pictures.
void set_camera(GLuint program, const Settings& settings) {
    const auto place = [program](const char* name) { return glGetUniformLocation(program, name); };
    const auto width = static_cast<float>(settings.viewport.width);
    const auto height = static_cast<float>(settings.viewport.height);
    const float focal_length = settings.camera.focal_length;
    set_uniform(place("camera"), settings.camera.position);
    // Rows go down in the scene and up in OpenGL.
    glUniform2f(place("scale"), 2.0f * focal_length / width, -2.0f * focal_length / height);
    // The middle of the scene is at side / 2, a whole pixel: half a pixel less if the side is odd.
    const auto middle = [](int side) { return static_cast<float>(-(side % 2)); };
    glUniform2f(place("middle"), middle(settings.viewport.width) / width,
                -middle(settings.viewport.height) / height);
    constexpr float depth = far_plane - near_plane;
    glUniform2f(place("depth"), (far_plane + near_plane) / depth,
                -2.0f * far_plane * near_plane / depth);
}

} // namespace

/// OSMesa's context, and the memory it draws to.
struct LlvmpipeDrawing::Context {
    OSMesaContext context = nullptr;
    std::vector<std::uint32_t> pixels; ///< 0xffRRGGBB as a number of a little-endian processor

    explicit Context(Viewport size) {
        const std::array attributes{OSMESA_FORMAT,
                                    OSMESA_BGRA,
                                    OSMESA_DEPTH_BITS,
                                    24,
                                    OSMESA_STENCIL_BITS,
                                    0,
                                    OSMESA_PROFILE,
                                    OSMESA_COMPAT_PROFILE,
                                    OSMESA_CONTEXT_MAJOR_VERSION,
                                    3,
                                    OSMESA_CONTEXT_MINOR_VERSION,
                                    0,
                                    0};
        context = OSMesaCreateContextAttribs(attributes.data(), nullptr);
        pixels.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
        if (context == nullptr || OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE,
                                                    size.width, size.height) != GL_TRUE) {
            throw AccessError("OSMesa cannot be started.");
        }
        OSMesaPixelStore(OSMESA_Y_UP, 0);
    }
    ~Context() { OSMesaDestroyContext(context); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
};

LlvmpipeDrawing::LlvmpipeDrawing(const PeerTask& task, const Scene& scene)
    : size_(task.size), settings_(workload_settings(task.workload, scene, task.size)) {
    // With 0 it draws on the calling thread.
    setenv("LP_NUM_THREADS", task.threads == 1 ? "0" : std::to_string(task.threads).c_str(), 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    context_ = std::make_unique<Context>(size_);
    if (!name().starts_with("llvmpipe"))
        throw AccessError(fmt::format("OSMesa uses {} here, not llvmpipe.", name()));
    const SurfaceFacts facts = surface_facts(scene);
    const GLuint program = linked_program(shader_texts(task.workload, facts));
    glUseProgram(program);
    upload(scene.mesh, !facts.has_one_colour);
    indices_ = scene.triangle_count() * triangle_corners;
    set_camera(program, settings_);
    const auto place = [program](const char* name) { return glGetUniformLocation(program, name); };
    lamp_ = place("lamp");
    set_uniform(place("power"), settings_.light.power);
    set_uniform(place("indirect"), settings_.light.indirect);
    if (facts.has_one_colour)
        set_uniform(place("reflectance"), scene.mesh.vertices().front().reflectance);
    glViewport(0, 0, size_.width, size_.height);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_DITHER);
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
}

LlvmpipeDrawing::~LlvmpipeDrawing() = default;

std::string LlvmpipeDrawing::name() const {
    const auto* const text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return text != nullptr ? text : "";
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
    return {size_, context_->pixels};
}

} // namespace rasterwalk
