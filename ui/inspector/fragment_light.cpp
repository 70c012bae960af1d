#include <string>

#include <fmt/format.h>

#include "base/element_names.h"
#include "explain/light_formulas.h"
#include "explain/shadow_formulas.h"
#include "picture/view_image.h"
#include "ui/actions/go_to_source.h"
#include "ui/inspector/fragment_parts.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// As the screen shows it: only if that is not the light itself.
void draw_clamped(Ui& ui, const glm::vec3& colour) {
    const Palette& p = palette(ui.options.theme);
    FormulaLine line(ui, 0.0f);
    const Frame& frame = ui.results.a.frame;
    const Encoding encoding = frame.settings.encoding;
    const bool is_encoded = encoding != Encoding::linear;
    const bool is_cut = shown_colour(colour, ScreenRules{}) != colour;
    const bool is_turned = frame.settings.channel_order == ChannelOrder::bgr;
    if (!is_cut && !is_encoded && !is_turned) return;
    const bool is_wrapped = frame.settings.colour_over_one == ColourOverOne::wrap;
    line.text(is_cut && is_wrapped          ? "wrapped "
              : encoding == Encoding::srgb  ? "sRGB "
              : encoding == Encoding::gamma ? "c^(1/2.2) "
              : is_cut                      ? "clamped "
                                            : "blue first ",
              p.dim);
    const glm::vec3 cut = shown_colour(colour, frame.stages.screen);
    for (int i = 0; i < 3; ++i)
        line.text(shown({cut[i]}) + (i < 2 ? "  " : ""), p.text);
}

/// The texels of the shadow map that decided; each leads to the moment that wrote it.
void draw_texels(Ui& ui, const ShadowTerms& shadow) {
    if (shadow.face < 0) return;
    FormulaLine line(ui, 0.0f);
    line.text(std::string("face ") + shadow_face_names[static_cast<std::size_t>(shadow.face)] +
                  "  ",
              palette(ui.options.theme).dim);
    for (int i = 0; i < shadow.texel_count; ++i) {
        const ShadowTexel& texel = shadow.texels[static_cast<std::size_t>(i)];
        const Meaning meaning = texel.is_lit ? Meaning::pass : Meaning::fail;
        const std::string sign = texel.is_lit ? passed_sign : failed_sign;
        if (line.link(fmt::format("{} ({}, {})", sign, texel.column, texel.row),
                      fmt::format("fragment.shadow.texel.{}", i),
                      "The texel of the shadow map that this pixel was compared with, by column "
                      "and row.\nClick to go to the pass in which the lamp looked there, to the "
                      "moment that wrote it.",
                      colour_of(meaning, ui.options.theme)))
            go_to_source(ui, from_texel(shadow.face, texel.column, texel.row));
        if (i + 1 < shadow.texel_count) line.text("  ", palette(ui.options.theme).dim);
    }
}

/// What is in the way, if anything casts shadows, and the numbers that show it.
void draw_shadow(Ui& ui, const std::string& prefix, const SurfaceLight& light) {
    const std::string words = shadow_text(light.shadow, ui.results.a.frame);
    if (words.empty()) return;
    const bool is_dark = light.shadow.is_dark() || !light.shadow.is_tested;
    wrapped_text_in(colour_of(is_dark ? Meaning::fail : Meaning::pass, ui.options.theme), words);
    register_widget(
        ui, "fragment.shadow",
        "Whether the lamp's light arrives, according to the shadows setting. Where it does "
        "not, there is no direct light.");
    draw_texels(ui, light.shadow);
    draw_fragment_section(ui, prefix + "shadow");
    draw_shadow_faces(ui, light.shadow);
}

/// Three numbers of the normal map on a line; each leads to its formula.
void draw_bump_line(Ui& ui, const char* word, const std::string& id,
                    const std::array<const char*, 3>& parts, const glm::vec3& value,
                    const std::string& help) {
    FormulaLine line(ui, 0.0f);
    line.text(std::string(word) + "  ", palette(ui.options.theme).dim);
    for (int i = 0; i < 3; ++i) {
        const std::string formula = "bump." + id + "." + parts[static_cast<std::size_t>(i)];
        if (line.link(shown({value[i]}), "fragment." + formula, help,
                      palette(ui.options.theme).text))
            follow_source(ui, from_formula(formula));
        line.text(i < 2 ? "  " : "", palette(ui.options.theme).text);
    }
}

/// How the normal map bends the normal.
void draw_bump(Ui& ui) {
    const FragmentReport& report = report_of(ui);
    if (!report.bump) return;
    const BumpReport& bump = *report.bump;
    if (bump.sign != 0.0f) {
        draw_bump_line(ui, "map", "colour", channel_names, bump.colour,
                       "Red, green and blue of the normal map there.");
        draw_bump_line(ui, "arrow", "arrow", axis_names, bump.arrow,
                       "What that colour stands for: along u, toward the texture's top, and away "
                       "from the surface.");
        draw_fragment_section(ui, "bump");
    }
    draw_bump_line(ui, "n", "normal", axis_names, bump.normal,
                   bump.space ? "The normal in the world, as the normal map bends it."
                              : "The normal used for the light, as the normal map bends it.");
    if (!bump.space) return;
    draw_bump_line(ui, "in t, b, n", "square.normal", axis_names, bump.space->normal,
                   "The normal used for the light, along the axes of tangent space.");
}

/// What reflects the light, its sum, and what the screen makes of that.
/// @param light the sum, before a texture is applied to it
void draw_reflected(Ui& ui, const std::string& prefix, const glm::vec3& light) {
    const FragmentReport& report = report_of(ui);
    draw_fragment_section(ui, prefix + "reflected");
    const bool is_painted = find_formula(report.formulas, prefix + "painted.red") != nullptr;
    draw_clamped(ui, is_painted ? light * report.texture->colour : light);
}

/// The light at one point, term by term.
void draw_light_terms(Ui& ui, const std::string& prefix, const SurfaceLight& light) {
    draw_fragment_section(ui, prefix + "normal");
    if (prefix == "pixel_light.") draw_fragment_section(ui, "parallax");
    if (prefix == "pixel_light.") draw_bump(ui);
    draw_fragment_section(ui, prefix + "lamp");
    draw_shadow(ui, prefix, light);
    draw_reflected(ui, prefix, light.reflected);
}

void draw_vertex_light(Ui& ui) {
    const FragmentReport& report = report_of(ui);
    const Palette& p = palette(ui.options.theme);
    for (int v = 0; v < triangle_corners; ++v) {
        FormulaLine line(ui, 0.0f);
        const glm::vec3& light = report.at_vertex[static_cast<std::size_t>(v)].reflected;
        line.text("R at " + vertex_name(v) + "  ", p.dim);
        for (int i = 0; i < 3; ++i) {
            const std::string channel = channel_names[static_cast<std::size_t>(i)];
            const ImVec4 colour =
                light[i] > 1.0f ? colour_of(Meaning::fail, ui.options.theme) : p.text;
            const std::string name = "fragment.vertex_light.v" + std::to_string(v) + "." + channel;
            if (line.link(shown({light[i]}), name,
                          channel + " of the light that the vertex reflects.\nClick to see it "
                                    "there, term by term.",
                          colour)) {
                go_to_source(ui, from_vertex(report.cursor.triangle, v, "light.R." + channel));
            }
            line.text(i < 2 ? "  " : "", p.text);
        }
    }
    draw_reflected(ui, "vertex_light.", report.light_per_vertex);
}

} // namespace

bool shows_vertex_light(const Ui& ui) {
    const Shading shading = report_of(ui).shading;
    if (shading != Shading::gouraud && shading != Shading::phong) return false;
    return (shading == Shading::gouraud) != ui.inspector.chosen.shows_other_light;
}

void draw_fragment_light(Ui& ui) {
    const FragmentReport& report = report_of(ui);
    const Palette& p = palette(ui.options.theme);
    if (report.shading == Shading::unlit) return;
    const bool in_force_is_vertex = report.shading == Shading::gouraud;
    const bool in_force_is_flat = report.shading == Shading::flat;
    const bool shows_vertex = shows_vertex_light(ui);
    begin_card(ui);
    ImGui::PushFont(ui.fonts.small);
    ImGui::AlignTextToFramePadding();
    text_in(p.dim, "light");
    register_widget(ui, "fragment.light", "R = ρ (D + N), term by term; see the tooltips.");
    struct LightChoice {
        const char* name;
        const char* title;
        const char* help;
        bool is_first; ///< the one in force, if it is not the light per pixel
    };
    const LightChoice per_triangle{"fragment.light.per_triangle", "per triangle",
                                   "The light at the middle of the triangle, used for all of "
                                   "it.",
                                   true};
    const LightChoice per_vertex{"fragment.light.per_vertex", "per vertex",
                                 "The light of the three vertices, interpolated.", true};
    const bool shows_first =
        in_force_is_flat ? !ui.inspector.chosen.shows_other_light : shows_vertex;
    const LightChoice choices[] = {in_force_is_flat ? per_triangle : per_vertex,
                                   {"fragment.light.per_pixel", "per pixel",
                                    "The light computed at the fragment's own position.", false}};
    for (const auto& choice : choices) {
        ImGui::SameLine();
        const bool in_force = choice.is_first == (in_force_is_vertex || in_force_is_flat);
        const std::string title = std::string(in_force ? "● " : "") + choice.title;
        const std::string help =
            std::string(choice.help) +
            (in_force ? "\nThis is the lighting in use." : "\nWhat the other lighting would give.");
        if (button(ui, choice.name, title,
                   choice.is_first == shows_first ? Look::plain : Look::quiet, help)) {
            ui.inspector.chosen.shows_other_light = !in_force;
        }
    }
    ImGui::PopFont();
    if (shows_first && in_force_is_flat) {
        draw_light_terms(ui, "triangle_light.", report.light_per_triangle);
    } else if (shows_first) {
        draw_vertex_light(ui);
    } else {
        draw_light_terms(ui, "pixel_light.", report.light);
    }
    end_card(ui);
}

} // namespace rasterwalk
