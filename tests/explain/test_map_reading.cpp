// Where the maps of a surface are read, computed again from the triangle's own corners.

#include "explain/map_reading.h"

#include <cmath>

#include "session/session.h"
#include "support/normal_map_oracle.h"
#include "support/project_root.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

FragmentReport report_at(const Frame& frame, const glm::ivec2& pixel) {
    const auto cursor = fragment_on_pixel(frame, pixel, cursor_end);
    REQUIRE(cursor);
    const auto report = fragment_report(frame, *cursor);
    REQUIRE(report);
    return *report;
}

int wrapped(double place, int count) {
    const int texel = static_cast<int>(std::floor(place * count)) % count;
    return texel < 0 ? texel + count : texel;
}

} // namespace

TEST_CASE("Texture and normal map are read where the pixel lies, and the arrow is 2 c - 1") {
    Session session = open_session(project_root() + "/lessons/scenes/brick-relief.toml");
    Settings& settings = session.a.settings;
    settings.texture_filter = TextureFilter::nearest;
    const Frame frame = prepare_frame(*session.scene, settings);
    int compared = 0;
    for (int row = 20; row < 220; row += 17) {
        for (int column = 20; column < 300; column += 23) {
            const FragmentReport report = report_at(frame, {column, row});
            const std::vector<MapReading> readings = map_readings(report);
            REQUIRE(readings.size() == 2);
            CHECK(readings[0].use == SurfaceMap::texture);
            CHECK(readings[1].use == SurfaceMap::normal_map);
            const int triangle = report.cursor.triangle;
            CHECK(readings[0].map == texture_of(*frame.scene, triangle));
            CHECK(readings[1].map == normal_map_of(*frame.scene, triangle));
            // Rows go from one rounded end to the other, so that a place may be a pixel off.
            const glm::dvec3 weights = weights_at(frame, triangle, column + 0.5, row + 0.5);
            const glm::dvec2 uv = mean_at(*frame.scene, triangle, weights, &Vertex::texcoord);
            for (const MapReading& reading : readings) {
                CAPTURE(column, row, uv.x, uv.y);
                CHECK(reading.place.texcoord.x == Approx(uv.x).margin(0.012));
                CHECK(reading.place.texcoord.y == Approx(uv.y).margin(0.012));
                const TextureLevel& base = reading.map->base();
                const SampledTexel& texel = reading.taken.list[0];
                REQUIRE(reading.taken.count == 1);
                CHECK(texel.column == wrapped(double{reading.place.texcoord.x}, base.width));
                CHECK(texel.row == wrapped(double{reading.place.texcoord.y}, base.height));
                CHECK(reading.colour == base.at(texel.column, texel.row));
            }
            for (int i = 0; i < 3; ++i)
                CHECK(report.bump->arrow[i] == 2.0f * readings[1].colour[i] - 1.0f);
            ++compared;
        }
    }
    CHECK(compared > 100);
}

TEST_CASE("A height map is read before the shift, the other two after it") {
    Session session = open_session(project_root() + "/lessons/scenes/brick-heights.toml");
    const Frame frame = prepare_frame(*session.scene, session.a.settings);
    const FragmentReport report = report_at(frame, {205, 140});
    const std::vector<MapReading> readings = map_readings(report);
    REQUIRE(readings.size() == 3);
    const MapReading &texture = readings[0], &normals = readings[1], &heights = readings[2];
    CHECK(heights.use == SurfaceMap::height_map);
    CHECK(heights.place.texcoord == heights.carried);
    CHECK(texture.carried == heights.carried);
    CHECK(normals.carried == heights.carried);
    CHECK(texture.place.texcoord == normals.place.texcoord);
    CHECK(texture.place.texcoord != heights.place.texcoord);
    CHECK(heights.colour.r == Approx(report.parallax->terms.stored));
}

TEST_CASE("A map that does not act is not among the readings") {
    Session session = open_session(project_root() + "/lessons/scenes/brick-relief.toml");
    session.a.settings.normal_map = NormalMapUse::off;
    const Frame without = prepare_frame(*session.scene, session.a.settings);
    CHECK(map_readings(report_at(without, {160, 118})).size() == 1);
    session.a.settings.texture = TextureUse::off;
    const Frame bare = prepare_frame(*session.scene, session.a.settings);
    CHECK(map_readings(report_at(bare, {160, 118})).empty());
}
