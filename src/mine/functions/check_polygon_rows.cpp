#include <compare>
#include <optional>

#include "mine/functions/check_parts.h"
#include "mine/functions/line_rules.h"
#include "mine/functions/row_reach.h"
#include "mistakes/coverage.h"

namespace rasterwalk {

namespace {

using rasterwalk_kit::PixelValues;

/// A way to fill the row table.
struct RowRule {
    const LineRule* line = nullptr;
    Stages stages;
    std::string words;
    RuleSettings settings;
    std::vector<std::string> bugs, causes;
    const RowRule* right = nullptr; ///< the same without its mistakes; null: not known
};

struct AskedPolygons {
    const Questions& questions;
    const std::vector<RowLists>& answers;

    int count() const { return static_cast<int>(answers.size()); }
    const PolygonQuestion& question(int index) const {
        return questions.polygons[static_cast<std::size_t>(index)];
    }
    const RowLists& answer(int index) const { return answers[static_cast<std::size_t>(index)]; }
};

/// Half of B6, in the slot begin_polygon_rows: only the right ends start at 0.
void begin_rows_with_right_at_zero(PolygonCorners vertices, const EdgeRules& rules,
                                   PolygonRows& rows) {
    begin_polygon_rows(vertices, rules, rows);
    for (RowEnd& end : rows.right)
        end.column = 0;
}

/// A change of the lab's row table that is a mistake.
struct RowChange {
    std::string_view name, value, bug, cause;
    void (*make)(Stages&);
};

constexpr RowChange row_changes[] = {
    {"edge_samples",
     "rows",
     "B5",
     {},
     [](Stages& stages) { stages.edge_sample_count = edge_sample_count_by_rows; }},
    {"edge_samples",
     "shifted",
     "B12",
     {},
     [](Stages& stages) { stages.edge_sample_count = edge_sample_count_shifted; }},
    {"edge_samples",
     "without_last",
     "B91",
     {},
     [](Stages& stages) { stages.entered_samples = entered_without_last; }},
    {"edge_samples",
     "no_last_edge",
     "B94",
     {},
     [](Stages& stages) { stages.entered_samples = entered_without_last_edge; }},
    {"row_start",
     "window",
     "B6",
     {},
     [](Stages& stages) { stages.begin_polygon_rows = begin_rows_at_picture; }},
    {"row_start",
     "window",
     "B6",
     {},
     [](Stages& stages) { stages.begin_polygon_rows = begin_rows_with_right_at_zero; }},
    {"row_start",
     "row_short",
     "B95",
     {},
     [](Stages& stages) { stages.begin_polygon_rows = begin_rows_without_last; }},
};

constexpr std::pair<EdgeOrder, std::string_view> edge_orders[] = {
    {EdgeOrder::as_given, ""},
    {EdgeOrder::down, "; each edge is walked from its upper end"},
    {EdgeOrder::left_first, "; each edge is walked from its left end"},
};

/// Each order of the ends, with samples beyond the table left out or put in the nearest row.
void add_row_rules(const LineRule& line, std::vector<RowRule>& rules) {
    for (const auto& [order, order_words] : edge_orders) {
        for (const bool is_clamped : {false, true}) {
            RowRule& rule = rules.emplace_back();
            rule.line = &line;
            rule.stages = with_edge_order(line.stages, order);
            rule.words = line.words + std::string(order_words);
            rule.settings = line.settings;
            if (!line.bug.empty()) rule.bugs.push_back(line.bug);
            if (!line.cause.empty()) rule.causes.push_back(line.cause);
            if (!is_clamped) continue;
            rule.stages.find_row = find_nearest_row;
            rule.words += "; samples beyond the table go in the nearest row";
            rule.settings.emplace_back("row_search", "clamped");
        }
    }
}

const std::vector<RowRule>& right_row_rules() {
    static const std::vector<RowRule> rules = [] {
        std::vector<RowRule> made;
        for (const LineRule& line : right_line_rules())
            add_row_rules(line, made);
        return made;
    }();
    return rules;
}

const std::vector<RowRule>& mistaken_row_rules() {
    static const std::vector<RowRule> rules = [] {
        std::vector<RowRule> made;
        for (const RowRule& right : right_row_rules()) {
            for (const RowChange& change : row_changes) {
                // Other algorithms have no use for another number of samples.
                if (right.line->needs_full_count && change.name == "edge_samples" &&
                    change.bug != "B91" && change.bug != "B94")
                    continue;
                RowRule& rule = made.emplace_back(right);
                rule.right = &right;
                change.make(rule.stages);
                rule.settings.emplace_back(change.name, change.value);
                rule.bugs.emplace_back(change.bug);
            }
        }
        for (const LineRule& line : mistaken_line_rules())
            add_row_rules(line, made);
        return made;
    }();
    return rules;
}

/// The row table of a question by a rule.
void fill_rows(const RowRule& rule, int index, const AskedPolygons& asked, PolygonRows& rows) {
    std::vector<ScreenVertex> corners;
    for (const PixelValues& corner : asked.question(index).corners)
        corners.push_back(to_screen_vertex(corner));
    const EdgeRules edges{
        rule.line->rounding, asked.questions.program.viewport.width, VaryingSet{}, {}};
    compute_polygon_rows(corners, edges, rule.stages, rows, nullptr);
}

bool is_empty_row(const RowLists& lists, std::size_t row) {
    return lists.left.pixels[row].x > lists.right.pixels[row].x;
}

/// Has the answer these ends of a row, or are both empty there?
bool has_same_ends(const PolygonRows& ours, const RowLists& theirs, std::size_t row) {
    if (ours.is_empty_row(static_cast<int>(row)) && is_empty_row(theirs, row)) return true;
    return theirs.left.pixels[row].x == ours.left[row].column &&
           theirs.right.pixels[row].x == ours.right[row].column;
}

/// The first row in which the answer differs from a table; -1: none. A different number of rows
/// differs in the first that is missing or too many.
int first_other_row(const PolygonRows& ours, const RowLists& theirs) {
    const auto size = static_cast<std::size_t>(ours.size());
    const std::size_t common =
        std::min({size, theirs.left.pixels.size(), theirs.right.pixels.size()});
    for (std::size_t i = 0; i < common; ++i) {
        if (!has_same_ends(ours, theirs, i)) return static_cast<int>(i);
    }
    const bool same_size = theirs.left.size == ours.size() && theirs.right.size == ours.size();
    return same_size ? -1 : static_cast<int>(common);
}

bool explains_all_polygons(const RowRule& rule, const AskedPolygons& asked, PolygonRows& room) {
    // Small triangles first: most rules fail at one of them, and cost little there.
    for (int turn = asked.count() - 1; turn >= 0; --turn) {
        fill_rows(rule, turn, asked, room);
        if (first_other_row(room, asked.answer(turn)) >= 0) return false;
    }
    return true;
}

/// How many polygons a rule fills alike, and how many rows of all of them.
struct Alike {
    int polygons = 0, rows = 0;

    auto operator<=>(const Alike&) const = default;
};

Alike alike_by(const RowRule& rule, const AskedPolygons& asked) {
    PolygonRows room;
    Alike alike;
    for (int i = 0; i < asked.count(); ++i) {
        const RowLists& theirs = asked.answer(i);
        fill_rows(rule, i, asked, room);
        if (first_other_row(room, theirs) < 0) ++alike.polygons;
        const std::size_t common =
            std::min({static_cast<std::size_t>(room.size()), theirs.left.pixels.size(),
                      theirs.right.pixels.size()});
        for (std::size_t row = 0; row < common; ++row)
            alike.rows += has_same_ends(room, theirs, row) ? 1 : 0;
    }
    return alike;
}

/// The same answers with something undone that the laboratory lacks.
struct UndoneTrap {
    std::string_view cause;
    void (*undo)(RowLists&);
};

constexpr UndoneTrap row_traps[] = {
    {"leftPixels and rightPixels are exchanged.",
     [](RowLists& lists) { std::swap(lists.left, lists.right); }},
    {"The table has one row too many at its end.",
     [](RowLists& lists) {
         for (PixelList* const list : {&lists.left, &lists.right}) {
             list->size -= 1.0;
             if (!list->pixels.empty()) list->pixels.pop_back();
         }
     }},
};

const RowRule* first_that_explains(const std::vector<RowRule>& rules, const AskedPolygons& asked) {
    PolygonRows room;
    for (const RowRule& rule : rules) {
        if (explains_all_polygons(rule, asked, room)) return &rule;
    }
    return nullptr;
}

/// The right rule that fills the most polygons alike, and of those the most rows.
const RowRule& closest_row_rule(const AskedPolygons& asked) {
    const RowRule* closest = nullptr;
    Alike most;
    for (const RowRule& rule : right_row_rules()) {
        const Alike alike = alike_by(rule, asked);
        if (closest == nullptr || alike > most) most = alike, closest = &rule;
    }
    return *closest;
}

PixelValues to_pixel_values(const RowEnd& end, int row) {
    PixelValues values{};
    values.fields = rasterwalk_kit::field_xy;
    values.x = end.column;
    values.y = row;
    return values;
}

void say_row_difference(const RowRule& closest, int index, int row, const AskedPolygons& asked,
                        FunctionCheck& check) {
    PolygonRows ours;
    fill_rows(closest, index, asked, ours);
    FunctionDifference& difference = check.difference;
    difference.question = index;
    difference.item = row;
    difference.their_rows = asked.answer(index);
    difference.our_rows.left.size = difference.our_rows.right.size = ours.size();
    for (int i = 0; i < ours.size(); ++i) {
        const auto at = static_cast<std::size_t>(i);
        difference.our_rows.left.pixels.push_back(
            to_pixel_values(ours.left[at], ours.first_row + i));
        difference.our_rows.right.pixels.push_back(
            to_pixel_values(ours.right[at], ours.first_row + i));
    }
    const std::string& name = asked.question(index).name;
    const RowLists& theirs = difference.their_rows;
    const auto at = static_cast<std::size_t>(row);
    if (theirs.left.size != theirs.right.size) {
        check.first = fmt::format("{}: leftPixels has {:.0f} rows and rightPixels {:.0f}.", name,
                                  theirs.left.size, theirs.right.size);
    } else if (at >= theirs.left.pixels.size() || row >= ours.size()) {
        check.first = fmt::format("{}: the table has {:.0f} rows where {} are right.", name,
                                  theirs.left.size, ours.size());
    } else {
        check.first =
            fmt::format("{}: row {} goes from {:.9g} to {:.9g} where {} to {} is right.", name,
                        ours.first_row + row, theirs.left.pixels[at].x, theirs.right.pixels[at].x,
                        ours.left[at].column, ours.right[at].column);
    }
}

/// Is everything within what rounding can do, and nearly all as the closest rule has it?
bool is_within_row_rounding(const RowRule& closest, const AskedPolygons& asked) {
    PolygonRows ours;
    int rows = 0, same = 0;
    for (int i = 0; i < asked.count(); ++i) {
        fill_rows(closest, i, asked, ours);
        const RowLists& theirs = asked.answer(i);
        if (theirs.left.size != ours.size() || theirs.right.size != ours.size()) return false;
        for (std::size_t r = 0; r < theirs.left.pixels.size(); ++r) {
            const int row = ours.first_row + static_cast<int>(r);
            const double left = theirs.left.pixels[r].x, right = theirs.right.pixels[r].x;
            if (!can_reach(asked.question(i).corners, row, left, right)) return false;
            ++rows;
            same += left == ours.left[r].column && right == ours.right[r].column ? 1 : 0;
        }
    }
    return same * 10 >= rows * 8;
}

void explain_tables(const AskedPolygons& asked, FunctionCheck& check) {
    if (const RowRule* const rule = first_that_explains(right_row_rules(), asked)) {
        check.rule = rule->words;
        check.rules = rule->settings;
        check.right = asked.count();
        if (rule->line == &right_line_rules().front())
            check.rule +=
                "; this is the handout's own rule, which loses the end of some edges (B1)";
        return;
    }
    const RowRule* closest = &closest_row_rule(asked);
    PolygonRows room;
    bool is_by_known_rule = false;
    for (const RowRule& rule : mistaken_row_rules()) {
        const bool is_known = (!rule.bugs.empty() && std::find(check.bugs.begin(), check.bugs.end(),
                                                               rule.bugs[0]) != check.bugs.end());
        if (is_known || !explains_all_polygons(rule, asked, room)) continue;
        for (const std::string& bug : rule.bugs)
            add_once(bug, check.bugs);
        for (const std::string& cause : rule.causes)
            add_once(cause, check.causes);
        // The program's own rule gives the right numbers, not one that happens to be nearer.
        if (is_by_known_rule || rule.right == nullptr) continue;
        closest = rule.right;
        is_by_known_rule = true;
    }
    const int most = alike_by(*closest, asked).polygons;
    check.right = most;
    check.rules = closest->settings;
    if (check.bugs.empty() && check.causes.empty()) {
        for (const UndoneTrap& trap : row_traps) {
            std::vector<RowLists> undone = asked.answers;
            for (RowLists& lists : undone)
                trap.undo(lists);
            if (first_that_explains(right_row_rules(), {asked.questions, undone}) != nullptr)
                add_once(trap.cause, check.causes);
        }
    }
    const bool is_named = !check.bugs.empty() || !check.causes.empty();
    if (!is_named && is_within_row_rounding(*closest, asked)) {
        check.right = asked.count();
        check.rule = fmt::format("within the rounding of a pixel everywhere; {} of {} polygons as "
                                 "if {}",
                                 most, asked.count(), closest->words);
        return;
    }
    set_wrong(check);
    for (int i = 0; i < asked.count(); ++i) {
        fill_rows(*closest, i, asked, room);
        const int row = first_other_row(room, asked.answer(i));
        if (row < 0) continue;
        say_row_difference(*closest, i, row, asked, check);
        return;
    }
}

/// Checks y, 1/z and the rest at the ends of the rows.
void check_row_values(const AskedPolygons& asked, FunctionCheck& check) {
    bool has_zinv = false, has_y = false;
    // The tables themselves are right where this is called.
    RightQuestions right(static_cast<std::size_t>(asked.count()), true);
    std::optional<std::pair<int, std::string>> wrong;
    for (int i = 0; i < asked.count(); ++i) {
        const PolygonQuestion& question = asked.question(i);
        const RowLists& theirs = asked.answer(i);
        double top = question.corners[0].y;
        for (const PixelValues& corner : question.corners)
            top = std::min(top, corner.y);
        for (std::size_t r = 0; r < theirs.left.pixels.size(); ++r) {
            if (is_empty_row(theirs, r)) continue;
            const double row = top + static_cast<double>(r);
            for (const PixelValues* const end : {&theirs.left.pixels[r], &theirs.right.pixels[r]}) {
                has_zinv = has_zinv || end->zinv != 0.0;
                has_y = has_y || end->y != 0.0;
                std::string fault;
                if (end->y != row) {
                    fault = fmt::format("y of row {:.0f} is {:.9g}.", row, end->y);
                } else {
                    fault = value_fault(question.corners, *end);
                }
                if (fault.empty()) continue;
                right[static_cast<std::size_t>(i)] = false;
                if (!wrong) wrong = {i, fmt::format("{}: {}", question.name, fault)};
            }
        }
    }
    if (!wrong) return;
    set_wrong(check);
    check.right = count_right(right);
    check.first = wrong->second;
    check.difference.question = wrong->first;
    check.difference.their_rows = asked.answer(wrong->first);
    if (!has_y) check.causes.emplace_back("The ends of the rows have no y: it is 0 everywhere.");
    if (has_y && !has_zinv) check.bugs.emplace_back("B90");
}

} // namespace

FunctionCheck check_polygon_rows(const Questions& questions, const Answers& answers) {
    FunctionCheck check = begin_check("ComputePolygonRows", rasterwalk_kit::part_polygon_rows,
                                      questions, answers.polygons);
    if (!has_answers(check)) return check;
    const AskedPolygons asked{questions, answers.polygons.answers};
    if (check.state == CheckState::died &&
        answers.polygons.answers.size() < questions.polygons.size())
        check.first = fmt::format("The program ended at {}.", asked.question(asked.count()).name);
    if (asked.count() == 0) return check;
    const bool does_nothing =
        std::all_of(asked.answers.begin(), asked.answers.end(), [](const RowLists& lists) {
            return lists.left.size == 0.0 && lists.right.size == 0.0;
        });
    if (does_nothing) {
        if (check.state == CheckState::right) check.state = CheckState::not_written;
        return check;
    }
    explain_tables(asked, check);
    const bool is_explained = check.bugs.empty() && check.causes.empty();
    if (check.state == CheckState::right && is_explained) check_row_values(asked, check);
    return check;
}

} // namespace rasterwalk
