#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "explain/light_formulas.h"
#include "ui/actions/go_to_source.h"
#include "ui/inspector/fragment_parts.h"
#include "ui/inspector/panels.h"
#include "ui/inspector/texture_parts.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The choice of a map.
struct MapChoice {
    SurfaceMap use;
    const char *name, *words, *help;
    const char* number; ///< id of the formula that is explained first
};
constexpr std::array map_choices{
    MapChoice{SurfaceMap::texture, "texture.show.texture", "texture",
              "The picture whose colours are seen on the surface.", "texture.level"},
    MapChoice{SurfaceMap::normal_map, "texture.show.normal_map", "normal map",
              "The picture whose colours are arrows that bend the normal.", "bump.colour.red"},
    MapChoice{SurfaceMap::height_map, "texture.show.height_map", "height map",
              "The picture whose red is a height. It shifts where the others are read.",
              "parallax.stored"},
};
static_assert(is_indexed_by(map_choices, &MapChoice::use));

/// The chosen map, or the first if that one does not act at the pixel.
const MapReading& shown_reading(const Ui& ui, const std::vector<MapReading>& readings) {
    const auto chosen = std::find_if(readings.begin(), readings.end(), [&](const MapReading& one) {
        return one.use == ui.inspector.chosen.surface_map;
    });
    return chosen == readings.end() ? readings.front() : *chosen;
}

void choose_texture_number(Ui& ui, const std::string& id) {
    ui.inspector.chosen.texture_number = id;
}

void choose_map(Ui& ui, const MapChoice& choice) {
    ui.inspector.chosen.surface_map = choice.use;
    choose_texture_number(ui, choice.number);
}

/// Asks about a number that is clicked, or goes to where it comes from.
void follow_texture_source(Ui& ui, const std::optional<Source>& source) {
    if (!source) return;
    if (source->kind == SourceKind::formula) choose_texture_number(ui, source->name);
    go_to_source(ui, *source);
}

void draw_texture_title(Ui& ui, const MapReading& reading) {
    const FragmentReport& report = report_of(ui);
    const Texture& texture = *reading.map;
    put_text(fmt::format("Pixel ({}, {})", report.pixel.x, report.pixel.y), ui.fonts.bold);
    register_widget(ui, "texture.pixel", "Column and row of the pixel that the fragment fell on.");
    const std::string size =
        fmt::format("{} × {} texels", texture.base().width, texture.base().height);
    const std::string file = texture.name.substr(texture.name.find_last_of('/') + 1);
    text_in(palette(ui.options.theme).dim,
            first_fitting({texture.name + ", " + size, file + ", " + size, size},
                          ImGui::GetContentRegionAvail().x));
    register_widget(ui, "texture.name",
                    "The " + map_words(reading.use) + ": the picture on the surface, " +
                        texture.name + ". Its pixels are called texels.");
}

/// Which of the maps that act at the pixel is shown; nothing to choose if there is one.
void draw_map_choice(Ui& ui, const std::vector<MapReading>& readings, SurfaceMap shown) {
    if (readings.size() < 2) return;
    for (const MapReading& reading : readings) {
        const MapChoice& choice = map_choices[static_cast<std::size_t>(reading.use)];
        if (&reading != &readings.front()) same_line_if_room(choice.words);
        if (button(ui, choice.name, choice.words, reading.use == shown ? Look::chosen : Look::plain,
                   choice.help))
            choose_map(ui, choice);
    }
}

/// The colour that the texels make, each number a link to its formula.
void draw_mixed_colour(Ui& ui, const MapReading& reading) {
    const bool is_texture = reading.use == SurfaceMap::texture;
    const float size = ImGui::GetTextLineHeight();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + 2.0f * size, from.y + size},
                                              colour_in_map(ui, reading.use, reading.colour));
    ImGui::Dummy({2.0f * size, size});
    ImGui::SameLine();
    draw_number_links(
        ui, {"", channel_names, reading.colour, is_texture ? "texture." : "bump.colour.",
             is_texture ? "texture." : "texture.normal_map.",
             " of the " + map_words(reading.use) + " here.\nClick to see how it was mixed."});
}

/// What a height map says here, and the height that this stands for.
void draw_mixed_height(Ui& ui) {
    const Palette& p = palette(ui.options.theme);
    const ParallaxTerms& terms = report_of(ui).parallax->terms;
    FormulaLine line(ui, 0.0f);
    line.text("red ", p.dim);
    if (line.link(shown({terms.stored}), "texture.height_map.red",
                  "Red of the height map here.\nClick to see how it was mixed.", p.text))
        choose_texture_number(ui, "parallax.stored");
    line.text("  height ", p.dim);
    if (line.link(shown({terms.height}), "texture.height_map.height",
                  "The height above the surface, world units.\nClick to see how it was "
                  "calculated.",
                  p.text))
        choose_texture_number(ui, "parallax.height");
}

/// The numbers of the map in use, below its drawings.
void draw_map_numbers(Ui& ui, const MapReading& reading) {
    const std::vector<Formula>& formulas = report_of(ui).formulas;
    const auto draw_numbers = [&](const char* section, const char* owner) {
        follow_texture_source(ui, draw_section(ui, formulas, section, owner));
    };
    switch (reading.use) {
    case SurfaceMap::texture:
        draw_mixed_colour(ui, reading);
        ImGui::Spacing();
        draw_numbers("parallax", "texture.");
        draw_numbers("texture", "");
        return;
    case SurfaceMap::normal_map:
        draw_mixed_colour(ui, reading);
        ImGui::Spacing();
        draw_map_arrow(ui, *report_of(ui).bump);
        draw_numbers("bump", "texture.");
        return;
    case SurfaceMap::height_map:
        draw_mixed_height(ui);
        ImGui::Spacing();
        draw_numbers("parallax", "texture.");
        return;
    }
}

void draw_texture_page(Ui& ui, const std::vector<MapReading>& readings) {
    const MapReading& reading = shown_reading(ui, readings);
    draw_texture_title(ui, reading);
    draw_map_choice(ui, readings, reading.use);
    ImGui::Spacing();
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float gap = 12.0f * ui.options.text_scale;
    const float inset = map_gap * ui.options.text_scale;
    const float side = map_side * ui.options.text_scale, map = inset + side;
    const float texels = 2.0f * texel_side * ui.options.text_scale;
    const bool fits = map + gap + texels <= ImGui::GetContentRegionAvail().x;
    ImGui::SetCursorScreenPos({start.x + inset, start.y});
    draw_map(ui, reading);
    const ImVec2 second{fits ? start.x + map + gap : start.x,
                        fits ? start.y : ImGui::GetCursorScreenPos().y + gap};
    ImGui::SetCursorScreenPos(second);
    draw_sampled_texels(ui, reading);
    const float bottom =
        std::max(fits ? start.y + side : second.y, second.y + height_of_sampled(ui, reading));
    ImGui::SetCursorScreenPos({start.x, bottom + gap});
    ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x);
    draw_map_numbers(ui, reading);
    ImGui::PopItemWidth();
}

/// The number that is explained if the chosen one is not there: the level first, if the filter
/// chooses one.
const Formula* usual_formula(const std::vector<Formula>& formulas, SurfaceMap use) {
    const Formula* const usual = find_formula(formulas, first_number(use));
    // A surface without axes has only its normal.
    if (usual == nullptr) return find_formula(formulas, "bump.normal.x");
    return use == SurfaceMap::texture && usual->section.empty()
               ? find_formula(formulas, "texture.x")
               : usual;
}

void draw_texture_formula(Ui& ui, SurfaceMap use) {
    const std::vector<Formula>& formulas = report_of(ui).formulas;
    const std::string& chosen = ui.inspector.chosen.texture_number;
    const Formula* const usual = usual_formula(formulas, use);
    const Formula* formula = find_formula(formulas, chosen);
    const bool is_unused_level = chosen == "texture.level" && formula != usual;
    if (formula == nullptr || is_unused_level) formula = usual;
    if (formula != nullptr)
        follow_texture_source(ui, draw_formula_card(ui, *formula, "texture.formula"));
}

/// Why nothing acts at the fragment shown.
std::string no_map_words(const Frame& frame, int triangle) {
    if (texture_of(*frame.scene, triangle) != nullptr) return "Textures are off.";
    if (normal_map_of(*frame.scene, triangle) != nullptr)
        return "This surface has a normal map, which acts only in light per pixel, and if normal "
               "maps are on.";
    return "This surface has no texture.";
}

void draw_no_texture(Ui& ui) {
    const Frame& frame = ui.results.a.frame;
    const std::optional<FragmentReport>& fragment = ui.results.a.inspected.fragment;
    std::string words = "Click a pixel of the picture, or step to a fragment.";
    if (frame.scene->textures.empty())
        words = "This scene has no textures.";
    else if (!has_fragments(frame.settings.stage))
        words = "This stage has no fragments. They come with filled triangles.";
    else if (fragment)
        words = no_map_words(frame, fragment->cursor.triangle);
    else if (ui.session.selection.pixel)
        words = "No fragment ever falls on this pixel. The History tab says why.";
    wrapped_text_in(palette(ui.options.theme).dim, words);
    register_widget(ui, "texture.none");
}

} // namespace

std::string map_words(SurfaceMap use) {
    return map_choices[static_cast<std::size_t>(use)].words;
}

const char* first_number(SurfaceMap use) {
    return map_choices[static_cast<std::size_t>(use)].number;
}

void draw_number_links(Ui& ui, const NumberLinks& numbers) {
    const Palette& p = palette(ui.options.theme);
    FormulaLine line(ui, 0.0f);
    if (!numbers.label.empty()) line.text(numbers.label, p.dim);
    for (int i = 0; i < 3; ++i) {
        const std::string name = numbers.names[static_cast<std::size_t>(i)];
        const std::string id = numbers.formula + name, number = shown({numbers.values[i]});
        if (find_formula(report_of(ui).formulas, id) == nullptr)
            line.text(number, p.text);
        else if (line.link(number, numbers.widget + name, name + numbers.help, p.text))
            choose_texture_number(ui, id);
        line.text("  ", p.text);
    }
}

void draw_texture_panel(Ui& ui) {
    const std::optional<FragmentReport>& fragment = ui.results.a.inspected.fragment;
    const std::vector<MapReading> readings =
        fragment ? map_readings(*fragment) : std::vector<MapReading>{};
    if (readings.empty()) {
        draw_no_texture(ui);
        return;
    }
    const SurfaceMap use = shown_reading(ui, readings).use;
    draw_panel(ui, "texture", {{[&] { draw_texture_page(ui, readings); }, true}},
               [&] { draw_texture_formula(ui, use); });
}

} // namespace rasterwalk
