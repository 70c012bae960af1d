#include "ui/hosts/opengl_drawing.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include "base/error.h"
#include "ui/hosts/opengl_program.h"
#include "ui/hosts/opengl_shaders.h"

namespace rasterwalk {

namespace {

/// The planes that the fragment shader writes, in the order of its outputs.
enum Plane : std::size_t { colour_plane, inv_z_plane, owner_plane, plane_count };

constexpr const char* outputs[plane_count] = {"colour", "inv_z", "triangle"};

/// A member of OpenGlCorner, in the order of the struct.
struct Attribute {
    const char* name;
    GLint count; ///< of its numbers
};
constexpr Attribute attributes[] = {{"place", 3},       {"lit_place", 3}, {"normal", 3},
                                    {"reflectance", 3}, {"texcoord", 2},  {"specular", 3},
                                    {"exponent", 1},    {"owner", 1}};
constexpr std::size_t owner_attribute = std::size(attributes) - 1;

/// Names that OpenGL has given, deleted at the end.
class Names {
  public:
    using Generate = void (*)(GLsizei, GLuint*);
    using Delete = void (*)(GLsizei, const GLuint*);

    Names(std::size_t count, Generate generate, Delete free) : names_(count), delete_(free) {
        generate(static_cast<GLsizei>(count), names_.data());
    }
    ~Names() { delete_(static_cast<GLsizei>(names_.size()), names_.data()); }
    Names(const Names&) = delete;
    Names& operator=(const Names&) = delete;

    GLuint operator[](std::size_t i) const { return names_[i]; }

  private:
    std::vector<GLuint> names_;
    Delete delete_;
};

int integer(GLenum name) {
    std::array<GLint, 2> values{};
    glGetIntegerv(name, values.data());
    return values[0];
}

glm::vec3 vector(const float (&from)[3]) {
    return {from[0], from[1], from[2]};
}

/// Memory to draw to: the planes, and a depth buffer.
class Target {
  public:
    explicit Target(const fast::View& view) : width_(view.width), height_(view.height) {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_[0]);
        attach(colour_plane, GL_COLOR_ATTACHMENT0, GL_RGBA8);
        attach(inv_z_plane, GL_COLOR_ATTACHMENT1, GL_R32F);
        attach(owner_plane, GL_COLOR_ATTACHMENT2, GL_R32I);
        attach(plane_count, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F);
        constexpr GLenum planes[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1,
                                     GL_COLOR_ATTACHMENT2};
        glDrawBuffers(plane_count, planes);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw AccessError(fmt::format("OpenGL has no memory for a picture of {}x{} pixels.",
                                          width_, height_));
    }
    ~Target() { glBindFramebuffer(GL_FRAMEBUFFER, 0); }
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    void clear() const {
        constexpr float black[4] = {}, nothing[4] = {}, farthest = 0.0f;
        constexpr GLint no_triangle[4] = {-1, -1, -1, -1};
        glClearBufferfv(GL_COLOR, colour_plane, black);
        glClearBufferfv(GL_COLOR, inv_z_plane, nothing);
        glClearBufferiv(GL_COLOR, owner_plane, no_triangle);
        glClearBufferfv(GL_DEPTH, 0, &farthest);
    }
    void read(FastPicture& picture) const {
        picture.size = {width_, height_};
        picture.stride = static_cast<std::size_t>(width_);
        const std::size_t pixels = picture.stride * static_cast<std::size_t>(height_);
        const auto take = [&](Plane plane, GLenum format, GLenum type, auto& to) {
            to.resize(pixels);
            glReadBuffer(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + plane));
            glReadPixels(0, 0, width_, height_, format, type, to.data());
        };
        take(colour_plane, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, picture.colour);
        take(inv_z_plane, GL_RED, GL_FLOAT, picture.inv_z);
        take(owner_plane, GL_RED_INTEGER, GL_INT, picture.owner);
        for (std::uint32_t& colour : picture.colour)
            colour &= 0xffffffU; // without alpha
    }

  private:
    void attach(std::size_t i, GLenum place, GLenum format) const {
        glBindRenderbuffer(GL_RENDERBUFFER, planes_[i]);
        glRenderbufferStorage(GL_RENDERBUFFER, format, width_, height_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, planes_[i]);
    }

    int width_, height_;
    Names planes_{plane_count + 1, glGenRenderbuffers, glDeleteRenderbuffers};
    Names framebuffer_{1, glGenFramebuffers, glDeleteFramebuffers};
};

/// The textures. Shaders read single texels, so nothing is set about filter and wrap but what makes
/// a texture without smaller levels complete.
class Textures {
  public:
    explicit Textures(const std::vector<OpenGlTexture>& textures)
        : names_(textures.size(), glGenTextures, glDeleteTextures) {
        for (std::size_t i = 0; i < textures.size(); ++i) {
            const OpenGlTexture& texture = textures[i];
            if (texture.texels.empty()) continue;
            glBindTexture(GL_TEXTURE_2D, names_[i]);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, texture.width, texture.height, 0, GL_RGBA,
                         GL_UNSIGNED_INT_8_8_8_8_REV, texture.texels.data());
        }
    }
    /// @param texture -1: none
    void bind(std::int32_t texture) const {
        glBindTexture(GL_TEXTURE_2D, texture < 0 ? 0 : names_[static_cast<std::size_t>(texture)]);
    }

  private:
    Names names_;
};

/// The corners in a buffer, each number an attribute.
class Corners {
  public:
    explicit Corners(const std::vector<OpenGlCorner>& corners) {
        glBindVertexArray(arrays_[0]);
        glBindBuffer(GL_ARRAY_BUFFER, buffer_[0]);
        glBufferData(GL_ARRAY_BUFFER,
                     static_cast<GLsizeiptr>(corners.size() * sizeof(OpenGlCorner)), corners.data(),
                     GL_STREAM_DRAW);
        std::uintptr_t offset = 0;
        for (std::size_t i = 0; i < std::size(attributes); ++i) {
            const auto index = static_cast<GLuint>(i);
            const auto* const begin = reinterpret_cast<const void*>(offset);
            if (i == owner_attribute)
                glVertexAttribIPointer(index, 1, GL_INT, sizeof(OpenGlCorner), begin);
            else
                glVertexAttribPointer(index, attributes[i].count, GL_FLOAT, GL_FALSE,
                                      sizeof(OpenGlCorner), begin);
            glEnableVertexAttribArray(index);
            offset += sizeof(float) * static_cast<std::size_t>(attributes[i].count);
        }
    }
    ~Corners() { glBindVertexArray(0); }
    Corners(const Corners&) = delete;
    Corners& operator=(const Corners&) = delete;

  private:
    Names buffer_{1, glGenBuffers, glDeleteBuffers};
    Names arrays_{1, glGenVertexArrays, glDeleteVertexArrays};
};

/// Makes all uniforms of the program in use those of the task.
void set_uniforms(GLuint program, const fast::View& view) {
    const auto place = [program](const char* name) { return uniform(program, name); };
    set_uniform(place("eye"), vector(view.eye));
    glUniformMatrix3fv(place("axes"), 1, GL_FALSE, &view.axes[0][0]);
    // Near is -w in clip space, and nothing is too far: near / z is the depth.
    set_projection(program, {view.width, view.height}, view.focal_length, {1.0f, -2.0f * view.near},
                   1.0f);
    glUniform1f(place("near"), view.near);
    glUniform1f(place("focal_length"), view.focal_length);
    glUniform1f(place("guard_band"), fast::guard_band);
    glUniform1f(place("subpixels"), static_cast<float>(fast::subpixels));
    glUniform2f(place("size"), static_cast<float>(view.width), static_cast<float>(view.height));
    glUniform2f(place("middle_pixel"), view.middle[0], view.middle[1]);
    set_uniform(place("lamp"), vector(view.lamp));
    set_uniform(place("power"), vector(view.power));
    set_uniform(place("indirect"), vector(view.indirect));
    glUniform1i(place("has_highlights"), view.has_highlights);
    glUniform1i(place("texels"), 0);
    glUniform1i(place("is_bilinear"), view.is_bilinear);
    glUniform1i(place("is_clamped"), view.wrap == fast::Wrap::clamp ? 1 : 0);
    glUniform1i(place("is_mirrored"), view.wrap == fast::Wrap::mirror ? 1 : 0);
}

void set_state(const OpenGlTask& task) {
    const auto set = [](GLenum what, bool is_on) { is_on ? glEnable(what) : glDisable(what); };
    glViewport(0, 0, task.view.width, task.view.height);
    glPolygonMode(GL_FRONT_AND_BACK, task.surface == OpenGlSurface::lines ? GL_LINE : GL_FILL);
    // Without the test no depth is written either; none is read then.
    set(GL_DEPTH_TEST, task.surface == OpenGlSurface::nearest);
    glDepthFunc(GL_GREATER);
    set(GL_CULL_FACE, task.view.culls_backs != 0);
    // Rows go down in memory as in the picture, so a front goes round as the steps see it.
    glFrontFace(GL_CCW);
    glDisable(GL_DITHER);
}

void throw_too_large(const char* what, int width, int height, int most) {
    throw AccessError(fmt::format("{} of {}x{} is too large for OpenGL here: its sides have at "
                                  "most {}.",
                                  what, width, height, most));
}

} // namespace

OpenGlDrawing::OpenGlDrawing() : name_(renderer_name()) {
    const auto* const version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    const std::string words = version != nullptr ? version : "";
    // "4.5 (Compatibility Profile) Mesa 22.3.6"
    if (words.empty() || words[0] < '3' || words[0] > '9')
        throw AccessError("OpenGL 3.0 is needed; this system has " +
                          (words.empty() ? "none" : words) + '.');
    largest_texture_ = integer(GL_MAX_TEXTURE_SIZE);
    largest_side_ = std::min(integer(GL_MAX_RENDERBUFFER_SIZE), integer(GL_MAX_VIEWPORT_DIMS));
}

OpenGlDrawing::~OpenGlDrawing() {
    for (const GLuint program : programs_)
        glDeleteProgram(program);
}

GLuint OpenGlDrawing::program_of(const OpenGlTask& task) {
    const bool is_lines = task.surface == OpenGlSurface::lines;
    GLuint& program =
        programs_[is_lines ? programs_.size() - 1 : static_cast<std::size_t>(task.view.light_at)];
    if (program == 0) {
        std::array<const char*, std::size(attributes)> names{};
        std::transform(std::begin(attributes), std::end(attributes), names.begin(),
                       [](const Attribute& attribute) { return attribute.name; });
        program =
            linked_program(is_lines ? opengl_line_texts() : opengl_shader_texts(task.view.light_at),
                           {names, outputs});
    }
    return program;
}

void OpenGlDrawing::draw(const OpenGlTask& task, FastPicture& picture) {
    const fast::View& view = task.view;
    if (std::max(view.width, view.height) > largest_side_)
        throw_too_large("a picture", view.width, view.height, largest_side_);
    for (const OpenGlTexture& texture : task.textures) {
        if (std::max(texture.width, texture.height) > largest_texture_)
            throw_too_large("a texture", texture.width, texture.height, largest_texture_);
    }
    while (glGetError() != GL_NO_ERROR) {
    } // what is left from before
    const Target target(view);
    const Textures textures(task.textures);
    const Corners corners(task.corners);
    const GLuint program = program_of(task);
    glUseProgram(program);
    set_uniforms(program, view);
    set_state(task);
    target.clear();
    const GLint is_painted = uniform(program, "is_painted");
    for (const OpenGlRun& run : task.runs) {
        textures.bind(run.texture);
        glUniform1i(is_painted, run.texture >= 0 ? 1 : 0);
        glDrawArrays(GL_TRIANGLES, 3 * run.first_triangle, 3 * run.triangle_count);
    }
    target.read(picture);
    if (task.surface == OpenGlSurface::lines)
        std::fill(picture.inv_z.begin(), picture.inv_z.end(), 0.0f); // lines are marks
    if (const GLenum fault = glGetError(); fault != GL_NO_ERROR)
        throw AccessError(fault == GL_OUT_OF_MEMORY
                              ? "OpenGL has not enough memory for this."
                              : fmt::format("OpenGL fails with error {:#06x}.", fault));
}

} // namespace rasterwalk
