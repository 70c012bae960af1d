#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/element_names.h"
#include "base/numbers.h"
#include "settings/setting_table.h"
#include "ui/inspector/depth_ruler_part.h"
#include "ui/inspector/history_parts.h"
#include "ui/inspector/inspector_parts.h"
#include "ui/inspector/panels.h"
#include "ui/ui.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/swatch.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

std::string capitalized(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') {
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    }
    return text;
}

std::string triangle_words(const Ui& ui, int triangle) {
    return triangle_name(triangle) + " (" + part_words(*ui.results.a.frame.scene, triangle) + ")";
}

/// 1 where the nearer one wins, -1 where the farther one does.
float winning_sign(const Ui& ui) {
    return depth_rule(ui.results.a.frame.settings) == DepthTest::reversed ? -1.0f : 1.0f;
}

/// The next in the depth test's order among those that do not stay.
/// @param history of two entries at least
/// @param sign 1: the nearer one wins
const PixelEntry& runner_up(const PixelHistory& history, float sign) {
    std::size_t best = stays(history, 0) ? 1 : 0;
    for (std::size_t i = best + 1; i < history.entries.size(); ++i) {
        const bool is_next = sign * history.entries[i].margin_to_winner >
                             sign * history.entries[best].margin_to_winner;
        if (is_next && !stays(history, static_cast<int>(i))) best = i;
    }
    return history.entries[best];
}

std::string number_words(float share) {
    return significant(static_cast<double>(share), 3);
}

/// The same for a pixel with several samples.
std::array<std::string, 2> sample_verdict(const Ui& ui, const PixelHistory& history) {
    const PixelEntry& winner = history.entries[history.winner];
    const glm::vec3& colour = history.resolve->colour;
    const bool is_late = ui.results.a.frame.settings.sample_rule == SampleRule::late_clamp;
    return {
        fmt::format("{} of the pixel is {}.", number_words(winner.share),
                    triangle_words(ui, winner.cursor.triangle)),
        fmt::format("When everything is drawn, {}, the pixel gets the mean of its four samples, "
                    "{} clamped to 0..1: {} {} {}.",
                    to_text(history.resolve->cursor), is_late ? "which is then" : "each",
                    number_words(colour.r), number_words(colour.g), number_words(colour.b))};
}

/// Why the final colour stays, in two lines.
std::array<std::string, 2> verdict(const Ui& ui, const PixelHistory& history) {
    const float sign = winning_sign(ui);
    const std::string value = depth_value_words(ui);
    const DepthWords& words = depth_words(ui.results.a.frame);
    const std::string more(sign > 0.0f ? words.nearer : words.farther);
    const char* const most = more == "larger" ? "largest" : "smallest";
    if (history.winner < 0) {
        return {"No " + value + " here is " + more +
                    " than that of the empty depth buffer, so the pixel stays black.",
                ""};
    }
    const PixelEntry& winner = history.entries[history.winner];
    if (history.resolve) return sample_verdict(ui, history);
    std::string text = triangle_words(ui, winner.cursor.triangle) + " stays";
    if (winner.share < 1.0f) {
        return {triangle_words(ui, winner.cursor.triangle) +
                    " was written last, half-transparent: " + number_words(winner.share) +
                    " of the colour is its own,",
                number_words(1.0f - winner.share) + " is what the pixel showed before."};
    }
    if (ui.results.a.frame.squares != nullptr)
        return {text + " because the square around the pixel shows it.", ""};
    if (history.entries.size() == 1) return {text + " because nothing else fell here.", ""};
    if (!history.depth_tested)
        return {text + " because there is no depth test and it was drawn last.", ""};
    const PixelEntry& next = runner_up(history, sign);
    const std::string other = triangle_words(ui, next.cursor.triangle);
    const float ahead = -sign * next.margin_to_winner;
    if (!(ahead > 0.0f)) {
        const bool is_raced = depth_rule(ui.results.a.frame.settings) == DepthTest::raced;
        if (is_raced && next.cursor < winner.cursor)
            return {text + ", although " + other + " was there and it is no nearer:",
                    "the two threads raced, and the right depth was lost."};
        if (depth_rule(ui.results.a.frame.settings) == DepthTest::or_equal)
            return {text + " because it came after " + other + ", which is just as near.", ""};
        const bool has_epsilon = depth_epsilon_rule(ui.results.a.frame.settings) > 0.0f;
        return {text + " because it came before " + other +
                    (has_epsilon ? ", which is not nearer by more than epsilon."
                                 : ", which is just as near."),
                ""};
    }
    return {text + " because its " + value + " is the " + most + ",",
            fmt::format("{} ahead of {}.",
                        with_minus_signs(significant(static_cast<double>(ahead), 3)), other)};
}

void draw_title(Ui& ui, const PixelHistory& history) {
    const Palette& p = palette(ui.options.theme);
    const std::size_t at = ui.results.a.framebuffer->at(history.pixel.x, history.pixel.y);
    const float size = ImGui::GetTextLineHeight();
    const ImVec2 start = ImGui::GetCursorScreenPos();
    draw_swatch(ui, {start.x, start.y + ImGui::GetStyle().FramePadding.y}, size,
                ui.results.a.framebuffer->colour[at], 1.0f, swatch_border);
    ImGui::SetCursorScreenPos({start.x + size + ImGui::GetStyle().ItemSpacing.x, start.y});
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(ui.fonts.bold);
    ImGui::Text("Pixel (%d, %d)", history.pixel.x, history.pixel.y);
    ImGui::PopFont();
    register_widget(ui, "history.pixel", "The picked pixel, column and row, and its colour now.");
    const int owner = ui.results.a.framebuffer->owner[at];
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    std::vector<std::string> shows;
    if (owner < 0) {
        shows = {history.entries.empty() ? "not drawn" : "not drawn yet"};
    } else {
        const std::string part = part_words(*ui.results.a.frame.scene, owner);
        const std::string number = short_triangle_name(owner);
        shows = {"now " + triangle_name(owner) + ", " + part, "now " + number + " " + part,
                 "now " + number};
    }
    text_in(p.dim, first_fitting(shows, ImGui::GetContentRegionAvail().x));
}

/// A triangle that passes by: its name leads to it, the sentence says by how much it misses.
void draw_near(Ui& ui, const NearTriangle& near, int index, const glm::ivec2& pixel) {
    if (button(ui, "history.near." + std::to_string(index), triangle_words(ui, near.triangle),
               Look::link, "Selects this triangle.")) {
        ui.session.selection.triangle = near.triangle;
    }
    put_text(capitalized(miss_text(near)) + ".");
    const std::string rules = rules_text(near, pixel);
    if (rules.empty()) return;
    text_in(colour_of(Meaning::pass, ui.options.theme), capitalized(rules) + ".");
}

void draw_uncovered(Ui& ui, const PixelHistory& history) {
    const float u = ui.options.text_scale;
    wrapped_text(uncovered_text(ui.results.a.frame, history.pixel));
    if (history.nearest.empty()) return;
    ImGui::Dummy({0, 4.0f * u});
    text_in(palette(ui.options.theme).dim,
            history.nearest.size() == 1 ? "What comes nearest" : "What comes near");
    std::vector<std::string_view> rules;
    for (std::size_t i = 0; i < history.nearest.size(); ++i) {
        const NearTriangle& near = history.nearest[i];
        begin_card(ui);
        draw_near(ui, near, static_cast<int>(i), history.pixel);
        end_card(ui);
        for (const OtherRule& rule : near.rules) {
            if (std::find(rules.begin(), rules.end(), rule.rule) == rules.end())
                rules.push_back(rule.rule);
        }
    }
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const std::string label = "try " + std::string(rules[i]);
        if (i > 0) {
            ImGui::SameLine();
            if (ImGui::GetCursorScreenPos().x + button_width(label) > right) ImGui::NewLine();
        }
        if (button(ui, "history.try." + std::string(rules[i]), label, Look::plain,
                   "Sets this rule for the whole picture. Undo reverts it.")) {
            set_from_text(ui.session.a.settings, std::string(rules[i]));
        }
    }
}

/// The pixel with the most fragments so far; none if no fragment was drawn.
std::optional<glm::ivec2> most_drawn_pixel(const Framebuffer& framebuffer) {
    const auto most = std::max_element(framebuffer.overdraw.begin(), framebuffer.overdraw.end());
    if (most == framebuffer.overdraw.end() || *most == 0) return std::nullopt;
    const auto at = static_cast<int>(most - framebuffer.overdraw.begin());
    const int width = framebuffer.size.width;
    return glm::ivec2(at % width, at / width);
}

void pick(Ui& ui, const glm::ivec2& pixel) {
    ui.session.selection.pixel = pixel;
    ui.session.selection.row = pixel.y;
}

/// Says what to do, and offers two pixels to begin with.
void draw_no_pixel(Ui& ui) {
    wrapped_text(
        "No pixel is picked. Click one in the picture, and everything that falls on it is listed "
        "here in drawing order, with what the depth test said about it.");
    register_widget(ui, "history.empty",
                    "Everything that falls on the picked pixel is listed here.");
    if (const std::optional<FragmentReport>& fragment = ui.results.a.inspected.fragment) {
        const std::string pixel = fmt::format("({}, {})", fragment->pixel.x, fragment->pixel.y);
        const float padding = 2.0f * ImGui::GetStyle().FramePadding.x;
        const std::string label = first_fitting({"the last fragment: " + pixel, "last: " + pixel},
                                                ImGui::GetContentRegionAvail().x - padding);
        if (button(ui, "history.pick_last", label, Look::plain,
                   "Picks the pixel that the last fragment fell on.")) {
            pick(ui, fragment->pixel);
        }
    }
    if (button(ui, "history.pick_most", "a pixel with the most fragments", Look::plain,
               "Picks a pixel with the most fragments so far.")) {
        if (const auto pixel = most_drawn_pixel(*ui.results.a.framebuffer)) {
            pick(ui, *pixel);
        } else {
            show_info(ui.session, "Nothing has been drawn yet.");
        }
    }
}

void draw_searching_pixel(const glm::ivec2& pixel) {
    wrapped_text(fmt::format("Pixel ({}, {}): searching all triangles for what fell on it ...",
                             pixel.x, pixel.y));
}

} // namespace

void draw_history_panel(Ui& ui) {
    if (ui.results.history_work) {
        draw_searching_pixel(ui.results.history_work->pixel());
        return;
    }
    if (!ui.results.history) {
        draw_no_pixel(ui);
        return;
    }
    const PixelHistory& history = *ui.results.history;
    draw_title(ui, history);
    draw_engine_note(ui);
    if (history.entries.empty()) {
        draw_uncovered(ui, history);
        draw_program_writes(ui);
        return;
    }
    std::array<std::string, 2> sentences = verdict(ui, history);
    const float u = ui.options.text_scale;
    const float width = ImGui::GetContentRegionAvail().x - 26.0f * u;
    // If the first line wraps, the second follows it on the same line.
    if (ImGui::CalcTextSize(sentences[0].c_str()).x > width && !sentences[1].empty())
        sentences = {sentences[0] + " " + sentences[1], ""};
    float below = 2.0f * ImGui::GetStyle().ItemSpacing.y + 22.0f * u;
    for (const std::string& sentence : sentences) {
        if (sentence.empty()) continue;
        below += ImGui::CalcTextSize(sentence.c_str(), nullptr, false, width).y +
                 ImGui::GetStyle().ItemSpacing.y;
    }
    const float least = 5.0f * ImGui::GetTextLineHeightWithSpacing();
    // In a low page the table scrolls together with what is below it, unless it is long.
    const float room = ui.inspector.is_low
                           ? 2.0f * least
                           : std::max(ImGui::GetContentRegionAvail().y - below, least);
    draw_history_table(ui, history, room);
    begin_card(ui);
    for (const std::string& sentence : sentences)
        wrapped_text(sentence);
    end_card(ui);
    draw_program_writes(ui);
    draw_ruler_of_history(ui, history);
}

} // namespace rasterwalk
