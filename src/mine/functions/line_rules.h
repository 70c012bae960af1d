#pragma once

// The ways to walk a line: those that are equally right, and the mistakes. Each is a table of
// stages in which Interpolate or the line algorithm has another function.

#include <cstdint>
#include <string>
#include <vector>

#include "mine/functions/function_checks.h"
#include "stages/stage_table.h"

namespace rasterwalk {

/// From which end an edge is walked.
enum class EdgeOrder : std::uint8_t {
    as_given,
    down,       ///< from its upper end to its lower end
    left_first, ///< from its left end to its right end
};

/// A way to walk a line.
struct LineRule {
    std::string words;     ///< "each step is added to the previous sample, and int() cuts"
    RuleSettings settings; ///< the nearest that the settings can say
    Stages stages;         ///< with the functions of the walk
    Rounding rounding = Rounding::truncate;
    bool needs_full_count = false; ///< made for max(|dx|, |dy|) + 1 samples and no other number
    std::string bug;               ///< id of the laboratory; empty: it is right, or `cause` tells
    std::string cause;             ///< a sentence, for a mistake that the laboratory lacks
};

/// Those that are equally right; the lab's is first.
const std::vector<LineRule>& right_line_rules();

/// Those that are mistakes, each with each way to round.
const std::vector<LineRule>& mistaken_line_rules();

/// The same walk from another end.
Stages with_edge_order(const Stages& stages, EdgeOrder order);

/// The samples of a line by this rule, `count` of them, both ends included.
std::vector<LineSample> samples_by(const LineRule& rule, const LineEnd& a, const LineEnd& b,
                                   int count);

/// What is asked, as the end of a line.
LineEnd to_line_end(const rasterwalk_kit::PixelValues& values);
/// And as a vertex of a polygon. Positions must be whole numbers.
ScreenVertex to_screen_vertex(const rasterwalk_kit::PixelValues& values);

} // namespace rasterwalk
