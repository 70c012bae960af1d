#include "ui/page/figure_view.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "facts/facts.h"
#include "figures/figure_drawing.h"
#include "session/quiz_state.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Sizes of the style in a browser, in the figure's unit; see figure_style().
constexpr float line_width = 1.5f, thin_width = 0.75f, thick_width = 3.0f, dash_length = 4.0f;
constexpr float text_size = 14.0f, small_size = 12.0f;
constexpr float lowered_share = 0.75f, lowered_by = 0.25f, soft_opacity = 0.2f;
constexpr float arrow_length = 9.0f, arrow_half_width = 3.5f;

/// A font is drawn at its own size, which is sharp, if the wanted one is within these factors.
constexpr float least_own_size = 0.75f, largest_own_size = 1.3f;

/// A handle is taken from this far around it at least, design pixels.
constexpr float least_grip = 10.0f;

ImVec4 colour_of_figure(FigureColour colour, Theme theme) {
    switch (colour) {
    case FigureColour::ink:
        return palette(theme).text;
    case FigureColour::quiet:
        return palette(theme).dim;
    case FigureColour::edge_1:
        return colour_of(Meaning::edge_1, theme);
    case FigureColour::edge_2:
        return colour_of(Meaning::edge_2, theme);
    case FigureColour::edge_3:
        return colour_of(Meaning::edge_3, theme);
    case FigureColour::left:
        return colour_of(Meaning::left_end, theme);
    case FigureColour::right:
        return colour_of(Meaning::right_end, theme);
    case FigureColour::current:
        return colour_of(Meaning::current, theme);
    case FigureColour::pass:
        return colour_of(Meaning::pass, theme);
    case FigureColour::fail:
        return colour_of(Meaning::fail, theme);
    }
    return palette(theme).text;
}

/// Where the figure is on the screen.
struct FigurePlace {
    const Ui& ui;
    ImDrawList* list;
    ImVec2 low;
    float scale; ///< screen pixels per unit of the figure

    ImVec2 at(glm::vec2 place) const { return {low.x + scale * place.x, low.y + scale * place.y}; }
    glm::vec2 from(ImVec2 screen) const {
        return {(screen.x - low.x) / scale, (screen.y - low.y) / scale};
    }
    ImU32 ink(const FigureLook& look, float opacity = 1.0f) const {
        return packed(colour_of_figure(look.colour, ui.options.theme), opacity);
    }
};

float width_of_line(const FigureLook& look) {
    if (look.is_thick) return thick_width;
    return look.is_thin ? thin_width : line_width;
}

/// A dashed piece from place to place, which begins in the midst of a dash or gap.
/// @param done the length of what is already drawn, in the figure's unit
void draw_dashes(const FigurePlace& place, const FigureLook& look, glm::vec2 a, glm::vec2 b,
                 float done, int& budget) {
    const float length = glm::distance(a, b);
    if (!(length > 0.0f)) return;
    const float period = 2.0f * dash_length;
    for (float from = -std::fmod(done, period); from < length && budget > 0; from += period) {
        const float low = std::max(from, 0.0f), high = std::min(from + dash_length, length);
        if (high <= low) continue;
        place.list->AddLine(place.at(a + (low / length) * (b - a)),
                            place.at(a + (high / length) * (b - a)), place.ink(look),
                            place.scale * width_of_line(look));
        --budget;
    }
}

void draw_arrow_head(const FigurePlace& place, const FigureLook& look, glm::vec2 from,
                     glm::vec2 to) {
    const float length = glm::distance(from, to);
    if (!(length > 0.0f)) return;
    const glm::vec2 along = (to - from) / length, across{-along.y, along.x};
    const glm::vec2 back = to - std::min(arrow_length, length) * along;
    place.list->AddTriangleFilled(place.at(to), place.at(back + arrow_half_width * across),
                                  place.at(back - arrow_half_width * across), place.ink(look));
}

void draw_figure_line(const FigurePlace& place, const FigureLine& line, int& budget) {
    budget -= static_cast<int>(line.places.size());
    if (budget < 0) return;
    std::vector<ImVec2> corners;
    for (const glm::vec2& each : line.places)
        corners.push_back(place.at(each));
    const auto count = static_cast<int>(corners.size());
    const FigureLook& look = line.look;
    if (look.is_filled || look.is_soft)
        place.list->AddConvexPolyFilled(corners.data(), count,
                                        place.ink(look, look.is_filled ? 1.0f : soft_opacity));
    if (look.is_filled || look.is_bare) return;
    if (look.is_dashed) {
        const std::size_t pieces = line.places.size() - (line.is_closed ? 0 : 1);
        float done = 0.0f;
        for (std::size_t i = 0; i < pieces; ++i) {
            const glm::vec2 a = line.places[i], b = line.places[(i + 1) % line.places.size()];
            draw_dashes(place, look, a, b, done, budget);
            done += glm::distance(a, b);
        }
    } else {
        place.list->AddPolyline(corners.data(), count, place.ink(look),
                                line.is_closed ? ImDrawFlags_Closed : ImDrawFlags_None,
                                place.scale * width_of_line(look));
    }
    if (look.has_arrow)
        draw_arrow_head(place, look, line.places[line.places.size() - 2], line.places.back());
}

/// A span with the font and the size that it is drawn in, screen pixels.
struct SetSpan {
    const FigureSpan* span = nullptr;
    ImFont* font = nullptr;
    float size = 0.0f, width = 0.0f;
};

SetSpan set_span(const FigurePlace& place, const FigureSpan& span) {
    const Fonts& fonts = place.ui.fonts;
    SetSpan set{&span};
    set.font = span.look.is_bold     ? fonts.bold
               : span.look.is_italic ? fonts.italic
               : span.look.is_small  ? fonts.small
                                     : fonts.text;
    set.size = place.scale * (span.look.is_small ? small_size : text_size);
    const float own = set.font->FontSize;
    if (set.size > least_own_size * own && set.size < largest_own_size * own) set.size = own;
    set.size = std::max(set.size, least_own_size * own);
    if (span.is_lowered) set.size *= lowered_share;
    set.width = text_width(set.font, span.text, set.size);
    return set;
}

void draw_figure_text(const FigurePlace& place, const FigureText& text, int& budget) {
    std::vector<SetSpan> spans;
    float width = 0.0f;
    for (const FigureSpan& span : text.spans) {
        if (span.text.empty()) continue;
        budget -= static_cast<int>(span.text.size());
        if (budget < 0) return;
        spans.push_back(set_span(place, span));
        width += spans.back().width;
    }
    ImVec2 pen = place.at(text.at);
    if (text.anchor == FigureShape::Anchor::middle) pen.x -= 0.5f * width;
    if (text.anchor == FigureShape::Anchor::end) pen.x -= width;
    for (const SetSpan& set : spans) {
        const float ascent = set.font->Ascent * set.size / set.font->FontSize;
        const float drop = set.span->is_lowered ? lowered_by * set.size / lowered_share : 0.0f;
        const char* const begin = set.span->text.data();
        place.list->AddText(set.font, set.size,
                            {std::floor(pen.x), std::floor(pen.y - ascent + drop)},
                            place.ink(set.span->look), begin, begin + set.span->text.size());
        pen.x += set.width;
    }
}

/// A handle's button, and what dragging it or an arrow does.
void work_grip(Ui& ui, const FigurePlace& place, const Figure& figure, const FigureGrip& grip,
               const FactReader& fact) {
    const FigureHandle& handle = figure.handles[static_cast<std::size_t>(grip.handle)];
    // However far out and large a lesson makes it, it can be taken at the figure's edge, and the
    // page does not grow by it.
    const glm::vec2 size = figure.size;
    const float largest = std::max(0.5f * place.scale * std::min(size.x, size.y), 1.0f);
    const float radius =
        std::min(std::max(place.scale * grip.radius, least_grip * ui.options.text_scale), largest);
    const ImVec2 centre = place.at(glm::clamp(grip.at, glm::vec2(0.0f), size));
    ImGui::SetCursorScreenPos({centre.x - radius, centre.y - radius});
    const std::string name = "figure." + handle.setting;
    ImGui::InvisibleButton(name.c_str(), {2.0f * radius, 2.0f * radius});
    const bool is_held = ImGui::IsItemActive(), is_hovered = ImGui::IsItemHovered();
    if (is_hovered || is_held) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        place.list->AddCircle(centre, place.scale * grip.radius + 4.0f * ui.options.text_scale,
                              packed(palette(ui.options.theme).link), 0,
                              2.0f * ui.options.text_scale);
    }
    register_widget(ui, name, "Drag it to change " + std::string(handle.set->title) + ".");
    Settings& settings = ui.session.a.settings;
    const float now = slider_value(*handle.set, handle.range, settings);
    float wanted = now;
    if (is_held && ImGui::IsMouseDragging(ImGuiMouseButton_Left))
        wanted = dragged_value(figure, handle, place.from(ImGui::GetMousePos()), fact);
    if (const int more = take_arrows(ui, name).more(); more != 0)
        wanted = slider_stop(handle.range, static_cast<double>(now), more);
    if (wanted != now) set_slider_value(*handle.set, handle.range, wanted, settings);
}

} // namespace

void show_figure(Ui& ui, const Figure& figure, ImVec2 low, ImVec2 high, int& budget) {
    if (budget <= 0) return;
    const Facts facts(ui.session, ui.results, &ui.lesson.facts);
    // Numbers of settings would give away what a quiz asks for.
    const bool is_still = hides_settings(ui.session);
    const FactReader fact = [&](std::string_view name) -> Value {
        return is_still ? Value() : facts(name);
    };
    const FigureDrawing drawing = draw_figure(figure, fact);
    const FigurePlace place{ui, ImGui::GetWindowDrawList(), low, (high.x - low.x) / figure.size.x};
    place.list->PushClipRect(low, high, true);
    for (const FigureLine& line : drawing.lines)
        draw_figure_line(place, line, budget);
    for (const FigureText& text : drawing.texts)
        draw_figure_text(place, text, budget);
    if (!is_still) {
        ImGui::PushID(&figure);
        for (const FigureGrip& grip : drawing.grips)
            work_grip(ui, place, figure, grip, fact);
        ImGui::PopID();
    }
    place.list->PopClipRect();
}

} // namespace rasterwalk
