#include "inspect/triangle_fates.h"

#include <algorithm>
#include <string>

#include "inspect/pixel_history.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "support/effort.h"
#include "support/random.h"
#include "support/samples.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

Frame depth_frame(const Scene& scene) {
    Settings settings = default_settings(scene);
    settings.stage = Stage::depth;
    return prepare_frame(scene, settings);
}

/// The first disagreement between the histories of the part's pixels and the triangle's fates;
/// empty if there is none.
std::string first_fault(const Frame& frame, int triangle, const Rectangle& part,
                        const std::vector<FragmentFate>& fates) {
    std::size_t known = 0;
    for (int row = part.top; row < part.bottom; ++row) {
        for (int column = part.left; column < part.right; ++column) {
            const glm::ivec2 pixel(column, row);
            for (const PixelEntry& entry : pixel_history(frame, pixel).entries) {
                if (entry.cursor.triangle != triangle) continue;
                ++known;
                const auto fate = std::find_if(fates.begin(), fates.end(), [&](const auto& f) {
                    return f.pixel == pixel && f.cursor == entry.cursor;
                });
                const std::string name = to_text(entry.cursor);
                if (fate == fates.end()) return name + " is missing";
                if (fate->fate != entry.fate) return name + " has another fate";
            }
        }
    }
    if (known != fates.size()) return "there are fates that no history knows";
    return {};
}

} // namespace

TEST_CASE("The fates of a triangle agree with the histories of its pixels") {
    const Scene scene = test::lab_room();
    const Frame frame = depth_frame(scene);
    test::Random random(11);
    FateFinder finder;
    int failed = 0, passed = 0;
    // Forward, back and again with the same finder.
    for (int i = 0; i < test::rounds(60, 12); ++i) {
        const int triangle = random.integer(0, frame.triangle_count() - 1);
        const int left = random.integer(-5, 480), top = random.integer(-5, 480);
        const Rectangle part{left, top, left + random.integer(1, 24), top + random.integer(1, 24)};
        const Rectangle inside{std::max(part.left, 0), std::max(part.top, 0),
                               std::min(part.right, 500), std::min(part.bottom, 500)};
        for (const int t : {triangle, 0, triangle, frame.triangle_count() - 1}) {
            CAPTURE(t, part.left, part.top, part.right, part.bottom);
            const std::vector<FragmentFate>& fates = finder.find(frame, 1, t, part);
            CHECK(first_fault(frame, t, inside, fates) == "");
            for (const FragmentFate& fate : fates)
                ++(fate.fate == Fate::written ? passed : failed);
        }
    }
    CHECK(passed > 0);
    CHECK(failed > 0);
}

TEST_CASE("A different frame has different fates, whatever was found before") {
    const Scene scene = test::lab_room();
    const Frame frame = depth_frame(scene);
    Settings settings = frame.settings;
    settings.camera.position.x += 0.3f;
    const Frame other = prepare_frame(scene, settings);
    FateFinder finder;
    const Rectangle part{240, 290, 264, 314};
    for (const std::size_t i : test::spread(static_cast<std::size_t>(frame.triangle_count()), 6)) {
        const int t = static_cast<int>(i);
        CAPTURE(t);
        CHECK(first_fault(frame, t, part, finder.find(frame, 1, t, part)) == "");
        CHECK(first_fault(other, t, part, finder.find(other, 2, t, part)) == "");
    }
}

TEST_CASE("Without a depth test or fragments, or with too much work, there are no fates") {
    const Scene scene = test::lab_room();
    Settings settings = default_settings(scene);
    FateFinder finder;
    const Rectangle part{200, 250, 330, 380}; // on the short block
    for (const Stage stage : {Stage::points, Stage::edges, Stage::rows, Stage::fill}) {
        settings.stage = stage;
        const Frame frame = prepare_frame(scene, settings);
        CHECK(finder.find(frame, 10 + static_cast<std::uint64_t>(stage), 8, part).empty());
    }
    const Frame frame = depth_frame(scene);
    const Framebuffer picture = draw_frame(frame);
    const int block = picture.owner[picture.at(250, 350)];
    REQUIRE(block >= 0);
    CHECK_FALSE(finder.find(frame, 1, block, part).empty());
    CHECK(finder.find(frame, 1, -1, part).empty());
    CHECK(finder.find(frame, 1, frame.triangle_count(), part).empty());
    CHECK(finder.find(frame, 1, block, {600, 600, 700, 700}).empty());
    CHECK(finder.find(frame, 1, block, {20, 20, 10, 10}).empty());
    CHECK_FALSE(finder.find(frame, 1, block, part).empty());

    // 40 triangles that each cover the whole of a large picture.
    std::vector<std::array<glm::vec3, 3>> large(
        40, {glm::vec3(-9, -9, 1), glm::vec3(1200, -9, 1), glm::vec3(-9, 1200, 1)});
    const Scene heavy = test::pixel_scene(large, {600, 600});
    const Frame heavy_frame = depth_frame(heavy);
    CHECK(finder.find(heavy_frame, 3, 39, {0, 0, 600, 600}).empty());
    CHECK_FALSE(finder.find(heavy_frame, 3, 39, {0, 0, 30, 30}).empty());
}
