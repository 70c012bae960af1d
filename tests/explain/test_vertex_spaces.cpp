// The spaces of a vertex, compared with the vertex as drawn and with sums by hand; and the
// conventions, compared with products that are known to cancel.

#include "explain/vertex_spaces.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "explain/conventions.h"
#include "inspect/clip_history.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/setting_table.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

Scene turned_block() {
    return read_scene(lessons_folder() + "/scenes/turned-block.toml");
}

Settings turned_settings(const Scene& scene, const char* projection) {
    Settings settings = default_settings(scene);
    settings.camera.yaw = 0.25f;
    set_from_text(settings, projection);
    set_from_text(settings, "transform=matrices");
    return settings;
}

const SpacePlace& place_in(const SpacesOfVertex& spaces, std::string_view name) {
    for (const SpacePlace& place : spaces.places) {
        if (place.space == name) return place;
    }
    FAIL("no space " << name);
    return spaces.places.front();
}

/// The sets of choices that cancel, by their words.
std::vector<std::string> cancelling_words(const Camera& camera) {
    std::vector<std::string> sets;
    for (const ConventionPlace& place : convention_report(camera, {0.3f, 0.2f, 0.5f}).cancelling) {
        std::string set;
        for (std::size_t i = 0; i < convention_count; ++i) {
            if (has(place.chosen, static_cast<Convention>(i)))
                set.append(set.empty() ? "" : " ").append(enum_words<Convention>[i]);
        }
        sets.push_back(set);
    }
    return sets;
}

} // namespace

TEST_CASE("Every vertex has the place in each space that it is drawn with") {
    const Scene scene = turned_block();
    for (const char* projection :
         {"projection=perspective", "projection=orthographic", "projection_mix=0.5"}) {
        for (const char* box : {"view_box=auto", "view_box=-0.06,0.03,-0.02,0.07"}) {
            Settings settings = turned_settings(scene, projection);
            set_from_text(settings, box);
            const Frame frame = prepare_frame(scene, settings);
            const VertexRules rules = vertex_rules(settings, scene.space);
            for (int t = 0; t < scene.triangle_count(); ++t) {
                for (int v = 0; v < 3; ++v) {
                    const SpacesOfVertex spaces =
                        spaces_of_vertex(frame, t, v, MatrixOrder::column_vectors);
                    REQUIRE(spaces.places.size() == space_names.size());
                    for (std::size_t i = 0; i < space_names.size(); ++i)
                        CHECK(spaces.places[i].space == space_names[i]);
                    const ShadedVertex shaded = shade_vertex(
                        scene.corner(t, v), camera_rotation(settings.camera), rules, frame.stages);
                    CAPTURE(projection, box, t, v);
                    const glm::dvec3 world(scene.corner(t, v).position);
                    CHECK(glm::distance(glm::dvec3(place_in(spaces, "world").place), world) < 1e-6);
                    CHECK(glm::distance(glm::dvec3(place_in(spaces, "camera").place),
                                        glm::dvec3(shaded.in("rotated"))) < 1e-6);
                    const glm::dvec4 window = place_in(spaces, "window").place;
                    CHECK(window.x == Approx(shaded.pixel.position.x).margin(1e-3));
                    CHECK(window.y == Approx(shaded.pixel.position.y).margin(1e-3));
                    CHECK(window.w == 1.0);
                    const glm::dvec4 ndc = place_in(spaces, "ndc").place;
                    CHECK(ndc.x == Approx(window.x / 120.0 - 1.0).margin(1e-9));
                    CHECK(ndc.z > 0.0);
                    CHECK(ndc.z < 1.0);
                    if (settings.projection_mix == 1.0f)
                        CHECK(place_in(spaces, "clip").place.w == 1.0);
                    // The normal is the one that the light falls on.
                    CHECK(glm::distance(spaces.normal.world,
                                        glm::dvec3(scene.corner(t, v).normal)) < 1e-5);
                }
            }
        }
    }
}

TEST_CASE("The text about a box in clip space agrees with its matrix, for every projection") {
    const Scene scene = turned_block();
    struct Case {
        const char *projection, *beginning, *end;
        double factor; ///< n, 1 or w(n), of near = 0.25
    };
    for (const Case& one :
         {Case{"projection=perspective", "x = 2n / (r − l) · x − (r + l) / (r − l) · w",
               "and n = near = 0.25.", 0.25},
          Case{"projection=orthographic", "x = 2 / (r − l) · x − (r + l) / (r − l) · w", "t = 0.5.",
               1.0},
          Case{"projection_mix=0.5", "x = 2w(n) / (r − l) · x − (r + l) / (r − l) · w",
               "and w(n) = 0.625 is w at the near plane.", 0.625}}) {
        for (const char* axes : {"image_axes=right_way", "image_axes=mirrored"}) {
            Settings settings = turned_settings(scene, one.projection);
            for (const char* set : {"near=0.25", "view_box=-0.25,0.75,-0.125,0.5", axes})
                set_from_text(settings, set);
            const Frame frame = prepare_frame(scene, settings);
            const SpacesOfVertex spaces = spaces_of_vertex(frame, 3, 1, MatrixOrder::row_vectors);
            const SpacePlace& clip = place_in(spaces, "clip");
            const glm::dvec4 camera = place_in(spaces, "camera").place;
            CAPTURE(one.projection, axes, clip.about);
            CHECK(clip.about.find(one.beginning) != std::string::npos);
            CHECK(clip.about.find(one.end) != std::string::npos);
            CHECK((clip.about.find("opposite sign") != std::string::npos) ==
                  (settings.image_axes == ImageAxes::mirrored));
            CHECK(clip.about.find("l = −0.25, r = 0.75, b = −0.125, t = 0.5") != std::string::npos);
            const double sign = settings.image_axes == ImageAxes::mirrored ? -1.0 : 1.0;
            const double w = clip.place.w;
            CHECK(sign * clip.place.x == Approx(2.0 * one.factor * camera.x - 0.5 * w));
            CHECK(sign * clip.place.y == Approx((2.0 * one.factor * camera.y + 0.375 * w) / 0.625));
            // As it is drawn.
            const ClipHistory history = clip_history(frame, 3);
            CHECK(clip.place.x * 0.5 * settings.viewport.width ==
                  Approx(history.corners[1].position_clip.x).margin(1e-3));
        }
    }
}

TEST_CASE("A formula of a space is its matrix times the previous place, in either order") {
    const Scene scene = turned_block();
    const Frame frame = prepare_frame(scene, turned_settings(scene, "projection=perspective"));
    const Part& turned = scene.parts[2];
    const SpacesOfVertex columns =
        spaces_of_vertex(frame, turned.first_triangle, 0, MatrixOrder::column_vectors);
    const SpacesOfVertex rows =
        spaces_of_vertex(frame, turned.first_triangle, 0, MatrixOrder::row_vectors);
    // E = (-0.5, -0.5, -0.5), scaled by (1, 1.5, 0.6), turned by 0.7 about y, moved.
    CHECK(place_in(columns, "object").place == glm::dvec4(-0.5, -0.5, -0.5, 1.0));
    CHECK(place_in(columns, "world").formulas[1] == "y = 1.5 · (−0.5) + 0.05 · 1 = −0.7");
    CHECK(place_in(rows, "world").formulas[1] == "y = −0.5 · 1.5 + 1 · 0.05 = −0.7");
    CHECK(columns.chain != rows.chain);
    for (std::size_t i = 0; i < columns.places.size(); ++i) {
        CHECK(columns.places[i].place == rows.places[i].place);
        if (!columns.places[i].matrix) continue;
        // Row times matrix by hand, with the entries as written in this order.
        const glm::dvec4 before = rows.places[i - 1].place;
        for (int column = 0; column < 4; ++column) {
            double sum = 0.0;
            for (int row = 0; row < 4; ++row)
                sum += before[row] *
                       entry(*rows.places[i].matrix, MatrixOrder::row_vectors, row, column);
            CHECK(sum == Approx(rows.places[i].place[column]).margin(1e-12));
        }
        // A translation is in the last column, or in the last row.
        for (int k = 0; k < 3; ++k) {
            CHECK(entry(*rows.places[i].matrix, MatrixOrder::row_vectors, 3, k) ==
                  entry(*columns.places[i].matrix, MatrixOrder::column_vectors, k, 3));
        }
    }
}

TEST_CASE("Clip space of the matrices is the Clip tab's in units of half a picture") {
    const Scene scene = turned_block();
    for (const char* projection : {"projection=perspective", "projection_mix=0.5"}) {
        Settings settings = turned_settings(scene, projection);
        settings.viewport = {240, 100}; // W/2 and H/2 are not the same
        const Frame frame = prepare_frame(scene, settings);
        for (int t = 0; t < scene.triangle_count(); ++t) {
            const ClipHistory history = clip_history(frame, t);
            for (int v = 0; v < 3; ++v) {
                CAPTURE(projection, t, v);
                const glm::dvec4 clip =
                    place_in(spaces_of_vertex(frame, t, v, MatrixOrder::row_vectors), "clip").place;
                const glm::dvec4 lab(history.corners[static_cast<std::size_t>(v)].position_clip);
                CHECK(120.0 * clip.x == Approx(lab.x).margin(1e-3));
                CHECK(50.0 * clip.y == Approx(lab.y).margin(1e-3));
                CHECK(clip.w == Approx(lab.w).margin(1e-5));
            }
        }
    }
}

TEST_CASE("Behind the camera a vertex has no NDC, and in pixels only a window") {
    const Scene room = lab_room();
    Settings settings = default_settings(room);
    settings.camera.position.z = 5.0f;
    const Frame frame = prepare_frame(room, settings);
    CHECK(spaces_of_vertex(frame, 0, 0, MatrixOrder::row_vectors).places.size() == 4);
    const Scene bench = small_scene();
    const Frame pixels = prepare_frame(bench, default_settings(bench));
    const SpacesOfVertex spaces = spaces_of_vertex(pixels, 0, 1, MatrixOrder::row_vectors);
    REQUIRE(spaces.places.size() == 1);
    CHECK(spaces.places[0].space == "window");
}

TEST_CASE("The conventions known to cancel each other do") {
    Camera camera;
    camera.yaw = 0.3f;
    const std::vector<std::string> turned = cancelling_words(camera);
    // In the order of size, then of the choices.
    CHECK(turned == std::vector<std::string>{"column_vectors transposed", "y_up rows_up",
                                             "column_vectors z_backward negative_f",
                                             "transposed z_backward negative_f"});
    // Without a turn R is the same as its transpose.
    camera.yaw = 0.0f;
    CHECK(cancelling_words(camera) == std::vector<std::string>{"column_vectors", "transposed",
                                                               "z_backward negative_f",
                                                               "y_up rows_up"});
    // With a tilt, y up reverses it as well.
    camera.pitch = 0.2f;
    CHECK(cancelling_words(camera) ==
          std::vector<std::string>{
              "column_vectors transposed", "column_vectors z_backward negative_f",
              "transposed z_backward negative_f", "column_vectors y_up rows_up",
              "transposed y_up rows_up", "y_up z_backward negative_f rows_up"});
}

TEST_CASE("A single choice moves the point as it does on paper") {
    Camera camera;
    camera.position = glm::vec3(0.0f);
    camera.yaw = 0.3f;
    camera.focal_length = 100.0f;
    const glm::vec3 point(0.5f, 0.25f, 2.0f);
    const ConventionReport report = convention_report(camera, point);
    const double c = std::cos(static_cast<double>(camera.yaw)),
                 s = std::sin(static_cast<double>(camera.yaw));
    const auto seen = [&](double x, double y, double z) {
        return glm::dvec2(100.0 * x / z, 100.0 * y / z);
    };
    const glm::dvec2 right = seen(0.5 * c - 2.0 * s, 0.25, 0.5 * s + 2.0 * c);
    const glm::dvec2 turned_back = seen(0.5 * c + 2.0 * s, 0.25, -0.5 * s + 2.0 * c);
    const auto alone = [&](Convention choice) {
        return report.alone[static_cast<std::size_t>(choice)];
    };
    constexpr double tolerance = 1e-5;
    CHECK(glm::distance(report.lab.picture, right) < tolerance);
    CHECK(glm::distance(alone(Convention::column_vectors).picture, turned_back) < tolerance);
    CHECK(glm::distance(alone(Convention::transposed).picture, turned_back) < tolerance);
    CHECK(glm::distance(alone(Convention::negative_f).picture, -right) < tolerance);
    CHECK(alone(Convention::negative_f).change == PictureChange::half_turn);
    CHECK(alone(Convention::rows_up).change == PictureChange::upside_down);
    CHECK(alone(Convention::y_up).change == PictureChange::upside_down);
    CHECK(alone(Convention::column_vectors).change == PictureChange::elsewhere);
    CHECK(report.lab.change == PictureChange::same);
    CHECK(report.sentences.front() == "R v instead of v R and the transpose of R cancel each other "
                                      "out.");
}
