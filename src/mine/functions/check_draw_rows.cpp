#include <array>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "mine/functions/check_parts.h"
#include "mine/functions/line_rules.h"
#include "mistakes/coverage.h"

namespace rasterwalk {

namespace {

using rasterwalk_kit::PixelValues;
using PixelSet = std::set<std::pair<int, int>>; ///< row, column

/// A way to draw the rows of a table.
struct DrawRule {
    std::string words; ///< of a rule that is right
    RuleSettings settings;
    std::string bug, cause;
    int (*drawn_pixels)(int) = rasterwalk::drawn_pixels;
    const LineRule* line = nullptr; ///< that makes the columns of a row; null: they are counted
    int skipped_left = 0;           ///< pixels left out at the left end
    int skipped_rows_above = 0, skipped_rows_below = 0;
    bool leaves_out_zero = false;       ///< column 0 and row 0 count as outside
    bool counts_rows_from_zero = false; ///< row i of the table is drawn in row i of the picture
};

struct AskedRows {
    const Questions& questions;
    const std::vector<PutList>& answers;

    int count() const { return static_cast<int>(answers.size()); }
    const RowsQuestion& question(int index) const {
        return questions.rows[static_cast<std::size_t>(index)];
    }
};

bool is_inside(double x, double y, const Viewport& picture) {
    return x >= 0.0 && y >= 0.0 && x < picture.width && y < picture.height;
}

/// Longer rows lie outside every picture, or are empty.
constexpr double most_columns = 32768.0;

/// The pixels of one row.
void add_row_pixels(const DrawRule& rule, const PixelValues& left, const PixelValues& right,
                    int row, const Viewport& picture, PixelSet& pixels) {
    if (left.x > right.x || right.x - left.x > most_columns) return;
    const int count = row_pixel_count(static_cast<int>(left.x), static_cast<int>(right.x));
    const int drawn = rule.drawn_pixels(count);
    std::vector<LineSample> samples;
    if (rule.line != nullptr)
        samples = samples_by(*rule.line, to_line_end(left), to_line_end(right), count);
    for (int i = rule.skipped_left; i < drawn; ++i) {
        const int column = samples.empty() ? static_cast<int>(left.x) + i
                                           : samples[static_cast<std::size_t>(i)].fragment.column;
        if (rule.leaves_out_zero && (column == 0 || row == 0)) continue;
        if (is_inside(column, row, picture)) pixels.emplace(row, column);
    }
}

PixelSet pixels_by(const DrawRule& rule, const RowsQuestion& question, const Viewport& picture) {
    PixelSet pixels;
    const int last = static_cast<int>(question.left.size()) - rule.skipped_rows_below;
    for (int i = rule.skipped_rows_above; i < last; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const int row = rule.counts_rows_from_zero ? i : static_cast<int>(question.left[at].y);
        add_row_pixels(rule, question.left[at], question.right[at], row, picture, pixels);
    }
    return pixels;
}

/// Those that the program put inside the picture. What it puts outside does not show: its helper
/// may refuse it.
PixelSet pixels_of(const PutList& drawn, const Viewport& picture) {
    PixelSet pixels;
    for (const DrawnPixel& pixel : drawn.pixels) {
        if (is_inside(pixel.x, pixel.y, picture))
            pixels.emplace(static_cast<int>(pixel.y), static_cast<int>(pixel.x));
    }
    return pixels;
}

bool draws_question(const DrawRule& rule, int index, const AskedRows& asked,
                    const std::vector<PixelSet>& theirs) {
    return pixels_by(rule, asked.question(index), asked.questions.program.viewport) ==
           theirs[static_cast<std::size_t>(index)];
}

bool draws_all(const DrawRule& rule, const AskedRows& asked, const std::vector<PixelSet>& theirs) {
    for (int i = asked.count() - 1; i >= 0; --i) {
        if (!draws_question(rule, i, asked, theirs)) return false;
    }
    return true;
}

std::vector<DrawRule> make_right_draw_rules() {
    std::vector<DrawRule> rules(1);
    rules[0].words = "from the left to the right end, both included";
    rules[0].settings = {{"spans", "inclusive"}};
    for (const LineRule& line : right_line_rules()) {
        DrawRule& rule = rules.emplace_back();
        rule.words = "the samples of Interpolate; " + line.words;
        rule.settings = {{"spans", "inclusive"}};
        rule.line = &line;
    }
    return rules;
}

std::vector<DrawRule> make_mistaken_draw_rules() {
    std::vector<DrawRule> rules;
    const auto add = [&](std::string_view bug, std::string_view cause,
                         RuleSettings settings) -> DrawRule& {
        DrawRule& rule = rules.emplace_back();
        rule.bug = bug;
        rule.cause = cause;
        rule.settings = std::move(settings);
        return rule;
    };
    add("B8", {}, {{"spans", "single_skipped"}}).drawn_pixels = drawn_pixels_without_single;
    add("B9", {}, {{"spans", "last_dropped"}}).drawn_pixels = drawn_pixels_without_last;
    add("B10", {}, {{"bounds", "excludes_zero"}}).leaves_out_zero = true;
    add({}, "The first pixel of each row is not drawn.", {}).skipped_left = 1;
    add({}, "The last row of the table is not drawn.", {}).skipped_rows_below = 1;
    add({}, "The first row of the table is not drawn.", {}).skipped_rows_above = 1;
    add({},
        "Row i of the table is drawn in row i of the picture, and not in the row that its y says.",
        {})
        .counts_rows_from_zero = true;
    for (const LineRule& line : mistaken_line_rules())
        add(line.bug, line.cause, line.settings).line = &line;
    return rules;
}

void say_first_pixel(const AskedRows& asked, const std::vector<PixelSet>& theirs,
                     FunctionCheck& check) {
    const DrawRule right;
    for (int i = 0; i < asked.count(); ++i) {
        const PixelSet ours = pixels_by(right, asked.question(i), asked.questions.program.viewport);
        const PixelSet& drawn = theirs[static_cast<std::size_t>(i)];
        if (ours == drawn) continue;
        FunctionDifference& difference = check.difference;
        difference.question = i;
        for (const auto& [row, column] : ours) {
            if (drawn.count({row, column}) == 0)
                difference.missing.push_back({double(column), double(row), {}});
        }
        for (const auto& [row, column] : drawn) {
            if (ours.count({row, column}) == 0)
                difference.too_many.push_back({double(column), double(row), {}});
        }
        const bool is_missing = !difference.missing.empty();
        const DrawnPixel& first = (is_missing ? difference.missing : difference.too_many).front();
        check.first = fmt::format("{}: {} pixels are missing and {} too many; {} is {}.",
                                  asked.question(i).name, difference.missing.size(),
                                  difference.too_many.size(), pixel_text(first.x, first.y),
                                  is_missing ? "not drawn" : "drawn");
        return;
    }
}

/// How the colour of a pixel follows from the ends of its row.
struct ColourRule {
    std::string_view words, cause;
    bool is_carried, is_divided, has_colour, stays_left;
};

constexpr ColourRule colour_rules[] = {
    {"the colour as it is given", {}, false, false, true, false},
    {"the light that the pixels carry", {}, true, false, false, false},
    {"the light that the pixels carry, times the colour", {}, true, false, true, false},
    {"the light that the pixels carry, divided by 1/z", {}, true, true, false, false},
    {"the light that the pixels carry, divided by 1/z, times the colour",
     {},
     true,
     true,
     true,
     false},
    {{}, "The light stays as it is at the left end of a row.", true, false, false, true},
    {{}, "The light stays as it is at the left end of a row.", true, false, true, true},
};

glm::dvec3 colour_by(const ColourRule& rule, const RowsQuestion& question, std::size_t row,
                     double column) {
    const glm::dvec3 colour(question.colour);
    if (!rule.is_carried) return colour;
    const PixelValues& left = question.left[row];
    const PixelValues& right = question.right[row];
    const double t = rule.stays_left ? 0.0 : (column - left.x) / std::max(right.x - left.x, 1.0);
    glm::dvec3 light;
    for (int c = 0; c < 3; ++c)
        light[c] = left.light[c] + t * (right.light[c] - left.light[c]);
    if (rule.is_divided) light /= left.zinv + t * (right.zinv - left.zinv);
    return rule.has_colour ? light * colour : light;
}

bool is_same_drawn_colour(const glm::dvec3& theirs, const glm::dvec3& ours) {
    for (int c = 0; c < 3; ++c) {
        const double tolerance = 1e-4 * (std::abs(ours[c]) + 1e-3);
        if (!is_close(theirs[c], ours[c], tolerance) &&
            !is_close(theirs[c], std::min(ours[c], 1.0), tolerance))
            return false;
    }
    return true;
}

bool colours_question(const ColourRule& rule, int index, const AskedRows& asked) {
    const RowsQuestion& question = asked.question(index);
    std::map<double, std::size_t> row_of;
    for (std::size_t r = 0; r < question.left.size(); ++r)
        row_of.emplace(question.left[r].y, r);
    for (const DrawnPixel& pixel : asked.answers[static_cast<std::size_t>(index)].pixels) {
        const auto found = row_of.find(pixel.y);
        if (found == row_of.end()) continue;
        if (!is_same_drawn_colour(pixel.colour, colour_by(rule, question, found->second, pixel.x)))
            return false;
    }
    return true;
}

int count_coloured(const ColourRule& rule, const AskedRows& asked) {
    int coloured = 0;
    for (int i = 0; i < asked.count(); ++i)
        coloured += colours_question(rule, i, asked) ? 1 : 0;
    return coloured;
}

void check_drawn_colours(const AskedRows& asked, FunctionCheck& check) {
    int most = 0; // with the right rule that comes closest
    for (const ColourRule& rule : colour_rules) {
        const int coloured = count_coloured(rule, asked);
        if (rule.cause.empty()) most = std::max(most, coloured);
        if (coloured < asked.count()) continue;
        if (rule.cause.empty()) {
            check.rule += fmt::format("; drawn in {}", rule.words);
            return;
        }
        set_wrong(check);
        check.right = most;
        add_once(rule.cause, check.causes);
        check.first = "The colours of a row do not change from its left to its right end.";
        return;
    }
    check.notes.emplace_back("Its colours were not judged here, because light per pixel needs the "
                             "normal of the triangle; see PixelShader.");
}

} // namespace

FunctionCheck check_draw_rows(const Questions& questions, const Answers& answers) {
    FunctionCheck check =
        begin_check("DrawPolygonRows", rasterwalk_kit::part_draw_rows, questions, answers.rows);
    if (!has_answers(check)) return check;
    const AskedRows asked{questions, answers.rows.answers};
    if (check.state == CheckState::died && answers.rows.answers.size() < questions.rows.size())
        check.first = fmt::format("The program ended at {}.", asked.question(asked.count()).name);
    if (asked.count() == 0) return check;
    std::vector<PixelSet> theirs;
    std::size_t put = 0;
    for (const PutList& drawn : asked.answers) {
        theirs.push_back(pixels_of(drawn, questions.program.viewport));
        put += drawn.pixels.size();
    }
    if (put == 0) {
        if (check.state == CheckState::right) {
            check.state = CheckState::not_written;
            check.notes.emplace_back("Nothing is drawn.");
        }
        return check;
    }
    for (const DrawRule& rule : make_right_draw_rules()) {
        if (!draws_all(rule, asked, theirs)) continue;
        check.rule = rule.words;
        check.rules = rule.settings;
        check.right = asked.count();
        check_drawn_colours(asked, check);
        return check;
    }
    const DrawRule right;
    for (int i = 0; i < asked.count(); ++i)
        check.right += draws_question(right, i, asked, theirs) ? 1 : 0;
    for (const DrawRule& rule : make_mistaken_draw_rules()) {
        if (!draws_all(rule, asked, theirs)) continue;
        if (!rule.bug.empty()) add_once(rule.bug, check.bugs);
        if (!rule.cause.empty()) add_once(rule.cause, check.causes);
        check.rules = rule.settings;
    }
    set_wrong(check);
    say_first_pixel(asked, theirs, check);
    return check;
}

} // namespace rasterwalk
