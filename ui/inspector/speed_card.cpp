#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "inspect/row_graph.h"
#include "session/second_run.h"
#include "ui/actions/compare.h"
#include "ui/actions/measure.h"
#include "ui/actions/open_tab.h"
#include "ui/inspector/speed_parts.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The times of all rounds as dots above an axis: the band is the middle half, the line the median.
void draw_rounds(Ui& ui, const RungTime& time) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const TimeRange half = middle_half(time.milliseconds);
    std::vector<double> sorted = time.milliseconds;
    std::sort(sorted.begin(), sorted.end());
    const Interval range = with_margin({sorted.front(), sorted.back()}, 0.08);

    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::CalcItemWidth(), field = 30.0f * u;
    ImGui::Dummy({width, field + 4.0f * u + ui.fonts.small->FontSize});
    register_widget(ui, "speed.rounds",
                    "A dot for each round. The line is the median, and the band behind it holds "
                    "the middle half of the rounds.");
    const float bottom = at.y + field;
    const auto to_x = [&](double milliseconds) {
        const double share = (milliseconds - range.low) / (range.high - range.low);
        return std::round(at.x + static_cast<float>(share) * width);
    };
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddRectFilled({to_x(half.low), at.y}, {to_x(half.high) + 1.0f, bottom}, packed(p.chosen));
    // Dots that would cover each other are stacked, as far as there is room.
    const float radius = 3.0f * u, step = 2.0f * radius;
    const int most = static_cast<int>(field / step);
    float from = -HUGE_VALF;
    int level = 0;
    for (const double milliseconds : sorted) {
        const float x = to_x(milliseconds);
        level = x - from < step ? level + 1 : 0;
        if (level == 0) from = x;
        const float y = bottom - radius - step * static_cast<float>(level % std::max(most, 1));
        list->AddCircleFilled({x, y}, radius, packed(p.link, 0.75f));
    }
    const float median = to_x(time.median);
    list->AddLine({median + 0.5f, at.y}, {median + 0.5f, bottom}, packed(p.text),
                  std::round(1.5f * u));
    list->AddLine({at.x, bottom + 0.5f}, {at.x + width, bottom + 0.5f}, packed(p.dim));
    ImFont* const small = ui.fonts.small;
    const float room = text_width(small, "00.00 ms") * 1.5f;
    const Ticks ticks = nice_ticks(range, std::max(static_cast<int>(width / room), 2));
    for (const double tick : ticks.places) {
        const std::string words = decimals(tick, ticks.digits) + " ms";
        const float wide = text_width(small, words);
        const float x = std::clamp(to_x(tick) - 0.5f * wide, at.x, at.x + width - wide);
        list->AddLine({to_x(tick) + 0.5f, bottom}, {to_x(tick) + 0.5f, bottom + 3.0f * u},
                      packed(p.dim));
        list->AddText(small, small->FontSize, {std::round(x), bottom + 4.0f * u}, packed(p.dim),
                      words.c_str());
    }
}

/// "15 rounds: median 1.05 ms, middle half 1.03 to 1.09 ms".
std::string rounds_words(const RungTime& time) {
    const TimeRange half = middle_half(time.milliseconds);
    const std::string low = milliseconds_text(half.low), high = milliseconds_text(half.high);
    return fmt::format(
        "{}: median {}, middle half {} to {}",
        counted(static_cast<std::int64_t>(time.milliseconds.size()), "round", "rounds"),
        milliseconds_text(time.median), low, high);
}

/// Below the wrong turning of two threads: how many pixels they get wrong, again and again.
void draw_race(Ui& ui, std::size_t index) {
    if (!rung_at(index).is_random) return;
    const Palette& p = palette(ui.options.theme);
    if (ladder_threads() == 1) {
        wrapped_text_in(p.dim, "Nothing races here: this program has one thread.");
        register_widget(ui, "speed.no_race", "In a browser a program has no other threads.");
        return;
    }
    if (button(ui, "speed.race", "Race", Look::plain,
               fmt::format(
                   "Draws a made scene, one sheet of tiles close behind another, {} times with "
                   "two threads, and counts the pixels that one thread draws differently.",
                   usual_race_runs))) {
        begin_race(ui);
    }
    if (ui.ladder.wrong.empty()) return;
    std::string counts;
    for (const std::int64_t wrong : ui.ladder.wrong)
        counts += (counts.empty() ? "" : " · ") + grouped(wrong);
    const std::string words =
        "Wrong pixels in " +
        counted(static_cast<std::int64_t>(ui.ladder.wrong.size()), "picture", "pictures") + ": " +
        counts;
    wrapped_text(words);
    const std::vector<std::int64_t>& wrong = ui.ladder.wrong;
    const bool are_all_right =
        std::all_of(wrong.begin(), wrong.end(), [](std::int64_t count) { return count == 0; });
    register_widget(ui, "speed.race.runs",
                    "Each picture has the same triangles. Only which thread was faster differs.",
                    counts);
    if (are_all_right && ui.ladder.race == nullptr)
        wrapped_text_in(p.dim, "None this time. That is why a race is hard to find: try again.");
}

/// Below the last rung: its picture next to that of the steps.
void draw_compare_link(Ui& ui, std::size_t index) {
    if (index + 1 != ladder().size()) return;
    if (!button(ui, "speed.compare", "compare it with the steps", Look::link,
                "Compares run A, drawn by the steps, with a run B that the fast engine draws.") ||
        refuses_settings(ui.session))
        return;
    ui.session.a.settings.engine = Engine::steps;
    Run fast = ui.session.a;
    fast.settings.engine = Engine::fast;
    compare_with(ui.session, fast);
    open_compare_tab(ui);
}

} // namespace

void draw_rung_card(Ui& ui, const LadderTimes& times) {
    const Palette& p = palette(ui.options.theme);
    if (!ui.ladder.chosen) return;
    const std::size_t index = *ui.ladder.chosen;
    const Rung& rung = rung_at(index);
    begin_card(ui);
    // Directly below its line, it needs no title.
    if (ui.inspector.has_card) wrapped_text(rung.title, ui.fonts.bold);
    wrapped_text(rung.change);
    register_widget(ui, "speed.change", "What is different from the rung before.", rung.change);
    wrapped_text_in(p.dim, rung.why);
    register_widget(ui, "speed.why", "Why this makes it faster, or does not.", rung.why);
    const bool is_measured = index < times.rungs.size() && !times.rungs[index].milliseconds.empty();
    if (is_measured) {
        ImGui::Spacing();
        const std::string words = rounds_words(times.rungs[index]);
        wrapped_text(words, ui.fonts.small);
        register_widget(ui, "speed.median",
                        "The median is the time in the middle of all rounds, in order. A quarter "
                        "of the rounds is below the middle half, and a quarter above.",
                        words);
        draw_rounds(ui, times.rungs[index]);
    }
    draw_race(ui, index);
    draw_compare_link(ui, index);
    const std::filesystem::path file =
        (std::filesystem::path("src/engines/ladder") / rung.file).lexically_normal();
    ImGui::PushFont(ui.fonts.mono_small);
    const std::string shown =
        first_fitting({file.generic_string(), file.filename().string()}, ImGui::CalcItemWidth());
    text_in(p.dim, shown);
    ImGui::PopFont();
    register_widget(ui, "speed.file", "The file that draws it: " + file.generic_string(), shown);
    end_card(ui);
}

} // namespace rasterwalk
