#include "ui/hosts/opengl_program.h"

#include <array>

#include "base/error.h"

namespace rasterwalk {

namespace {

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
    throw AccessError(std::string("OpenGL cannot compile a shader: ") + log.data());
}

} // namespace

const char* const shader_version = "#version 130\n";

const char* const clip_space_text = R"(
uniform vec2 scale, middle; // focal length and middle of the picture, in normalized coordinates
uniform vec2 depth;         // z is mapped to depth.x z + depth.y
vec4 clip_place(vec3 seen) {
    return vec4(scale * seen.xy + middle * seen.z, depth.x * seen.z + depth.y, seen.z);
}
)";

std::string replaced(std::string text, const std::string& word, const std::string& by) {
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + by.size()))
        text.replace(at, word.size(), by);
    return text;
}

GLuint linked_program(const ShaderTexts& texts, const ShaderNames& names) {
    const GLuint program = glCreateProgram();
    for (const GLuint shader :
         {compiled(GL_VERTEX_SHADER, texts.vertex), compiled(GL_FRAGMENT_SHADER, texts.fragment)}) {
        glAttachShader(program, shader);
        glDeleteShader(shader); // with the program
    }
    for (std::size_t i = 0; i < names.attributes.size(); ++i)
        glBindAttribLocation(program, static_cast<GLuint>(i), names.attributes[i]);
    for (std::size_t i = 0; i < names.outputs.size(); ++i)
        glBindFragDataLocation(program, static_cast<GLuint>(i), names.outputs[i]);
    glLinkProgram(program);
    GLint is_good = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &is_good);
    if (is_good != GL_TRUE) throw AccessError("OpenGL cannot link its shaders.");
    return program;
}

GLint uniform(GLuint program, const char* name) {
    return glGetUniformLocation(program, name);
}

void set_uniform(GLint place, const glm::vec3& value) {
    glUniform3f(place, value.x, value.y, value.z);
}

void set_projection(GLuint program, const Viewport& size, float focal_length,
                    const glm::vec2& depth, float row_sign) {
    const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    glUniform2f(uniform(program, "scale"), 2.0f * focal_length / width,
                row_sign * 2.0f * focal_length / height);
    // The middle of the scene is at side / 2, a whole pixel: half a pixel less if the side is odd.
    const auto middle = [](int side) { return static_cast<float>(-(side % 2)); };
    glUniform2f(uniform(program, "middle"), middle(size.width) / width,
                row_sign * middle(size.height) / height);
    glUniform2f(uniform(program, "depth"), depth.x, depth.y);
}

std::string renderer_name() {
    const auto* const text = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return text != nullptr ? text : "";
}

} // namespace rasterwalk
