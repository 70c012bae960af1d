#include "mine/functions/questions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/dice.h"
#include "stages/edges.h"
#include "stages/polygon_rows.h"
#include "stages/stage_table.h"

namespace rasterwalk {

namespace {

using rasterwalk_kit::PixelValues;

constexpr double all_fields = rasterwalk_kit::field_xy | rasterwalk_kit::field_zinv |
                              rasterwalk_kit::field_place | rasterwalk_kit::field_light;

/// Sides of the pictures for which edges and rows are made, pixels. Every list of pixels then stays
/// below most_listed, and every question fits.
constexpr int largest_side = 500, small_side = 120;

PixelValues pixel(int x, int y, float zinv, const glm::vec3& place, const glm::vec3& light) {
    PixelValues made{all_fields, static_cast<double>(x), static_cast<double>(y), double{zinv}, {},
                     {}};
    for (int i = 0; i < 3; ++i) {
        made.place[i] = double{place[i]};
        made.light[i] = double{light[i]};
    }
    return made;
}

int whole(Dice& dice, int lowest, int highest) {
    return lowest + static_cast<int>(dice.below(static_cast<std::size_t>(highest - lowest + 1)));
}

float real(Dice& dice, float lowest, float highest) {
    return lowest + (highest - lowest) * static_cast<float>(dice.share());
}

glm::vec3 real3(Dice& dice, float lowest, float highest) {
    const float x = real(dice, lowest, highest), y = real(dice, lowest, highest);
    return {x, y, real(dice, lowest, highest)};
}

/// A pixel with values that a point of a room can have.
PixelValues random_pixel(Dice& dice, int lowest, int highest) {
    const int x = whole(dice, lowest, highest), y = whole(dice, lowest, highest);
    const float zinv = real(dice, 0.2f, 0.6f);
    const glm::vec3 place = zinv * real3(dice, -1.0f, 1.0f);
    return pixel(x, y, zinv, place, real3(dice, 0.1f, 1.0f));
}

/// The side of the square pictures that are asked about.
int side_of(const KnownProgram& program, int largest) {
    return std::max(std::min({program.viewport.width, program.viewport.height, largest}), 8);
}

/// The room as the lab's camera sees it in a picture of this size.
ScreenVertex projected(const Vertex& vertex, int side) {
    VertexRules rules;
    rules.viewport = {side, side};
    rules.camera.focal_length = static_cast<float>(side);
    const Stages stages;
    return shade_vertex(vertex, camera_rotation(rules.camera), rules, stages).pixel;
}

PixelValues to_values(const ScreenVertex& at, const Vertex& vertex) {
    const glm::vec3 light = vertex.reflectance * (0.5f + 0.25f * (vertex.position.y + 1.0f));
    return pixel(at.column, at.row, at.depth, vertex.position * at.depth, light);
}

std::vector<PixelValues> room_triangle(const Scene& room, int triangle, int side) {
    std::vector<PixelValues> corners;
    for (int i = 0; i < triangle_corners; ++i) {
        const Vertex& vertex = room.corner(triangle, i);
        corners.push_back(to_values(projected(vertex, side), vertex));
    }
    return corners;
}

int longest_axis_count(const PixelValues& a, const PixelValues& b) {
    ScreenVertex from, to;
    from.column = static_cast<int>(a.x), from.row = static_cast<int>(a.y);
    to.column = static_cast<int>(b.x), to.row = static_cast<int>(b.y);
    return edge_sample_count(from, to);
}

std::vector<VertexQuestion> vertex_questions(const Scene& room, const KnownProgram& program) {
    std::vector<VertexQuestion> made;
    for (int t = 0; t < room.triangle_count(); ++t) {
        for (int i = 0; i < triangle_corners; ++i) {
            const Vertex& vertex = room.corner(t, i);
            made.push_back({vertex.position, vertex.normal, vertex.reflectance});
        }
    }
    Dice dice(1);
    const glm::mat3 rotation = camera_rotation(program.camera);
    const float reach =
        0.7f * static_cast<float>(program.viewport.width) / program.camera.focal_length;
    for (int i = 0; i < 200; ++i) {
        const float z = real(dice, 0.5f, 6.0f);
        const float x = z * reach * real(dice, -1.0f, 1.0f);
        const glm::vec3 in_camera(x, z * reach * real(dice, -1.0f, 1.0f), z);
        // R is a rotation, so R p undoes p R.
        const glm::vec3 position = rotation * in_camera + program.camera.position;
        const glm::vec3 normal = glm::normalize(real3(dice, -1.0f, 1.0f) + glm::vec3(0, 0, 1.5f));
        made.push_back({position, normal, real3(dice, 0.1f, 1.0f)});
    }
    return made;
}

std::vector<LineQuestion> line_questions(const Scene& room, const KnownProgram& program) {
    Dice dice(2);
    std::vector<LineQuestion> made;
    const auto ask = [&](const PixelValues& a, const PixelValues& b) {
        made.push_back({a, b, longest_axis_count(a, b)});
    };
    // The lab's printed example.
    PixelValues a = random_pixel(dice, 0, 9), b = random_pixel(dice, 0, 9);
    a.x = 4, a.y = 2, b.x = 1, b.y = 8;
    made.push_back({a, b, 4});
    std::vector<PixelValues> single;
    const int side = side_of(program, largest_side);
    for (int t = 0; t < room.triangle_count(); ++t) {
        const std::vector<PixelValues> corners = room_triangle(room, t, side);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const PixelValues& next = corners[(i + 1) % corners.size()];
            const bool is_point = corners[i].x == next.x && corners[i].y == next.y;
            if (!is_point) ask(corners[i], next);
        }
    }
    for (int i = 0; i < 200; ++i) {
        const PixelValues from = random_pixel(dice, 0, 300);
        PixelValues to = random_pixel(dice, 0, 300);
        // Some short ones, and both directions of both axes.
        if (i % 4 == 0) to.x = from.x + whole(dice, -9, 9), to.y = from.y + whole(dice, -9, 9);
        if (i == 11 || i == 12) to.x = from.x;
        if (i == 13 || i == 14) to.y = from.y;
        if (from.x == to.x && from.y == to.y) to.x += 1.0;
        ask(from, to);
    }
    for (int i = 0; i < 6; ++i) {
        const PixelValues point = random_pixel(dice, 0, 300);
        ask(point, point);
    }
    return made;
}

std::vector<PolygonQuestion> polygon_questions(const Scene& room,
                                               std::span<const BenchTriangle> bench,
                                               const KnownProgram& program) {
    Dice dice(3);
    std::vector<PolygonQuestion> made;
    const auto at = [&](int x, int y) {
        PixelValues corner = random_pixel(dice, 0, 1);
        corner.x = x, corner.y = y;
        return corner;
    };
    made.push_back({{at(10, 20), at(30, 10), at(20, 40)}, "the lab's triangle of 31 rows"});
    made.push_back({{at(10, 5), at(5, 10), at(15, 15)}, "the lab's triangle of 11 rows"});
    const int side = side_of(program, largest_side);
    for (int t = 0; t < room.triangle_count(); ++t)
        made.push_back({room_triangle(room, t, side), fmt::format("triangles[{}]", t)});
    for (std::size_t i = 0; i < bench.size(); ++i) {
        std::vector<PixelValues> corners;
        for (const glm::vec3& corner : bench[i])
            corners.push_back(at(static_cast<int>(corner.x), static_cast<int>(corner.y)));
        made.push_back({corners, fmt::format("example {} of the bench", i)});
    }
    for (int i = 0; i < 200; ++i) {
        // The last forty are to the left of the picture or to its right.
        std::vector<PixelValues> corners;
        const int shift = i < 160 ? 0 : i < 180 ? -400 : program.viewport.width + 20;
        for (int corner = 0; corner < triangle_corners; ++corner) {
            corners.push_back(random_pixel(dice, 0, i % 3 == 0 ? 40 : 200));
            corners.back().x += shift;
        }
        made.push_back({corners, fmt::format("random triangle {}", i)});
    }
    made.push_back({{at(20, 30), at(60, 30), at(40, 30)}, "a horizontal line"});
    made.push_back({{at(20, 30), at(20, 60), at(20, 45)}, "a vertical line"});
    made.push_back({{at(20, 30), at(20, 30), at(20, 30)}, "a point"});
    return made;
}

/// Makes the values of a question larger than all before it, so that its fragments are nearest even
/// if the program's depth buffer was not cleared.
void bring_nearer(RowsQuestion& question, double factor) {
    for (std::vector<PixelValues>* const ends : {&question.left, &question.right}) {
        for (PixelValues& end : *ends) {
            end.zinv = static_cast<double>(static_cast<float>(end.zinv * factor));
            for (double& value : end.place)
                value = static_cast<double>(static_cast<float>(value * factor));
        }
    }
}

PixelValues end_values(const RowEnd& end, int row) {
    return pixel(end.column, row, end.depth, end.varyings.position_world,
                 end.varyings.illumination);
}

RowsQuestion rows_of_triangle(const Scene& room, int triangle, int side) {
    std::vector<ScreenVertex> corners;
    for (int i = 0; i < triangle_corners; ++i) {
        const Vertex& vertex = room.corner(triangle, i);
        ScreenVertex at = projected(vertex, side);
        at.varyings.position_world = vertex.position * at.depth;
        at.varyings.illumination = vertex.reflectance;
        corners.push_back(at);
    }
    PolygonRows rows;
    compute_polygon_rows(corners, {}, Stages{}, rows, nullptr);
    RowsQuestion made;
    made.colour = room.corner(triangle, 0).reflectance;
    made.name = fmt::format("the rows of triangles[{}]", triangle);
    for (int i = 0; i < rows.size(); ++i) {
        if (rows.is_empty_row(i)) continue;
        const auto index = static_cast<std::size_t>(i);
        made.left.push_back(end_values(rows.left[index], rows.first_row + i));
        made.right.push_back(end_values(rows.right[index], rows.first_row + i));
    }
    return made;
}

RowsQuestion row_of(Dice& dice, int left, int right, int row, std::string name) {
    RowsQuestion made;
    made.colour = real3(dice, 0.2f, 0.9f);
    made.name = std::move(name);
    made.left.push_back(random_pixel(dice, 0, 1));
    made.right.push_back(random_pixel(dice, 0, 1));
    made.left[0].x = left, made.right[0].x = right;
    made.left[0].y = made.right[0].y = row;
    return made;
}

std::vector<RowsQuestion> rows_questions(const Scene& room, const KnownProgram& program) {
    Dice dice(4);
    std::vector<RowsQuestion> made;
    const int side = side_of(program, small_side);
    for (int t = 0; t < room.triangle_count(); ++t)
        made.push_back(rows_of_triangle(room, t, side));
    for (int i = 0; i < 3; ++i) {
        const int x = whole(dice, 1, side - 2), y = whole(dice, 1, side - 2);
        made.push_back(row_of(dice, x, x, y, "a row of one pixel"));
    }
    made.push_back(row_of(dice, 0, side - 1, 0, "a row in row 0 of the picture"));
    made.push_back(row_of(dice, empty_left, empty_right, side / 2, "an empty row"));
    made.push_back(row_of(dice, -5, 4, side / 2, "a row that begins left of the picture"));
    const int width = program.viewport.width;
    made.push_back(
        row_of(dice, width - 3, width + 4, side / 2, "a row that ends right of the picture"));
    made.push_back(row_of(dice, 2, 6, -1, "a row above the picture"));
    double factor = 4.0;
    for (RowsQuestion& question : made) {
        bring_nearer(question, factor);
        factor *= 3.5; // 1/z differs by less than that within a question
    }
    return made;
}

std::vector<DepthQuestion> depth_questions(const KnownProgram& program) {
    Dice dice(5);
    const int side = side_of(program, small_side);
    std::vector<DepthQuestion> made;
    float base = 1.0f;
    const auto fragment = [&](int x, int y, float zinv) {
        DepthFragment one;
        one.at = pixel(x, y, zinv, zinv * real3(dice, -1.0f, 1.0f), real3(dice, 0.2f, 1.0f));
        one.colour = real3(dice, 0.2f, 0.9f);
        return one;
    };
    struct Pair {
        const char* name;
        float first, second; ///< added to the question's 1/z
    };
    constexpr Pair pairs[] = {
        {"a far fragment behind a near one", 0.2f, 0.1f},
        {"a near fragment in front of a far one", 0.1f, 0.2f},
        {"two fragments that are equally near", 0.1f, 0.1f},
        {"a fragment nearer by a hundredth", 0.1f, 0.11f},
        {"a fragment nearer by half a ten-thousandth", 0.1f, 0.10005f},
    };
    for (int turn = 0; turn < 4; ++turn) {
        for (const Pair& pair : pairs) {
            const int x = whole(dice, 0, side - 1), y = whole(dice, 0, side - 1);
            made.push_back({{fragment(x, y, base + pair.first), fragment(x, y, base + pair.second)},
                            pair.name});
            base += 0.25f;
        }
        const int x = whole(dice, 0, side / 2 - 1), y = whole(dice, side / 2, side - 1);
        made.push_back({{fragment(x, y, base + 0.2f), fragment(y, x, base + 0.1f),
                         fragment(x, y, base + 0.05f)},
                        "fragments on two pixels"});
        base += 0.25f;
    }
    return made;
}

std::vector<ShaderQuestion> shader_questions(const Scene& room, const KnownProgram& program) {
    Dice dice(6);
    const int side = side_of(program, largest_side);
    std::vector<ShaderQuestion> made;
    float zinv = 1.0f;
    for (int i = 0; i < 120; ++i) {
        const int triangle = i % room.triangle_count();
        const float u = real(dice, 0.05f, 0.9f);
        const float v = real(dice, 0.0f, 0.95f - u);
        const Vertex& corner = room.corner(triangle, 0);
        const glm::vec3 position = corner.position * (1.0f - u - v) +
                                   room.corner(triangle, 1).position * u +
                                   room.corner(triangle, 2).position * v;
        const int x = whole(dice, 0, side - 1), y = whole(dice, 0, side - 1);
        made.push_back({pixel(x, y, zinv, position * zinv, real3(dice, 0.2f, 1.0f)), corner.normal,
                        corner.reflectance, position});
        zinv += 0.03125f;
    }
    return made;
}

} // namespace

Questions make_questions(const Scene& room, std::span<const BenchTriangle> bench,
                         const KnownProgram& program) {
    Questions made;
    made.program = program;
    made.vertices = vertex_questions(room, program);
    made.lines = line_questions(room, program);
    made.polygons = polygon_questions(room, bench, program);
    made.rows = rows_questions(room, program);
    made.depths = depth_questions(program);
    made.points = shader_questions(room, program);
    const int count = room.triangle_count();
    using namespace rasterwalk_kit;
    made.fed[part_vertex_shader] =
        fmt::format("the room's {} vertices and 200 random points", triangle_corners * count);
    made.fed[part_interpolate] =
        "the lab's example, the edges of the room, 200 random lines and single points";
    made.fed[part_polygon_rows] =
        fmt::format("the lab's 2 triangles, the room's {}, {} examples of the bench, 200 random "
                    "triangles, two lines and a point",
                    count, bench.size());
    made.fed[part_draw_rows] = fmt::format(
        "the rows of the room's {} triangles, rows of one pixel, an empty row, and rows that reach "
        "outside the picture",
        count);
    made.fed[part_depth_test] = fmt::format("{} groups of fragments", made.depths.size());
    made.fed[part_pixel_shader] = fmt::format("{} points of the room", made.points.size());
    return made;
}

} // namespace rasterwalk
