// Mistakes are named, or described, or honestly unknown; none is misnamed.

#include "mine/checked_student.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// From a point to the lamp.
struct LampRay {
    float length, cosine;
};

LampRay lamp_ray(const StudentPixel& pixel, const glm::vec3& normal) {
    const glm::vec3 r = student_lamp - pixel.place / pixel.zinv;
    return {glm::length(r), glm::dot(r, normal) / glm::length(r)};
}

constexpr float unit_sphere = 4.0f * student_pi;

Student student_with_changed_rows(void (*change)(RowStyle&)) {
    RowStyle style;
    change(style);
    return student_with_rows(style);
}

Student student_with_changed_draw(void (*change)(DrawStyle&)) {
    DrawStyle style;
    change(style);
    return student_with_draw(style);
}

Student student_with_depth(bool (*passes)(float zinv, float stored), float start) {
    Student student = handout_student();
    student.depth = [passes, start](float zinv, float& stored) {
        if (stored == 0.0f) stored = start;
        if (!passes(zinv, stored)) return false;
        stored = zinv;
        return true;
    };
    return student;
}

} // namespace

TEST_CASE("the laboratory's mistakes in VertexShader are named") {
    expect_bugs(student_with_pixels([](glm::vec3 p) {
                    return StudentPlace(std::trunc(-500.0f * p.x / p.z) + 250.0f,
                                        std::trunc(-500.0f * p.y / p.z) + 250.0f);
                }),
                vertex, {"B25"});
    expect_bugs(student_with_pixels([](glm::vec3 p) {
                    return StudentPlace(500.0f * p.y / p.z + 250.0f, 500.0f * p.x / p.z + 250.0f);
                }),
                vertex, {"B73"});
    expect_bugs(student_with_pixels([](glm::vec3 p) {
                    return StudentPlace(500.0f * p.x / p.z, 500.0f * p.y / p.z);
                }),
                vertex, {"B74"});
    expect_bugs(student_with_pixels([](glm::vec3 p) {
                    const float d = glm::length(p);
                    return StudentPlace(500.0f * p.x / d + 250.0f, 500.0f * p.y / d + 250.0f);
                }),
                vertex, {"B75"});
    // v + C
    expect_bugs(student_with_pixels([](glm::vec3 p) {
                    const float z = p.z - 6.002f;
                    return StudentPlace(500.0f * p.x / z + 250.0f, 500.0f * p.y / z + 250.0f);
                }),
                vertex, {"B70"});
}

TEST_CASE("mistakes in VertexShader that the laboratory lacks are described") {
    expect_cause(student_with_pixels([](glm::vec3 p) {
                     return StudentPlace(500.0f * p.x + 250.0f, 500.0f * p.y + 250.0f);
                 }),
                 vertex, "not divided by z");
    expect_cause(student_with_pixels([](glm::vec3 p) {
                     return StudentPlace(500.0f * p.x / p.z + 250.0f, 250.0f - 500.0f * p.y / p.z);
                 }),
                 vertex, "upside down");
    expect_unknown(student_with_pixels([](glm::vec3 p) {
                       return StudentPlace(450.0f * p.x / p.z + 250.0f,
                                           500.0f * p.y / p.z + 250.0f);
                   }),
                   vertex);
    Student holds_z = handout_student();
    const auto handout = holds_z.vertex;
    holds_z.vertex = [handout](glm::vec3 position, glm::vec3 normal, glm::vec3 colour) {
        StudentPixel pixel = handout(position, normal, colour);
        pixel.zinv = 1.0f / pixel.zinv;
        return pixel;
    };
    expect_cause(holds_z, vertex, "zinv holds z");
}

TEST_CASE("steps that are wrong are named") {
    const auto integer_step = [](const StudentPixel& a, const StudentPixel& b, int count) {
        const int steps = std::max(count - 1, 1);
        const int x = (b.x - a.x) / steps, y = (b.y - a.y) / steps;
        return line_by(a, b, count, [&](int i) { return std::pair(a.x + i * x, a.y + i * y); });
    };
    expect_bugs(student_with_line(integer_step), line, {"B11"});
    expect_bugs(student_with_line(integer_step), rows, {"B11"});
    const auto short_step = [](const StudentPixel& a, const StudentPixel& b, int count) {
        const float n = static_cast<float>(count);
        const float step_x = float(b.x - a.x) / n, step_y = float(b.y - a.y) / n;
        float x = float(a.x), y = float(a.y);
        return line_by(a, b, count, [&](int) {
            const std::pair at(static_cast<int>(x), static_cast<int>(y));
            x += step_x;
            y += step_y;
            return at;
        });
    };
    expect_bugs(student_with_line(short_step), line, {"B92"});
}

TEST_CASE("Interpolate that counts the samples itself may count wrongly") {
    Student student = handout_student();
    student.line = [](const StudentPixel& a, const StudentPixel& b, int) {
        return line_as_handout(a, b, std::abs(a.y - b.y) + 1);
    };
    expect_bugs(student, line, {"B5"});
    // The single points, and the lines that are steep or diagonal, get the count that is right.
    int steep = 0;
    for (const LineQuestion& question : asked_questions().lines) {
        const auto& [a, b, count] = question;
        steep += std::abs(a.y - b.y) >= std::abs(a.x - b.x) ? 1 : 0;
    }
    CHECK(check_of(student, line).right == steep);
    student.line = [](const StudentPixel& a, const StudentPixel& b, int) {
        return line_as_handout(a, b,
                               std::max({std::abs(a.x - b.x + 1), std::abs(a.y - b.y + 1), 1}));
    };
    expect_bugs(student, line, {"B12"});
    student.line = [](const StudentPixel& a, const StudentPixel& b, int) {
        return line_as_handout(a, b, std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) + 2);
    };
    expect_unknown(student, line);
    // The right count does not excuse samples that are wrong.
    student.line = [](const StudentPixel& a, const StudentPixel& b, int) {
        const int count = std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) + 1;
        StudentLine samples = line_as_handout(a, b, count);
        samples[samples.size() / 2].y += 3;
        return samples;
    };
    expect_unknown(student, line);
}

TEST_CASE("a vertex is right if its pixel, its 1/z and its light are") {
    Student student = handout_student();
    const auto handout = student.vertex;
    // The cube of the distance in place of its square.
    student.vertex = [handout](glm::vec3 position, glm::vec3 normal, glm::vec3 colour) {
        StudentPixel pixel = handout(position, normal, colour);
        const glm::vec3 direct = student_light(position, normal) - student_indirect;
        pixel.light = direct / glm::length(student_lamp - position) + student_indirect;
        return pixel;
    };
    expect_bugs(student, vertex, {"B20d"});
    // What no light reaches but the indirect is right all the same.
    int unlit = 0;
    for (const VertexQuestion& question : asked_questions().vertices)
        unlit += glm::dot(student_lamp - question.position, question.normal) <= 0.0f ? 1 : 0;
    REQUIRE(unlit > 0);
    CHECK(check_of(student, vertex).right == unlit);
    // One vertex alone has another 1/z.
    int asked = 0;
    student.vertex = [handout, &asked](glm::vec3 position, glm::vec3 normal, glm::vec3 colour) {
        StudentPixel pixel = handout(position, normal, colour);
        if (asked++ == 7) pixel.zinv *= 1.5f;
        return pixel;
    };
    const FunctionCheck check = check_of(student, vertex);
    INFO(described(check));
    CHECK(check.state == CheckState::wrong);
    CHECK(check.right == check.asked - 1);
}

TEST_CASE("a line and a row table are right if what they carry is") {
    Student student = handout_student();
    student.line = [](const StudentPixel& a, const StudentPixel& b, int count) {
        StudentLine samples = line_as_handout(a, b, count);
        if (count == 4) samples[2].zinv *= 1.5f;
        return samples;
    };
    int of_four = 0;
    for (const LineQuestion& question : asked_questions().lines)
        of_four += question.count == 4 ? 1 : 0;
    FunctionCheck check = check_of(student, line);
    INFO(described(check));
    CHECK(check.state == CheckState::wrong);
    CHECK(check.right == check.asked - of_four);
    student.rows = [](const StudentLine& corners) {
        auto table = rows_with(corners, line_as_handout, {});
        if (table.first.size() == 31) table.first[3].y += 1;
        return table;
    };
    int of_31_rows = 0;
    for (const PolygonQuestion& question : asked_questions().polygons) {
        double top = question.corners[0].y, bottom = top;
        for (const rasterwalk_kit::PixelValues& corner : question.corners) {
            top = std::min(top, corner.y);
            bottom = std::max(bottom, corner.y);
        }
        of_31_rows += bottom - top == 30.0 ? 1 : 0;
    }
    check = check_of(student, rows);
    CHECK(check.state == CheckState::wrong);
    CHECK(check.right == check.asked - of_31_rows);
}

TEST_CASE("mistakes in Interpolate that the laboratory lacks are described") {
    const auto lagging = [](const StudentPixel& a, const StudentPixel& b, int count) {
        StudentLine samples = line_as_handout(a, b, count);
        samples.insert(samples.begin(), a);
        samples.pop_back();
        return samples;
    };
    expect_cause(student_with_line(lagging), line, "lags one sample behind");
    expect_cause(student_with_line(lagging), rows, "lags one sample behind");
    const auto stays = [](const StudentPixel& a, const StudentPixel& b, int count) {
        StudentLine samples = line_as_handout(a, b, count);
        for (StudentPixel& sample : samples)
            sample.place = a.place;
        return samples;
    };
    expect_cause(student_with_line(stays), line, "position is not interpolated");
    const auto twice = [](const StudentPixel& a, const StudentPixel& b, int count) {
        StudentPixel from = a, to = b;
        from.place *= a.zinv;
        to.place *= b.zinv;
        return line_as_handout(from, to, count);
    };
    expect_cause(student_with_line(twice), line, "not divided by it again");
    const auto by_zero = [](const StudentPixel& a, const StudentPixel& b, int count) {
        StudentLine samples = line_as_handout(a, b, count);
        if (count == 1) samples[0].x = samples[0].y = INT_MIN;
        return samples;
    };
    Student divides = handout_student();
    divides.line = by_zero;
    expect_cause(divides, line, "N - 1 = 0");
    Student bent = handout_student();
    bent.line = [](const StudentPixel& a, const StudentPixel& b, int count) {
        StudentLine samples = line_as_handout(a, b, count);
        samples[samples.size() / 2].y += 3;
        return samples;
    };
    expect_unknown(bent, line);
}

TEST_CASE("mistakes in ComputePolygonRows are named") {
    const auto with = student_with_changed_rows;
    expect_bugs(with([](RowStyle& s) { s.counts_by_rows = true; }), rows, {"B5"});
    expect_bugs(with([](RowStyle& s) { s.counts_shifted = true; }), rows, {"B12"});
    expect_bugs(with([](RowStyle& s) { s.lacks_last_edge = true; }), rows, {"B94"});
    expect_bugs(with([](RowStyle& s) { s.lacks_last_row = true; }), rows, {"B95"});
    expect_bugs(with([](RowStyle& s) { s.lacks_last_sample = true; }), rows, {"B91"});
    expect_bugs(with([](RowStyle& s) {
                    s.left_start = 500;
                    s.right_start = 0;
                }),
                rows, {"B6"});
    expect_bugs(with([](RowStyle& s) { s.right_start = 0; }), rows, {"B6"});
    expect_bugs(with([](RowStyle& s) { s.takes_only_x = true; }), rows, {"B90"});
}

TEST_CASE("mistakes in ComputePolygonRows that the laboratory lacks are described") {
    Student exchanged = handout_student();
    exchanged.rows = [](const StudentLine& corners) {
        auto table = rows_with(corners, line_as_handout, {});
        std::swap(table.first, table.second);
        return table;
    };
    expect_cause(exchanged, rows, "exchanged");
    Student longer = handout_student();
    longer.rows = [](const StudentLine& corners) {
        auto table = rows_with(corners, line_as_handout, {});
        table.first.emplace_back().x = INT_MAX;
        table.second.emplace_back().x = -INT_MAX;
        return table;
    };
    expect_cause(longer, rows, "one row too many");
    Student lost = handout_student();
    lost.rows = [](const StudentLine& corners) {
        auto table = rows_with(corners, line_as_handout, {});
        for (StudentPixel& end : table.second)
            end.x -= 4;
        return table;
    };
    expect_unknown(lost, rows);
}

TEST_CASE("the first wrong row is given with its numbers") {
    Student student = handout_student();
    student.rows = [](const StudentLine& corners) {
        auto table = rows_with(corners, line_as_handout, {});
        table.second[0].x += 50;
        return table;
    };
    const FunctionCheck check = check_of(student, rows);
    // The edge from (10,20) to (30,10) has the samples (29, 10.5) and (30, 10) in row 10.
    CHECK(check.first == "the lab's triangle of 31 rows: row 10 goes from 29 to 80 where 29 to 30 "
                         "is right.");
    CHECK(check.difference.question == 0);
    CHECK(check.difference.item == 0);
    REQUIRE(check.difference.our_rows.left.pixels.size() == 31);
    CHECK(check.difference.their_rows.right.pixels[0].x == 80.0);
}

TEST_CASE("rows that are missing are counted by the rule by which the program walks lines") {
    // It multiplies steps, so its row 13 ends one column farther to the right than the handout's.
    const auto multiplied = [](const StudentPixel& a, const StudentPixel& b, int count) {
        const float steps = static_cast<float>(std::max(count - 1, 1));
        const float x = static_cast<float>(b.x - a.x) / steps;
        const float y = static_cast<float>(b.y - a.y) / steps;
        return line_by(a, b, count, [&](int i) {
            return std::pair(static_cast<int>(static_cast<float>(a.x) + static_cast<float>(i) * x),
                             static_cast<int>(static_cast<float>(a.y) + static_cast<float>(i) * y));
        });
    };
    expect_right(student_with_line(multiplied));
    RowStyle short_of_one;
    short_of_one.lacks_last_row = true;
    const FunctionCheck check = check_of(student_with_line(multiplied, short_of_one), rows);
    CHECK(check.bugs == Names{"B95"});
    CHECK(check.first ==
          "the lab's triangle of 31 rows: the table has 30 rows where 31 are right.");
}

TEST_CASE("mistakes in DrawPolygonRows are named or described") {
    const auto with = student_with_changed_draw;
    expect_bugs(with([](DrawStyle& s) { s.lacks_last = true; }), draw, {"B9"});
    expect_bugs(with([](DrawStyle& s) { s.skips_single = true; }), draw, {"B8"});
    expect_bugs(with([](DrawStyle& s) { s.lacks_zero = true; }), draw, {"B10"});
    expect_cause(with([](DrawStyle& s) { s.lacks_last_row = true; }), draw, "last row");
}

TEST_CASE("mistakes in the depth test are named") {
    const auto with = student_with_depth;
    expect_bugs(with([](float zinv, float stored) { return zinv >= stored; }, 0.0f), depth,
                {"B88a"});
    expect_bugs(with([](float zinv, float stored) { return zinv > stored + 0.0001f; }, 0.0f), depth,
                {"B88b"});
    expect_bugs(with([](float zinv, float stored) { return zinv > stored + 0.05f; }, 0.0f), depth,
                {"B61"});
    expect_bugs(with([](float zinv, float stored) { return zinv < stored; }, 1000.0f), depth,
                {"B17d"});
    // That nothing passes proves nothing.
    const FunctionCheck nothing =
        check_of(with([](float zinv, float stored) { return zinv < stored; }, 0.0f), depth);
    CHECK(nothing.state == CheckState::not_written);
    CHECK(nothing.bugs.empty());
    CHECK_FALSE(nothing.notes.empty());
    const FunctionCheck all = check_of(with([](float, float) { return true; }, 0.0f), depth);
    CHECK(all.state == CheckState::not_written);
}

TEST_CASE("the laboratory's mistakes in the light are named") {
    expect_bugs(student_with_shade([](const StudentPixel& p, glm::vec3 n, glm::vec3 colour) {
                    const LampRay ray = lamp_ray(p, n);
                    return colour * (14.0f * std::max(-ray.cosine, 0.0f) /
                                         (unit_sphere * ray.length * ray.length) +
                                     0.5f);
                }),
                shade, {"B20a"});
    expect_bugs(student_with_shade([](const StudentPixel& p, glm::vec3 n, glm::vec3 colour) {
                    const LampRay ray = lamp_ray(p, n);
                    return colour *
                           (14.0f * std::max(ray.cosine, 0.0f) / (ray.length * ray.length) + 0.5f);
                }),
                shade, {"B20c"});
    expect_bugs(student_with_shade([](const StudentPixel& p, glm::vec3 n, glm::vec3 colour) {
                    const LampRay ray = lamp_ray(p, n);
                    return colour * (14.0f * std::max(ray.cosine, 0.0f) /
                                         (unit_sphere * std::pow(ray.length, 3.0f)) +
                                     0.5f);
                }),
                shade, {"B20d"});
    expect_bugs(student_with_shade([](const StudentPixel& p, glm::vec3 n, glm::vec3 colour) {
                    return student_light(p.place / p.zinv, n) - 0.5f + colour;
                }),
                shade, {"B21"});
    expect_bugs(student_with_shade([](const StudentPixel& p, glm::vec3 n, glm::vec3 colour) {
                    return colour * colour * student_light(p.place / p.zinv, n);
                }),
                shade, {"B78"});
    expect_bugs(student_with_shade([](const StudentPixel& p, glm::vec3 n, glm::vec3 colour) {
                    return colour * student_light(p.place, n);
                }),
                shade, {"B86"});
    expect_bugs(student_with_shade([](const StudentPixel& p, glm::vec3 n, glm::vec3 colour) {
                    return colour * student_light(p.place / (p.zinv * p.zinv), n);
                }),
                shade, {"B87"});
}

TEST_CASE("mistakes in the light that the laboratory lacks are described") {
    expect_cause(student_with_shade([](const StudentPixel& p, glm::vec3 n, glm::vec3 colour) {
                     const LampRay ray = lamp_ray(p, n);
                     return colour *
                            (14.0f * ray.cosine / (unit_sphere * ray.length * ray.length) + 0.5f);
                 }),
                 shade, "max(..., 0)");
    expect_cause(student_with_shade([](const StudentPixel& p, glm::vec3 n, glm::vec3 colour) {
                     return colour * (student_light(p.place / p.zinv, n) - 0.5f);
                 }),
                 shade, "indirect light is missing");
    expect_unknown(student_with_shade([](const StudentPixel& p, glm::vec3 n, glm::vec3 colour) {
                       return colour * student_light(p.place / p.zinv, n) * 0.9f;
                   }),
                   shade);
    // The same formula at the vertices.
    Student at_vertices = handout_student();
    const auto handout = at_vertices.vertex;
    at_vertices.vertex = [handout](glm::vec3 position, glm::vec3 normal, glm::vec3 colour) {
        StudentPixel pixel = handout(position, normal, colour);
        pixel.light = student_light(position, normal) - 0.5f + colour;
        return pixel;
    };
    expect_bugs(at_vertices, vertex, {"B21"});
}

TEST_CASE("two mistakes at once are named together") {
    const FunctionCheck check =
        check_of(student_with_shade([](const StudentPixel& p, glm::vec3 n, glm::vec3 colour) {
                     return colour * colour * student_light(p.place, n);
                 }),
                 shade);
    INFO(described(check));
    CHECK(check.state == CheckState::wrong);
    CHECK(check.bugs.empty());
    CHECK(check.together == Names{"B78", "B86"});
}

TEST_CASE("one mistake fails one function") {
    DrawStyle style;
    style.lacks_last = true;
    const std::vector<FunctionCheck> checks = checks_of(student_with_draw(style));
    for (const FunctionCheck& check : checks) {
        INFO(described(check));
        CHECK((check.state == CheckState::wrong) == (check.function == "DrawPolygonRows"));
    }
}
