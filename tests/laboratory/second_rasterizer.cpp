#include "laboratory/second_rasterizer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rasterwalk::test {

namespace {

/// The lab's Pixel: a place in the picture, and what is interpolated with it.
struct Sample {
    float x = 0.0f, y = 0.0f;
    float zinv = 0.0f;
    glm::vec3 carried{0.0f}; ///< position or light, times 1/z where it is perspective-correct
};

Sample operator+(const Sample& a, const Sample& b) {
    return {a.x + b.x, a.y + b.y, a.zinv + b.zinv, a.carried + b.carried};
}
Sample operator-(const Sample& a, const Sample& b) {
    return {a.x - b.x, a.y - b.y, a.zinv - b.zinv, a.carried - b.carried};
}
Sample operator*(const Sample& a, float s) {
    return {a.x * s, a.y * s, a.zinv * s, a.carried * s};
}
Sample operator/(const Sample& a, float s) {
    return {a.x / s, a.y / s, a.zinv / s, a.carried / s};
}

int whole(float value, bool is_rounded) {
    return static_cast<int>(is_rounded ? std::floor(value + 0.5f) : value);
}

enum class LineOf { edge, row };

/// Interpolate() of the lab: `count` samples from a to b.
std::vector<Sample> interpolate(const Sample& a, const Sample& b, int count, LineOf line,
                                const StudentProgram& program) {
    const StudentMistakes& wrong = program.mistakes;
    const int steps = wrong.step_over_count ? count : std::max(count - 1, 1);
    Sample step = (b - a) / static_cast<float>(steps);
    if (wrong.whole_steps) {
        step.x = static_cast<float>(static_cast<int>(b.x - a.x) / steps);
        step.y = static_cast<float>(static_cast<int>(b.y - a.y) / steps);
    }
    if (wrong.depth_falls_along_row && line == LineOf::row) step.zinv = -step.zinv;
    std::vector<Sample> result(static_cast<std::size_t>(count));
    Sample current = a;
    for (int i = 0; i < count; ++i) {
        const auto k = static_cast<float>(i);
        if (program.walk == Walk::multiply_step) current = a + step * k;
        if (program.walk == Walk::blend_ends) {
            const float t = k / static_cast<float>(steps);
            current = a * (1.0f - t) + b * t;
        }
        Sample& sample = result[static_cast<std::size_t>(i)];
        sample = current;
        sample.x = static_cast<float>(whole(current.x, program.lines_rounded));
        sample.y = static_cast<float>(whole(current.y, program.lines_rounded));
        if (line == LineOf::row) sample.x = a.x + k; // columns are counted
        if (program.walk == Walk::add_steps) current = current + step;
    }
    return result;
}

int edge_samples(const Sample& a, const Sample& b, const StudentMistakes& wrong) {
    const int dx = static_cast<int>(a.x) - static_cast<int>(b.x);
    const int dy = static_cast<int>(a.y) - static_cast<int>(b.y);
    if (wrong.edges_by_rows) return std::abs(dy) + 1;
    if (wrong.one_inside_abs) return std::max({std::abs(dx + 1), std::abs(dy + 1), 1});
    return std::max(std::abs(dx), std::abs(dy)) + 1;
}

/// leftPixels and rightPixels of one triangle.
struct RowTable {
    int first_row = 0;
    std::vector<Sample> left, right;
};

void replace(Sample& end, const Sample& sample, const StudentMistakes& wrong) {
    if (wrong.ends_take_only_x) {
        end.x = sample.x;
    } else {
        end = sample;
    }
}

RowTable row_table(const std::array<Sample, 3>& corners, const StudentProgram& program) {
    const StudentMistakes& wrong = program.mistakes;
    const auto [lowest, highest] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    RowTable table;
    table.first_row = static_cast<int>(lowest);
    const int rows = static_cast<int>(highest) - table.first_row + (wrong.last_row_lost ? 0 : 1);
    const auto size = static_cast<std::size_t>(rows);
    Sample left, right;
    left.x = wrong.rows_begin_at_window ? static_cast<float>(program.width) : 1e9f;
    right.x = wrong.rows_begin_at_window ? 0.0f : -1e9f;
    table.left.assign(size, left);
    table.right.assign(size, right);
    for (std::size_t i = 0; i < (wrong.third_edge_lost ? 2u : 3u); ++i) {
        const Sample& a = corners[i];
        const Sample& b = corners[(i + 1) % 3];
        std::vector<Sample> edge =
            interpolate(a, b, edge_samples(a, b, wrong), LineOf::edge, program);
        if (wrong.last_sample_lost) edge.pop_back();
        for (const Sample& sample : edge) {
            int row = static_cast<int>(sample.y) - table.first_row;
            if (wrong.samples_clamped) row = std::clamp(row, 0, std::max(rows - 1, 0));
            if (row < 0 || row >= rows) continue;
            const auto r = static_cast<std::size_t>(row);
            if (sample.x < table.left[r].x) replace(table.left[r], sample, wrong);
            if (sample.x > table.right[r].x) replace(table.right[r], sample, wrong);
        }
    }
    return table;
}

glm::vec3 reflected(const StudentProgram& program, const StudentPoint& point) {
    const StudentMistakes& wrong = program.mistakes;
    const glm::vec3 lamp_light = student_lamp_light(program, point.position, point.normal);
    glm::vec3 light = point.colour * (lamp_light + program.indirect);
    if (wrong.reflectance_added) light = lamp_light + point.colour;
    if (wrong.reflectance_twice) light *= point.colour;
    return program.change_light ? program.change_light(program, light, point) : light;
}

/// The three corners of a triangle on the screen, and whether it is drawn at all.
struct CameraTriangle {
    std::array<Sample, 3> corners;
    bool is_seen = true;
};

glm::vec3 to_camera(glm::vec3 v, const StudentProgram& program) {
    const StudentMistakes& wrong = program.mistakes;
    const float c = std::cos(program.yaw);
    const float s = wrong.rotation_transposed ? -std::sin(program.yaw) : std::sin(program.yaw);
    const auto turned = [&](glm::vec3 p) {
        return glm::vec3(c * p.x - s * p.z, p.y, s * p.x + c * p.z);
    };
    if (wrong.camera_added) return turned(v + program.camera);
    if (wrong.rotated_first) return turned(v) - program.camera;
    return turned(v - program.camera);
}

int to_pixel(float along, float z, float zinv, float focal_length, int size,
             const StudentProgram& program) {
    const int half = program.mistakes.half_forgotten ? 0 : size / 2;
    float x = 0.0f;
    switch (program.vertex_product) {
    case VertexProduct::by_zinv:
        x = focal_length * along * zinv;
        break;
    case VertexProduct::zinv_first:
        x = focal_length * (along * zinv);
        break;
    case VertexProduct::by_z:
        x = focal_length * along / z;
        break;
    case VertexProduct::z_first:
        x = focal_length * (along / z);
        break;
    }
    switch (program.vertex_cut) {
    case VertexCut::floor:
        return static_cast<int>(std::floor(x)) + half;
    case VertexCut::round:
        return static_cast<int>(std::round(x)) + half;
    case VertexCut::sum_cut:
        return static_cast<int>(x + static_cast<float>(half));
    case VertexCut::cut:
        break;
    }
    return static_cast<int>(x) + half;
}

/// VertexShader() of the lab for all three.
CameraTriangle camera_triangle(const StudentTriangle& triangle, const StudentProgram& program) {
    const StudentMistakes& wrong = program.mistakes;
    CameraTriangle seen;
    if (wrong.culled_by_lamp &&
        glm::dot(triangle.normal, program.lamp - triangle.corners[0]) < 0.0f)
        seen.is_seen = false;
    const float f = (wrong.focal_length_negative ? -1.0f : 1.0f) * program.zoom *
                    static_cast<float>(program.height);
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3 p = to_camera(triangle.corners[i], program);
        if (p.z <= 0.0f) seen.is_seen = false;
        const float z = wrong.distance_for_z ? glm::length(p) : p.z;
        Sample& corner = seen.corners[i];
        corner.zinv = 1.0f / z;
        const float across = wrong.axes_exchanged ? p.y : p.x;
        const float down = wrong.axes_exchanged ? p.x : p.y;
        if (wrong.dropped_partly_outside &&
            (std::abs(f * across) > 0.5f * static_cast<float>(program.width) * z ||
             std::abs(f * down) > 0.5f * static_cast<float>(program.height) * z))
            seen.is_seen = false;
        if (!seen.is_seen) continue;
        corner.x = static_cast<float>(to_pixel(across, z, corner.zinv, f, program.width, program));
        corner.y = static_cast<float>(to_pixel(down, z, corner.zinv, f, program.height, program));
        bool is_straight = wrong.position_straight;
        corner.carried = triangle.corners[i];
        if (program.stage == StudentStage::vertex_light) {
            is_straight = is_straight || program.vertex_light_straight;
            corner.carried = reflected(program, {triangle.corners[i], triangle.normal,
                                                 triangle.colour, triangle.number, corner.zinv});
        }
        if (!is_straight) corner.carried *= corner.zinv;
    }
    return seen;
}

/// The position or the light that the pixel shader gets back from an interpolated sample.
glm::vec3 taken(const Sample& sample, const StudentProgram& program) {
    const StudentMistakes& wrong = program.mistakes;
    const bool is_light = program.stage == StudentStage::vertex_light;
    if (wrong.position_straight || (is_light && program.vertex_light_straight))
        return sample.carried;
    if (wrong.never_divided) return sample.carried;
    if (wrong.divided_twice) return sample.carried / sample.zinv / sample.zinv;
    return sample.carried / sample.zinv;
}

/// The colours of the window, and the depth buffer.
struct Screen {
    const StudentProgram& program;
    std::vector<glm::vec3> colours;
    std::vector<float> depths;

    explicit Screen(const StudentProgram& of) : program(of) {
        const auto size = static_cast<std::size_t>(of.width) * static_cast<std::size_t>(of.height);
        colours.assign(size, glm::vec3(0.0f));
        depths.assign(size, of.mistakes.depth_clear);
    }

    bool is_nearer(float depth, float kept) const {
        const StudentMistakes& wrong = program.mistakes;
        if (wrong.depth_reversed) return depth < kept;
        if (wrong.depth_or_equal) return depth >= kept;
        return depth > kept + wrong.depth_epsilon;
    }

    /// PixelShader() of the lab.
    void shade(const Sample& sample, int row, const StudentTriangle& triangle) {
        const int x = static_cast<int>(sample.x);
        const int first = program.mistakes.zero_is_outside ? 1 : 0;
        if (x < first || row < first || x >= program.width || row >= program.height) return;
        const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(program.width) +
                        static_cast<std::size_t>(x);
        if (program.stage != StudentStage::fill) {
            const float depth = program.change_depth
                                    ? program.change_depth(sample.zinv, triangle.number)
                                    : sample.zinv;
            if (!is_nearer(depth, depths[at])) return;
            depths[at] = depth;
        }
        glm::vec3 colour = triangle.colour;
        if (program.stage == StudentStage::vertex_light) colour = taken(sample, program);
        if (program.stage == StudentStage::pixel_light)
            colour = reflected(program, {taken(sample, program), triangle.normal, triangle.colour,
                                         triangle.number, sample.zinv});
        colours[at] = program.change_mix ? program.change_mix(colour, colours[at]) : colour;
    }
};

void draw_rows(const RowTable& table, const StudentTriangle& triangle, Screen& screen) {
    const StudentMistakes& wrong = screen.program.mistakes;
    for (std::size_t r = 0; r < table.left.size(); ++r) {
        Sample left = table.left[r], right = table.right[r];
        const int row = table.first_row + static_cast<int>(r);
        const int count = static_cast<int>(right.x) - static_cast<int>(left.x) + 1;
        if (left.x > right.x || row < 0 || row >= screen.program.height) continue;
        if (wrong.single_pixels_skipped && count == 1) continue;
        if (wrong.multiplied_twice) {
            left.carried *= left.zinv;
            right.carried *= right.zinv;
        }
        std::vector<Sample> samples = interpolate(left, right, count, LineOf::row, screen.program);
        if (wrong.last_column_lost) samples.pop_back();
        for (const Sample& sample : samples)
            screen.shade(sample, row, triangle);
    }
}

std::uint8_t to_byte(float channel, const StudentProgram& program) {
    if (!(channel > 0.0f)) return 0; // nor NaN
    const StudentMistakes& wrong = program.mistakes;
    if (wrong.gamma_applied) channel = std::pow(channel, 1.0f / 2.2f);
    const float half = program.bytes_rounded ? 0.5f : 0.0f;
    if (wrong.colour_wraps)
        return static_cast<std::uint8_t>(static_cast<int>(255.0f * std::min(channel, 1e6f) + half) &
                                         255);
    return static_cast<std::uint8_t>(255.0f * std::min(channel, 1.0f) + half);
}

} // namespace

StudentProgram StudentProgram::without_mistakes() const {
    StudentProgram right = *this;
    right.mistakes = {};
    right.change_room = {};
    right.change_depth = {};
    right.change_light = {};
    right.change_mix = {};
    right.change_picture = {};
    return right;
}

glm::vec3 student_lamp_light(const StudentProgram& program, glm::vec3 position, glm::vec3 normal) {
    const StudentMistakes& wrong = program.mistakes;
    glm::vec3 r = program.lamp - position;
    if (wrong.light_vector_reversed) r = -r;
    const float w = wrong.light_vector_with_w ? 1.0f : 0.0f;
    const float squared = glm::dot(r, r) + w;
    const float length = std::sqrt(squared);
    if (!wrong.light_vector_as_long) r /= length;
    float pi = 3.14159265f;
    if (wrong.pi_by_wrong_atan) pi = std::atan(1.0f) / 4.0f;
    if (wrong.pi_is_three) pi = 3.0f;
    float area = 4.0f * pi * squared;
    if (wrong.four_pi_forgotten) area = squared;
    if (wrong.distance_cubed) area *= length;
    return program.power * std::max(glm::dot(r, normal), 0.0f) / area;
}

Image draw(const StudentProgram& program) {
    std::vector<StudentTriangle> room = student_room();
    if (program.change_room) program.change_room(room);
    Screen screen(program);
    for (const StudentTriangle& triangle : room) {
        const CameraTriangle seen = camera_triangle(triangle, program);
        if (seen.is_seen) draw_rows(row_table(seen.corners, program), triangle, screen);
    }
    Image image{program.width, program.height, {}};
    for (const glm::vec3& colour : screen.colours) {
        const std::uint8_t red = to_byte(colour.r, program), blue = to_byte(colour.b, program);
        const bool is_swapped = program.mistakes.red_and_blue_swapped;
        image.rgba.push_back(is_swapped ? blue : red);
        image.rgba.push_back(to_byte(colour.g, program));
        image.rgba.push_back(is_swapped ? red : blue);
        image.rgba.push_back(255);
    }
    if (program.change_picture) program.change_picture(image);
    return image;
}

} // namespace rasterwalk::test
