#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "inspect/row_graph.h"
#include "ui/inspector/speed_parts.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// Below this width of the page the gain is below the title, and the picture is left to tooltip and
/// card, design pixels.
constexpr float narrow_rungs = 400.0f;

/// Where the parts of a rung are, screen pixels.
struct RungPlaces {
    float left = 0.0f, right = 0.0f; ///< of the page
    float title = 0.0f;              ///< where titles begin
    float field = 0.0f;              ///< where the field of the bars begins
    float gain = 0.0f, time = 0.0f;  ///< where these columns end
    bool is_narrow = false;
};

RungPlaces places_of(const Ui& ui) {
    const float u = ui.options.text_scale;
    RungPlaces places;
    places.left = ImGui::GetCursorScreenPos().x;
    places.right = places.left + ImGui::GetContentRegionAvail().x;
    const float width = places.right - places.left;
    places.is_narrow = width < narrow_rungs * u;
    places.title = places.left + 8.0f * u + text_width(ui.fonts.mono, "00") + 6.0f * u;
    constexpr float share = 0.52f, narrow_share = 0.4f;
    places.field = std::round(places.left + (places.is_narrow ? narrow_share : share) * width);
    places.time = places.right - 6.0f * u;
    places.gain = places.time - text_width(ui.fonts.mono, "00.0 ms") - 14.0f * u;
    return places;
}

/// Milliseconds to screen pixels; the scale multiplies.
struct TimeScale {
    double low = 0.0, high = 1.0; ///< logarithms of milliseconds
    float left = 0.0f, right = 1.0f;

    float to_x(double milliseconds) const {
        const double share = (std::log10(milliseconds) - low) / (high - low);
        return std::round(left + static_cast<float>(share) * (right - left));
    }
};

/// A time of nothing at all has no logarithm.
double shown_time(double milliseconds) {
    constexpr double least = 1e-4;
    return std::max(milliseconds, least);
}

bool is_measured(const LadderTimes& times, std::size_t index) {
    return index < times.rungs.size() && !times.rungs[index].milliseconds.empty();
}

TimeScale scale_of(const LadderTimes& times, const RungPlaces& places) {
    TimeScale scale{HUGE_VAL, -HUGE_VAL, places.field, places.time};
    for (std::size_t i = 0; i < times.rungs.size(); ++i) {
        if (!is_measured(times, i)) continue;
        const double power = std::log10(shown_time(times.rungs[i].median));
        scale.low = std::min(scale.low, power);
        scale.high = std::max(scale.high, power);
    }
    const Interval wider = with_margin({scale.low, scale.high}, 0.06);
    scale.low = wider.low;
    scale.high = wider.high;
    return scale;
}

/// The marks of the scale: 1, 2 and 5 times a power of ten.
struct TimeMark {
    double milliseconds;
    bool is_power;
};

std::vector<TimeMark> marks_of(const TimeScale& scale) {
    std::vector<TimeMark> marks;
    for (int power = static_cast<int>(std::floor(scale.low)); power <= scale.high; ++power) {
        for (const double times : {1.0, 2.0, 5.0}) {
            const double milliseconds = times * std::pow(10.0, power);
            const double place = std::log10(milliseconds);
            if (place >= scale.low && place <= scale.high)
                marks.push_back({milliseconds, times == 1.0});
        }
    }
    return marks;
}

void draw_time_lines(const Ui& ui, const TimeScale& scale, float top, float bottom) {
    const ImVec4& colour = palette(ui.options.theme).line;
    for (const TimeMark& mark : marks_of(scale)) {
        const float x = scale.to_x(mark.milliseconds);
        ImGui::GetWindowDrawList()->AddLine({x, top}, {x, bottom},
                                            packed(colour, mark.is_power ? 1.0f : 0.45f));
    }
}

/// How many times as fast as the rung before; none before both are measured.
std::optional<double> gain_of(const LadderTimes& times, std::size_t index) {
    const std::size_t before = rung_before(index);
    if (before == index || !is_measured(times, index) || !is_measured(times, before)) return {};
    return shown_time(times.rungs[before].median) / shown_time(times.rungs[index].median);
}

std::string tooltip_of_rung(const LadderTimes& times, std::size_t index) {
    const Rung& rung = rung_at(index);
    std::string text(rung.change);
    if (const std::optional<double> gain = gain_of(times, index)) {
        text += fmt::format("\n{}: {} instead of {} ({})", gain_text(*gain),
                            milliseconds_text(times.rungs[index].median),
                            milliseconds_text(times.rungs[rung_before(index)].median),
                            rung_at(rung_before(index)).title);
    }
    const PictureWords picture = picture_words(times, index);
    if (!picture.sign.empty()) text += "\n" + picture.sign + " " + picture.forms.front();
    return text + "\nClick to read why.";
}

/// "24.6 ms, × 1.7"; empty before it is measured.
std::string numbers_of_rung(const LadderTimes& times, std::size_t index) {
    if (!is_measured(times, index)) return {};
    const std::optional<double> gain = gain_of(times, index);
    return milliseconds_text(times.rungs[index].median) + (gain ? ", " + gain_text(*gain) : "");
}

/// A rung as it is drawn, screen pixels.
struct RungRow {
    RungPlaces places;
    std::string title;                 ///< in one or more lines
    float first = 0.0f, second = 0.0f; ///< where title and second line begin
    bool has_second = false;
    float height = 0.0f;
};

/// Of the rung that is drawn next.
RungRow row_of(const Ui& ui, const LadderTimes& times, std::size_t index) {
    const float u = ui.options.text_scale, space = 4.0f * u, gap = 3.0f * u;
    RungRow row;
    row.places = places_of(ui);
    row.has_second = !times.rungs.empty();
    const float end = !row.has_second        ? row.places.time
                      : row.places.is_narrow ? row.places.gain
                                             : row.places.gain - text_width(ui.fonts.mono, "× 0.0");
    row.title = broken_into_lines(rung_at(index).title, end - row.places.title - 8.0f * u);
    const auto lines = static_cast<float>(std::count(row.title.begin(), row.title.end(), '\n') + 1);
    const float top = ImGui::GetCursorScreenPos().y;
    row.first = top + space;
    row.second = row.first + lines * ui.fonts.text->FontSize + gap;
    const float bottom = row.has_second ? row.second + ui.fonts.small->FontSize : row.second - gap;
    row.height = std::round(bottom + space - top);
    return row;
}

/// Text that ends here.
void draw_text_to(ImFont* font, float end, float top, const ImVec4& colour,
                  const std::string& words) {
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize,
                                        {std::round(end - text_width(font, words)), top},
                                        packed(colour), words.c_str());
}

/// Its number, title, gain and time.
void draw_first_line(const Ui& ui, const LadderTimes& times, std::size_t index,
                     const RungRow& row) {
    const Palette& p = palette(ui.options.theme);
    ImFont* const text = ui.fonts.text;
    ImFont* const mono = ui.fonts.mono;
    const float top = row.first + 0.5f * (text->FontSize - mono->FontSize);
    if (index < ladder().size()) {
        draw_text_to(mono, row.places.title - 8.0f * ui.options.text_scale, top, p.dim,
                     std::to_string(index));
    }
    ImGui::GetWindowDrawList()->AddText(text, text->FontSize, {row.places.title, row.first},
                                        packed(p.text), row.title.c_str());
    if (!is_measured(times, index)) return;
    draw_text_to(mono, row.places.time, top, p.text, milliseconds_text(times.rungs[index].median));
    const std::optional<double> gain = gain_of(times, index);
    if (!gain || row.places.is_narrow) return;
    draw_text_to(mono, row.places.gain, top,
                 is_slower(*gain) ? colour_of(Meaning::fail, ui.options.theme) : p.link,
                 gain_text(*gain));
}

/// Below the title: whether the picture is the same, and in a narrow page what it gained.
void draw_second_line(const Ui& ui, const LadderTimes& times, std::size_t index,
                      const RungRow& row) {
    const Palette& p = palette(ui.options.theme);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    ImFont* const small = ui.fonts.small;
    const float x = row.places.title;
    const auto put = [&](float at, const ImVec4& colour, const std::string& words) {
        list->AddText(small, small->FontSize, {at, row.second}, packed(colour), words.c_str());
    };
    PictureWords picture = picture_words(times, index);
    if (picture.sign.empty()) return;
    const std::optional<double> gain = gain_of(times, index);
    if (row.places.is_narrow) picture.forms = {gain ? gain_text(*gain) : ""};
    ImGui::PushFont(small);
    const float sign = text_width(picture.sign + " ");
    const float room = row.places.field - x - sign - 8.0f * ui.options.text_scale;
    const std::string words = first_fitting(picture.forms, room);
    ImGui::PopFont();
    const bool is_same = picture.sign == passed_sign;
    put(x,
        is_same            ? colour_of(Meaning::pass, ui.options.theme)
        : picture.is_wrong ? colour_of(Meaning::fail, ui.options.theme)
                           : p.changed,
        picture.sign);
    put(x + sign, p.dim, words);
}

/// The bar from the time before to its own, with a mark at its own, over the lines of the scale.
void draw_bar(const Ui& ui, const LadderTimes& times, std::size_t index, const RungRow& row) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const TimeScale scale = scale_of(times, row.places);
    const float line = ui.fonts.small->FontSize;
    draw_time_lines(ui, scale, row.second - u, row.second + line + u);
    const float middle = std::round(row.second + 0.5f * line), half = std::round(5.0f * u);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float x = scale.to_x(shown_time(times.rungs[index].median));
    if (const std::optional<double> gain = gain_of(times, index)) {
        const float from = scale.to_x(shown_time(times.rungs[rung_before(index)].median));
        list->AddRectFilled(
            {std::min(x, from), middle - half}, {std::max(x, from), middle + half},
            packed(is_slower(*gain) ? colour_of(Meaning::fail, ui.options.theme) : p.accent));
    }
    const float width = std::round(1.5f * u), above = std::round(2.0f * u);
    list->AddRectFilled({x - width, middle - half - above}, {x + width, middle + half + above},
                        packed(p.text));
}

/// Scrolls to the chosen rung, which is drawn next, when it was just chosen, and when its card has
/// grown over it.
void keep_chosen_in_sight(Ui& ui, std::size_t index, float height) {
    LadderLook& look = ui.ladder;
    if (look.chosen != index) return;
    const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
    const bool is_other = look.in_sight != index, has_moved = look.bottom != bottom;
    look.in_sight = index;
    look.bottom = bottom;
    const float at = ImGui::GetCursorScreenPos().y;
    if (!ui.inspector.has_card) {
        // The card opens below it, and that of another has closed above it.
        if (is_other) ImGui::SetScrollFromPosY(at - top, 0.0f);
    } else if ((is_other || has_moved) && at + height > bottom) {
        ImGui::SetScrollFromPosY(at + height - top, 1.0f);
    }
}

} // namespace

void draw_time_scale(Ui& ui, const LadderTimes& times) {
    if (!is_measured(times, 0)) return;
    const RungPlaces places = places_of(ui);
    const TimeScale scale = scale_of(times, places);
    const float top = ImGui::GetCursorScreenPos().y;
    ImFont* const small = ui.fonts.small;
    ImGui::Dummy({places.right - places.left, small->FontSize + 2.0f * ui.options.text_scale});
    register_widget(ui, "speed.scale",
                    "The time for one picture. The scale multiplies: bars of equal length are "
                    "equal factors.");
    const std::vector<TimeMark> marks = marks_of(scale);
    const auto powers = std::count_if(marks.begin(), marks.end(),
                                      [](const TimeMark& mark) { return mark.is_power; });
    float free_from = places.left;
    for (const TimeMark& mark : marks) {
        // 2 and 5 only where there are hardly any others.
        if (!mark.is_power && powers > 1) continue;
        const std::string words = significant(mark.milliseconds, 3) + " ms";
        const float width = text_width(small, words);
        const float x = std::round(
            std::min(scale.to_x(mark.milliseconds) - 0.5f * width, places.right - width));
        if (x < free_from) continue;
        ImGui::GetWindowDrawList()->AddText(small, small->FontSize, {x, top},
                                            packed(palette(ui.options.theme).dim), words.c_str());
        free_from = x + width + 8.0f * ui.options.text_scale;
    }
}

void draw_all_rungs(Ui& ui, const LadderTimes& times) {
    if (!times.has_all()) return;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale, space = 6.0f * u;
    const RungPlaces places = places_of(ui);
    const double first = times.rungs.front().median, last = times.rungs[ladder().size() - 1].median;
    const std::string gain = gain_text(shown_time(first) / shown_time(last));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = ui.fonts.text->FontSize;
    ImGui::Dummy({places.right - places.left, line + 2.0f * space});
    clip_range_to_lines(at.y, at.y + space + line);
    register_widget(ui, "speed.all",
                    fmt::format("From the first rung to the last: {} instead of {}.",
                                milliseconds_text(last), milliseconds_text(first)),
                    gain);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float rule = std::round(at.y + 0.5f * space) + 0.5f;
    list->AddLine({places.left, rule}, {places.right, rule}, packed(p.line));
    list->AddText(ui.fonts.bold, line, {places.title, at.y + space}, packed(p.text),
                  "All rungs together");
    draw_text_to(ui.fonts.bold, places.time, at.y + space, p.text, gain);
}

void draw_rung(Ui& ui, const LadderTimes& times, std::size_t index) {
    const RungRow row = row_of(ui, times, index);
    keep_chosen_in_sight(ui, index, row.height);
    const std::size_t count = ladder().size();
    const std::string name = index < count ? fmt::format("speed.rung.{}", index)
                                           : fmt::format("speed.turning.{}", index - count);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, 0.0f));
    const bool is_chosen = ui.ladder.chosen == index;
    if (ImGui::Selectable(("##" + name).c_str(), is_chosen, 0, {0.0f, row.height}))
        ui.ladder.chosen = is_chosen ? std::nullopt : std::optional(index);
    keep_selectable_whole();
    register_widget(ui, name, tooltip_of_rung(times, index), numbers_of_rung(times, index));
    ImGui::PopStyleVar();
    draw_first_line(ui, times, index, row);
    if (!row.has_second) return;
    draw_second_line(ui, times, index, row);
    if (is_measured(times, index)) draw_bar(ui, times, index, row);
}

} // namespace rasterwalk
