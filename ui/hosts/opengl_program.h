#pragma once

// What programs that draw with shaders share. All of this needs a current context. The build
// defines GL_GLEXT_PROTOTYPES for them, because whichever file includes GL/gl.h first decides.

#include <span>
#include <string>

#include <GL/gl.h>
#include <GL/glext.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace rasterwalk {

/// The two shaders of a program, in GLSL 1.30.
struct ShaderTexts {
    std::string vertex, fragment;
};

/// The line that a shader begins with.
extern const char* const shader_version;

/// The part of a vertex shader that leads from the camera's space into clip space, with uniforms
/// `scale`, `middle` and `depth`: see set_projection().
extern const char* const clip_space_text;

/// The text of a shader with another text in each place of a word.
std::string replaced(std::string text, const std::string& word, const std::string& by);

/// The names of a program's attributes, and of what its fragment shader writes, in their order.
struct ShaderNames {
    std::span<const char*const> attributes, outputs;
};

/// A program. Throws AccessError with the compiler's message.
GLuint linked_program(const ShaderTexts& texts, const ShaderNames& names);

/// The place of a uniform of the program; -1, which is ignored, if it has none.
GLint uniform(GLuint program, const char* name);
void set_uniform(GLint place, const glm::vec3& value);

/// Sets what `clip_space_text` reads, in the program in use.
/// @param focal_length pixels
/// @param depth        z of the camera's space becomes depth.x z + depth.y in clip space
/// @param row_sign     1 if the first row of the memory that is drawn to is the top one, -1 if it
///                     is the bottom one, as in a window
void set_projection(GLuint program, const Viewport& size, float focal_length,
                    const glm::vec2& depth, float row_sign);

/// Puts values into a new buffer, which stays bound.
template <class Values>
GLuint filled_buffer(GLenum target, const Values& values) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, static_cast<GLsizeiptr>(sizeof(values[0]) * values.size()), values.data(),
                 GL_STATIC_DRAW);
    return buffer;
}

/// The renderer: "llvmpipe (LLVM 15.0.6, 256 bits)".
std::string renderer_name();

} // namespace rasterwalk
