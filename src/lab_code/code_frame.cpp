#include "lab_code/code_frame.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <vector>

#include "code/code_host.h"
#include "lab_code/lab_program.h"

namespace rasterwalk {

namespace {

/// Sets a global variable, if the program has it.
template <class T>
void give(CodeMachine& machine, std::string_view name, const T& value) {
    const std::span<std::uint32_t> words = machine.global(name);
    if (words.size() == static_cast<std::size_t>(code_words<T>))
        write_code_value(words.data(), value);
}

class Words {
  public:
    void add(const glm::vec3& v) {
        for (int i = 0; i < 3; ++i)
            words_.push_back(std::bit_cast<std::uint32_t>(v[i]));
    }
    void add(float value) { words_.push_back(std::bit_cast<std::uint32_t>(value)); }
    void add(int value) { words_.push_back(static_cast<std::uint32_t>(value)); }
    void add(bool value) { words_.push_back(value ? 1u : 0u); }
    const std::vector<std::uint32_t>& all() const { return words_; }

  private:
    std::vector<std::uint32_t> words_;
};

/// The triangles, as struct Triangle has them.
Words triangles_of(const Frame& frame) {
    Words words;
    const bool has_own = has_own_corners(frame);
    const bool is_blended = code_word_holds("scene_transparency", frame);
    const bool has_shine = code_word_holds("light_model_blinn_phong", frame);
    for (int t = 0; t < frame.triangle_count(); ++t) {
        const std::array<Vertex, triangle_corners> corners = corners_of(*frame.scene, t);
        for (const Vertex& corner : corners)
            words.add(corner.position);
        if (has_own) {
            for (const Vertex& corner : corners)
                words.add(corner.normal);
            for (const Vertex& corner : corners)
                words.add(corner.reflectance);
            const CornerDifferences differences = frame.scene->mesh.differences(t);
            words.add(differences.normals);
            words.add(differences.colours);
        } else {
            words.add(corners[0].normal);
            words.add(corners[0].reflectance);
        }
        if (has_shine) {
            words.add(corners[0].shine.specular);
            words.add(exponent_of(corners[0].shine, frame.settings.light));
        }
        if (is_textured(frame)) {
            for (const Vertex& corner : corners) {
                words.add(corner.texcoord.x);
                words.add(corner.texcoord.y);
            }
            const int part = part_of(*frame.scene, t);
            words.add(part < 0 ? -1 : frame.scene->parts[static_cast<std::size_t>(part)].texture);
        }
        if (is_blended) words.add(alpha_rule(frame.settings, *frame.scene, t));
    }
    return words;
}

/// Gives a list of the program's all its elements, if it has the list.
void give_list(CodeMachine& machine, std::string_view name, const Words& words) {
    machine.resize_list(name, words.all().size());
    const std::span<std::uint32_t> list = machine.list(name);
    if (list.size() == words.all().size())
        std::copy(words.all().begin(), words.all().end(), list.begin());
}

/// The textures without their smaller copies, and the texels of all of them.
void give_textures(CodeMachine& machine, const Scene& scene) {
    Words textures, texels;
    int first = 0;
    for (const SharedTexture& shared : scene.textures) {
        const TextureLevel& base = (*shared).base();
        textures.add(base.width);
        textures.add(base.height);
        textures.add(first);
        first += base.width * base.height;
        for (const glm::vec3& texel : base.texels)
            texels.add(texel);
    }
    give_list(machine, "textures", textures);
    give_list(machine, "texels", texels);
}

} // namespace

void give_frame(CodeMachine& machine, const Frame& frame) {
    give_list(machine, "triangles", triangles_of(frame));
    if (is_textured(frame)) give_textures(machine, *frame.scene);
    const VertexRules rules = vertex_rules(frame);
    give(machine, "cameraPos", rules.camera.position);
    give(machine, "R", camera_rotation(rules.camera));
    give(machine, "focalLength", rules.camera.focal_length);
    give(machine, "lightPos", rules.light.position);
    give(machine, "lightPower", rules.light.power);
    give(machine, "indirectLightPowerPerArea", rules.light.indirect);
    give(machine, "emptyDepth", depth_clear_rule(frame.settings, frame.scene->space));
    give(machine, "epsilon", frame.settings.depth_epsilon);
    give(machine, "mixing", frame.stages.mixed_weight.mix);
    give(machine, "referenceDepth", frame.stages.mixed_weight.depth);
}

void give_planes(CodeMachine& machine, const Framebuffer& planes) {
    const std::span<std::uint32_t> frame = machine.global("frame");
    if (frame.size() == 3 * planes.colour.size() && !frame.empty())
        std::memcpy(frame.data(), planes.colour.data(), frame.size_bytes());
    const std::span<std::uint32_t> depth = machine.global("depthBuffer");
    if (depth.size() == planes.depth.size() && !depth.empty())
        std::memcpy(depth.data(), planes.depth.data(), depth.size_bytes());
}

glm::vec3 drawn_colour(CodeMachine& machine, std::size_t pixel) {
    const std::span<std::uint32_t> frame = machine.global("frame");
    if (3 * pixel + 3 > frame.size()) return glm::vec3(0.0f);
    return read_code_value<glm::vec3>(frame.data() + 3 * pixel);
}

float drawn_depth(CodeMachine& machine, std::size_t pixel) {
    const std::span<std::uint32_t> depth = machine.global("depthBuffer");
    return pixel < depth.size() ? std::bit_cast<float>(depth[pixel]) : 0.0f;
}

} // namespace rasterwalk
