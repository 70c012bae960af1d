#pragma once

// What lessons can ask for by name: the one table of facts about the session
// and its results, and every setting under its own name.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "explain/fragment_report.h"
#include "explain/texture_report.h"
#include "facts/value.h"
#include "inspect/clip_history.h"
#include "inspect/coverage_comparison.h"
#include "inspect/edge_lines.h"
#include "inspect/pixel_tests.h"
#include "inspect/ray_stats.h"
#include "inspect/row_history.h"
#include "inspect/shadow_count.h"
#include "inspect/shared_edge.h"
#include "inspect/stats.h"
#include "pipeline/draw_cost.h"
#include "session/results.h"
#include "session/session.h"
#include "settings/setting_table.h"

namespace rasterwalk {

/// Affine compared with perspective-correct interpolation on one fragment.
struct InterpolationError {
    double light = 0.0;    ///< largest channel difference of the pixel shader's result, linear
    double position = 0.0; ///< world units
};

/// An edge that two triangles share, and how each fill rule draws it.
struct CountedEdge {
    SharedEdge shared;
    EdgeByRules rules;
};

/// Facts that take some work; kept as long as the frame stays.
struct FactCache {
    std::uint64_t frame_number = 0;
    std::optional<FrameStats> frame;
    std::optional<DrawCost> cost;
    std::optional<std::int64_t> prepass_shaded;
    std::optional<ClipHistory> clip; ///< of the triangle it names
    std::optional<int> outline_triangle;
    std::optional<CoverageComparison> outline;
    std::optional<int> shared_triangle;
    std::optional<glm::ivec2> shared_pixel;
    std::optional<CountedEdge> shared;
    std::optional<int> table_triangle;
    RowHistory table;
    std::optional<EdgeEnds> edge_ends;
    std::optional<std::int64_t> drawn_twice;
    std::optional<int> column;
    std::vector<int> column_owners; ///< of that column
    std::uint64_t samples_of = 0;   ///< the frame of run B with which the next two were counted
    std::optional<std::int64_t> different_samples;
    std::optional<int> different_triangle;
    std::vector<std::int64_t> different_edges; ///< of that triangle
    std::optional<Cursor> decision_at;
    std::optional<LineDecision> decision;
    std::optional<Cursor> error_at;
    std::optional<InterpolationError> error;
    std::optional<Cursor> fragment_at;
    std::optional<FragmentReport> fragment;
    std::optional<FrameShadows> shadows;
    std::optional<HiddenWay> hidden_way;
    std::optional<RayStats> rays;
    std::optional<Cursor> texture_at;
    std::optional<TextureReport> texture;
};

/// Answers questions about a session and its results; both must outlive it, and
/// the results must be up to date. Counts from 0, as everywhere.
class Facts {
  public:
    /// @param cache kept by the caller between uses, so that nothing is worked
    /// out twice; null: it
    ///              lives as long as this
    Facts(const Session& session, const Results& results, FactCache* cache = nullptr);

    /// The value of a fact or a setting; none if it is not there, or there is no
    /// such name.
    Value operator()(std::string_view name) const;

    // For the table of facts:
    const Session& session() const { return *session_; }
    const Results& results() const { return *results_; }
    /// The whole frame in numbers.
    const FrameStats& frame_stats() const;
    /// The work of the whole frame, stage by stage.
    const DrawCost& draw_cost() const;
    /// How many fragments of the frame get a colour after a depth pre-pass; none if that would
    /// change the picture.
    std::optional<std::int64_t> prepass_shaded() const;
    /// What clipping and culling do to the triangle shown; null without one.
    const ClipHistory* clip() const;
    /// The polygon of the scene that the triangle shown belongs to; null if there
    /// is none.
    const CoverageComparison* outline() const;
    /// The edge that the triangle shown shares with a neighbour, the nearest to
    /// the picked pixel; null if it shares none, or no fill rule is used.
    const CountedEdge* shared_edge() const;
    /// Whether the edges of the frame reach their ends.
    const EdgeEnds& edge_ends() const;
    /// How much of the frame's picture is in shadow.
    const FrameShadows& shadows() const;
    /// The frame's way to remove hidden surfaces, next to the depth buffer's; null if the scene is
    /// too large for it.
    const HiddenWay* hidden_way() const;
    /// What it takes to draw the frame by rays; null if they cannot draw it.
    const RayStats* rays() const;
    /// Pixels that two neighbours of the frame have both drawn.
    std::int64_t drawn_twice() const;
    /// The triangle that each pixel of the picked pixel's column finally shows,
    /// from the top; -1: none. A pixel must be picked.
    const std::vector<int>& column_owners() const;
    /// Is there a second run, and does it cut the scene into the same triangles?
    bool has_same_triangles_in_b() const;
    /// Edge samples on a different pixel in run B, for the whole frame and for an
    /// edge of the triangle shown; none without such a run, or without such an
    /// edge.
    std::optional<std::int64_t> different_samples() const;
    std::optional<std::int64_t> different_samples(int edge) const;
    /// What the line decides at the next edge sample; none if there is none, or
    /// it decides nothing.
    std::optional<LineDecision> decision() const;
    /// The results of edge functions for the pixel they test next; none if there
    /// is none.
    std::optional<PixelTest> pixel_test() const;
    /// The finished row table of the triangle shown; null if it has none.
    const RowHistory* table() const;
    /// The selected row in that table; none if no row is selected, or the table
    /// does not have it.
    std::optional<int> table_row() const;
    /// The fragment that the picked pixel finally shows; null if there is none.
    const PixelEntry* winner() const;
    /// The error of that fragment; none if it belongs to no row.
    std::optional<InterpolationError> interpolation_error() const;
    /// Everything about that fragment; null if there is none.
    const FragmentReport* fragment() const;
    /// The same if light is computed; otherwise null.
    const FragmentReport* light() const;
    /// What it took from its texture; null if it shows none.
    const TextureReport* texture() const;
    /// The selected vertex of the triangle shown; null if none is selected.
    const VertexReport* vertex() const;

  private:
    FactCache& cache() const;
    FactCache& cache_with_b() const;

    const Session* session_;
    const Results* results_;
    FactCache* cache_;
    mutable FactCache own_;
};

/// One fact: a name with a meaning.
struct Fact {
    std::string name; ///< `pixel.light_error`
    std::string help; ///< one sentence
    ValueRange range;
    Value (*read)(const Facts&, int number);
    int number = 0; ///< passed to `read` if facts are alike: which overlay, edge,
                    ///< component
};

/// Every fact, grouped by the part before the point.
std::span<const Fact> fact_table();

/// What a name stands for, fact, setting or formula; none if there is no such
/// name. Settings with several numbers have parts: `camera.position.z`,
/// `light.power.red`, `viewport.width`. A formula is named by its id after the
/// thing it belongs to: `pixel.pixel_light.cosine` of what the picked pixel
/// finally shows, `vertex.rotated.z` of the selected vertex,
/// `triangle.cull.area` of the triangle shown; see the reports of `explain` for
/// the ids. Whether it exists depends on the settings: it is a number, or none.
std::optional<ValueRange> find_name(std::string_view name);

/// Does a name stand for a formula, which may be there or not?
bool is_formula_name(std::string_view name);

/// The names of the formulas that are there now, but for those of clipping.
std::vector<std::string> formula_names(const Facts& facts);

/// A setting, or one part of it, as conditions name it.
struct SettingName {
    const Setting* setting = nullptr;
    int part = -1; ///< 0 to 2 for a vector, 0 or 1 for a size; -1: the setting itself
};

/// The setting behind a name; null if it stands for none.
SettingName find_setting_name(std::string_view name);

/// The name that is meant when one is compared with a word: another setting's
/// if the word has moved there, or the same.
std::string meant_name(std::string_view name, std::string_view word);

/// The names of all facts and settings: for messages.
std::vector<std::string> all_names();
/// Only the names of settings.
std::vector<std::string> all_setting_names();

} // namespace rasterwalk
