#include "ui/widgets/formula_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "ui/ui.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"
#include "ui/widgets/vector_letters.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

std::string exact_text(const Number& number) {
    return number.is_whole ? with_minus_signs(decimals(static_cast<double>(number.value), 0))
                           : nine_digits_shown(number.value);
}

std::string input_tooltip(const FormulaInput& input) {
    std::string text = input.symbol + " = " + exact_text(input.number) + "\n";
    std::string place = source_text(input.source);
    if (input.source.kind == SourceKind::formula)
        place = "Click to see how it was calculated.";
    else if (input.source.kind != SourceKind::given)
        place += "\nClick to see it there.";
    return text + place;
}

/// The help for a formula, followed by that for the functions in it.
std::string with_function_help(std::string text, const Formula& formula) {
    const std::string functions = function_help(formula.expression);
    return functions.empty() ? text : text.append("\n").append(functions);
}

/// The numbers of a formula, one after another, with the signs between them.
std::optional<Source> draw_numbers(FormulaLine& line, const Palette& p, const Formula& formula,
                                   const std::string& name) {
    std::optional<Source> clicked;
    int number = 0;
    for (const FormulaPiece& piece : pieces_with_numbers(formula)) {
        if (piece.input < 0) {
            line.text(piece.text, p.text);
            continue;
        }
        const FormulaInput& input = formula.inputs[static_cast<std::size_t>(piece.input)];
        // The same input may be in a formula twice.
        const std::string id = name + "." + input.symbol;
        const std::string unique = number++ == 0 ? id : id + "##" + std::to_string(number);
        if (line.link(piece.text, unique, input_tooltip(input), p.text)) clicked = input.source;
    }
    return clicked;
}

/// A tooltip is text even over a number.
void name_number(Ui& ui, std::string_view name, std::string_view tooltip) {
    ImGui::PushFont(ui.fonts.text);
    register_widget(ui, name, tooltip);
    ImGui::PopFont();
}

/// A page that scrolls, and below it the part that must stay in view: the card.
/// @param name under which both keep their sizes from one frame to the next
void draw_with_card(const char* name, const std::function<void()>& page,
                    const std::function<void()>& card) {
    ImGuiStorage* const sizes = ImGui::GetStateStorage();
    const ImGuiID page_id = ImGui::GetID((std::string(name) + ".page").c_str());
    const ImGuiID card_id = ImGui::GetID((std::string(name) + ".card").c_str());
    const ImGuiID whole_id = ImGui::GetID((std::string(name) + ".whole").c_str());
    const float room = ImGui::GetContentRegionAvail().y;
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float card_height = sizes->GetFloat(card_id, 8.0f * ImGui::GetTextLineHeight());
    const float left = std::max(room - card_height - spacing, 0.42f * room);
    // The card follows the last whole line; a leftover strip of the room is below the card.
    const float whole = std::min(sizes->GetFloat(whole_id, left), left);
    ImGui::BeginChild(page_id, {0, std::min(sizes->GetFloat(page_id, room), whole)}, false,
                      ImGuiWindowFlags_NoNav);
    begin_line_clip(left);
    page();
    // A gap lower than a line is like any other, and the page keeps it.
    const float blank = left - whole_height();
    sizes->SetFloat(
        whole_id, blank < ImGui::GetTextLineHeight() ? left : std::max(left - blank, 0.5f * left));
    end_line_clip();
    const float page_height = ImGui::GetCursorPosY();
    ImGui::EndChild();
    // A card without enough room scrolls separately, so that neither of the two is ever out of
    // sight. Its height is from the previous frame: what does not fit yet must not make the panel
    // scroll.
    const float card_room = std::max(room - left - spacing, 1.0f);
    const bool scrolls = card_height > card_room + 1.0f && card_room > ImGui::GetTextLineHeight();
    ImGui::BeginChild(card_id, {0, std::max(scrolls ? card_room : card_height, 1.0f)}, false,
                      scrolls ? ImGuiWindowFlags_NoNav
                              : ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar);
    begin_line_clip();
    card();
    end_line_clip();
    const float card_height_now = ImGui::GetCursorPosY();
    ImGui::EndChild();
    sizes->SetFloat(page_id, page_height);
    sizes->SetFloat(card_id, card_height_now);
}

/// Are its letters those of vectors at a fragment? In other formulas they name other things.
bool is_about_vectors(const Formula& formula) {
    const std::string_view part = first_part(formula.id);
    const bool is_light = part == "pixel_light" || part == "triangle_light" || part == "bump";
    return is_light && formula.id.find(".shadow.") == std::string::npos;
}

} // namespace

FormulaLine::FormulaLine(Ui& in, float indented)
    : ui_(in), begin_(ImGui::GetCursorPosX()), indent_(indented),
      right_(begin_ + ImGui::CalcItemWidth()) {
    ImGui::PushFont(ui_.fonts.mono);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 2.0f * ui_.options.text_scale));
}

FormulaLine::~FormulaLine() {
    ImGui::PopStyleVar();
    ImGui::PopFont();
}

void FormulaLine::make_room(float width) {
    if (is_first_) {
        is_first_ = false;
        return;
    }
    ImGui::SameLine(0.0f, 0.0f);
    if (width == 0.0f || ImGui::GetCursorPosX() + width <= right_ ||
        ImGui::GetCursorPosX() <= begin_ + indent_)
        return;
    ImGui::NewLine();
    ImGui::SetCursorPosX(begin_ + indent_);
}

template <class Draw>
void FormulaLine::each_word(std::string_view words, const Draw& draw) {
    while (!words.empty()) {
        // A word keeps the blank after it.
        const std::size_t blank = words.find(' ');
        const std::size_t length = blank == std::string_view::npos ? words.size() : blank + 1;
        const std::string_view word = words.substr(0, length);
        const std::string_view visible = word.substr(0, word.find(' '));
        // A closing sign stays next to its number: the card's border has room for it.
        const bool closes = visible.starts_with(')') || visible.starts_with(',');
        make_room(closes || visible.empty()
                      ? 0.0f
                      : ImGui::CalcTextSize(visible.data(), visible.data() + visible.size()).x);
        draw(word);
        words.remove_prefix(length);
    }
}

void FormulaLine::text(std::string_view words, const ImVec4& colour) {
    each_word(words, [&](std::string_view word) { text_in(colour, word); });
}

void FormulaLine::text_with_vectors(std::string_view words, const ImVec4& colour) {
    each_word(words, [&](std::string_view word) {
        std::size_t begin = 0;
        for (const LetterPart& part : vector_letters_in(word)) {
            if (begin > 0) ImGui::SameLine(0.0f, 0.0f);
            text_in(vector_letter_colour(ui_, part.vector).value_or(colour),
                    word.substr(begin, part.end - begin));
            begin = part.end;
        }
    });
}

bool FormulaLine::link(std::string_view label, const std::string& name, const std::string& tooltip,
                       const ImVec4& colour) {
    const Palette& p = palette(ui_.options.theme);
    const ImVec2 size = ImGui::CalcTextSize(label.data(), label.data() + label.size());
    make_room(size.x);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(name.c_str(), {std::max(size.x, 1.0f), size.y});
    const bool hovered = ImGui::IsItemHovered();
    name_number(ui_, name.substr(0, name.find("##")), tooltip);
    register_text(ui_, name.substr(0, name.find("##")), label);
    if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->AddText(at, packed(hovered ? p.link : colour), label.data(), label.data() + label.size());
    const float below = at.y + size.y - 0.5f;
    list->AddLine({at.x, below}, {at.x + size.x, below},
                  packed(hovered ? p.link : p.dim, hovered ? 1.0f : 0.45f));
    return clicked;
}

std::optional<Source> draw_formula(Ui& ui, const Formula& formula, const std::string& name) {
    const Palette& p = palette(ui.options.theme);
    ImGui::PushFont(ui.fonts.mono);
    const float indent = ImGui::CalcTextSize("= ").x;
    ImGui::PopFont();
    const float begin = ImGui::GetCursorPosX();
    ImGui::BeginGroup();
    {
        FormulaLine line(ui, indent);
        if (is_about_vectors(formula)) {
            line.text_with_vectors(formula.name + " ", p.text);
            line.text_with_vectors("= " + formula.expression, p.dim);
        } else {
            line.text(formula.name + " ", p.text);
            line.text("= " + formula.expression, p.dim);
        }
    }
    ImGui::EndGroup();
    register_widget(ui, name + ".expression", with_function_help(formula.help, formula));
    std::optional<Source> clicked;
    {
        FormulaLine line(ui, indent);
        line.text("= ", p.dim);
        clicked = draw_numbers(line, p, formula, name);
    }
    const std::string result = shown(formula.result);
    const std::string terms = with_terms(formula);
    const auto draw_result = [&](FormulaLine& line) {
        line.text("= ", p.dim);
        line.text(result, p.link);
        name_number(ui, name + ".result", "In full: " + exact_text(formula.result));
        register_text(ui, name + ".result", result);
    };
    const bool has_result = with_numbers(formula) != result;
    bool is_done = false;
    if (!terms.empty() && terms != result) {
        FormulaLine line(ui, indent);
        line.text("= ", p.dim);
        line.text(terms, p.text);
        // Where lines are few the result is on the last one.
        if (has_result && ui.inspector.is_low) {
            line.text(" ", p.dim);
            draw_result(line);
            is_done = true;
        }
    }
    if (has_result && !is_done) {
        ImGui::SetCursorPosX(begin);
        FormulaLine line(ui, indent);
        draw_result(line);
    }
    return clicked;
}

std::optional<Source> draw_formula_line(Ui& ui, const Formula& formula, const std::string& name) {
    const Palette& p = palette(ui.options.theme);
    ImGui::PushFont(ui.fonts.mono);
    const float indent = ImGui::CalcTextSize("   ").x;
    ImGui::PopFont();
    FormulaLine line(ui, indent);
    line.text((formula.label.empty() ? formula.name : formula.label) + " ", p.dim);
    line.text("= ", p.dim);
    std::optional<Source> clicked = draw_numbers(line, p, formula, name);
    const std::string result = shown(formula.result);
    if (with_numbers(formula) == result) return clicked;
    line.text(" = ", p.dim);
    const ImVec4 colour = formula.warns ? colour_of(Meaning::fail, ui.options.theme) : p.text;
    if (line.link(result, name,
                  with_function_help(formula.help + "\n" + formula.name + " = " +
                                         formula.expression + " = " + exact_text(formula.result),
                                     formula),
                  colour)) {
        clicked = from_formula(formula.id);
    }
    return clicked;
}

std::optional<Source> draw_section(Ui& ui, const std::vector<Formula>& formulas,
                                   std::string_view section, const std::string& owner) {
    std::optional<Source> clicked;
    for (const Formula& formula : formulas) {
        if (formula.section != section) continue;
        if (std::optional<Source> source = draw_formula_line(ui, formula, owner + formula.id))
            clicked = std::move(source);
    }
    return clicked;
}

void draw_panel(const Ui& ui, const char* name, const std::vector<PanelBlock>& blocks,
                const std::function<void()>& card) {
    bool is_card_due = !ui.inspector.has_card;
    const auto page = [&] {
        for (const PanelBlock& block : blocks) {
            block.draw();
            if (is_card_due && block.has_chosen) {
                card();
                is_card_due = false;
            }
        }
    };
    if (is_card_due) {
        page();
    } else {
        draw_with_card(name, page, card);
    }
}

std::optional<Source> draw_formula_card(Ui& ui, const Formula& formula, const std::string& name) {
    begin_card(ui);
    if (!ui.inspector.is_low) wrapped_text_in(palette(ui.options.theme).dim, formula.help);
    const std::optional<Source> clicked = draw_formula(ui, formula, name);
    end_card(ui);
    return clicked;
}

bool number_cell(Ui& ui, const std::string& name, std::string_view text, const ImVec4& colour,
                 bool is_chosen, std::string_view tooltip) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x;
    // The highlight behind a chosen number stays within the space around its cell.
    const ImGuiStyle& style = ImGui::GetStyle();
    const float around = 2.0f * std::floor(0.7f * style.CellPadding.x);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        ImVec2(std::min(style.ItemSpacing.x, around), style.ItemSpacing.y));
    const bool clicked =
        ImGui::Selectable(("##" + name).c_str(), is_chosen, 0, {room, ImGui::GetTextLineHeight()});
    ImGui::PopStyleVar();
    // As high as the words next to it: both are seen, or neither.
    const float bottom = at.y + std::max(ImGui::GetTextLineHeight(), ui.fonts.text->FontSize);
    clip_range_to_lines(at.y, bottom);
    // The highlight behind the chosen number begins above its line.
    keep_beginning(ImGui::GetItemRectMin().y, bottom);
    name_number(ui, name, tooltip);
    register_text(ui, name, text);
    const float width = ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
    ImGui::GetWindowDrawList()->AddText({at.x + std::max(room - width, 0.0f), at.y}, packed(colour),
                                        text.data(), text.data() + text.size());
    return clicked;
}

} // namespace rasterwalk
