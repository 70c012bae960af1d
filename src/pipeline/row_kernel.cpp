#include "pipeline/row_kernel.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

#include "mistakes/interpolate.h"
#include "stages/light.h"
#include "stages/stage_table.h"
#include "stages/surface_shader.h"

namespace rasterwalk {

namespace {

/// Pixels that take each step together: enough for the widest instructions, and few enough for all
/// their values to fit in the nearest cache.
constexpr std::size_t block_size = 32;

template <class T>
using Block = std::array<T, block_size>;

/// A walk along a row: the running values of Interpolate, for the depth, the weight and these
/// varyings.
template <glm::vec3 Varyings::*... carried>
class RowWalk {
  public:
    static constexpr std::size_t size = 2 + 3 * sizeof...(carried);
    using Values = std::array<float, size>;

    /// The values at each pixel of a block.
    struct Walked {
        std::array<Block<float>, size> values;

        const Block<float>& depth() const { return values[0]; }
        float weight(std::size_t i) const { return values[1][i]; }
        /// @param number of the varying in the list `carried`
        glm::vec3 varying(std::size_t number, std::size_t i) const {
            const std::size_t k = 2 + 3 * number;
            return {values[k][i], values[k + 1][i], values[k + 2][i]};
        }
    };

    /// Starts at the first pixel of the part.
    RowWalk(const RowPart& part, const Stages& stages) : value_(values_at(part.left, stages)) {
        if (part.first + part.drawn == 1) return; // no step is taken
        const Values end = values_at(part.right, stages);
        const float steps = static_cast<float>(std::max(part.count - 1, 1));
        for (std::size_t k = 0; k < size; ++k)
            step_[k] = (end[k] - value_[k]) / steps;
        for (int i = 0; i < part.first; ++i)
            add_step();
    }

    /// Stores the values of the next `count` pixels.
    void walk(std::size_t count, Walked& walked) {
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < size; ++k)
                walked.values[k][i] = value_[k];
            add_step();
        }
    }

  private:
    static constexpr std::array<glm::vec3 Varyings::*, sizeof...(carried)> members{carried...};

    static Values values_at(const RowEnd& end, const Stages& stages) {
        const float weight =
            call<rasterwalk::varying_weight>(stages.recovery_weight, end.inv_w, stages);
        Values values{end.depth, weight};
        std::size_t k = 2;
        for (glm::vec3 Varyings::*const member : members) {
            for (int i = 0; i < 3; ++i)
                values[k++] = (end.varyings.*member)[i];
        }
        return values;
    }
    void add_step() {
        for (std::size_t k = 0; k < size; ++k)
            value_[k] = value_[k] + step_[k];
    }

    Values value_, step_{};
};

/// Without light, or with one light value for the whole triangle.
struct OneColour {
    using Walk = RowWalk<>;

    explicit OneColour(const RowSurface& of)
        : colour_(of.rules.shading == Shading::flat && of.stages.pixel_shader == surface_shader
                      ? of.surface.flat_light
                      : of.surface.reflectance) {}

    glm::vec3 operator()(const Walk::Walked&, std::size_t) const { return colour_; }

  private:
    glm::vec3 colour_;
};

/// Light per vertex.
struct VertexLight {
    using Walk = RowWalk<&Varyings::illumination>;

    explicit VertexLight(const RowSurface&) {}

    glm::vec3 operator()(const Walk::Walked& at, std::size_t i) const {
        return at.varying(0, i) / at.weight(i);
    }
};

/// A function of the slot light_side.
using LightSide = decltype(Stages::light_side);

/// Light per pixel if all corners have the same normal.
template <LightSide side>
struct FlatPixelLight {
    using Walk = RowWalk<&Varyings::position_world>;

    explicit FlatPixelLight(const RowSurface& of)
        : normal_(of.surface.normal), reflectance_(of.surface.reflectance), light_(of.rules.light),
          rays_(of.rules.rays) {}

    glm::vec3 operator()(const Walk::Walked& at, std::size_t i) const {
        const glm::vec3 place = at.varying(0, i) / at.weight(i);
        return reflected_light(place, side(place, normal_, rays_) * normal_, reflectance_, light_)
            .reflected;
    }

  private:
    glm::vec3 normal_, reflectance_;
    Light light_;
    SightRays rays_;
};

/// Light per pixel with an interpolated normal.
template <LightSide side>
struct BentPixelLight {
    using Walk = RowWalk<&Varyings::position_world, &Varyings::normal>;

    explicit BentPixelLight(const RowSurface& of)
        : reflectance_(of.surface.reflectance), light_(of.rules.light), rays_(of.rules.rays) {}

    glm::vec3 operator()(const Walk::Walked& at, std::size_t i) const {
        const glm::vec3 place = at.varying(0, i) / at.weight(i);
        const glm::vec3 normal = unit_normal(at.varying(1, i) / at.weight(i));
        return reflected_light(place, side(place, normal, rays_) * normal, reflectance_, light_)
            .reflected;
    }

  private:
    glm::vec3 reflectance_;
    Light light_;
    SightRays rays_;
};

/// The planes, starting at the first pixel of a block.
struct BlockPlanes {
    BlockPlanes(Framebuffer& target, std::size_t pixel)
        : colour(&target.colour[pixel]), depth(&target.depth[pixel]), owner(&target.owner[pixel]),
          overdraw(&target.overdraw[pixel]) {}

    glm::vec3* colour;
    float* depth;
    std::int32_t* owner;
    std::uint32_t* overdraw;
};

/// The colours of a block, by their channels.
struct BlockColours {
    Block<float> red, green, blue;

    glm::vec3 at(std::size_t i) const { return {red[i], green[i], blue[i]}; }
};

/// What depth_test() says about each pixel; stores what has passed.
/// @return how many have passed
int test_depths(const Block<float>& depth, std::size_t count, const BlockPlanes& at,
                Block<int>& passed) {
    int sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const float stored = at.depth[i];
        const bool is_nearer = depth[i] > stored;
        at.depth[i] = is_nearer ? depth[i] : stored;
        passed[i] = is_nearer;
        sum += is_nearer;
    }
    return sum;
}

template <class Shader>
void shade(const Shader& shader, const typename Shader::Walk::Walked& walked, std::size_t count,
           BlockColours& colours) {
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 colour = shader(walked, i);
        colours.red[i] = colour.x;
        colours.green[i] = colour.y;
        colours.blue[i] = colour.z;
    }
}

void put_pixels(const BlockColours& colours, const Block<int>& passed, bool have_all_passed,
                std::size_t count, int triangle, const BlockPlanes& at) {
    for (std::size_t i = 0; i < count; ++i)
        at.owner[i] = passed[i] != 0 ? triangle : at.owner[i];
    // Colours are three floats apart: several are stored at once only if there is no choice.
    if (have_all_passed) {
        for (std::size_t i = 0; i < count; ++i)
            at.colour[i] = colours.at(i);
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (passed[i] != 0) at.colour[i] = colours.at(i);
    }
}

template <class Shader>
int draw_row(const RowPart& part, const RowSurface& of, Framebuffer& target) {
    typename Shader::Walk walk(part, of.stages);
    const Shader shader(of);
    typename Shader::Walk::Walked walked;
    Block<int> passed;
    BlockColours colours;
    int shaded = 0;
    const std::size_t end = part.pixel + static_cast<std::size_t>(part.drawn);
    for (std::size_t pixel = part.pixel; pixel < end; pixel += block_size) {
        const std::size_t count = std::min(end - pixel, block_size);
        const BlockPlanes at(target, pixel);
        walk.walk(count, walked);
        for (std::size_t i = 0; i < count; ++i)
            ++at.overdraw[i];
        const int nearer = test_depths(walked.depth(), count, at, passed);
        if (nearer == 0) continue;
        shade(shader, walked, count, colours);
        put_pixels(colours, passed, nearer == static_cast<int>(count), count, part.triangle, at);
        shaded += nearer;
    }
    return shaded;
}

template <LightSide side>
int draw_row_by_corners(const RowPart& part, const RowSurface& of, Framebuffer& target) {
    return of.surface.differences.normals ? draw_row<BentPixelLight<side>>(part, of, target)
                                          : draw_row<FlatPixelLight<side>>(part, of, target);
}

/// Are a row's values walked as RowWalk does, and tested and put as draw_row() does?
bool has_lab_rows(const Frame& frame) {
    const Stages& stages = frame.stages;
    const bool is_walked =
        stages.row_fragments == row_fragments && stages.line_step == line_step &&
        stages.interpolate == interpolate && stages.span_end == span_end &&
        (stages.recovery_weight == varying_weight || stages.recovery_weight == varying_weight_one);
    const bool is_tested = stages.cull_fragment == keep_fragment &&
                           stages.depth_test == depth_test && stages.depth_cell == depth_cell &&
                           frame.settings.depth_order == DepthOrder::after_depth_test;
    return is_walked && is_tested && !frame.blends;
}

/// Do all surfaces have just one reflectance each, and the lab's light?
bool has_lab_surfaces(const Frame& frame) {
    const Stages& stages = frame.stages;
    const bool is_plain = !is_textured(frame) && !frame.bends && occluders_of(frame) == nullptr;
    if (stages.pixel_shader == pixel_shader) return is_plain;
    return is_plain && stages.pixel_shader == surface_shader &&
           !frame.scene->mesh.differences().colours &&
           frame.settings.light.model == LightModel::lambert &&
           stages.light_normal == light_normal && stages.unit_normal == unit_normal;
}

} // namespace

RowKernel row_kernel_of(const Frame& frame) {
    if (!has_lab_rows(frame) || !has_lab_surfaces(frame)) return nullptr;
    switch (shading_rule(frame.settings)) {
    case Shading::unlit:
    case Shading::flat:
        return draw_row<OneColour>;
    case Shading::gouraud:
        return draw_row<VertexLight>;
    case Shading::phong:
        break;
    }
    const Stages& stages = frame.stages;
    if (stages.reflected_light != reflected_light) return nullptr;
    if (stages.pixel_shader != surface_shader) return draw_row<FlatPixelLight<side_of_normal>>;
    if (stages.light_side == side_of_normal) return draw_row_by_corners<side_of_normal>;
    if (stages.light_side == side_of_eye) return draw_row_by_corners<side_of_eye>;
    return nullptr;
}

} // namespace rasterwalk
