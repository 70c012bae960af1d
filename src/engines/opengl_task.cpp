#include "engines/opengl_task.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <type_traits>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/error.h"
#include "base/limits.h"
#include "engines/fast/fast_mesh.h"
#include "engines/fast/fast_view.h"
#include "pipeline/surface.h"

namespace rasterwalk {

namespace {

void put(const glm::vec3& from, float (&to)[3]) {
    for (int i = 0; i < 3; ++i)
        to[i] = from[i];
}

/// The corners of a triangle. With shading=flat all of them are lit as its middle is.
void add_corners(const Scene& scene, int triangle, bool is_flat, const Light& light,
                 std::vector<OpenGlCorner>& to) {
    const std::array<Vertex, triangle_corners> corners = corners_of(scene, triangle);
    const SurfacePoint middle = middle_point(corners, triangle_normal(scene, triangle));
    for (const Vertex& vertex : corners) {
        OpenGlCorner& corner = to.emplace_back();
        put(vertex.position, corner.place);
        put(is_flat ? middle.position_world : vertex.position, corner.lit_place);
        put(is_flat ? middle.normal : vertex.normal, corner.normal);
        put(is_flat ? middle.reflectance : vertex.reflectance, corner.reflectance);
        corner.texcoord[0] = vertex.texcoord.x;
        corner.texcoord[1] = vertex.texcoord.y;
        put(corners[0].shine.specular, corner.specular);
        corner.exponent = exponent_of(corners[0].shine, light);
        corner.owner = triangle;
    }
}

void add_triangles(const Scene& scene, const Settings& settings, OpenGlTask& task) {
    const bool is_flat = shading_rule(settings) == Shading::flat;
    const auto add_run = [&](int first, int count, int texture) {
        OpenGlRun run{task.triangle_count(), 0, texture};
        for (int t = first; t < first + count; ++t) {
            const bool can_be_drawn = is_place(scene.corner(t, 0).position) &&
                                      is_place(scene.corner(t, 1).position) &&
                                      is_place(scene.corner(t, 2).position);
            if (can_be_drawn) add_corners(scene, t, is_flat, settings.light, task.corners);
        }
        run.triangle_count = task.triangle_count() - run.first_triangle;
        task.runs.push_back(run);
    };
    task.corners.reserve(3 * static_cast<std::size_t>(scene.triangle_count()));
    const bool shows_textures = task.view.shows_textures != 0;
    for (const Part& part : scene.parts)
        add_run(part.first_triangle, part.triangle_count, shows_textures ? part.texture : -1);
    if (scene.parts.empty()) add_run(0, scene.triangle_count(), -1);
}

void add_textures(const Scene& scene, OpenGlTask& task) {
    for (const SharedTexture& texture : scene.textures) {
        const TextureLevel& base = (*texture).base();
        const auto index = static_cast<std::int32_t>(task.textures.size());
        OpenGlTexture& to = task.textures.emplace_back(OpenGlTexture{base.width, base.height, {}});
        if (std::none_of(task.runs.begin(), task.runs.end(),
                         [&](const OpenGlRun& run) { return run.texture == index; }))
            continue;
        for (const glm::vec3& texel : base.texels) {
            const glm::vec3 bytes = glm::clamp(texel, 0.0f, 1.0f) * 255.0f + 0.5f;
            to.texels.push_back(0xff000000U | static_cast<std::uint32_t>(bytes.z) << 16 |
                                static_cast<std::uint32_t>(bytes.y) << 8 |
                                static_cast<std::uint32_t>(bytes.x));
        }
    }
}

template <class Value>
void append(const Value* values, std::size_t count, std::string& bytes) {
    static_assert(std::is_trivially_copyable_v<Value>);
    bytes.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
}
template <class Value>
void append_list(const std::vector<Value>& list, std::string& bytes) {
    const std::uint64_t count = list.size();
    append(&count, 1, bytes);
    append(list.data(), list.size(), bytes);
}

[[noreturn]] void throw_no_task(const char* why) {
    throw InputError(std::string("these bytes are no picture to draw: ") + why + '.');
}

/// Takes values from the front of bytes.
class Taking {
  public:
    explicit Taking(std::string_view bytes) : left_(bytes) {}

    template <class Value>
    void take(Value* values, std::size_t count) {
        static_assert(std::is_trivially_copyable_v<Value>);
        if (count > left_.size() / sizeof(Value)) throw_no_task("some are missing");
        if (count > 0) std::memcpy(values, left_.data(), count * sizeof(Value));
        left_.remove_prefix(count * sizeof(Value));
    }
    template <class Value>
    void take_list(std::vector<Value>& list) {
        std::uint64_t count = 0;
        take(&count, 1);
        if (count > left_.size() / sizeof(Value)) throw_no_task("some are missing");
        list.resize(static_cast<std::size_t>(count));
        take(list.data(), list.size());
    }
    bool is_empty() const { return left_.empty(); }

  private:
    std::string_view left_;
};

bool is_flag(std::int32_t value) {
    return value == 0 || value == 1;
}

/// Can this be drawn without reading beyond what is there?
void check(const OpenGlTask& task) {
    const fast::View& view = task.view;
    const auto is_side = [](std::int32_t side) { return side >= 1 && side <= largest_viewport; };
    if (!is_side(view.width) || !is_side(view.height)) throw_no_task("its size");
    if (!is_flag(view.has_highlights) || !is_flag(view.shows_textures) ||
        !is_flag(view.culls_backs) || !is_flag(view.is_bilinear) ||
        view.light_at < fast::LightAt::nowhere || view.light_at > fast::LightAt::pixels ||
        view.wrap < fast::Wrap::repeat || view.wrap > fast::Wrap::mirror ||
        task.surface < OpenGlSurface::lines || task.surface > OpenGlSurface::nearest)
        throw_no_task("one of its rules");
    if (task.corners.size() % 3 != 0) throw_no_task("its corners");
    const auto textures = static_cast<std::int64_t>(task.textures.size());
    for (const OpenGlRun& run : task.runs) {
        const std::int64_t end = std::int64_t{run.first_triangle} + run.triangle_count;
        if (run.first_triangle < 0 || run.triangle_count < 0 || end > task.triangle_count() ||
            run.texture < -1 || run.texture >= textures)
            throw_no_task("one of its runs of triangles");
        if (run.texture >= 0 && task.textures[static_cast<std::size_t>(run.texture)].texels.empty())
            throw_no_task("a texture without texels");
    }
    for (const OpenGlTexture& texture : task.textures) {
        const auto texels = static_cast<std::uint64_t>(std::max(texture.width, 0)) *
                            static_cast<std::uint64_t>(std::max(texture.height, 0));
        if (texels == 0 || (!texture.texels.empty() && texture.texels.size() != texels))
            throw_no_task("the size of a texture");
    }
}

} // namespace

OpenGlTask opengl_task(const Scene& scene, const Settings& settings) {
    OpenGlTask task;
    task.view = fast_view(settings);
    // The light of a triangle is that of three equal corners.
    if (shading_rule(settings) == Shading::flat) task.view.light_at = fast::LightAt::vertices;
    task.surface = settings.stage == Stage::edges  ? OpenGlSurface::lines
                   : settings.stage == Stage::fill ? OpenGlSurface::unsorted
                                                   : OpenGlSurface::nearest;
    if (task.surface == OpenGlSurface::lines) task.view.shows_textures = 0;
    add_triangles(scene, settings, task);
    add_textures(scene, task);
    return task;
}

std::string bytes_of(const OpenGlTask& task) {
    std::string bytes;
    append(&task.view, 1, bytes);
    append(&task.surface, 1, bytes);
    append_list(task.corners, bytes);
    append_list(task.runs, bytes);
    const std::uint64_t count = task.textures.size();
    append(&count, 1, bytes);
    for (const OpenGlTexture& texture : task.textures) {
        append(&texture.width, 1, bytes);
        append(&texture.height, 1, bytes);
        append_list(texture.texels, bytes);
    }
    return bytes;
}

OpenGlTask opengl_task_from(const std::string& bytes) {
    OpenGlTask task;
    Taking from(bytes);
    from.take(&task.view, 1);
    from.take(&task.surface, 1);
    from.take_list(task.corners);
    from.take_list(task.runs);
    std::uint64_t count = 0;
    from.take(&count, 1);
    for (; count > 0; --count) { // each needs bytes, so a false count ends soon
        OpenGlTexture& texture = task.textures.emplace_back();
        from.take(&texture.width, 1);
        from.take(&texture.height, 1);
        from.take_list(texture.texels);
    }
    if (!from.is_empty()) throw_no_task("there are too many");
    check(task);
    return task;
}

} // namespace rasterwalk
