#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "ui/inspector/fragment_parts.h"
#include "ui/inspector/texture_parts.h"
#include "ui/ui.h"
#include "ui/widgets/arrows.h"
#include "ui/widgets/style.h"
#include "ui/widgets/swatch.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// A map is drawn texel by texel; a larger one by the first level of its mip chain that is not.
constexpr int most_map_texels = 64;

/// The ring on the map, design pixels.
constexpr float ring = 5.0f;

/// Black or white, whichever stands out; the weights of the channels are those of Rec. 709.
ImU32 readable_on(const glm::vec3& colour) {
    const float light = 0.2126f * colour.r + 0.7152f * colour.g + 0.0722f * colour.b;
    return light > 0.4f ? IM_COL32(0, 0, 0, 255) : IM_COL32(255, 255, 255, 255);
}

/// Does a texel of this map have a formula of its own, that of its weight?
bool has_weight_formula(SurfaceMap use) {
    return use == SurfaceMap::texture;
}

/// The formula that a texel leads to: its weight, or the mean that it is part of.
std::string number_of_texel(SurfaceMap use, int texel) {
    return has_weight_formula(use) ? fmt::format("texture.texel.{}.weight", texel)
                                   : first_number(use);
}

std::string texel_help(SurfaceMap use, const SampledTexel& texel) {
    return fmt::format("Column {}, row {} of level {}; its weight is {}.\nClick to see how {}.",
                       texel.column, texel.row, texel.level, shown({texel.weight}),
                       has_weight_formula(use) ? "that was calculated"
                                               : "the red of the texels is mixed");
}

/// A coordinate wrapped into the texture, and -1 where the texture runs backward there.
struct InTexture {
    float coordinate, sign;
};

InTexture in_texture(float coordinate, TextureWrap wrap) {
    const float part = coordinate - std::floor(coordinate);
    const bool is_odd = std::fmod(std::floor(coordinate), 2.0f) != 0.0f;
    switch (wrap) {
    case TextureWrap::repeat:
        break;
    case TextureWrap::clamp:
        return {std::clamp(coordinate, 0.0f, 1.0f), 1.0f};
    case TextureWrap::mirror:
        return is_odd ? InTexture{1.0f - part, -1.0f} : InTexture{part, 1.0f};
    }
    return {part, 1.0f};
}

bool is_number(ImVec2 place) {
    return std::isfinite(place.x) && std::isfinite(place.y);
}

/// From where the pixel lies to where the texture is read.
void draw_shift(ImDrawList* list, ImVec2 from, ImVec2 to, ImU32 colour, float u) {
    list->AddCircleFilled(from, 3.0f * u, colour);
    draw_arrow(list, u, from, to, {colour, IM_COL32(0, 0, 0, 160)});
}

} // namespace

ImU32 colour_in_map(const Ui& ui, SurfaceMap use, const glm::vec3& colour) {
    if (use == SurfaceMap::texture) return screen_colour(ui, colour);
    return packed({colour.r, colour.g, colour.b, 1.0f});
}

namespace {

/// Where the whole map is drawn on the screen.
struct MapArea {
    ImVec2 low, size;

    ImVec2 at(const glm::vec2& uv) const { return {low.x + uv.x * size.x, low.y + uv.y * size.y}; }
};

void draw_texels(const Ui& ui, const MapReading& reading, const MapArea& area) {
    const Texture& texture = *reading.map;
    std::size_t number = 0;
    while (std::max(texture.levels[number].width, texture.levels[number].height) > most_map_texels)
        ++number;
    const TextureLevel& level = texture.levels[number];
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const auto corner = [&](int column, int row) {
        return area.at({static_cast<float>(column) / static_cast<float>(level.width),
                        static_cast<float>(row) / static_cast<float>(level.height)});
    };
    for (int row = 0; row < level.height; ++row) {
        for (int column = 0; column < level.width; ++column) {
            list->AddRectFilled(corner(column, row), corner(column + 1, row + 1),
                                colour_in_map(ui, reading.use, level.at(column, row)));
        }
    }
}

/// Where the texture is read, mistakes included, and what the pixel covers there. False, and
/// nothing is drawn, if u or v is no number, as 0 / 0 is if zinv is wrong.
bool draw_place(const Ui& ui, const MapReading& reading, const MapArea& area, bool is_shifted) {
    const Frame& frame = ui.results.a.frame;
    const TextureWrap wrap = frame.settings.texture_wrap;
    const auto read_at = [&](TextureDirection direction, int count) {
        const bool is_u = direction == TextureDirection::u;
        return frame.stages.texel_place(is_u ? reading.place.texcoord.x : reading.place.texcoord.y,
                                        direction, count) /
               static_cast<float>(count);
    };
    const float v_sign = frame.settings.texel_rule == TexelRule::upside_down ? -1.0f : 1.0f;
    const TextureLevel& base = reading.map->base();
    const InTexture u = in_texture(read_at(TextureDirection::u, base.width), wrap),
                    v = in_texture(read_at(TextureDirection::v, base.height), wrap);
    const glm::vec2 place{u.coordinate, v.coordinate}, half{0.5f * u.sign, 0.5f * v.sign * v_sign};
    const ImVec2 centre = area.at(place);
    // A NaN may have been clamped to a border.
    const glm::vec2 texcoord = reading.place.texcoord;
    if (!is_number({texcoord.x, texcoord.y}) || !is_number(centre)) return false;
    const float thickness = 2.0f * ui.options.text_scale;
    const ImU32 mark = packed(palette(ui.options.theme).changed);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->PushClipRect(area.low, {area.low.x + area.size.x, area.low.y + area.size.y}, true);
    const glm::vec2 right = half * reading.place.footprint.right,
                    down = half * reading.place.footprint.down;
    const std::array covered{area.at(place - right - down), area.at(place + right - down),
                             area.at(place + right + down), area.at(place - right + down)};
    if (std::all_of(covered.begin(), covered.end(), is_number))
        list->AddQuad(covered[0], covered[1], covered[2], covered[3], mark, thickness);
    if (is_shifted) {
        // Backward from the ring, so that both ends are on the map's side of a border.
        const glm::vec2 way = reading.place.texcoord - reading.carried;
        const ImVec2 from = area.at(place - glm::vec2{way.x * u.sign, way.y * v.sign * v_sign});
        if (is_number(from))
            draw_shift(list, from, centre, packed(colour_of(Meaning::current, ui.options.theme)),
                       ui.options.text_scale);
    }
    list->PopClipRect();
    list->AddCircle(centre, ring * ui.options.text_scale, mark, 0, thickness);
    return true;
}

} // namespace

void draw_map(Ui& ui, const MapReading& reading) {
    const Texture& texture = *reading.map;
    const float side = map_side * ui.options.text_scale;
    const float width = static_cast<float>(texture.base().width);
    const float height = static_cast<float>(texture.base().height);
    const MapArea area{
        ImGui::GetCursorScreenPos(),
        {side * std::min(1.0f, width / height), side * std::min(1.0f, height / width)}};
    draw_texels(ui, reading, area);
    const bool is_shifted = report_of(ui).parallax && reading.use != SurfaceMap::height_map;
    const bool has_place = draw_place(ui, reading, area, is_shifted);
    ImGui::Dummy(area.size);
    const char* help =
        !has_place ? ". There is no ring: u or v is not a number here."
        : is_shifted
            ? ". The arrow goes from where the pixel lies on the flat surface to where the height "
              "map shifts it: the ring. The box is what the pixel covers."
            : ". The ring is where the pixel is, and the box around it is what the pixel covers.";
    register_widget(ui, "texture.map", "The whole " + map_words(reading.use) + help);
}

namespace {

/// What is in the texels that were taken, and which level they belong to, to their right: next to
/// the first row of each level, if there is room.
void draw_names_of_sampled(Ui& ui, const SampledTexels& taken, ImVec2 low) {
    const float u = ui.options.text_scale, side = texel_side * u;
    const float line = ImGui::GetTextLineHeight();
    const float x = low.x + (taken.count > 1 ? 2.0f : 1.0f) * side + 6.0f * u;
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    if (x + text_width("column, row") > right) return;
    const ImU32 ink = packed(palette(ui.options.theme).dim);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    for (int first = 0; first < taken.count; first += 4) {
        const int row = first / 2;
        const float top = low.y + static_cast<float>(row) * side + (first > 0 ? 6.0f * u : 0);
        const int level = taken.list[static_cast<std::size_t>(first)].level;
        list->AddText({x, top + 4.0f * u}, ink, "weight");
        list->AddText({x, top + side - u - line - 3.0f * u}, ink, "column, row");
        if (first + 1 < taken.count)
            list->AddText({x, top + side + 4.0f * u}, ink, fmt::format("level {}", level).c_str());
    }
}

} // namespace

void draw_sampled_texels(Ui& ui, const MapReading& reading) {
    const float u = ui.options.text_scale, side = texel_side * u;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::PushFont(ui.fonts.small);
    for (int k = 0; k < reading.taken.count; ++k) {
        const SampledTexel& texel = reading.taken.list[static_cast<std::size_t>(k)];
        // Each level has a square of four.
        const int column = k % 2, row = k / 2;
        const float x = static_cast<float>(column) * side;
        const float y = static_cast<float>(row) * side + (k < 4 ? 0.0f : 6.0f * u);
        const ImVec2 from{low.x + x, low.y + y}, to{from.x + side - u, from.y + side - u};
        const std::string name = fmt::format("texture.texel.{}", k);
        const std::string id = number_of_texel(reading.use, k);
        ImGui::SetCursorScreenPos(from);
        if (ImGui::InvisibleButton(name.c_str(), {side - u, side - u}))
            ui.inspector.chosen.texture_number = id;
        register_widget(ui, name, texel_help(reading.use, texel));
        list->AddRectFilled(from, to, colour_in_map(ui, reading.use, texel.colour));
        const bool is_chosen =
            has_weight_formula(reading.use) && ui.inspector.chosen.texture_number == id;
        list->AddRect(
            from, to,
            packed(is_chosen ? palette(ui.options.theme).changed : palette(ui.options.theme).line),
            0.0f, 0, is_chosen ? 2.0f * u : 1.0f * u);
        const ImU32 ink = readable_on(texel.colour);
        const float line = ImGui::GetTextLineHeight();
        list->AddText({from.x + 4.0f * u, from.y + 4.0f * u}, ink,
                      fixed(static_cast<double>(texel.weight), 3).c_str());
        list->AddText({from.x + 4.0f * u, to.y - line - 3.0f * u}, ink,
                      fmt::format("{}, {}", texel.column, texel.row).c_str());
    }
    draw_names_of_sampled(ui, reading.taken, low);
    ImGui::PopFont();
}

float height_of_sampled(const Ui& ui, const MapReading& reading) {
    const int count = reading.taken.count, rows = (count + 1) / 2;
    return (static_cast<float>(rows) * texel_side + (count > 4 ? 6.0f : 0.0f)) *
           ui.options.text_scale;
}

} // namespace rasterwalk
