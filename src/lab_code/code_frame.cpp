#include "lab_code/code_frame.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <vector>

#include "code/code_host.h"
#include "lab_code/code_words.h"
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

/// The index of a scene's texture in the program's list; -1: none.
int listed(const Frame& frame, int texture) {
    if (!uses_mip_levels(frame)) return texture;
    int place = texture;
    for (int i = 0; i < texture; ++i)
        place += (*frame.scene->textures[static_cast<std::size_t>(i)]).last_level();
    return place;
}

/// The texture of a triangle and its other maps.
void add_maps(const Frame& frame, int triangle, Words& words) {
    const int number = part_of(*frame.scene, triangle);
    static const Part no_part;
    const Part& part = number < 0 ? no_part : frame.scene->parts[static_cast<std::size_t>(number)];
    const int texture = is_textured(frame) ? part.texture : -1;
    const int normal_map = frame.bends ? part.normal_map : -1;
    words.add(listed(frame, texture));
    if (frame.bends) words.add(listed(frame, normal_map));
    if (!frame.shifts) return;
    // A height map shifts the other maps; where there are none, it is not read.
    const bool has_map = texture >= 0 || normal_map >= 0;
    words.add(has_map ? listed(frame, part.height_map.texture) : -1);
    words.add(part.height_map.scale);
    words.add(part.height_map.bias);
}

/// The triangles, as struct Triangle has them.
Words triangles_of(const Frame& frame) {
    Words words;
    const bool has_own = has_own_corners(frame);
    const bool is_blended = shows_transparency(frame);
    const bool has_texcoords = reads_maps(frame);
    const bool has_shine = shows_highlights(frame);
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
        if (has_texcoords) {
            for (const Vertex& corner : corners) {
                words.add(corner.texcoord.x);
                words.add(corner.texcoord.y);
            }
            add_maps(frame, t, words);
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

/// The textures and the texels of all of them; where smaller copies are in use, each texture is
/// followed by its own.
void give_textures(CodeMachine& machine, const Frame& frame) {
    Words textures, texels;
    int first = 0;
    const bool has_levels = uses_mip_levels(frame);
    for (const SharedTexture& shared : frame.scene->textures) {
        const std::size_t levels = has_levels ? (*shared).levels.size() : 1;
        for (std::size_t i = 0; i < levels; ++i) {
            const TextureLevel& level = (*shared).levels[i];
            textures.add(level.width);
            textures.add(level.height);
            textures.add(first);
            if (has_levels) textures.add((*shared).last_level());
            first += level.width * level.height;
            for (const glm::vec3& texel : level.texels)
                texels.add(texel);
        }
    }
    give_list(machine, "textures", textures);
    give_list(machine, "texels", texels);
}

/// What casts shadows, apart from the triangles.
void give_occluders(CodeMachine& machine, const Occluders& occluders) {
    give(machine, "shadowOffset", occluders.rules.offset);
    give(machine, "shadowBias", occluders.rules.bias);
    give(machine, "slopeBias", occluders.rules.slope_bias);
    if (occluders.map == nullptr) return;
    const ShadowMap& map = *occluders.map;
    give(machine, "shadowMapSize", map.resolution);
    const std::span<std::uint32_t> axes = machine.global("shadowAxes");
    constexpr auto axes_words = static_cast<std::size_t>(code_words<glm::mat3>);
    if (axes.size() == map.faces.size() * axes_words) {
        for (std::size_t face = 0; face < map.faces.size(); ++face)
            write_code_value(axes.data() + face * axes_words, map.faces[face].axes);
    }
    const std::size_t face_words = map.faces[0].inv_depth.size();
    machine.resize_list("shadowMap", map.faces.size() * face_words);
    const std::span<std::uint32_t> list = machine.list("shadowMap");
    for (std::size_t face = 0; face < map.faces.size() && !list.empty(); ++face)
        std::memcpy(list.data() + face * face_words, map.faces[face].inv_depth.data(),
                    face_words * sizeof(std::uint32_t));
}

} // namespace

void give_frame(CodeMachine& machine, const Frame& frame) {
    give_list(machine, "triangles", triangles_of(frame));
    if (reads_maps(frame)) give_textures(machine, frame);
    const VertexRules rules = vertex_rules(frame);
    give(machine, "cameraPos", rules.camera.position);
    give(machine, "R", camera_rotation(rules.camera));
    give(machine, "focalLength", rules.camera.focal_length);
    give(machine, "zNear", rules.near);
    give(machine, "zFar", rules.far);
    give(machine, "orthographicMix", rules.projection.mix);
    give(machine, "orthographicDepth", rules.projection.depth);
    give(machine, "lightPos", rules.light.position);
    give(machine, "lightPower", rules.light.power);
    give(machine, "indirectLightPowerPerArea", rules.light.indirect);
    if (const Occluders* const occluders = occluders_of(frame)) give_occluders(machine, *occluders);
    give(machine, "emptyDepth", depth_clear_rule(frame.settings, frame.scene->space));
    give(machine, "epsilon", frame.settings.depth_epsilon);
    give(machine, "mixing", frame.stages.mixed_weight.mix);
    give(machine, "referenceDepth", frame.stages.mixed_weight.depth);
}

namespace {

/// Does the program use [x][y] for [y][x] of its depth buffer? Its picture is square then.
bool is_transposed(const CodeMachine& machine) {
    const std::vector<std::string>& marks = machine.program().marks;
    return std::find(marks.begin(), marks.end(), "transposed") != marks.end();
}

/// The place of a pixel's depth in the program's depth buffer.
/// @param size of the buffer
std::size_t depth_place(const CodeMachine& machine, std::size_t size, std::size_t pixel) {
    if (!is_transposed(machine)) return pixel;
    const auto width = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(size))));
    return pixel % width * width + pixel / width;
}

} // namespace

void give_planes(CodeMachine& machine, const Framebuffer& planes) {
    const std::span<std::uint32_t> frame = machine.global("frame");
    if (frame.size() == 3 * planes.colour.size() && !frame.empty())
        std::memcpy(frame.data(), planes.colour.data(), frame.size_bytes());
    const std::span<std::uint32_t> colours = machine.global("sampleColors");
    if (colours.size() == 12 * planes.sample_colour.size() && !colours.empty())
        std::memcpy(colours.data(), planes.sample_colour.data(), colours.size_bytes());
    const std::span<std::uint32_t> depths = machine.global("sampleDepths");
    if (depths.size() == 4 * planes.sample_depth.size() && !depths.empty())
        std::memcpy(depths.data(), planes.sample_depth.data(), depths.size_bytes());
    const std::span<std::uint32_t> depth = machine.global("depthBuffer");
    if (depth.size() != planes.depth.size() || depth.empty()) return;
    if (!is_transposed(machine)) {
        std::memcpy(depth.data(), planes.depth.data(), depth.size_bytes());
        return;
    }
    for (std::size_t pixel = 0; pixel < depth.size(); ++pixel)
        depth[depth_place(machine, depth.size(), pixel)] =
            std::bit_cast<std::uint32_t>(planes.depth[pixel]);
}

glm::vec3 drawn_colour(CodeMachine& machine, std::size_t pixel) {
    const std::span<std::uint32_t> frame = machine.global("frame");
    if (3 * pixel + 3 > frame.size()) return glm::vec3(0.0f);
    return read_code_value<glm::vec3>(frame.data() + 3 * pixel);
}

float drawn_depth(CodeMachine& machine, std::size_t pixel) {
    const std::span<std::uint32_t> depth = machine.global("depthBuffer");
    const std::size_t place = depth_place(machine, depth.size(), pixel);
    return place < depth.size() ? std::bit_cast<float>(depth[place]) : 0.0f;
}

} // namespace rasterwalk
