// Textures with alpha: holes that are cut out, texels that are blended, and what the panels say.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "compare/divergence.h"
#include "engines/fast/fast_view.h"
#include "explain/fragment_report.h"
#include "facts/facts.h"
#include "inspect/pixel_history.h"
#include "pipeline/draw.h"
#include "session/content.h"
#include "session/results.h"
#include "settings/setting_table.h"
#include "support/recorder.h"
#include "support/textured_scene.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using test::many_colours;

namespace {

constexpr int picture_side = 41;
const Image& holed() {
    static const Image image = [] {
        Image made = many_colours(4, 4);
        const int alphas[]{0, 255, 127, 128, 255, 64, 255, 0, 200, 255, 10, 255, 255, 255, 255, 90};
        for (std::size_t i = 0; i < 16; ++i)
            made.rgba[4 * i + 3] = static_cast<std::uint8_t>(alphas[i]);
        return made;
    }();
    return image;
}

void add_square(Scene& scene, float depth, bool is_painted) {
    const test::PixelCorner a{{0, 0, depth}, {0, 0}}, b{{picture_side - 1, 0, depth}, {1, 0}},
        c{{picture_side - 1, picture_side - 1, depth}, {1, 1}},
        d{{0, picture_side - 1, depth}, {0, 1}};
    for (const auto& corners : {std::array{a, b, c}, std::array{a, c, d}}) {
        test::add_textured(scene, corners);
        if (!is_painted) scene.parts.back().texture = -1;
    }
}

/// A grey wall, a picture with holes in front of it, and finally a wall between the two.
Scene scene_with_holes(const Image& image = holed()) {
    Scene scene = test::textured_scene(image, {picture_side, picture_side});
    add_square(scene, 8.0f, false);
    add_square(scene, 2.0f, true);
    add_square(scene, 4.0f, false);
    return scene;
}

Framebuffer drawn_with_alpha(const Scene& scene, const char* alpha,
                             const Observer* observer = nullptr) {
    Settings settings = default_settings(scene);
    settings.stage = Stage::depth;
    set_from_text(settings, std::string("texture_alpha=") + alpha);
    const Frame frame = prepare_frame(scene, settings);
    Framebuffer picture;
    clear(picture, frame);
    draw(frame, {}, picture, observer);
    return picture;
}

/// The texel that contains a pixel, row by row; -1 if it is on a border.
int texel_under(int column, int row) {
    const double u = 4.0 * column / (picture_side - 1), v = 4.0 * row / (picture_side - 1);
    if (std::abs(u - std::round(u)) < 0.01 || std::abs(v - std::round(v)) < 0.01) return -1;
    return 4 * static_cast<int>(v) + static_cast<int>(u);
}

double channel_of(int texel, int channel) {
    return holed().rgba[4 * static_cast<std::size_t>(texel) + static_cast<std::size_t>(channel)] /
           255.0;
}

} // namespace

TEST_CASE(
    "Where a texture's alpha is below one half, colour and depth are those of the wall behind it") {
    const Scene scene = scene_with_holes();
    const glm::vec3 grey = scene.corner(4, 0).reflectance;
    const Framebuffer picture = drawn_with_alpha(scene, "cut_out");
    int holes = 0, compared = 0;
    for (int row = 0; row < picture_side; ++row) {
        for (int column = 0; column < picture_side; ++column) {
            const int texel = texel_under(column, row);
            if (texel < 0) continue;
            INFO("pixel " << column << "," << row << " of texel " << texel);
            const bool is_hole = holed().rgba[4 * static_cast<std::size_t>(texel) + 3] < 128;
            const std::size_t pixel = picture.at(column, row);
            ++compared;
            holes += is_hole;
            CHECK(picture.depth[pixel] == (is_hole ? 0.25f : 0.5f));
            for (int c = 0; c < 3; ++c) {
                const double wanted =
                    is_hole ? grey[c] : channel_of(texel, c) * scene.corner(2, 0).reflectance[c];
                CHECK(picture.colour[pixel][c] == Approx(wanted).margin(1e-5));
            }
            CHECK(picture.overdraw[pixel] >= 3);
        }
    }
    CHECK(holes > compared / 4);
    CHECK(holes < compared);
}

TEST_CASE("With blending each texel covers the wall by its alpha; switched off, all are opaque") {
    const Scene scene = scene_with_holes();
    const glm::vec3 grey = scene.corner(0, 0).reflectance, own = scene.corner(2, 0).reflectance;
    const Framebuffer blended = drawn_with_alpha(scene, "blend");
    const Framebuffer opaque = drawn_with_alpha(scene, "off");
    for (int row = 0; row < picture_side; ++row) {
        for (int column = 0; column < picture_side; ++column) {
            const int texel = texel_under(column, row);
            // On the diagonal both triangles draw, and blend twice.
            if (texel < 0 || std::abs(column - row) < 2) continue;
            INFO("pixel " << column << "," << row << " of texel " << texel);
            const std::size_t pixel = blended.at(column, row);
            const double alpha = channel_of(texel, 3);
            for (int c = 0; c < 3; ++c) {
                const double colour = channel_of(texel, c) * own[c];
                // Surfaces drawn behind it later are hidden, because it has written its depth.
                CHECK(blended.colour[pixel][c] ==
                      Approx(alpha * colour + (1.0 - alpha) * grey[c]).margin(1e-5));
                CHECK(opaque.colour[pixel][c] == Approx(colour).margin(1e-5));
            }
            CHECK(blended.depth[pixel] == 0.5f);
        }
    }
}

TEST_CASE("An observer sees the same picture, and each fragment that is cut out") {
    const Scene scene = scene_with_holes();
    for (const char* const alpha : {"cut_out", "blend", "off"}) {
        INFO(alpha);
        test::Recorder recorder;
        const Observer keep = recorder.observer();
        CHECK(drawn_with_alpha(scene, alpha, &keep).colour ==
              drawn_with_alpha(scene, alpha).colour);
        const auto cut =
            std::count_if(recorder.fragments.begin(), recorder.fragments.end(),
                          [](const FragmentEvent& event) { return event.fate == Fate::cut_out; });
        CHECK((cut > 0) == (std::string(alpha) == "cut_out"));
    }
}

TEST_CASE("A texture without alpha is opaque, and so is an image whose alpha is empty") {
    Image clear_all_over = many_colours(4, 4);
    const Framebuffer wanted = drawn_with_alpha(scene_with_holes(clear_all_over), "off");
    for (std::size_t i = 3; i < clear_all_over.rgba.size(); i += 4)
        clear_all_over.rgba[i] = 0;
    drop_empty_alpha(clear_all_over); // as when an image is read
    const Scene clear_scene = scene_with_holes(clear_all_over);
    CHECK_FALSE(has_texture_alpha(clear_scene));
    for (const char* const alpha : {"cut_out", "blend", "off"}) {
        INFO(alpha);
        CHECK(drawn_with_alpha(clear_scene, alpha).colour == wanted.colour);
        CHECK(drawn_with_alpha(scene_with_holes(many_colours(4, 4)), alpha).colour ==
              wanted.colour);
    }
}

TEST_CASE("The alpha of a smaller level is the mean of the texels it covers") {
    const Texture texture = make_texture("holed", holed());
    REQUIRE(texture.levels.size() == 3);
    double sum = 0.0;
    for (int texel = 0; texel < 16; ++texel)
        sum += channel_of(texel, 3);
    CHECK(texture.levels[2].alpha_at(0, 0) == Approx(sum / 16.0));
    CHECK(texture.levels[1].alpha_at(1, 0) ==
          Approx((channel_of(2, 3) + channel_of(3, 3) + channel_of(6, 3) + channel_of(7, 3)) / 4));
    CHECK(texture.base().alpha_at(-1, 0) == 1.0f);
}

TEST_CASE("The history of a pixel and the report on a fragment show that it was cut out") {
    const Scene scene = scene_with_holes();
    Settings settings = default_settings(scene);
    settings.stage = Stage::depth;
    const Frame frame = prepare_frame(scene, settings);
    const glm::ivec2 pixel{15, 13};
    REQUIRE(texel_under(pixel.x, pixel.y) == 5);
    const PixelHistory history = pixel_history(frame, pixel);
    const auto cut = std::find_if(history.entries.begin(), history.entries.end(),
                                  [](const PixelEntry& e) { return e.fate == Fate::cut_out; });
    REQUIRE(cut != history.entries.end());
    CHECK(cut->alpha == Approx(64.0 / 255.0));
    CHECK(cut->colour_after == cut->colour_before);
    CHECK(history.entries.at(static_cast<std::size_t>(history.winner)).cursor.triangle >= 4);
    const auto report = fragment_report(frame, cut->cursor);
    REQUIRE(report.has_value());
    CHECK(report->fate == Fate::cut_out);
    CHECK(report->alpha == cut->alpha);
}

TEST_CASE("The fast engine refuses textures with alpha until their alpha is switched off") {
    Scene scene = scene_with_holes();
    scene.space = SceneSpace::world;
    Settings settings = default_settings(scene);
    set_from_text(settings, "clip=near");
    settings.stage = Stage::depth;
    const std::string alpha = "textures with alpha (texture_alpha=off draws them opaque)";
    CHECK(fast_engine_refuses(scene, settings).find(alpha) != std::string::npos);
    set_from_text(settings, "texture_alpha=off");
    CHECK(fast_engine_refuses(scene, settings).find(alpha) == std::string::npos);
    set_from_text(settings, "texture_alpha=blend");
    set_from_text(settings, "texture=off");
    CHECK(fast_engine_refuses(scene, settings).find(alpha) == std::string::npos);
}

TEST_CASE("Two runs diverge where only one lets a fragment through, and the alpha is given") {
    const Scene scene = scene_with_holes();
    Settings settings = default_settings(scene);
    settings.stage = Stage::depth;
    const Frame cut = prepare_frame(scene, settings);
    settings.texture_alpha = TextureAlpha::off;
    const Frame opaque = prepare_frame(scene, settings);
    const auto first = next_divergence(cut, opaque, cursor_begin);
    REQUIRE(first.has_value());
    // The corner of the picture is in the first texel, which is clear.
    CHECK(first->text.find("is cut out because the alpha of its texture is 0, below 1/2 in A") !=
          std::string::npos);
}

TEST_CASE("The fact pixel.cut_out counts the fragments of a pixel that fall through a hole") {
    Session session = open_session(lessons_folder() + "/scenes/lab-room.toml");
    set_scene(session, scene_with_holes());
    session.a.settings.stage = Stage::depth;
    Results results;
    int holes = 0;
    for (int row = 2; row < picture_side; row += 7) {
        for (int column = 3; column < picture_side; column += 5) {
            const int texel = texel_under(column, row);
            // Both triangles of a square draw its diagonal.
            if (texel < 0 || column == row) continue;
            INFO(column << "," << row);
            session.selection.pixel = glm::ivec2(column, row);
            finish(session, results);
            const int wanted = holed().rgba[4 * static_cast<std::size_t>(texel) + 3] < 128 ? 1 : 0;
            const Value cut_out = Facts(session, results)("pixel.cut_out");
            REQUIRE(is_there(cut_out));
            CHECK(std::get<double>(cut_out) == wanted);
            holes += wanted;
        }
    }
    CHECK(holes > 5);
}
