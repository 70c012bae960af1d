#include "ui/start/start_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "picture/thumbnail.h"
#include "pipeline/work.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

constexpr int largest_side = 400; ///< pixels

/// The scene with these settings at a step of the strip. A point is one pixel large: points are
/// drawn half as far apart, and shown at twice the size.
Image stage_picture(const Scene& scene, Settings settings, const StripStep& step, int side) {
    set_step(settings, step);
    return thumbnail(scene, settings, step.stage == Stage::points ? std::max(1, side / 2) : side);
}

constexpr int pictures_of_way = 3;
constexpr float picture_gap = 10.0f; ///< between two, design pixels
constexpr float least_start_picture = 56.0f;

using StartImages = std::array<Image, pictures_of_way>;
using StartWords = std::array<const char*, pictures_of_way>;

constexpr StartWords words_of_time{"a third is drawn", "two thirds", "the frame"};
constexpr StartWords words_of_check{"yours", "correct", "what differs"};

/// The scene with only the first of its triangles.
Scene first_triangles(const Scene& scene, int count) {
    Scene begun;
    begun.space = scene.space;
    begun.camera = scene.camera;
    begun.light = scene.light;
    begun.viewport = scene.viewport;
    for (const Vertex& vertex : scene.mesh.vertices())
        begun.mesh.add_vertex(vertex);
    for (int t = 0; t < count; ++t)
        begun.mesh.add_triangle(scene.mesh.triangles()[static_cast<std::size_t>(t)]);
    return begun;
}

StartImages pictures_of_time(const Scene& scene, const Settings& settings, int side) {
    StartImages images;
    for (int i = 0; i < pictures_of_way; ++i) {
        const int count = scene.triangle_count() * (i + 1) / pictures_of_way;
        images[static_cast<std::size_t>(i)] =
            thumbnail(first_triangles(scene, count), settings, side);
    }
    return images;
}

/// Where the pictures differ in the colour of failure, over what they share in grey.
Image marked_difference(const Image& wrong, const Image& right, const ImVec4& mark) {
    Image image = right;
    const std::array<float, 3> marked{mark.x, mark.y, mark.z};
    for (std::size_t at = 0; at + 3 < image.rgba.size(); at += 4) {
        const bool differs = !std::equal(&wrong.rgba[at], &wrong.rgba[at] + 3, &right.rgba[at]);
        const int grey = (right.rgba[at] + right.rgba[at + 1] + right.rgba[at + 2]) / 9;
        for (std::size_t c = 0; c < 3; ++c) {
            image.rgba[at + c] = differs
                                     ? static_cast<std::uint8_t>(std::lround(255.0f * marked[c]))
                                     : static_cast<std::uint8_t>(grey);
        }
    }
    return image;
}

/// A picture without a depth test, the right one, and what differs.
StartImages pictures_of_check(const Ui& ui, const Scene& scene, Settings settings, int side) {
    StartImages images;
    images[1] = thumbnail(scene, settings, side);
    settings.depth_test = DepthTest::off;
    images[0] = thumbnail(scene, settings, side);
    images[2] = marked_difference(images[0], images[1], colour_of(Meaning::fail, ui.options.theme));
    return images;
}

void renew_start_pictures(Ui& ui, int side) {
    StartPictures& pictures = ui.start.start_pictures;
    const std::shared_ptr<const Scene>& scene = ui.session.scene;
    if (pictures.scene == scene && pictures.side == side && pictures.theme == ui.options.theme)
        return;
    pictures.scene = scene;
    pictures.side = side;
    pictures.theme = ui.options.theme;
    pictures.is_shown.fill(false);
    Settings settings = default_settings(*scene);
    light_up(ui.session, settings);
    set_step(settings, stage_list().back().step);
    constexpr int drawn = 2 * pictures_of_way;
    if (thumbnail_work(*scene, settings, side) * drawn > frame_limit.at_once) return;
    const auto show = [&](StartChoice choice, const StartImages& images) {
        const auto place = static_cast<std::size_t>(choice);
        pictures.is_shown[place] = true;
        for (std::size_t i = 0; i < images.size(); ++i) {
            ImTextureID& texture = pictures.textures[place][i];
            texture = ui.host.textures->upload(texture, images[i]);
        }
    };
    if (scene->triangle_count() >= pictures_of_way)
        show(StartChoice::stages, pictures_of_time(*scene, settings, side));
    const StartImages check = pictures_of_check(ui, *scene, settings, side);
    if (!(check[0] == check[1])) show(StartChoice::picture, check);
}

} // namespace

void light_up(const Session& session, Settings& settings) {
    for (const Preset& preset : session.presets) {
        if (preset.name == "visible light") apply_preset(preset, settings);
    }
}

void renew_stage_pictures(Ui& ui, int side) {
    StagePictures& pictures = ui.start.pictures;
    const std::shared_ptr<const Scene>& scene = ui.session.scene;
    side = std::min(side, largest_side);
    if (pictures.scene == scene && pictures.side == side) return;
    pictures.scene = scene;
    pictures.side = side;
    Settings settings = default_settings(*scene);
    light_up(ui.session, settings);
    pictures.is_drawn = thumbnail_work(*scene, settings, side) * stage_count <= frame_limit.at_once;
    if (!pictures.is_drawn) return;
    for (std::size_t i = 0; i < pictures.textures.size(); ++i) {
        const Image image = stage_picture(*scene, settings, stage_list()[i].step, side);
        pictures.textures[i] = ui.host.textures->upload(pictures.textures[i], image);
    }
}

void draw_start_pictures(Ui& ui, StartChoice choice, ImVec2 low, ImVec2 high, float most) {
    const float u = ui.options.text_scale;
    const float gap = picture_gap * u;
    const float caption = ui.fonts.small->FontSize + 6.0f * u;
    const float width = high.x - low.x;
    const float side =
        std::floor(std::min((width - gap * (pictures_of_way - 1)) / pictures_of_way, most));
    const float y = std::round(high.y - caption - side);
    if (side < least_start_picture * u || y < low.y) return;
    renew_start_pictures(ui, static_cast<int>(side));
    const StartPictures& pictures = ui.start.start_pictures;
    const auto place = static_cast<std::size_t>(choice);
    if (!pictures.is_shown[place]) return;
    const Palette& p = palette(ui.options.theme);
    const StartWords& words = choice == StartChoice::stages ? words_of_time : words_of_check;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float step = std::round((width - side) / (pictures_of_way - 1));
    for (std::size_t i = 0; i < words.size(); ++i) {
        const float x = std::round(low.x) + step * static_cast<float>(i);
        list->AddImage(pictures.textures[place][i], {x, y}, {x + side, y + side});
        list->AddRect({x, y}, {x + side, y + side}, packed(p.line));
        list->AddText(ui.fonts.small, ui.fonts.small->FontSize, {x, y + side + 5.0f * u},
                      packed(p.dim), words[i]);
    }
}

} // namespace rasterwalk
