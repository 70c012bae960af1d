#include "session/bench.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/limits.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "base/text_parts.h"

namespace rasterwalk {

namespace {

[[noreturn]] void refuse(std::string_view text) {
    throw UsageError(
        fmt::format("the vertices of a triangle are three positions with slashes between them, "
                    "like 10,5/5,10/15,15 or, for triangle 3, 3:10,5/5,10/15,15, and no farther "
                    "out than {} pixels, not {}.",
                    number_text(largest_pixel_coordinate), in_quotes(text)));
}

std::optional<float> parse_coordinate(std::string_view text, float smallest) {
    text = trimmed(text);
    float value = 0.0f;
    const char* const last = text.data() + text.size();
    const auto [end, fault] = std::from_chars(text.data(), last, value);
    const bool is_good = fault == std::errc{} && end == last && value >= smallest &&
                         value <= largest_pixel_coordinate;
    return is_good ? std::optional(value) : std::nullopt;
}

std::optional<glm::vec3> parse_position(std::string_view text) {
    const auto commas = std::count(text.begin(), text.end(), ',');
    if (commas != 1 && commas != 2) return std::nullopt;
    const auto x = parse_coordinate(take_part(text, ','), -largest_pixel_coordinate);
    const auto y = parse_coordinate(take_part(text, ','), -largest_pixel_coordinate);
    const auto z = commas == 2 ? parse_coordinate(text, smallest_pixel_depth) : 1.0f;
    return x && y && z ? std::optional(glm::vec3(*x, *y, *z)) : std::nullopt;
}

/// Moves all three corners of a triangle.
void put_corners(Scene& scene, int triangle, const std::array<glm::vec3, 3>& positions) {
    for (int v = 0; v < triangle_corners; ++v)
        scene.mesh.place_corner(triangle, v, positions[static_cast<std::size_t>(v)]);
}

} // namespace

bool is_bench(const Scene& scene) {
    return scene.space == SceneSpace::pixels;
}

void move_bench_vertex(Session& session, int triangle, int vertex, glm::ivec2 pixel) {
    if (!is_bench(*session.scene)) return;
    const int limit = static_cast<int>(max_pixel_distance);
    Scene scene = *session.scene;
    glm::vec3 position = scene.corner(triangle, vertex).position;
    position.x = static_cast<float>(std::clamp(pixel.x, -limit, limit));
    position.y = static_cast<float>(std::clamp(pixel.y, -limit, limit));
    scene.mesh.place_corner(triangle, vertex, position);
    session.scene = std::make_shared<const Scene>(std::move(scene));
}

std::string to_text(const PlacedTriangle& placed) {
    const auto place = [&](std::size_t v) {
        const glm::vec3& position = placed.positions[v];
        const std::string pixel = number_text(position.x) + "," + number_text(position.y);
        return position.z == 1.0f ? pixel : pixel + "," + number_text(position.z);
    };
    const std::string places = fmt::format("{}/{}/{}", place(0), place(1), place(2));
    return placed.triangle == 0 ? places : fmt::format("{}:{}", placed.triangle, places);
}

PlacedTriangle parse_placed_triangle(std::string_view text) {
    PlacedTriangle placed;
    std::string_view rest = text;
    if (rest.find(':') != rest.npos) {
        const std::optional<int> number = parse_int(take_part(rest, ':'));
        if (!number || *number < 0) refuse(text);
        placed.triangle = *number;
    }
    if (std::count(rest.begin(), rest.end(), '/') != 2) refuse(text);
    for (glm::vec3& position : placed.positions) {
        const std::optional<glm::vec3> read = parse_position(take_part(rest, '/'));
        if (!read) refuse(text);
        position = *read;
    }
    return placed;
}

void place_triangle(Session& session, const PlacedTriangle& placed) {
    if (!is_bench(*session.scene)) {
        throw UsageError(
            fmt::format("only the vertices of a scene in pixels can be moved, and {} is not such a "
                        "scene.",
                        in_quotes(session.scene->name)));
    }
    const int count = session.scene->triangle_count();
    if (placed.triangle < 0 || placed.triangle >= count) {
        throw UsageError(fmt::format("there is no triangle {} to move; the triangles are 0 to {}.",
                                     placed.triangle, count - 1));
    }
    Scene scene = *session.scene;
    put_corners(scene, placed.triangle, placed.positions);
    session.scene = std::make_shared<const Scene>(std::move(scene));
}

std::vector<PlacedTriangle> moved_triangles(const Scene& scene, const Scene& original) {
    std::vector<PlacedTriangle> moved;
    if (!is_bench(scene) || scene.triangle_count() != original.triangle_count()) return moved;
    for (int t = 0; t < scene.triangle_count(); ++t) {
        PlacedTriangle placed;
        placed.triangle = t;
        bool is_moved = false;
        for (int v = 0; v < triangle_corners; ++v) {
            const glm::vec3& position = scene.corner(t, v).position;
            placed.positions[static_cast<std::size_t>(v)] = position;
            is_moved = is_moved || position != original.corner(t, v).position;
        }
        if (is_moved) moved.push_back(placed);
    }
    return moved;
}

void show_bench_example(Session& session, const BenchExample& example) {
    if (!is_bench(*session.scene) || session.scene->triangle_count() == 0) return;
    Scene scene = *session.scene;
    put_corners(scene, 0, example.positions);
    session.scene = std::make_shared<const Scene>(std::move(scene));
    session.cursor = cursor_end;
    session.play.running = false;
}

} // namespace rasterwalk
