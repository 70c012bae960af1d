#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>

#include "base/text_parts.h"
#include "ui/actions/code.h"
#include "ui/inspector/code_parts.h"
#include "ui/ui.h"
#include "ui/widgets/code_entries.h"
#include "ui/widgets/coloured_code.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The part of the program that is shown: a file, and the call whose values are at its lines.
struct ShownCode {
    std::vector<CodeCall> calls; ///< from outside to inside; empty: the program has ended
    std::size_t call = 0;        ///< the one shown
    int line = 0;                ///< of the program, from 1: the one that comes next in that call
    int first = 0, last = 0;     ///< lines of the file
};

ShownCode shown_code(const CodeLook& look) {
    ShownCode shown;
    const std::vector<ChosenLine>& lines = look.walk.lines();
    shown.calls = look.walk.machine().calls();
    const CodeProgram& program = look.walk.machine().program();
    if (shown.calls.empty()) {
        const int draw = program.find_function("Draw");
        shown.line = program.functions[static_cast<std::size_t>(draw)].line;
    } else {
        shown.call = std::min(look.call.value_or(shown.calls.size() - 1), shown.calls.size() - 1);
        shown.line = shown.calls[shown.call].line;
    }
    const FileLines file = file_around(lines, shown.line);
    shown.first = file.first;
    shown.last = file.last;
    return shown;
}

const LineCondition* condition_of(const CodeLook& look, const ChosenLine& line) {
    const auto found =
        std::find_if(look.conditions.begin(), look.conditions.end(), [&](const LineCondition& one) {
            return one.file == line.file && one.line == line.line;
        });
    return found == look.conditions.end() ? nullptr : &*found;
}

/// What a line has computed in the call shown.
struct LineResult {
    std::string value;              ///< empty: nothing
    std::vector<CodeEntry> entries; ///< of the row table, that it reads or writes
    bool is_new = false;            ///< it was carried out for the last moment, or since
};

/// Where the parts of a line are, screen pixels.
struct LineLayout {
    float height = 0.0f, left = 0.0f, digits = 0.0f, code = 0.0f, right = 0.0f;
};

/// The line's number, and the dot of a condition. A click opens the condition.
/// @param can_stop a statement begins in the line
void draw_number(Ui& ui, const ChosenLine& line, int number, bool can_stop, const LineLayout& at,
                 float top) {
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    CodeLook& look = ui.code;
    const std::string name = fmt::format("code.number.{}", number);
    ImGui::SetCursorScreenPos({at.left, top});
    const ImVec2 size{at.code - at.left, at.height};
    if (!can_stop) {
        ImGui::Dummy(size);
    } else if (ImGui::InvisibleButton(name.c_str(), size)) {
        const LineCondition* const known = condition_of(look, line);
        look.edited = known != nullptr ? *known : LineCondition{line.file, line.line, {}};
        look.condition_fault.clear();
    }
    const bool hovered = can_stop && ImGui::IsItemHovered();
    const LineCondition* const condition = condition_of(look, line);
    if (can_stop)
        register_widget(ui, name,
                        condition != nullptr ? "Stops here when " + condition->text + "."
                                             : "Click to stop at this line when something holds.");
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const std::string digits = std::to_string(number);
    const float x = at.left + 12.0f * u + at.digits - text_width(digits);
    list->AddText({x, top + 2.0f * u}, packed(hovered ? p.text : p.dim), digits.c_str());
    if (condition != nullptr)
        list->AddCircleFilled({at.left + 6.5f * u, top + 0.5f * at.height}, 3.0f * u,
                              packed(colour_of(Meaning::current, ui.options.theme)));
}

/// How far to the right a line begins: half as far where there is little room.
float indent_of(const Ui& ui, std::size_t blanks) {
    return static_cast<float>(blanks) * text_width(" ") * (ui.inspector.is_narrow ? 0.5f : 1.0f);
}

float words_width(const Ui& ui, std::string_view text) {
    const std::size_t blanks = std::min(text.find_first_not_of(' '), text.size());
    return indent_of(ui, blanks) + text_width(text.substr(blanks));
}

/// The words of a line, cut off where the room ends.
void draw_words(const Ui& ui, std::string_view text, float x, float y, float right,
                float opacity = 1.0f) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const std::size_t blanks = std::min(text.find_first_not_of(' '), text.size());
    text.remove_prefix(blanks);
    x += indent_of(ui, blanks);
    list->PushClipRect({x, y - 2.0f}, {right, y + 2.0f * ImGui::GetTextLineHeight()}, true);
    const Palette& p = palette(ui.options.theme);
    for (const ColouredWords& words : coloured_code(text, ui.options.theme, p.text, p.dim)) {
        list->AddText({x, y}, packed(words.ink, opacity), words.text.data(),
                      words.text.data() + words.text.size());
        x += text_width(words.text);
    }
    list->PopClipRect();
}

/// A line of a mistake has the right ones below it, and a right one those that a mistake leaves
/// out. Returns how many lines high they are.
int draw_right_lines(Ui& ui, const ChosenLine& line, int number, const LineLayout& at, float top) {
    const float u = ui.options.text_scale;
    const ImVec4 right = colour_of(Meaning::pass, ui.options.theme);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const std::string name = fmt::format("code.right.{}", number);
    const int count = std::max(static_cast<int>(line.usual.size()), 1);
    if (line.is_mistake)
        list->AddRectFilled({at.left, top - at.height}, {at.left + 3.0f * u, top},
                            packed(colour_of(Meaning::fail, ui.options.theme)));
    std::string all;
    for (const std::string& usual : line.usual)
        all.append(all.empty() ? "" : "\n").append(shown_words(usual));
    for (int i = 0; i < count; ++i) {
        const float y = top + static_cast<float>(i) * at.height + 2.0f * u;
        list->AddText({at.left + 12.0f * u, y}, packed(right), passed_sign);
        if (line.usual.empty())
            list->AddText({at.code, y}, packed(palette(ui.options.theme).dim), "no such line");
        else
            draw_words(ui, shown_words(line.usual[static_cast<std::size_t>(i)]), at.code, y,
                       at.right, 0.75f);
    }
    ImGui::SetCursorScreenPos({at.left, top});
    ImGui::Dummy({at.right - at.left, static_cast<float>(count) * at.height});
    register_widget(ui, name,
                    !line.is_mistake     ? "Missing after this line."
                    : line.usual.empty() ? "The right code has no such line."
                    : count == 1         ? "The right line."
                                         : "The right lines.",
                    all);
    return count;
}

/// The whole line and its value, which may be cut off, and what a click does.
std::string line_tooltip(std::string_view text, const std::string& value, bool is_next,
                         bool can_stop) {
    std::string words(trimmed(text));
    if (!value.empty()) words += "\n" + value;
    if (is_next) return words + "\nThis line comes next.";
    return can_stop ? words + "\nClick to run to the next time this line is reached." : words;
}

/// A line of the program and its value. Returns how many lines high it is.
int draw_line(Ui& ui, const ShownCode& shown, int line, const LineResult& result,
              const LineLayout& at, float top) {
    const std::string& value = result.value;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const ChosenLine& chosen = ui.code.walk.lines()[static_cast<std::size_t>(line - 1)];
    const int number = line - shown.first + 1;
    const bool is_next = line == shown.line && !shown.calls.empty();
    const bool is_innermost = shown.call + 1 == shown.calls.size();
    const std::string_view text = shown_words(chosen.text);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const std::string name = fmt::format("code.line.{}", number);
    const bool can_stop = ui.code.walk.begins(line);
    ImGui::SetCursorScreenPos({at.code, top});
    const ImVec2 size{std::max(at.right - at.code, 1.0f), at.height};
    if (!can_stop) {
        ImGui::Dummy(size);
    } else if (ImGui::InvisibleButton(name.c_str(), size)) {
        run_code_to(ui, line);
    }
    const bool hovered = can_stop && ImGui::IsItemHovered();
    register_widget(ui, name, line_tooltip(text, value, is_next, can_stop), std::string(text));
    if (hovered) ui.code.pointed = result.entries;
    const bool is_lit =
        std::any_of(result.entries.begin(), result.entries.end(),
                    [&](const CodeEntry& entry) { return is_pointed_in_table(ui, entry); });
    if (is_next || hovered || is_lit)
        list->AddRectFilled({at.left, top}, {at.right, top + at.height},
                            packed(p.row_lit, is_next && is_innermost ? 1.0f : 0.55f));
    // What has just been carried out.
    if (result.is_new && !is_next)
        list->AddRectFilled({at.left, top}, {at.left + 2.0f * u, top + at.height},
                            packed(p.link, 0.7f));
    if (is_next) draw_current_bar(ui, list, {at.left, top}, top + at.height);
    draw_number(ui, chosen, number, can_stop, at, top);
    const float end = at.right - 8.0f * u, gap = 14.0f * u;
    draw_words(ui, text, at.code, top + 2.0f * u, at.right);
    if (!value.empty()) {
        // The code comes first; a value that does not fit is in the tooltip.
        const float room = end - at.code;
        const float rest = room - words_width(ui, text) - gap;
        const std::string fitting = shortened(value, std::clamp(rest, 0.25f * room, 0.6f * room));
        const float wide = text_width(fitting) + gap;
        const ImVec4& ground = is_next || is_lit ? p.row_lit : p.card;
        list->AddRectFilled({end - wide, top}, {at.right, top + at.height}, packed(ground));
        list->AddText({end - text_width(fitting), top + 2.0f * u},
                      packed(result.is_new ? p.link : p.dim), fitting.c_str());
        register_text(ui, name, value);
    }
    if (!chosen.is_mistake && chosen.usual.empty()) return 1;
    return 1 + draw_right_lines(ui, chosen, number, at, top + at.height);
}

} // namespace

std::string code_place_text(const Ui& ui) {
    const CodeLook& look = ui.code;
    if (!look.is_ready || !look.code) return {};
    const ShownCode shown = shown_code(look);
    const auto file =
        static_cast<std::size_t>(look.walk.lines()[static_cast<std::size_t>(shown.line - 1)].file);
    return fmt::format("{}:{}", look.code->files[file].name, shown.line - shown.first + 1);
}

int number_in_file(const CodeLook& look, int file, int line) {
    const std::vector<ChosenLine>& lines = look.walk.lines();
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const ChosenLine& one) {
        return one.file == file && one.line == line;
    });
    const int number = static_cast<int>(found - lines.begin()) + 1;
    return found == lines.end() ? 0 : number - file_around(lines, number).first + 1;
}

void draw_code_lines(Ui& ui, float height) {
    CodeLook& look = ui.code;
    const Palette& p = palette(ui.options.theme);
    const float u = ui.options.text_scale;
    const ShownCode shown = shown_code(look);
    std::map<int, LineResult> results; // by the line of the program
    if (!shown.calls.empty()) {
        const CodeCall& call = shown.calls[shown.call];
        const std::vector<CodeShown> variables = look.walk.machine().variables(call);
        for (int line = shown.first; line <= shown.last; ++line) {
            const ChosenLine& chosen = look.walk.lines()[static_cast<std::size_t>(line - 1)];
            results[line].entries = entries_in(shown_words(chosen.text), variables);
        }
        for (CodeLineValue& value : look.walk.machine().line_values(call))
            results[value.line].value = std::move(value.text);
    }
    for (const int line : look.walk.recent_lines())
        results[line].is_new = true;
    ImGui::PushStyleColor(ImGuiCol_ChildBg, p.card);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 4.0f * u});
    ImGui::BeginChild("code.lines", {0.0f, height}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoNav);
    ImGui::PushFont(ui.fonts.mono_small);
    LineLayout at;
    at.height = std::round(ImGui::GetTextLineHeight() + 5.0f * u);
    at.left = ImGui::GetCursorScreenPos().x;
    at.right = at.left + ImGui::GetContentRegionAvail().x;
    at.digits = text_width(std::to_string(shown.last - shown.first + 1));
    at.code = at.left + 24.0f * u + at.digits;
    const float begin = ImGui::GetCursorScreenPos().y;
    int rows = 0, row_of_next = 0;
    for (int line = shown.first; line <= shown.last; ++line) {
        if (line == shown.line) row_of_next = rows;
        rows += draw_line(ui, shown, line, results[line], at,
                          begin + static_cast<float>(rows) * at.height);
    }
    ImGui::SetCursorScreenPos({at.left, begin + static_cast<float>(rows) * at.height});
    ImGui::Dummy({1.0f, 1.0f});
    // The line that comes next is always in sight.
    if (look.scrolled_to != shown.line || look.scrolled_in != height) {
        look.scrolled_to = shown.line;
        look.scrolled_in = height;
        const float y = static_cast<float>(row_of_next) * at.height;
        const float top = ImGui::GetScrollY(), room = height - 2.0f * at.height;
        if (y < top || y > top + 0.75f * room) ImGui::SetScrollY(std::max(y - 0.4f * room, 0.0f));
    }
    ImGui::PopFont();
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

} // namespace rasterwalk
