#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "explain/light_formulas.h"
#include "ui/actions/go_to_source.h"
#include "ui/inspector/fragment_parts.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/style.h"
#include "ui/widgets/swatch.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The texture is drawn texel by texel; a larger one by the first level of its mip chain that is
/// not.
constexpr int most_map_texels = 64;

/// Sides of the two drawings, design pixels.
constexpr float map_side = 132.0f, texel_side = 56.0f;

/// The ring on the map, and how far it reaches beyond the map when its middle is at the border,
/// design pixels.
constexpr float ring = 5.0f, map_gap = 6.0f;

const TextureReport& shown_texture(const Ui& ui) {
    return *report_of(ui).texture;
}

/// Black or white, whichever stands out; the weights of the channels are those of Rec. 709.
ImU32 readable_on(const glm::vec3& colour) {
    const float light = 0.2126f * colour.r + 0.7152f * colour.g + 0.0722f * colour.b;
    return light > 0.4f ? IM_COL32(0, 0, 0, 255) : IM_COL32(255, 255, 255, 255);
}

void choose_texture_number(Ui& ui, const std::string& id) {
    ui.inspector.chosen.texture_number = id;
}

/// Asks about a number that is clicked, or goes to where it comes from.
void follow_texture_source(Ui& ui, const std::optional<Source>& source) {
    if (!source) return;
    if (source->kind == SourceKind::formula) choose_texture_number(ui, source->name);
    go_to_source(ui, *source);
}

void draw_texture_title(Ui& ui) {
    const FragmentReport& report = report_of(ui);
    const Texture& texture = *shown_texture(ui).surface.texture;
    put_text(fmt::format("Pixel ({}, {})", report.pixel.x, report.pixel.y), ui.fonts.bold);
    register_widget(ui, "texture.pixel", "Column and row of the pixel that the fragment fell on.");
    const std::string size =
        fmt::format("{} × {} texels", texture.base().width, texture.base().height);
    const std::string file = texture.name.substr(texture.name.find_last_of('/') + 1);
    text_in(palette(ui.options.theme).dim,
            first_fitting({texture.name + ", " + size, file + ", " + size, size},
                          ImGui::GetContentRegionAvail().x));
    register_widget(ui, "texture.name",
                    "The texture: the picture on the surface, " + texture.name +
                        ". Its pixels are called texels.");
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

/// From where the pixel lies to where the texture is read.
void draw_shift(ImDrawList* list, ImVec2 from, ImVec2 to, ImU32 colour, float u) {
    const float x = to.x - from.x, y = to.y - from.y, length = std::hypot(x, y);
    list->AddCircleFilled(from, 3.0f * u, colour);
    if (!(length > 0.0f)) return;
    list->AddLine(from, to, IM_COL32(0, 0, 0, 160), 4.0f * u);
    list->AddLine(from, to, colour, 2.0f * u);
    const float head = std::min(7.0f * u, 0.5f * length) / length;
    const ImVec2 base{to.x - head * x, to.y - head * y};
    const ImVec2 across{-0.5f * head * y, 0.5f * head * x};
    list->AddTriangleFilled(to, {base.x + across.x, base.y + across.y},
                            {base.x - across.x, base.y - across.y}, colour);
}

/// The texture, and the footprint of the pixel on it.
void draw_texture_map(Ui& ui) {
    const TextureReport& report = shown_texture(ui);
    const Texture& texture = *report.surface.texture;
    std::size_t number = 0;
    while (std::max(texture.levels[number].width, texture.levels[number].height) > most_map_texels)
        ++number;
    const TextureLevel& level = texture.levels[number];
    const float side = map_side * ui.options.text_scale;
    const float width = static_cast<float>(texture.base().width);
    const float height = static_cast<float>(texture.base().height);
    const ImVec2 size{side * std::min(1.0f, width / height), side * std::min(1.0f, height / width)};
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const auto at = [&](const glm::vec2& uv) {
        return ImVec2{low.x + uv.x * size.x, low.y + uv.y * size.y};
    };
    const auto corner = [&](int column, int row) {
        return at({static_cast<float>(column) / static_cast<float>(level.width),
                   static_cast<float>(row) / static_cast<float>(level.height)});
    };
    for (int row = 0; row < level.height; ++row) {
        for (int column = 0; column < level.width; ++column) {
            list->AddRectFilled(corner(column, row), corner(column + 1, row + 1),
                                screen_colour(ui, level.at(column, row)));
        }
    }
    const TextureWrap wrap = ui.results.a.frame.settings.texture_wrap;
    // Where the texture is read, mistakes included.
    const auto read_at = [&](TextureDirection direction, int count) {
        const bool is_u = direction == TextureDirection::u;
        return ui.results.a.frame.stages.texel_place(
                   is_u ? report.place.texcoord.x : report.place.texcoord.y, direction, count) /
               static_cast<float>(count);
    };
    const float v_sign =
        ui.results.a.frame.settings.texel_rule == TexelRule::upside_down ? -1.0f : 1.0f;
    const InTexture u = in_texture(read_at(TextureDirection::u, texture.base().width), wrap),
                    v = in_texture(read_at(TextureDirection::v, texture.base().height), wrap);
    const glm::vec2 place{u.coordinate, v.coordinate}, half{0.5f * u.sign, 0.5f * v.sign * v_sign};
    const glm::vec2 right = half * report.place.footprint.right,
                    down = half * report.place.footprint.down;
    const ImU32 mark = packed(palette(ui.options.theme).changed);
    list->PushClipRect(low, {low.x + size.x, low.y + size.y}, true);
    list->AddQuad(at(place - right - down), at(place + right - down), at(place + right + down),
                  at(place - right + down), mark, 2.0f * ui.options.text_scale);
    if (report_of(ui).parallax) {
        // Backward from the ring, so that both ends are on the map's side of a border.
        const glm::vec2 way = report.place.texcoord - report.carried,
                        shift{way.x * u.sign, way.y * v.sign * v_sign};
        draw_shift(list, at(place - shift), at(place),
                   packed(colour_of(Meaning::current, ui.options.theme)), ui.options.text_scale);
    }
    list->PopClipRect();
    list->AddCircle(at(place), ring * ui.options.text_scale, mark, 0, 2.0f * ui.options.text_scale);
    ImGui::Dummy(size);
    register_widget(
        ui, "texture.map",
        report_of(ui).parallax
            ? "The whole texture. The arrow goes from where the pixel lies on the flat surface to "
              "where the height map shifts it: the ring. The box is what the pixel covers."
            : "The whole texture. The ring is where the pixel is, and the box around it is what "
              "the pixel covers.");
}

/// What is in the texels that were taken, and which level they belong to, to their right: next to
/// the first row of each level, if there is room.
void draw_names_of_sampled(Ui& ui, ImVec2 low) {
    const SampledTexels& taken = shown_texture(ui).taken;
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

/// The texels that were taken, in their places side by side, each with its weight.
void draw_sampled_texels(Ui& ui) {
    const TextureReport& report = shown_texture(ui);
    const float u = ui.options.text_scale, side = texel_side * u;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::PushFont(ui.fonts.small);
    for (int k = 0; k < report.taken.count; ++k) {
        const SampledTexel& texel = report.taken.list[static_cast<std::size_t>(k)];
        // Each level has a square of four.
        const int column = k % 2, row = k / 2;
        const float x = static_cast<float>(column) * side;
        const float y = static_cast<float>(row) * side + (k < 4 ? 0.0f : 6.0f * u);
        const ImVec2 from{low.x + x, low.y + y}, to{from.x + side - u, from.y + side - u};
        const std::string id = fmt::format("texture.texel.{}.weight", k);
        ImGui::SetCursorScreenPos(from);
        if (ImGui::InvisibleButton(id.c_str(), {side - u, side - u})) choose_texture_number(ui, id);
        register_widget(
            ui, fmt::format("texture.texel.{}", k),
            fmt::format("Column {}, row {} of level {}; its weight is {}.\nClick to see "
                        "how that was calculated.",
                        texel.column, texel.row, texel.level, shown({texel.weight})));
        list->AddRectFilled(from, to, screen_colour(ui, texel.colour));
        const bool is_chosen = ui.inspector.chosen.texture_number == id;
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
    draw_names_of_sampled(ui, low);
    ImGui::PopFont();
}

/// The height of the taken texels one below another, with the gap between two levels, screen
/// pixels.
float height_of_sampled(const Ui& ui) {
    const int count = shown_texture(ui).taken.count;
    const int rows = (count + 1) / 2;
    return (static_cast<float>(rows) * texel_side + (count > 4 ? 6.0f : 0.0f)) *
           ui.options.text_scale;
}

void draw_mixed_colour(Ui& ui) {
    const TextureReport& report = shown_texture(ui);
    const Palette& p = palette(ui.options.theme);
    const float size = ImGui::GetTextLineHeight();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + 2.0f * size, from.y + size},
                                              screen_colour(ui, report.colour));
    ImGui::Dummy({2.0f * size, size});
    ImGui::SameLine();
    FormulaLine line(ui, 0.0f);
    for (int i = 0; i < 3; ++i) {
        const std::string channel = channel_names[static_cast<std::size_t>(i)];
        const std::string id = "texture." + channel;
        if (line.link(shown({report.colour[i]}), id,
                      channel + " of the texture here.\nClick to see how it was mixed.", p.text))
            choose_texture_number(ui, id);
        line.text("  ", p.text);
    }
}

void draw_texture_page(Ui& ui) {
    draw_texture_title(ui);
    ImGui::Spacing();
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float gap = 12.0f * ui.options.text_scale;
    const float inset = map_gap * ui.options.text_scale;
    const float side = map_side * ui.options.text_scale, map = inset + side;
    const float texels = 2.0f * texel_side * ui.options.text_scale;
    const bool fits = map + gap + texels <= ImGui::GetContentRegionAvail().x;
    ImGui::SetCursorScreenPos({start.x + inset, start.y});
    draw_texture_map(ui);
    const ImVec2 second{fits ? start.x + map + gap : start.x,
                        fits ? start.y : ImGui::GetCursorScreenPos().y + gap};
    ImGui::SetCursorScreenPos(second);
    draw_sampled_texels(ui);
    const float bottom =
        std::max(fits ? start.y + side : second.y, second.y + height_of_sampled(ui));
    ImGui::SetCursorScreenPos({start.x, bottom + gap});
    draw_mixed_colour(ui);
    ImGui::Spacing();
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x);
    follow_texture_source(ui, draw_section(ui, report_of(ui).formulas, "parallax", "texture."));
    follow_texture_source(ui, draw_section(ui, report_of(ui).formulas, "texture", ""));
    ImGui::PopItemWidth();
}

/// The chosen number; the level first, if the filter chooses one.
void draw_texture_formula(Ui& ui) {
    const std::vector<Formula>& formulas = report_of(ui).formulas;
    const Formula* const level = find_formula(formulas, "texture.level");
    const bool has_level = !level->section.empty();
    const std::string& chosen = ui.inspector.chosen.texture_number;
    const Formula* formula = find_formula(formulas, chosen);
    if (formula == nullptr || (formula == level && !has_level))
        formula = has_level ? level : find_formula(formulas, "texture.x");
    follow_texture_source(ui, draw_formula_card(ui, *formula, "texture.formula"));
}

void draw_no_texture(Ui& ui) {
    const Frame& frame = ui.results.a.frame;
    std::string words = "Click a pixel of the picture, or step to a fragment.";
    if (frame.scene->textures.empty())
        words = "This scene has no textures.";
    else if (frame.settings.texture == TextureUse::off)
        words = "Textures are off.";
    else if (!has_fragments(frame.settings.stage))
        words = "This stage has no fragments. They come with filled triangles.";
    else if (ui.results.a.inspected.fragment)
        words = "This surface has no texture.";
    else if (ui.session.selection.pixel)
        words = "No fragment ever falls on this pixel. The History tab says why.";
    wrapped_text_in(palette(ui.options.theme).dim, words);
    register_widget(ui, "texture.none");
}

} // namespace

void draw_texture_panel(Ui& ui) {
    const std::optional<FragmentReport>& fragment = ui.results.a.inspected.fragment;
    if (!fragment || !fragment->texture) {
        draw_no_texture(ui);
        return;
    }
    draw_panel(ui, "texture", {{[&] { draw_texture_page(ui); }, true}},
               [&] { draw_texture_formula(ui); });
}

} // namespace rasterwalk
