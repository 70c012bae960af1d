#pragma once

// The float microscope: what the floats of an edge's walk do, next to what fractions would do.
//
// An edge is walked in float: each sample adds a step that is usually not the exact fraction to
// begin with. The microscope shows the walked value next to the exact one, and both next to the
// same edge walked the other way. If a line decides step by step, it keeps the decisions too.

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/frame.h"
#include "stages/stage_table.h"

namespace rasterwalk {

/// A fraction in lowest terms; the denominator is at least 1.
struct Fraction {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;

    double value() const {
        return static_cast<double>(numerator) / static_cast<double>(denominator);
    }
    friend bool operator==(const Fraction&, const Fraction&) = default;
};

/// The fraction in lowest terms; the denominator must be above 0.
Fraction reduced(std::int64_t numerator, std::int64_t denominator);

/// One coordinate of a sample, x or y.
struct MicroscopeCoordinate {
    float walked = 0.0f; ///< in the walk, before rounding, pixels
    Fraction exact;      ///< where the sample would be without any error, pixels
    double drift = 0.0;  ///< walked - exact, pixels
    int pixel = 0;       ///< column or row of the walked value
    int exact_pixel = 0; ///< column or row of the exact position, rounded by the same rule; if two
                         ///< are equally near, a line that decides may take either
    int reverse_pixel = 0; ///< of the walk from b to a, at the sample that should be at this place

    bool differs_from_exact() const { return pixel != exact_pixel; }
    bool differs_from_reverse() const { return pixel != reverse_pixel; }
};

/// One sample of an edge under the microscope.
struct MicroscopeSample {
    int sample = 0; ///< of the edge from a to b, counts from 0
    MicroscopeCoordinate x, y;

    bool differs_from_exact() const { return x.differs_from_exact() || y.differs_from_exact(); }
    bool differs_from_reverse() const {
        return x.differs_from_reverse() || y.differs_from_reverse();
    }
};

/// All samples of an edge in numbers.
struct MicroscopeSummary {
    double largest_drift_x = 0.0, largest_drift_y = 0.0; ///< with their signs, pixels
    int largest_drift_x_at = 0, largest_drift_y_at = 0;  ///< the first samples that have them
    int differ_from_reverse = 0;   ///< samples on a different pixel from the other way's
    double largest_decision = 0.0; ///< farthest from 0, with its sign; 0 if nothing is decided
    bool misses_end = false;       ///< the last sample is not on the pixel of the end point
};

/// An edge under the microscope. Holds the results of the walks; works out the rest on demand.
struct EdgeMicroscope {
    ScreenVertex a, b; ///< the two ends
    EdgeRules rules;
    Stages stages;           ///< whose walk it is
    int count = 0;           ///< samples, both ends included
    Fraction step_x, step_y; ///< from one sample to the next, without any error
    float float_step_x = 0.0f, float_step_y = 0.0f; ///< the same in float, as in the walk
    MicroscopeSummary summary;

    struct Place {
        float x = 0.0f, y = 0.0f; ///< before rounding, pixels
        int column = 0, row = 0;
    };
    std::vector<Place> forward;          ///< of each sample from a to b
    std::vector<Place> reverse;          ///< of each sample from b to a
    std::vector<LineDecision> decisions; ///< of each sample from a to b; empty for Interpolate
    LineFrame frame;                     ///< the two axes, for the formulas of the decisions
    std::vector<int> differing;          ///< samples on a different pixel from their exact position

    /// Is this the edge that was put under the microscope?
    bool shows(const ScreenVertex& from, const ScreenVertex& to, const EdgeRules& by,
               const Stages& with) const;

    /// Does a decision variable determine where the line goes? Interpolate has none.
    bool decides() const { return !decisions.empty(); }

    /// Is there a decision variable besides the positions? The DDA decides by the position itself.
    bool has_decision_variable() const { return decides() && stages.line != line_by_dda; }

    /// The sample of the other way that should be at the place of this one. If the two ways have
    /// different numbers of samples, the nearest one.
    int opposite(int sample) const;

    /// One sample, 0 <= sample < count.
    MicroscopeSample at(int sample) const;

    /// The first differing sample at or after `sample`, then from the beginning; -1: there is none.
    int next_difference(int sample) const;
};

/// Puts the edge from a to b under the microscope: listens to the coverage stage, which gets the
/// polygon of these two vertices, and walks there and back.
EdgeMicroscope microscope(const ScreenVertex& a, const ScreenVertex& b, const EdgeRules& rules,
                          const Stages& stages);

/// Puts an edge of a drawn triangle under the microscope, unless `shown` is that edge already.
/// @param edge of the polygon that is drawn, from vertex `edge` to the next
void look_at(EdgeMicroscope& shown, const Frame& frame, int triangle, int edge);

/// "5189/104"; a whole number without its denominator. With an ASCII minus.
std::string to_text(const Fraction& fraction);

} // namespace rasterwalk
