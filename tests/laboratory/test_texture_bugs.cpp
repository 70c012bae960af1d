// The mistakes of textures, on the square whose u and v go from -1 to 2 over 128 pixels: each pixel
// is computed again in double, from the place of its column and row among the texels.

#include "laboratory/bug.h"

#include <array>
#include <cmath>

#include <glm/common.hpp>

#include "explain/texture_report.h"
#include "mistakes/texture.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "support/bug_runs.h"
#include "support/texture_oracle.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

constexpr int square_side = 128;

/// Both runs of a mistake, drawn, and the texels of its scene.
struct TexturedRuns {
    Session session;
    Framebuffer wrong, right;
    test::OracleLevel texels;

    explicit TexturedRuns(std::string_view id) {
        session = open_session(lessons_folder() + "/scenes/lab-room.toml");
        open_bug(find_bug(read_bugs(), id), session);
        wrong = draw_frame(prepare_frame(*session.scene, session.a.settings));
        right = draw_frame(prepare_frame(*session.scene, session.b->settings));
        const TextureLevel& base = (*session.scene->textures.front()).base();
        texels = {base.width, base.height, {}};
        for (const glm::vec3& texel : base.texels)
            texels.texels.emplace_back(texel);
        REQUIRE(wrong.size == Viewport{square_side, square_side});
    }
};

/// u of a column, or v of a row.
double coordinate_of(int pixel) {
    return -1.0 + 3.0 * pixel / (square_side - 1.0);
}

/// Calls f with each pixel except those of the borders, where u and v are whole numbers.
template <class F>
void for_each_inner_pixel(const F& f) {
    for (int row = 1; row < square_side - 1; ++row) {
        for (int column = 1; column < square_side - 1; ++column)
            f(column, row);
    }
}

void require_colour(const Framebuffer& picture, int column, int row, const glm::dvec3& wanted,
                    double tolerance) {
    const glm::dvec3 drawn(picture.colour[picture.at(column, row)]);
    const glm::dvec3 off = glm::abs(drawn - wanted);
    if (std::max({off.x, off.y, off.z}) > tolerance) {
        FAIL("column " << column << " row " << row << " is " << drawn.x << " " << drawn.y << " "
                       << drawn.z << ", in double " << wanted.x << " " << wanted.y << " "
                       << wanted.z);
    }
}

int differing_pixels(const TexturedRuns& runs) {
    int differing = 0;
    for_each_inner_pixel([&](int column, int row) {
        const std::size_t at = runs.wrong.at(column, row);
        differing += runs.wrong.colour[at] != runs.right.colour[at] ? 1 : 0;
    });
    return differing;
}

} // namespace

TEST_CASE("B65: the texture is upside down, and left is still left") {
    const TexturedRuns runs("B65");
    for_each_inner_pixel([&](int column, int row) {
        const double x = coordinate_of(column) * runs.texels.width;
        const double y = (1.0 - coordinate_of(row)) * runs.texels.height;
        const auto texel = [](double place, int count) {
            return test::oracle_texel(static_cast<int>(std::floor(place)), count,
                                      TextureWrap::repeat);
        };
        require_colour(runs.wrong, column, row,
                       runs.texels.at(texel(x, runs.texels.width), texel(y, runs.texels.height)),
                       0.0);
    });
    CHECK(differing_pixels(runs) > 1000);
    CHECK(texel_place_upside_down(0.25f, TextureDirection::v, 8) == 6.0f);
    CHECK(texel_place_upside_down(0.25f, TextureDirection::u, 8) == 2.0f);
}

TEST_CASE("B66: each pixel has the colour that belongs half a texel farther right and down") {
    for (const TextureFilter filter : {TextureFilter::bilinear, TextureFilter::nearest}) {
        TexturedRuns runs("B66");
        runs.session.a.settings.texture_filter = filter;
        runs.wrong = draw_frame(prepare_frame(*runs.session.scene, runs.session.a.settings));
        const glm::dvec2 half(0.5 / runs.texels.width, 0.5 / runs.texels.height);
        for_each_inner_pixel([&](int column, int row) {
            const glm::dvec2 uv = glm::dvec2(coordinate_of(column), coordinate_of(row)) + half;
            const test::OracleColour wanted = test::oracle_sample(
                {runs.texels}, uv, glm::dvec2(0.0), glm::dvec2(0.0), filter, TextureWrap::repeat);
            if (!wanted.is_tie) require_colour(runs.wrong, column, row, wanted.colour, 1.0 / 255.0);
        });
        CHECK(differing_pixels(runs) > 1000);
    }
}

TEST_CASE("B67: below 0 a texel is read from the row above, and before the first one it is black") {
    const TexturedRuns runs("B67");
    int moved = 0, outside = 0;
    for_each_inner_pixel([&](int column, int row) {
        // The remainder of a number by counting, with its sign.
        const auto rest = [](double coordinate, int count) {
            int texel = static_cast<int>(std::floor(coordinate * count));
            while (texel <= -count)
                texel += count;
            while (texel >= count)
                texel -= count;
            return texel;
        };
        const int x = rest(coordinate_of(column), runs.texels.width);
        const int y = rest(coordinate_of(row), runs.texels.height);
        glm::dvec3 wanted(0.0);
        if (x >= 0 && y >= 0) {
            wanted = runs.texels.at(x, y);
        } else if (y > 0) {
            wanted = runs.texels.at(x + runs.texels.width, y - 1);
            ++moved;
        } else {
            ++outside;
        }
        require_colour(runs.wrong, column, row, wanted, 0.0);
    });
    CHECK(moved > 2000);
    CHECK(outside > 5000);
    CHECK(wrap_by_remainder(-9, 16) == -9);
    CHECK(wrap_by_remainder(-16, 16) == 0);
    CHECK(wrap_by_remainder(25, 16) == 9);
    // Without repetition nothing is divided.
    for (const TextureWrap wrap : {TextureWrap::clamp, TextureWrap::mirror}) {
        Settings wrong = runs.session.a.settings, right = runs.session.b->settings;
        wrong.texture_wrap = right.texture_wrap = wrap;
        CHECK(draw_frame(prepare_frame(*runs.session.scene, wrong)).colour ==
              draw_frame(prepare_frame(*runs.session.scene, right)).colour);
    }
}

TEST_CASE("B67: the texel that a pixel took is reported as it was read") {
    const TexturedRuns runs("B67");
    const Frame frame = prepare_frame(*runs.session.scene, runs.session.a.settings);
    const auto report = texture_report(frame, Cursor{0, Phase::rows, 64, 20});
    REQUIRE(report);
    // u is -1 + 3 * 20 / 127; of 16 columns that is -8.44, in column -9.
    CHECK(report->heaviest().column == -9);
    CHECK(report->heaviest().row == 8);
    const TextureLevel& base = (*runs.session.scene->textures.front()).base();
    CHECK(report->heaviest().colour == base.at(7, 7));
}

TEST_CASE("B97: each pixel has the level for its width along x, and far ones are too fine") {
    const test::BugRuns runs("B97");
    std::vector<test::OracleLevel> chain;
    for (const TextureLevel& level : (*runs.session.scene->textures.front()).levels) {
        chain.push_back({level.width, level.height, {}});
        for (const glm::vec3& texel : level.texels)
            chain.back().texels.emplace_back(texel);
    }
    const std::vector<FragmentEvent>& reported = runs.wrong.reported.fragments;
    int held = 0, finer = 0;
    for (std::size_t i = 1; i + 1 < reported.size(); ++i) {
        const auto place = [&](const FragmentEvent& event) {
            return glm::dvec2(event.fragment.varyings.texcoord) /
                   static_cast<double>(event.fragment.inv_w);
        };
        const Cursor &before = reported[i - 1].cursor, &behind = reported[i + 1].cursor;
        const bool is_one_row = before.triangle == behind.triangle && before.index == behind.index;
        // The last fragment drawn stays.
        const std::size_t pixel =
            runs.wrong.picture.at(reported[i].fragment.column, reported[i].fragment.row);
        if (!is_one_row || runs.wrong.picture.owner[pixel] != reported[i].cursor.triangle) continue;
        // Along a row of this floor z is the same, and u grows in equal steps.
        const glm::dvec2 right = (place(reported[i + 1]) - place(reported[i - 1])) / 2.0;
        const test::OracleColour wanted =
            test::oracle_sample(chain, place(reported[i]), right, glm::dvec2(0.0),
                                TextureFilter::mipmap, TextureWrap::repeat);
        if (wanted.is_tie) continue;
        ++held;
        const glm::dvec3 off =
            glm::abs(glm::dvec3(runs.wrong.picture.colour[pixel]) - wanted.colour);
        if (std::max({off.x, off.y, off.z}) > 2.0 / 255.0)
            FAIL(to_text(reported[i].cursor) << " has a different level");
        finer += runs.wrong.picture.colour[pixel] != runs.right.picture.colour[pixel] ? 1 : 0;
    }
    CHECK(held > 10000);
    CHECK(finer > 2000);
    // Seen face on, a pixel reaches equally far along both.
    const Texture& texture = *runs.session.scene->textures.front();
    const float side = 8.0f / static_cast<float>(texture.base().width);
    const float high = 8.0f / static_cast<float>(texture.base().height);
    const Footprint square{{side, 0.0f}, {0.0f, high}};
    CHECK(texture_level_along_x(square, texture) == texture_level(square, texture));
    CHECK(texture_level_along_x({{side, 0.0f}, {0.0f, 2.0f * high}}, texture) ==
          texture_level(square, texture));
}
