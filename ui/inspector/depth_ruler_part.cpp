#include "ui/inspector/depth_ruler_part.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/element_names.h"
#include "inspect/depth_ruler.h"
#include "inspect/pixel_history.h"
#include "stages/orthographic.h"
#include "ui/inspector/history_parts.h"
#include "ui/ui.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Between the two scales, and how far a tick reaches, design pixels.
constexpr float scales_apart = 44.0f, tick_reach = 5.0f;

/// Ticks closer together than this are left out, design pixels.
constexpr float least_tick_gap = 4.0f;

/// Two scales one above the other, with room for a line of numbers above and below.
struct Scales {
    const Ui& ui;
    ImDrawList* list;
    float u, left, right, upper, lower;

    float x(double place) const { return left + static_cast<float>(place) * (right - left); }
    const Palette& palette() const { return rasterwalk::palette(ui.options.theme); }
    ImU32 ink(Meaning meaning) const { return packed(colour_of(meaning, ui.options.theme)); }
    float bottom() const { return lower + (tick_reach + 2.0f) * u + ImGui::GetFontSize(); }
};

Scales make_scales(Ui& ui, float margin) {
    const float u = ui.options.text_scale, line = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float upper = at.y + line + (tick_reach + 2.0f) * u;
    return {ui,
            ImGui::GetWindowDrawList(),
            u,
            at.x + margin,
            at.x + ImGui::GetContentRegionAvail().x - margin,
            upper,
            upper + scales_apart * u};
}

/// Is a place between the ends, or as near to one as rounding brings it?
bool is_on_scale(double place) {
    return place > -0.001 && place < 1.001;
}

void draw_scale_lines(const Scales& scales) {
    for (const float y : {scales.upper, scales.lower})
        scales.list->AddLine({scales.left, y}, {scales.right, y}, packed(scales.palette().dim),
                             scales.u);
}

/// Numbers along a scale; one that would touch those that are already there is left out.
class ScaleNumbers {
  public:
    ScaleNumbers(const Scales& scales, float y) : scales_(scales), y_(y) {}

    bool add(float x, const std::string& text, const ImVec4& ink) {
        const float half = 0.5f * text_width(text), gap = 5.0f * scales_.u;
        const float low = std::clamp(x - half, first(), std::max(first(), last() - 2.0f * half));
        const float high = low + 2.0f * half;
        for (const auto& [from, to] : taken_)
            if (low < to + gap && high > from - gap) return false;
        taken_.emplace_back(low, high);
        scales_.list->AddText({std::round(low), y_}, packed(ink), text.c_str());
        return true;
    }

  private:
    float first() const { return ImGui::GetCursorScreenPos().x; }
    float last() const { return first() + ImGui::GetContentRegionAvail().x; }

    const Scales& scales_;
    float y_;
    std::vector<std::pair<float, float>> taken_;
};

/// From where a depth lies to what is stored for it.
void draw_depth_mark(const Scales& scales, float from, float to, bool is_chosen) {
    const ImU32 ink = is_chosen ? scales.ink(Meaning::current) : packed(scales.palette().dim);
    const float radius = (is_chosen ? 4.0f : 3.0f) * scales.u;
    scales.list->AddLine({from, scales.upper}, {to, scales.lower}, ink,
                         (is_chosen ? 2.0f : 1.0f) * scales.u);
    scales.list->AddCircleFilled({from, scales.upper}, radius, ink);
    scales.list->AddCircleFilled({to, scales.lower}, radius, ink);
}

std::string short_number(double value) {
    return with_minus_signs(significant(value, 4));
}

void draw_whole_ruler(const Scales& scales, const DepthRuler& ruler,
                      const std::vector<DepthMark>& marks, std::size_t chosen) {
    const Palette& p = scales.palette();
    const float reach = tick_reach * scales.u;
    for (const double z : ruler.round) {
        const double stored = depth_at(static_cast<float>(z), ruler.rules);
        scales.list->AddLine({scales.x(ruler.place(z)), scales.upper},
                             {scales.x(ruler.stored_place(stored)), scales.lower}, packed(p.line),
                             scales.u);
    }
    for (const DepthStep& step : ruler.told_apart) {
        const float x = scales.x(ruler.place(step.z));
        scales.list->AddLine({x, scales.upper}, {x, scales.upper + reach},
                             scales.ink(Meaning::pass), scales.u);
    }
    draw_scale_lines(scales);
    const auto draw_mark = [&](std::size_t i) {
        const double from = ruler.place(marks[i].z), to = ruler.stored_place(marks[i].stored);
        const bool is_seen = is_on_scale(from) && is_on_scale(to);
        if (is_seen) draw_depth_mark(scales, scales.x(from), scales.x(to), i == chosen);
        return is_seen;
    };
    for (std::size_t i = 0; i < marks.size(); ++i)
        if (i != chosen) draw_mark(i);
    const bool has_chosen = draw_mark(chosen);
    const DepthMark& mark = marks[chosen];
    ScaleNumbers above(scales, scales.upper - reach - ImGui::GetFontSize());
    if (has_chosen) above.add(scales.x(ruler.place(mark.z)), short_number(mark.z), p.text);
    above.add(scales.left, short_number(ruler.z.low), p.dim);
    above.add(scales.right, short_number(ruler.z.high), p.dim);
    for (const double z : ruler.round)
        above.add(scales.x(ruler.place(z)), short_number(z), p.dim);
    ScaleNumbers below(scales, scales.lower + reach);
    if (has_chosen)
        below.add(scales.x(ruler.stored_place(mark.stored)), short_number(mark.stored), p.text);
    below.add(scales.left, short_number(ruler.stored.low), p.dim);
    below.add(scales.right, short_number(ruler.stored.high), p.dim);
    for (const double z : ruler.round) {
        const double stored = depth_at(static_cast<float>(z), ruler.rules);
        below.add(scales.x(ruler.stored_place(stored)), short_number(stored), p.dim);
    }
}

std::string gap_text(double gap) {
    return with_minus_signs(significant(gap, 3));
}

/// Where the steps of a window lie, 0 to 1, by z.
std::vector<double> places_in(const DepthWindow& window) {
    double length = 0.0;
    for (const double gap : window.gaps)
        length += gap;
    std::vector<double> places{0.0};
    for (const double gap : window.gaps)
        places.push_back(places.back() + (length > 0.0 ? gap / length : 0.0));
    return places;
}

/// The value of a step: its number among the buffer's values, or the float.
std::string step_text(const DepthStep& step) {
    return step.number ? whole_text(*step.number) : nine_digits_shown(step.stored);
}

/// Are the steps so long that a mark next to one is off by the buffer's rounding alone? z, and the
/// depth before it is stored, are floats and rounded too.
/// @param next a step, not the first
bool is_rounding_seen(const DepthWindow& window, std::size_t next, double z) {
    constexpr double epsilon = std::numeric_limits<float>::epsilon(), clear = 16.0;
    const double from = window.steps[next - 1].stored, to = window.steps[next].stored;
    return std::abs(to - from) > clear * epsilon * std::max(std::abs(from), std::abs(to)) &&
           window.gaps[next - 1] > clear * epsilon * std::abs(z);
}

void draw_window(const Scales& scales, const DepthWindow& window,
                 const std::vector<DepthMark>& marks, std::size_t chosen) {
    const Palette& p = scales.palette();
    const float reach = tick_reach * scales.u;
    const std::vector<double> places = places_in(window);
    draw_scale_lines(scales);
    for (const double place : places) {
        const float x = scales.x(place);
        scales.list->AddLine({x, scales.upper}, {x, scales.lower + reach}, packed(p.line),
                             scales.u);
        scales.list->AddLine({x, scales.lower - reach}, {x, scales.lower + reach},
                             scales.ink(Meaning::pass), 2.0f * scales.u);
    }
    const auto draw_mark = [&](std::size_t m) {
        const DepthMark& mark = marks[m];
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (window.steps[i].stored != mark.stored) continue;
            const std::size_t next = std::min(i + 1, places.size() - 1);
            const double gap = window.gaps[next - 1], share = places[next] - places[next - 1];
            const double off = is_rounding_seen(window, next, mark.z)
                                   ? (mark.z - window.steps[i].z) / gap * share
                                   : 0.0;
            draw_depth_mark(scales, scales.x(places[i] + off), scales.x(places[i]), m == chosen);
        }
    };
    for (std::size_t m = 0; m < marks.size(); ++m)
        if (m != chosen) draw_mark(m);
    draw_mark(chosen);
    ScaleNumbers above(scales, scales.upper - reach - ImGui::GetFontSize());
    ScaleNumbers below(scales, scales.lower + reach);
    below.add(scales.x(places[window.middle]), step_text(window.asked()), p.text);
    const auto add_gap = [&](std::size_t i) {
        above.add(scales.x(0.5 * (places[i] + places[i + 1])), gap_text(window.gaps[i]), p.text);
    };
    if (window.middle > 0) add_gap(window.middle - 1);
    if (window.middle < window.gaps.size()) add_gap(window.middle);
    for (std::size_t i = 0; i < places.size(); ++i)
        below.add(scales.x(places[i]), step_text(window.steps[i]), p.dim);
}

/// Is z beyond an end of the range, so that the buffer holds that end instead?
bool is_cut_off(const DepthMark& mark, const DepthRules& rules) {
    const bool has_near = rules.bits > 0 || rules.projection.clip_depth != ClipDepth::inv_z;
    const bool has_far = rules.projection.clip_depth != ClipDepth::inv_z;
    return (has_near && mark.z < double{rules.near}) || (has_far && mark.z > double{rules.far});
}

std::string gap_sentence(const DepthMark& mark, const DepthWindow& window,
                         const DepthRules& rules) {
    if (is_cut_off(mark, rules))
        return fmt::format("z {} is not between near and far, so the buffer holds the end of its "
                           "range.",
                           short_number(mark.z));
    const std::string at = "At z " + short_number(window.asked().z);
    const std::optional<double> nearer = window.gap_nearer(), farther = window.gap_farther();
    if (nearer && farther)
        return fmt::format("{} the next depths that the buffer can hold are {} nearer and {} "
                           "farther, world units.",
                           at, gap_text(*nearer), gap_text(*farther));
    return fmt::format("{} the next depth that the buffer can hold is {} {}, world units.", at,
                       gap_text(nearer ? *nearer : *farther), nearer ? "nearer" : "farther");
}

void finish_scales(Ui& ui, const Scales& scales, const std::string& name, const std::string& help) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Dummy({ImGui::GetContentRegionAvail().x, scales.bottom() - at.y});
    register_widget(ui, name, help);
}

/// What is on the two scales.
void draw_ruler_title(const Ui& ui, const DepthRuler& ruler) {
    const std::string name(depth_words(ui.results.a.frame).name);
    const std::string bits =
        ruler.rules.bits > 0 ? fmt::format("{} bits", ruler.rules.bits) : std::string("floats");
    const std::string scale = ruler.is_logarithmic ? "logarithmic" : "linear";
    text_in(palette(ui.options.theme).dim,
            first_fitting(
                {fmt::format("above z, near to far, {}; below {} in {}", scale, name, bits),
                 fmt::format("above z, {}; below {}", scale, name), fmt::format("z and {}", name)},
                ImGui::GetContentRegionAvail().x));
}

/// Can it matter how fine the buffer is? Floats of 1/z are finer than anything seen in most scenes.
bool is_fineness_of_use(const DepthRules& rules, const std::vector<DepthMark>& marks,
                        std::size_t chosen) {
    constexpr float hair = 1e-4f; // of the depth
    if (rules.bits > 0 || rules.epsilon > 0.0f || rules.projection.clip_depth != ClipDepth::inv_z)
        return true;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const float apart = std::abs(marks[i].stored - marks[chosen].stored);
        if (i != chosen && apart <= hair * std::abs(marks[chosen].stored)) return true;
    }
    return false;
}

} // namespace

void draw_depth_ruler(Ui& ui, std::string_view owner, const std::vector<DepthMark>& marks,
                      std::size_t chosen) {
    const Frame& frame = ui.results.a.frame;
    if (frame.scene->space != SceneSpace::world || chosen >= marks.size()) return;
    const DepthRules rules = depth_rules(frame.settings, frame.scene->space);
    const float u = ui.options.text_scale;
    ImGui::PushFont(ui.fonts.small);
    const Scales whole = make_scales(ui, 6.0f * u);
    const double width = std::max(whole.right - whole.left, 1.0f);
    const std::optional<DepthRuler> ruler = depth_ruler(rules, least_tick_gap * u / width);
    const std::optional<DepthWindow> window = depth_window(marks[chosen].stored, rules);
    const std::string prefix(owner);
    if (ruler) {
        draw_ruler_title(ui, *ruler);
        const Scales scales = make_scales(ui, 6.0f * u);
        draw_whole_ruler(scales, *ruler, marks, chosen);
        finish_scales(ui, scales, prefix + "ruler",
                      "Each line joins a z with the depth that the buffer gets for it. Ticks below "
                      "the upper scale are the depths that the buffer can hold, where they are far "
                      "enough apart to be drawn. The bright line is " +
                          marks[chosen].name + ".");
    }
    if (window && !window->gaps.empty()) {
        text_in(palette(ui.options.theme).dim,
                first_fitting(
                    {"enlarged: the depths next to that of " + marks[chosen].name, "enlarged"},
                    ImGui::GetContentRegionAvail().x));
        const float margin = 0.5f * text_width(step_text(window->asked())) + 4.0f * u;
        const Scales scales = make_scales(ui, margin);
        draw_window(scales, *window, marks, chosen);
        finish_scales(ui, scales, prefix + "ruler.window",
                      window->asked().number
                          ? fmt::format("Ticks are the depths that the buffer can hold, by their "
                                        "number out of {}; above them, how far apart they are in "
                                        "z.",
                                        whole_text((std::int64_t{1} << rules.bits) - 1))
                          : "Ticks are the floats that the buffer can hold; above them, how far "
                            "apart they are in z.");
        wrapped_text(gap_sentence(marks[chosen], *window, rules));
        register_widget(ui, prefix + "ruler.gap",
                        "The next values of the buffer, taken back to z. Surfaces closer together "
                        "than this can be stored as equal.");
    }
    ImGui::PopFont();
}

HistoryMarks marks_of_history(const PixelHistory& history, const Cursor* shown,
                              const DepthRules& rules) {
    std::vector<DepthMark> marks;
    std::optional<std::size_t> chosen;
    for (std::size_t i = 0; i < history.entries.size(); ++i) {
        const PixelEntry& entry = history.entries[i];
        if (!is_depth_tested(entry.fate) || !std::isfinite(entry.z)) continue;
        const bool is_shown = shown != nullptr && *shown == entry.cursor;
        const bool is_chosen = is_shown || (!chosen && stays(history, static_cast<int>(i)));
        if (marks.size() == most_depth_marks) {
            if (!is_chosen) continue;
            marks.pop_back();
        }
        if (is_chosen) chosen = marks.size();
        // Several samples have depths of their own; z is that of the centre.
        const double z = entry.covered != 0 ? z_of_depth(entry.depth, rules) : double{entry.z};
        marks.push_back({z, entry.depth, short_triangle_name(entry.cursor.triangle)});
    }
    return {std::move(marks), chosen.value_or(0)};
}

void draw_ruler_of_history(Ui& ui, const PixelHistory& history) {
    const Frame& frame = ui.results.a.frame;
    if (!history.depth_tested || history.entries.empty() || !has_fragments(frame.settings.stage))
        return;
    const DepthRules rules = depth_rules(frame.settings, frame.scene->space);
    const std::optional<FragmentReport>& shown = ui.results.a.inspected.fragment;
    const HistoryMarks found = marks_of_history(history, shown ? &shown->cursor : nullptr, rules);
    if (found.marks.empty() || !is_fineness_of_use(rules, found.marks, found.chosen)) return;
    draw_depth_ruler(ui, "history.", found.marks, found.chosen);
}

} // namespace rasterwalk
