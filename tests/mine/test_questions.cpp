#include <set>

#include "mine/checked_student.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using rasterwalk_kit::PixelValues;

namespace {

Questions questions_for(Viewport viewport) {
    const Scene room = lab_room();
    return make_questions(room, {}, {room.camera, room.light, viewport, false, {}});
}

bool is_float(double value) {
    return static_cast<double>(static_cast<float>(value)) == value;
}

/// Whole pixels, and values that a float holds exactly.
bool is_exact(const PixelValues& values) {
    bool exact = values.fields == 15.0 && values.x == std::floor(values.x) &&
                 values.y == std::floor(values.y) && is_float(values.zinv) && values.zinv > 0.0;
    for (int i = 0; i < 3; ++i)
        exact = exact && is_float(values.place[i]) && is_float(values.light[i]);
    return exact;
}

std::vector<PixelValues> all_pixels(const Questions& questions) {
    std::vector<PixelValues> all;
    for (const LineQuestion& asked : questions.lines)
        all.insert(all.end(), {asked.a, asked.b});
    for (const PolygonQuestion& asked : questions.polygons)
        all.insert(all.end(), asked.corners.begin(), asked.corners.end());
    for (const RowsQuestion& asked : questions.rows) {
        all.insert(all.end(), asked.left.begin(), asked.left.end());
        all.insert(all.end(), asked.right.begin(), asked.right.end());
    }
    for (const DepthQuestion& asked : questions.depths) {
        for (const DepthFragment& fragment : asked.fragments)
            all.push_back(fragment.at);
    }
    for (const ShaderQuestion& asked : questions.points)
        all.push_back(asked.at);
    return all;
}

} // namespace

TEST_CASE("questions are whole pixels and exact floats") {
    const std::vector<PixelValues> all = all_pixels(asked_questions());
    CHECK(all.size() > 4000);
    CHECK(std::all_of(all.begin(), all.end(), is_exact));
}

TEST_CASE("questions are the same every time") {
    const Viewport picture{500, 500};
    CHECK(to_stream(questions_for(picture)).numbers == to_stream(questions_for(picture)).numbers);
}

TEST_CASE("all questions fit in the recording, and their parts in order") {
    for (const Viewport picture : {Viewport{500, 500}, Viewport{4096, 4096}, Viewport{100, 100},
                                   Viewport{320, 200}, Viewport{1, 1}}) {
        const QuestionStream stream = to_stream(questions_for(picture));
        CHECK(stream.numbers.size() <= rasterwalk_kit::most_questions);
        CHECK(stream.ends[rasterwalk_kit::part_globals] == 0);
        CHECK(std::is_sorted(stream.ends.begin(), stream.ends.end()));
        CHECK(stream.ends.back() == stream.numbers.size());
    }
}

TEST_CASE("a stream of questions is as the recording says") {
    const Questions& questions = asked_questions();
    const QuestionStream stream = to_stream(questions);
    const std::vector<double>& numbers = stream.numbers;
    // Position, normal and colour of 290 vertices.
    CHECK(stream.ends[rasterwalk_kit::part_vertex_shader] == 290u * 9u);
    CHECK(numbers[0] == double{questions.vertices[0].position.x});
    // The lab's example: (4,2) to (1,8) with 4 samples.
    const std::size_t line_at = 290 * 9;
    CHECK(numbers[line_at + 1] == 4.0);
    CHECK(numbers[line_at + 2] == 2.0);
    CHECK(numbers[line_at + 11] == 1.0);
    CHECK(numbers[line_at + 12] == 8.0);
    CHECK(numbers[line_at + 20] == 4.0);
    CHECK(stream.ends[rasterwalk_kit::part_interpolate] - line_at == questions.lines.size() * 21u);
    const std::size_t polygon_at = stream.ends[rasterwalk_kit::part_interpolate];
    CHECK(numbers[polygon_at] == 3.0);
    CHECK(numbers[polygon_at + 2] == 10.0);
    CHECK(numbers[polygon_at + 3] == 20.0);
}

TEST_CASE("lines go in all eight directions, and single points come last") {
    std::set<std::tuple<bool, bool, bool>> octants;
    bool had_point = false;
    for (const LineQuestion& asked : asked_questions().lines) {
        const double dx = asked.b.x - asked.a.x, dy = asked.b.y - asked.a.y;
        if (asked.count == 1) {
            had_point = true;
            CHECK(dx == 0.0);
            CHECK(dy == 0.0);
            continue;
        }
        CHECK_FALSE(had_point);
        octants.emplace(dx > 0.0, dy > 0.0, std::abs(dx) > std::abs(dy));
    }
    CHECK(had_point);
    CHECK(octants.size() == 8);
}

TEST_CASE("every point for VertexShader is in front of the camera") {
    const Scene room = lab_room();
    for (const VertexQuestion& asked : asked_questions().vertices)
        CHECK(asked.position.z - room.camera.position.z > 0.4f);
    // And of one that is turned and elsewhere.
    KnownProgram turned{room.camera, room.light, room.viewport, false, {}};
    turned.camera.yaw = 0.7f;
    turned.camera.position = {1.0f, 2.0f, 3.0f};
    const Questions questions = make_questions(room, {}, turned);
    const glm::vec3 forward = camera_rotation(turned.camera)[2];
    for (std::size_t i = 90; i < questions.vertices.size(); ++i) {
        const glm::vec3 away = questions.vertices[i].position - turned.camera.position;
        CHECK(glm::dot(away, forward) > 0.4f);
    }
}

TEST_CASE("each question about depth is nearer than all before it") {
    double nearest = 0.0;
    for (const DepthQuestion& asked : asked_questions().depths) {
        double now = nearest;
        for (const DepthFragment& fragment : asked.fragments) {
            CHECK(fragment.at.zinv > nearest);
            now = std::max(now, fragment.at.zinv);
        }
        nearest = now;
    }
    nearest = 0.0;
    for (const RowsQuestion& asked : asked_questions().rows) {
        double now = nearest;
        for (std::size_t i = 0; i < asked.left.size(); ++i) {
            CHECK(std::min(asked.left[i].zinv, asked.right[i].zinv) > nearest);
            CHECK(asked.left[i].y == asked.right[i].y);
            now = std::max({now, asked.left[i].zinv, asked.right[i].zinv});
        }
        nearest = now;
    }
}

TEST_CASE("only the last questions about rows leave the picture") {
    const std::vector<RowsQuestion>& rows = asked_questions().rows;
    for (std::size_t q = 0; q < rows.size(); ++q) {
        bool is_inside = true;
        for (std::size_t i = 0; i < rows[q].left.size(); ++i) {
            is_inside = is_inside && rows[q].left[i].x >= 0.0 && rows[q].right[i].x < 500.0 &&
                        rows[q].left[i].x <= rows[q].right[i].x && rows[q].left[i].y >= 0.0 &&
                        rows[q].left[i].y < 500.0;
        }
        INFO(rows[q].name);
        CHECK(is_inside == (q + 4 < rows.size()));
    }
}

TEST_CASE("no answer to a question about rows is longer than what is listed") {
    for (const RowsQuestion& asked : questions_for({4096, 4096}).rows) {
        double pixels = 0.0;
        for (std::size_t i = 0; i < asked.left.size(); ++i)
            pixels += std::max(asked.right[i].x - asked.left[i].x + 1.0, 0.0);
        CHECK(pixels <= static_cast<double>(rasterwalk_kit::most_listed));
    }
}
