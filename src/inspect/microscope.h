#pragma once

// The float microscope: what the floats of an edge's walk do, beside what the fractions would.
//
// An edge is walked in float: each sample adds a step that is, as a rule, already not the exact
// fraction. The microscope puts the walked value beside the exact one, and the same edge walked the
// other way beside both. Of a line that decides step by step it keeps the decisions too.

#include <cstdint>
#include <string>
#include <vector>

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
    float walked = 0.0f;   ///< as the walk has it, before rounding, pixels
    Fraction exact;        ///< where the sample would be without any error, pixels
    double drift = 0.0;    ///< walked - exact, pixels
    int pixel = 0;         ///< column or row of the walked value
    int exact_pixel = 0;   ///< column or row of the exact place, rounded by the same rule; of two
                           ///< that are equally near a line that decides may take either
    int reverse_pixel = 0; ///< of the walk from b to a, at the sample that should be in this place

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

/// What there is to say about all samples of an edge.
struct MicroscopeSummary {
    double largest_drift_x = 0.0, largest_drift_y = 0.0; ///< with their signs, pixels
    int largest_drift_x_at = 0, largest_drift_y_at = 0;  ///< the first samples that have them
    int differ_from_reverse = 0;   ///< samples that fall on another pixel than the other way's
    double largest_decision = 0.0; ///< farthest from 0, with its sign; 0 where nothing is decided
    bool misses_end = false;       ///< the last sample is not on the pixel of the end point
};

/// An edge under the microscope. Holds what has to be walked for; works out the rest when asked.
struct EdgeMicroscope {
    ScreenVertex a, b; ///< the two ends
    EdgeRules rules;
    Stages stages;           ///< whose walk it is
    int count = 0;           ///< samples, both ends included
    Fraction step_x, step_y; ///< from one sample to the next, without any error
    float float_step_x = 0.0f, float_step_y = 0.0f; ///< the same in float, as the walk has it
    MicroscopeSummary summary;

    struct Place {
        float x = 0.0f, y = 0.0f; ///< before rounding, pixels
        int column = 0, row = 0;
    };
    std::vector<Place> forward;          ///< of each sample from a to b
    std::vector<Place> reverse;          ///< of each sample from b to a
    std::vector<LineDecision> decisions; ///< of each sample from a to b; empty for Interpolate
    LineFrame frame;                     ///< the two axes, for the formulas of the decisions
    std::vector<int> differing; ///< samples that fall on another pixel than their exact place

    /// Is this the edge that was put under the microscope?
    bool shows(const ScreenVertex& from, const ScreenVertex& to, const EdgeRules& by,
               const Stages& with) const;

    /// Does a decision variable say where the line goes? Interpolate has none.
    bool decides() const { return !decisions.empty(); }

    /// Is there a decision variable beside the places? The DDA decides by the place itself.
    bool has_decision_variable() const { return decides() && stages.line != line_by_dda; }

    /// The sample of the other way that should be in the place of this one. Where the two ways have
    /// different numbers of samples, the one that comes nearest.
    int opposite(int sample) const;

    /// One sample, 0 <= sample < count.
    MicroscopeSample at(int sample) const;

    /// The first differing sample from `sample` on, then from the beginning; -1: there is none.
    int next_difference(int sample) const;
};

/// Puts the edge from a to b under the microscope: listens to the coverage stage, which is given
/// the polygon of these two vertices, and walks there and back.
EdgeMicroscope microscope(const ScreenVertex& a, const ScreenVertex& b, const EdgeRules& rules,
                          const Stages& stages);

/// "5189/104"; a whole number without its denominator. With an ASCII minus.
std::string to_text(const Fraction& fraction);

} // namespace rasterwalk
