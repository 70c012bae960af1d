#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/element_names.h"
#include "explain/depth_formulas.h"
#include "session/moments.h"
#include "session/walk.h"
#include "ui/inspector/history_parts.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/swatch.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

enum HistoryColumn {
    number_column,
    name_column,
    piece_column,
    step_column,
    zinv_column,
    margin_column,
    fate_column,
    swatch_column,
    column_count
};

/// The columns of the table; a narrow panel leaves some out.
struct Columns {
    std::array<float, column_count> widths{}; ///< of their content; 0: not there
    float padding = 0.0f;                     ///< on either side of each

    bool has(HistoryColumn column) const { return widths[column] > 0.0f; }
    int count() const {
        return static_cast<int>(
            std::count_if(widths.begin(), widths.end(), [](float w) { return w > 0.0f; }));
    }
};

/// The titles of the two columns that say where in its triangle a fragment lies: each number is
/// below the name of what it counts.
struct PlaceTitles {
    std::string piece; ///< "entry"
    std::string step;  ///< "fragment"; empty if a piece is all
    std::string piece_help, step_help;
};

PlaceTitles place_titles(Stage stage) {
    if (stage == Stage::points) return {"vertex", "", "Which of the triangle's vertices[].", ""};
    if (stage == Stage::edges) {
        return {"edge", "line", "Which of the triangle's edges, from 0.",
                "Which sample of the edge: line[4] is [4]."};
    }
    return {"entry", "fragment",
            "Which entry of the row table: [7] is leftPixels[7] and rightPixels[7].",
            "How many columns right of the row's left end: [0] is the left end itself."};
}

std::string in_brackets(int index) {
    return "[" + std::to_string(index) + "]";
}

float piece_width(const Ui& ui, const PlaceTitles& titles) {
    return std::max(text_width(ui.fonts.small, titles.piece), text_width(ui.fonts.mono, "[000]"));
}

float step_width(const Ui& ui, const PlaceTitles& titles) {
    return std::max(text_width(ui.fonts.small, titles.step), text_width(ui.fonts.mono, "[000]"));
}

/// The title of the column that names triangles.
constexpr const char* name_title = "triangle";

Columns measure_columns(const Ui& ui, const PixelHistory& history, float room) {
    ImFont* const mono = ui.fonts.mono;
    struct Form {
        bool has_place, has_number, has_margin;
        float padding; ///< design pixels
        std::string least_name;
    };
    // The entries are in the order of drawing: the last triangle has the longest number.
    const int last = history.entries.empty() ? 0 : history.entries.back().cursor.triangle;
    const std::string number =
        "t" + std::string(std::max<std::size_t>(std::to_string(last).size(), 2), '0');
    const PlaceTitles place = place_titles(ui.results.a.frame.settings.stage);
    // From roomy to narrow; the last one is taken if none fits.
    const Form forms[] = {{true, true, true, 7.0f, number + " tall block"},
                          {true, true, true, 4.0f, number + " tall block"},
                          {true, false, true, 4.0f, number + " tall block"},
                          {false, true, true, 5.0f, number + " tall block"},
                          {false, true, true, 4.0f, number + " tall bl"},
                          {false, false, true, 4.0f, number},
                          {false, false, false, 4.0f, number}};
    // Marks have no depth value, and so no margin.
    const bool has_margins =
        history.depth_tested && has_fragments(ui.results.a.frame.settings.stage);
    Columns columns;
    for (const Form& form : forms) {
        columns.padding = form.padding * ui.options.text_scale;
        columns.widths = {form.has_number ? text_width(mono, "00") : 0.0f,
                          std::max(text_width(ui.fonts.bold, form.least_name),
                                   text_width(ui.fonts.small, name_title)),
                          form.has_place ? piece_width(ui, place) : 0.0f,
                          form.has_place && !place.step.empty() ? step_width(ui, place) : 0.0f,
                          text_width(mono, "0.0000"),
                          has_margins && form.has_margin ? text_width(mono, "+0.0000") : 0.0f,
                          text_width(ui.fonts.small, "✓ written"),
                          mono->FontSize};
        float left = room;
        for (const float width : columns.widths)
            left -= width > 0.0f ? width + 2.0f * columns.padding : 0.0f;
        columns.widths[name_column] += std::max(left, 0.0f);
        if (left >= 0.0f) break;
    }
    return columns;
}

/// A margin with four digits after the point, or fewer where it would not fit into its column; one
/// that would read 0, or is larger than that, as its power of ten.
std::string margin_text(float value) {
    const float size = std::abs(value);
    const bool is_tiny = value != 0.0f && size < 0.00005f;
    if (is_tiny || size >= 9999.5f) return with_minus_signs(fmt::format("{:+.0e}", value));
    const int digits = size < 9.99995f ? 4 : size < 99.9995f ? 3 : size < 999.995f ? 2 : 1;
    return (value > 0.0f ? "+" : "") + fixed(static_cast<double>(value), digits);
}

bool is_linear_z(const Ui& ui) {
    return depth_rule(ui.results.a.frame.settings) == DepthTest::linear_z;
}

/// Did the fragment overwrite what is just as near, or nearer?
bool is_race_lost(const Ui& ui, const PixelEntry& entry) {
    return depth_rule(ui.results.a.frame.settings) == DepthTest::raced && entry.covered == 0 &&
           entry.fate == Fate::written && !(entry.margin > 0.0f);
}

const DepthWords& words_of(const Ui& ui) {
    return depth_words(ui.results.a.frame);
}

/// Is the compared value something other than the 1/z that all fragments carry?
bool has_other_depth(const Ui& ui) {
    return is_linear_z(ui) || words_of(ui).kind != ClipDepth::inv_z;
}

/// The title of the column of depths, and its tooltip.
std::string depth_title(const Ui& ui) {
    if (!is_linear_z(ui)) return std::string(words_of(ui).short_name);
    return words_of(ui).kind == ClipDepth::inv_z ? "1/lin z" : "by lin z";
}
std::string depth_help(const Ui& ui) {
    const DepthWords& words = words_of(ui);
    if (!is_linear_z(ui))
        return words.kind == ClipDepth::inv_z ? "Its interpolated 1/z: larger is nearer."
                                              : fmt::format("Its {}. {}", words.name, words.ends);
    return words.kind == ClipDepth::inv_z
               ? "One over the z that is interpolated in equal steps. This depth test compares it, "
                 "but it is wrong between the ends."
               : fmt::format("The {} of the z that is interpolated in equal steps. This depth test "
                             "compares it, but under perspective it is wrong between the ends.",
                             words.name);
}

std::string tooltip(const Ui& ui, const PixelHistory& history, int index) {
    const PixelEntry& entry = history.entries[index];
    std::string text = describe_moment(ui.results.a.frame, entry.cursor);
    if (history.depth_tested) {
        text += fmt::format("\n{} {}, previously stored {}, margin {}", depth_value_words(ui),
                            nine_digits_shown(entry.depth), nine_digits_shown(entry.stored),
                            nine_digits_shown(entry.margin));
    } else if (has_fragments(ui.results.a.frame.settings.stage)) {
        text += fmt::format("\n{} {}; no depth test uses it", depth_value_words(ui),
                            nine_digits_shown(entry.depth));
    }
    if (entry.covered != 0)
        text += fmt::format("\nCovers {} of the pixel's four samples, and passes at {}.",
                            count_samples(entry.covered), count_samples(entry.passed));
    if (entry.fate == Fate::depth_failed) {
        const bool is_reversed = depth_rule(ui.results.a.frame.settings) == DepthTest::reversed;
        const bool has_epsilon = depth_epsilon_rule(ui.results.a.frame.settings) > 0.0f;
        text += fmt::format("\nHidden: it is not {} than what is stored{}.",
                            is_reversed ? words_of(ui).farther : words_of(ui).nearer,
                            has_epsilon ? " by more than epsilon" : "");
    } else if (entry.fate == Fate::back_facing) {
        text += "\nCulled before the depth test: its normal points away from the camera.";
    } else if (entry.fate == Fate::cut_out) {
        text += fmt::format("\nCut out before the depth test: the alpha of its texture is {}, "
                            "below 1/2.",
                            nine_digits_shown(entry.alpha));
    } else if (is_race_lost(ui, entry)) {
        text += "\nWritten, although it is no nearer: the other thread wrote after this test.";
    } else if (entry.covered != 0) {
        text += fmt::format("\nIts colour has the share {} of the resolved pixel.",
                            nine_digits_shown(entry.share));
    } else if (stays(history, index)) {
        text += "\nWritten, and nothing was written after it, so its colour stays.";
    } else if (entry.share > 0.0f) {
        text += "\nWritten. Everything written later is half-transparent, so this shows through.";
    } else {
        text += "\nWritten, and overwritten later.";
    }
    if (ui.results.a.frame.blends && entry.share > 0.0f) {
        text += fmt::format("\n{} of the colour that stays is its own.",
                            nine_digits_shown(entry.share));
    }
    const auto colour = [](const glm::vec3& of) {
        return fmt::format("{} {} {}", nine_digits_shown(of.r), nine_digits_shown(of.g),
                           nine_digits_shown(of.b));
    };
    return fmt::format("{}\ncolour {} → {}\nClick to go to the moment just after it.", text,
                       colour(entry.colour_before), colour(entry.colour_after));
}

void draw_fate(const Ui& ui, const PixelHistory& history, int index, float opacity) {
    const PixelEntry& entry = history.entries[index];
    const bool written = entry.fate == Fate::written;
    ImVec4 colour = colour_of(written ? Meaning::pass : Meaning::fail, ui.options.theme);
    colour.w = opacity;
    const float lower = 0.5f * (ImGui::GetFontSize() - ui.fonts.small->FontSize);
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + lower);
    ImGui::PushFont(ui.fonts.small);
    const char* const word = entry.fate == Fate::back_facing ? " back"
                             : entry.fate == Fate::cut_out   ? " cut out"
                             : !written                      ? " hidden"
                             : stays(history, index)         ? " stays"
                             : entry.share > 0.0f            ? " shows"
                                                             : " written";
    text_in(colour, std::string(written ? passed_sign : failed_sign) + word);
    ImGui::PopFont();
}

/// A line between what is drawn at the cursor and what is still to come.
void draw_cursor_line(const Ui& ui, float y) {
    const float u = ui.options.text_scale;
    const ImVec2 low = ImGui::GetWindowPos();
    ImGui::GetWindowDrawList()->AddRectFilled(
        {low.x, y - 1.0f * u}, {low.x + ImGui::GetWindowWidth(), y + 1.0f * u},
        packed(colour_of(Meaning::current, ui.options.theme)));
}

/// The samples of the pixel in a row: a disc if the fragment has passed there, a ring if it only
/// covers the sample, a point if it does not.
/// @return the width that they take
float draw_sample_dots(const Ui& ui, const PixelEntry& entry, const ImVec4& colour) {
    const float u = ui.options.text_scale, step = 9.0f * u;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float middle = at.y + 0.5f * ImGui::GetTextLineHeight();
    ImDrawList* const list = ImGui::GetWindowDrawList();
    for (int sample = 0; sample < sample_count; ++sample) {
        const ImVec2 centre{at.x + step * (static_cast<float>(sample) + 0.5f), middle};
        if (has_sample(entry.passed, sample))
            list->AddCircleFilled(centre, 3.5f * u, packed(colour));
        else if (has_sample(entry.covered, sample))
            list->AddCircle(centre, 3.5f * u, packed(colour), 0, 1.2f * u);
        else
            list->AddCircleFilled(centre, 1.0f * u, packed(colour));
    }
    const float width = sample_count * step + 4.0f * u;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + width);
    return width;
}

void draw_entry(Ui& ui, const PixelHistory& history, int index, const Columns& columns) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const PixelEntry& entry = history.entries[index];
    const bool is_drawn = entry.cursor < ui.results.a.cursor;
    const bool is_now = ui.results.a.done == entry.cursor;
    // What is still to come is grey.
    const ImVec4 colour = is_drawn ? p.text : p.dim;
    const float opacity = is_drawn ? 1.0f : 0.6f;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(index);
    const float top = ImGui::GetCursorScreenPos().y - ImGui::GetStyle().CellPadding.y;
    const float left = ImGui::GetWindowPos().x;
    const bool pressed = selectable_row("##entry", is_now);
    const float bottom = ImGui::GetItemRectMax().y;
    register_widget(ui, "history." + std::to_string(index), tooltip(ui, history, index));
    ImGui::PopID();
    if (ui.follow_cursor && is_now && !ImGui::IsItemVisible()) scroll_here(0.5f);
    ImGui::SameLine(0.0f, 0.0f);
    if (columns.has(number_column)) {
        right_aligned(std::to_string(index), colour);
        ImGui::TableNextColumn();
    }
    const std::string number = short_triangle_name(entry.cursor.triangle);
    const std::string name =
        number + " " + part_words(*ui.results.a.frame.scene, entry.cursor.triangle);
    float room = columns.widths[name_column];
    if (entry.covered != 0) room -= draw_sample_dots(ui, entry, colour);
    const bool is_bold = stays(history, index) && text_width(ui.fonts.bold, name) <= room;
    ImGui::PushFont(is_bold ? ui.fonts.bold : ui.fonts.text);
    text_in(colour, first_fitting({name, number}, room));
    ImGui::PopFont();
    if (columns.has(piece_column)) {
        ImGui::TableNextColumn();
        const bool is_edge = entry.cursor.phase == Phase::edges;
        right_aligned(
            is_edge ? std::to_string(entry.cursor.index) : in_brackets(entry.cursor.index), colour);
    }
    if (columns.has(step_column)) {
        ImGui::TableNextColumn();
        // The right end of a row has the same moment as its left end.
        const bool is_row = entry.cursor.phase == Phase::rows;
        right_aligned(in_brackets(is_row ? entry.column : entry.cursor.step), colour);
    }
    ImGui::TableNextColumn();
    right_aligned(fixed(static_cast<double>(has_other_depth(ui) ? entry.depth : entry.zinv), 4),
                  colour);
    if (columns.has(margin_column)) {
        ImGui::TableNextColumn();
        right_aligned(margin_text(entry.margin), colour);
    }
    ImGui::TableNextColumn();
    draw_fate(ui, history, index, opacity);
    ImGui::TableNextColumn();
    draw_swatch(ui, ImGui::GetCursorScreenPos(), ImGui::GetTextLineHeight(), entry.colour_after,
                opacity, swatch_border * opacity);

    ImDrawList* const list = ImGui::GetWindowDrawList();
    if (stays(history, index)) {
        list->AddRectFilled({left, top}, {left + 3.0f * u, bottom},
                            packed(colour_of(Meaning::pass, ui.options.theme), opacity));
    }
    const bool is_first_upcoming =
        !is_drawn && (index == 0 || history.entries[index - 1].cursor < ui.results.a.cursor);
    if (is_first_upcoming) draw_cursor_line(ui, top);
    if (pressed) go_to_entry(ui.session, Timeline(ui.results.a.frame), entry);
}

void draw_history_headers(Ui& ui, const Columns& columns) {
    struct Header {
        const char* name;
        std::string title;
        std::string help;
    };
    const Frame& shown_frame = ui.results.a.frame;
    const DepthRules rules = depth_rules(shown_frame.settings, shown_frame.scene->space);
    const PlaceTitles place = place_titles(ui.results.a.frame.settings.stage);
    const Header headers[] = {
        {"number", "#", "Number of the fragment, in the order of drawing, from 0."},
        {"triangle", name_title, "The triangle that it belongs to, and the part of the scene."},
        {"piece", place.piece, place.piece_help},
        {"step", place.step, place.step_help},
        {"zinv", depth_title(ui), depth_help(ui)},
        {"margin", "margin",
         is_smaller_nearer(words_of(ui).kind)
             ? fmt::format("The depth buffer's previous value minus its {}. Above {} it is nearer "
                           "and is written.",
                           depth_value_words(ui), margin_limit(rules))
             : fmt::format("Its {} minus the depth buffer's previous value. Above {} it is nearer "
                           "and is written.",
                           depth_value_words(ui), margin_limit(rules))},
        {"fate", "fate",
         std::string("✓ written: it became the pixel's colour. ✓ stays: it was the last to do "
                     "so. ") +
             (shown_frame.blends ? "✓ shows: everything over it is half-transparent. " : "") +
             (has_texture_alpha(*shown_frame.scene) ? "✗ cut out: its texture is transparent "
                                                      "there. "
                                                    : "") +
             "✗ hidden: something nearer was there."},
        {"colour", "", "The pixel's colour after it."},
    };
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    int column = 0;
    for (int i = 0; i < column_count; ++i) {
        if (!columns.has(static_cast<HistoryColumn>(i))) continue;
        ImGui::TableSetColumnIndex(column++);
        ImGui::PushFont(ui.fonts.small);
        const ImVec4& colour = palette(ui.options.theme).dim;
        const bool is_left = i == name_column || i == fate_column;
        if (is_left) {
            text_in(colour, headers[i].title);
        } else {
            right_aligned(headers[i].title, colour);
        }
        ImGui::PopFont();
        register_widget(ui, std::string("history.header.") + headers[i].name, headers[i].help);
    }
}

} // namespace

std::string depth_value_words(const Ui& ui) {
    return std::string(words_of(ui).name) + (is_linear_z(ui) ? " from linear z" : "");
}

bool stays(const PixelHistory& history, int index) {
    return history.winner == index;
}

void draw_history_table(Ui& ui, const PixelHistory& history, float height) {
    const float u = ui.options.text_scale;
    const float line = ui.fonts.text->FontSize + 8.0f * u;
    const int count = static_cast<int>(history.entries.size());
    const float needed = line * static_cast<float>(count + 1) + 4.0f * u;
    const bool scrolls = needed > height;
    const float line_clip = line * std::floor((height - 4.0f * u) / line) + 4.0f * u;
    const Columns columns = measure_columns(ui, history,
                                            ImGui::GetContentRegionAvail().x -
                                                (scrolls ? ImGui::GetStyle().ScrollbarSize : 0.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(columns.padding, 4.0f * u));
    const bool open = begin_lined_table("history", columns.count(),
                                        ImGuiTableFlags_ScrollY | ImGuiTableFlags_PadOuterX |
                                            ImGuiTableFlags_SizingFixedFit,
                                        {0, std::min(needed, line_clip)});
    if (open) {
        ImGui::TableSetupScrollFreeze(0, 1);
        for (const float width : columns.widths) {
            if (width > 0.0f) ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, width);
        }
        draw_history_headers(ui, columns);
        ImGui::PushFont(ui.fonts.mono);
        ImGuiListClipper clipper;
        clipper.Begin(count);
        for (int i = 0; i < count && ui.follow_cursor; ++i) {
            if (ui.results.a.done == history.entries[i].cursor) {
                keep_items(clipper, i, i + 1);
                break;
            }
        }
        while (clipper.Step()) {
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
                draw_entry(ui, history, i, columns);
        }
        ImGui::PopFont();
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

} // namespace rasterwalk
