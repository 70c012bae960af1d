#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "explain/formula.h"

namespace rasterwalk {

struct Ui;

/// A line of a formula that breaks between its pieces and continues further to the right. In the
/// font for numbers.
class FormulaLine {
  public:
    /// @param indent where it continues after a break, screen pixels from where it begins
    FormulaLine(Ui& in, float indent);
    ~FormulaLine();
    FormulaLine(const FormulaLine&) = delete;
    FormulaLine& operator=(const FormulaLine&) = delete;

    void text(std::string_view words, const ImVec4& colour);
    /// The same with the letters of the vectors that are shown in their colours.
    void text_with_vectors(std::string_view words, const ImVec4& colour);
    /// A number that leads to where it comes from. Returns true if it is clicked.
    bool link(std::string_view label, const std::string& name, const std::string& tooltip,
              const ImVec4& colour);

  private:
    void make_room(float width);
    template <class Draw>
    void each_word(std::string_view words, const Draw& draw);

    Ui& ui_;
    float begin_, indent_, right_;
    bool is_first_ = true;
};

/// A formula in full: with symbols, with numbers, with its terms computed, its result; each number
/// a link. Returns the source that was clicked.
std::optional<Source> draw_formula(Ui& ui, const Formula& formula, const std::string& name);

/// A formula on one line: its label, the numbers, the result; each number a link. The result leads
/// to the formula itself.
std::optional<Source> draw_formula_line(Ui& ui, const Formula& formula, const std::string& name);

/// The formulas of a section, a line for each. Returns the source that was clicked.
/// @param owner before the ids in the names of the widgets: "fragment."
std::optional<Source> draw_section(Ui& ui, const std::vector<Formula>& formulas,
                                   std::string_view section, const std::string& owner);

/// A part of a panel, from top to bottom.
struct PanelBlock {
    std::function<void()> draw;
    bool has_chosen = false; ///< the number that the card explains is in it
};

/// A panel of numbers, and the card with the formula of the chosen one: below the page and always
/// in view, or, where lines are few, in the page, after the first block that has that number.
/// @param name under which page and card keep their sizes from one frame to the next
void draw_panel(const Ui& ui, const char* name, const std::vector<PanelBlock>& blocks,
                const std::function<void()>& card);

/// A formula in a card, with its help above it unless lines are few: then the tooltip of the number
/// has that. Returns the source that was clicked.
std::optional<Source> draw_formula_card(Ui& ui, const Formula& formula, const std::string& name);

/// A number in a cell of a table, at its right edge, that can be clicked.
bool number_cell(Ui& ui, const std::string& name, std::string_view text, const ImVec4& colour,
                 bool is_chosen, std::string_view tooltip);

} // namespace rasterwalk
