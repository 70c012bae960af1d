#pragma once

// Where two runs of one scene diverge: the moments at which run A does something different from run
// B.
//
// The visible effects of a run are compared: vertices with their pixel, 1/z and light; what each
// edge passes on at each clipping plane; culled triangles; edge samples with their pixel and
// whether they fall in the row table; fragments and marks with their pixel, fate, depth and colour.
// Row ends are compared through the samples that make them and the fragments between them. How
// varyings are carried (q or q/z) is a way to calculate, not a difference.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/cursor.h"
#include "pipeline/event_source.h"

namespace rasterwalk {

/// How two runs differ at a moment.
enum class DivergenceKind : std::uint8_t {
    missing, ///< A does something there, B does nothing
    extra,   ///< B does something there, A does nothing
    other,   ///< both do something, but with different results
};

/// "missing from B", "extra in B" or "different value".
std::string kind_text(DivergenceKind kind);

/// One moment at which the runs differ.
struct Divergence {
    Cursor cursor; ///< the piece of work that differs; holds triangle and phase
    DivergenceKind kind = DivergenceKind::other;
    bool only_rounding = false; ///< just numbers differ, by no more than rounding errors
    std::string text;           ///< the cause in words and numbers; A first, then B
};

/// All divergences of one triangle, phase and kind.
struct DivergenceGroup {
    int triangle = 0;
    Phase phase = Phase::vertices;
    DivergenceKind kind = DivergenceKind::other;
    std::int64_t count = 0; ///< moments
    Cursor first, last;

    friend bool operator==(const DivergenceGroup&, const DivergenceGroup&) = default;
};

/// All divergences of two runs.
struct DivergenceList {
    std::int64_t count = 0;          ///< moments at which they differ
    std::optional<Divergence> first; ///< none: the runs do the same
    std::optional<Divergence>
        first_beyond_rounding;           ///< the first that is more than a rounding error
    std::vector<DivergenceGroup> groups; ///< by triangle, then phase, then kind
};

class RunWalk;

/// Collects the divergences of two runs, part by part of a walk through both.
class DivergenceCollector {
  public:
    /// Walks one part further, and adds its findings to the list; the groups of a triangle once its
    /// last part is done.
    void walk_part(const Frame& a, const Frame& b, RunWalk& walk, DivergenceList& list);

  private:
    /// The divergences of one triangle by phase and kind.
    using TriangleGroups = std::array<std::array<DivergenceGroup, 3>, phase_count>;

    void add(const Cursor& cursor, DivergenceKind kind);
    void end_triangle(DivergenceList& list);

    TriangleGroups groups_;
};

/// The divergence at this very moment, if there is one. The pictures are those of both runs with
/// everything before it drawn. Costs no more than walking the triangle's edges.
/// @param scratch room for what the moment draws; kept by the caller to save allocations
std::optional<Divergence> divergence_at(const Frame& a, const Framebuffer& picture_a,
                                        const Frame& b, const Framebuffer& picture_b,
                                        const Cursor& cursor, Framebuffer& scratch);

/// The first divergence at or after `from`; none if there is none. Costs playing both runs up to
/// there.
std::optional<Divergence> next_divergence(const EventSource& a, const EventSource& b,
                                          const Cursor& from);

/// The last divergence before `to`; none if there is none.
std::optional<Divergence> previous_divergence(const EventSource& a, const EventSource& b,
                                              const Cursor& to);

} // namespace rasterwalk
