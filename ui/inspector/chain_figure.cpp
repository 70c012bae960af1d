#include "ui/inspector/chain_figure.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "explain/space_chain.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The slider rests at a space that is nearer than this.
constexpr double catch_range = 0.08;

constexpr double last_space = static_cast<double>(chain_space_count - 1);

/// Heights of the figure and of the slider, design pixels.
constexpr float figure_height = 230.0f, least_figure_height = 80.0f, slider_height = 24.0f;

/// The half width of what the figure shows, in its own units: a cube of side 2 fits.
constexpr double half_width = 1.75;

ChainLook& look_of_chain(Ui& ui) {
    return ui.inspector.chain;
}

std::size_t space_near(const ChainLook& look) {
    return static_cast<std::size_t>(std::lround(look.at));
}

void bring_chain_up_to_date(Ui& ui) {
    ChainLook& look = look_of_chain(ui);
    const int triangle = *ui.results.a.triangle;
    if (look.frame_number == ui.results.a.frame_number && look.triangle == triangle &&
        look.was_whole_scene == look.is_whole_scene)
        return;
    look.frame_number = ui.results.a.frame_number;
    look.triangle = triangle;
    look.was_whole_scene = look.is_whole_scene;
    look.chain = space_chain(ui.results.a.frame, triangle, look.is_whole_scene);
}

void draw_space_buttons(Ui& ui) {
    ChainLook& look = look_of_chain(ui);
    for (std::size_t i = 0; i < chain_space_count; ++i) {
        const std::string label(space_names[i]);
        if (i > 0) same_line_if_room(label);
        const bool is_chosen = look.at == static_cast<double>(i);
        if (button(ui, "chain.space." + label, label, is_chosen ? Look::chosen : Look::outline,
                   "Shows the figure in this space."))
            look.at = static_cast<double>(i);
    }
}

void draw_slider(Ui& ui) {
    ChainLook& look = look_of_chain(ui);
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale, inset = 8.0f * u;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = std::max(ImGui::GetContentRegionAvail().x, 4.0f * inset);
    const float track = width - 2.0f * inset, y = low.y + 0.5f * slider_height * u;
    const auto x_of = [&](double at) {
        return low.x + inset + track * static_cast<float>(at / last_space);
    };
    ImGui::InvisibleButton("chain.slider", {width, slider_height * u});
    if (ImGui::IsItemActive()) {
        const double share =
            static_cast<double>((ImGui::GetIO().MousePos.x - low.x - inset) / track);
        const double at = std::clamp(share, 0.0, 1.0) * last_space;
        look.at = std::abs(at - std::round(at)) < catch_range ? std::round(at) : at;
    }
    register_widget(ui, "chain.slider",
                    "Drag it from space to space. Between two of them the figure is a mixture of "
                    "both.",
                    fixed(look.at, 2));
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddLine({x_of(0.0), y}, {x_of(last_space), y}, packed(p.dim), 2.0f * u);
    for (std::size_t i = 0; i < chain_space_count; ++i)
        list->AddCircleFilled({x_of(static_cast<double>(i)), y}, 3.5f * u, packed(p.dim));
    list->AddCircleFilled({x_of(look.at), y}, 7.0f * u, packed(p.text));
}

/// The figure on the screen.
struct ChainField {
    const Ui& ui;
    const ChainLook& look;
    ImDrawList* list;
    ImVec2 low, high;

    ImVec2 at(const glm::dvec3& place) const {
        const double scale =
            0.5 * static_cast<double>(std::min(high.x - low.x, high.y - low.y)) / half_width;
        const glm::dvec2 seen = scale * seen_obliquely(place);
        // What is far outside is cut off anyway, and must be within a float's reach.
        constexpr double farthest = 1e5;
        return {
            0.5f * (low.x + high.x) + static_cast<float>(std::clamp(seen.x, -farthest, farthest)),
            0.5f * (low.y + high.y) + static_cast<float>(std::clamp(seen.y, -farthest, farthest))};
    }
    ImU32 meaning(Meaning of, float opacity = 1.0f) const {
        return packed(colour_of(of, ui.options.theme), opacity);
    }
};

void draw_guides(const ChainField& field, std::size_t space, double share) {
    if (share <= 0.0) return;
    constexpr const char* axis_names[] = {"x", "y", "z"};
    const auto opacity = static_cast<float>(share);
    const float u = field.ui.options.text_scale;
    for (const ChainGuide& guide :
         chain_guides(field.look.chain, field.ui.results.a.frame, space)) {
        const ImVec2 from = field.at(guide.from), to = field.at(guide.to);
        if (guide.axis < 0) {
            field.list->AddLine(
                from, to, packed(palette(field.ui.options.theme).dim, 0.8f * opacity), 1.0f * u);
            continue;
        }
        const ImU32 ink = field.meaning(edge_meaning(guide.axis), opacity);
        field.list->AddLine(from, to, ink, 1.8f * u);
        // Between two spaces, the letters of both would cover each other.
        if (share <= 0.5) continue;
        field.list->AddText({to.x + 3.0f * u, to.y - 0.5f * ImGui::GetTextLineHeight()}, ink,
                            axis_names[guide.axis]);
    }
}

void draw_wires(const ChainField& field) {
    const ChainLook& look = field.look;
    const Palette& p = palette(field.ui.options.theme);
    const float u = field.ui.options.text_scale;
    std::vector<ImVec2> places;
    places.reserve(look.chain.points.size());
    for (const ChainPoint& point : look.chain.points)
        places.push_back(field.at(chain_place(look.chain, point, look.at)));
    // The triangle's own edges come first, and are drawn last.
    for (auto edge = look.chain.edges.rbegin(); edge != look.chain.edges.rend(); ++edge) {
        const ChainPoint &a = look.chain.points[edge->from], &b = look.chain.points[edge->to];
        if (!is_in_chain(a, look.at) || !is_in_chain(b, look.at)) continue;
        field.list->AddLine(
            places[edge->from], places[edge->to],
            packed(edge->is_of_triangle ? p.text : p.link, edge->is_of_triangle ? 1.0f : 0.6f),
            (edge->is_of_triangle ? 2.2f : 1.0f) * u);
    }
}

/// "v0 in camera: (0.500, −0.200, 3.000, 1.000)"
std::string numbers_text(const ChainPoint& point, int vertex, std::size_t space) {
    if (!is_in_chain(point, static_cast<double>(space)))
        return fmt::format("{} has w = {}, so it cannot be divided", short_vertex_name(vertex),
                           with_minus_signs(significant(point.places[chain_clip_space].w, 4)));
    const glm::dvec4& place = point.places[space];
    const int digits = space + 1 == chain_space_count ? 1 : 3;
    return fmt::format("{} in {}: ({}, {}, {}, {})", short_vertex_name(vertex), space_names[space],
                       fixed(place.x, digits), fixed(place.y, digits), fixed(place.z, 3),
                       fixed(place.w, 3));
}

void draw_figure(Ui& ui, int vertex) {
    const ChainLook& look = look_of_chain(ui);
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    // In a low window the slider above it stays in view.
    const float room = ImGui::GetWindowHeight() - slider_height * u - ImGui::GetFrameHeight();
    const float height = std::clamp(room, least_figure_height * u, figure_height * u);
    const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, 1.0f), height};
    const ChainField field{
        ui, look, ImGui::GetWindowDrawList(), low, {low.x + size.x, low.y + size.y}};
    field.list->AddRectFilled(low, field.high, packed(p.canvas));
    field.list->PushClipRect(low, field.high, true);
    const double begin = std::floor(look.at), share = look.at - begin;
    const auto space = static_cast<std::size_t>(begin);
    ImGui::PushFont(ui.fonts.small);
    draw_guides(field, space, 1.0 - share);
    if (share > 0.0) draw_guides(field, space + 1, share);
    draw_wires(field);
    const ChainPoint& marked =
        look.chain.points[look.chain.corners[static_cast<std::size_t>(vertex)]];
    if (is_in_chain(marked, look.at)) {
        const ImVec2 place = field.at(chain_place(look.chain, marked, look.at));
        const ImU32 ink = field.meaning(edge_meaning(vertex));
        field.list->AddCircleFilled(place, 4.5f * u, ink);
        field.list->AddText({place.x + 7.0f * u, place.y - ImGui::GetTextLineHeight()}, ink,
                            short_vertex_name(vertex).c_str());
    }
    const std::string title = share > 0.0 ? fmt::format("{} → {}: {}", space_names[space],
                                                        space_names[space + 1], chain_steps[space])
                                          : std::string(space_names[space]);
    field.list->AddText({low.x + 6.0f * u, low.y + 4.0f * u}, packed(p.text), title.c_str());
    field.list->PopClipRect();
    ImGui::PopFont();
    ImGui::Dummy(size);
    register_widget(
        ui, "chain.figure",
        "The edges in this space, seen by an eye that never moves. Each space is scaled "
        "to fit. In clip space w, the fourth number, is not drawn.",
        title);
    const std::string numbers = numbers_text(marked, vertex, space_near(look));
    ImGui::PushFont(ui.fonts.mono_small);
    wrapped_text_in(colour_of(edge_meaning(vertex), ui.options.theme), numbers);
    ImGui::PopFont();
    register_widget(ui, "chain.numbers", "x, y, z and w of the marked vertex in the nearest space.",
                    numbers);
}

/// What of the scene is not in the figure.
void draw_what_is_left_out(Ui& ui) {
    const ChainLook& look = look_of_chain(ui);
    const SpaceChain& chain = look.chain;
    const auto behind =
        std::count_if(chain.edges.begin(), chain.edges.end(), [&](const ChainEdge& edge) {
            return !is_in_chain(chain.points[edge.from], look.at) ||
                   !is_in_chain(chain.points[edge.to], look.at);
        });
    const ImVec4& dim = palette(ui.options.theme).dim;
    if (behind > 0) {
        wrapped_text_in(dim, counted(behind, "edge is", "edges are") +
                                 " left out: an end is at or behind w = 0.");
        register_widget(ui, "chain.behind");
    }
    if (!chain.is_complete) {
        wrapped_text_in(dim, fmt::format("Only the first {} edges are drawn.", most_chain_edges));
        register_widget(ui, "chain.limit");
    }
}

} // namespace

void draw_chain_figure(Ui& ui, int vertex) {
    bring_chain_up_to_date(ui);
    draw_space_buttons(ui);
    ChainLook& look = look_of_chain(ui);
    if (ui.results.a.frame.scene->parts.size() > 1) {
        same_line_if_room("whole scene");
        if (button(ui, "chain.whole_scene", "whole scene",
                   look.is_whole_scene ? Look::chosen : Look::outline,
                   "Shows the edges of the whole scene, or of the triangle's part alone."))
            look.is_whole_scene = !look.is_whole_scene;
    }
    draw_slider(ui);
    draw_figure(ui, vertex);
    draw_what_is_left_out(ui);
}

} // namespace rasterwalk
