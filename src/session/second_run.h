#pragma once

// The second run: its settings for a comparison with the first, and how the two are shown.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_words.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

struct Session;
struct ProgramDrawing;

/// One way to draw a scene.
struct Run {
    Settings settings;
    /// The student's program that has drawn it, only of run B; null: our stages draw. Its settings
    /// are then those of the drawing. A view, a link or a lesson never has one.
    std::shared_ptr<const ProgramDrawing> program = nullptr;

    friend bool operator==(const Run&, const Run&) = default;
};

/// How the two pictures are shown.
enum class CompareView : std::uint8_t {
    run_a,      ///< A alone
    run_b,      ///< B alone
    difference, ///< B minus A
    side_by_side,
    wipe,  ///< A left of a divider, B right of it
    blink, ///< one after the other
};

inline constexpr int compare_view_count = static_cast<int>(enum_words<CompareView>.size());

/// The interface's words for a way to show them.
struct CompareViewInfo {
    CompareView view;
    std::string_view title;                ///< on the switch
    std::string_view menu_title;           ///< in the menu
    std::string_view help;                 ///< one sentence
    std::string_view name = word_of(view); ///< for tests and lessons
};

/// All of them, in the order of their switches; indexed by CompareView.
const std::array<CompareViewInfo, compare_view_count>& compare_view_list();

/// Both runs as they stood when mirror_changes_to_b() last looked.
struct RunPair {
    Run a, b;

    friend bool operator==(const RunPair&, const RunPair&) = default;
};

/// What a pair or a mistake has replaced, to be restored when the comparison ends.
struct ReplacedRun {
    Run before, after; ///< run A before it was begun, and just after
    std::shared_ptr<const Scene>
        before_scene; ///< if the scene was replaced, the original; null: it was not
    std::string bug;  ///< id of the mistake; empty: a pair

    friend bool operator==(const ReplacedRun&, const ReplacedRun&) = default;
};

/// From now on, compares run A with this run, or with a run that has these settings.
void compare_with(Session& session, const Run& b);
void compare_with(Session& session, const Settings& settings);

/// From now on, compares a student's program as run B with our picture of the same scene, under the
/// program's rules, as run A: at the end, on both sides of a divider unless a way to show both was
/// chosen. Ends a quiz and a comparison in progress first; end_comparison() restores scene and run.
/// @param drawing not null
void compare_with_program(Session& session, std::shared_ptr<const ProgramDrawing> drawing);

/// Back to one run; run A stays as it is.
void stop_comparing(Session& session);

/// Back to one run. Restores what a pair or a mistake replaced: the scene, and the values that it
/// set in run A, unless they have changed since.
void end_comparison(Session& session);

/// A becomes B and B becomes A. A student's program stays run B, which a notice says.
void swap_runs(Session& session);

/// A setting that has changed in A changes in B too if both had the same value before, so that
/// turning the camera turns both. Call it once per frame, before update(). If B has changed since
/// the last call, it is left alone. What a student's program has drawn does not change: as B it
/// keeps the settings of its drawing.
void mirror_changes_to_b(Session& session);

/// A setting in which two runs differ.
struct RunDifference {
    std::string_view setting; ///< by name
    std::string a, b;         ///< values as text
};

/// All of them, in the order of the table.
std::vector<RunDifference> run_differences(const Settings& a, const Settings& b);

/// Those of the session's two runs; none unless comparing.
std::vector<RunDifference> run_differences(const Session& session);

/// One of two ways of drawing.
struct PairMethod {
    std::string_view title;                 ///< "affine interpolation"
    std::string_view words;                 ///< what it does, a sentence
    std::span<const std::string_view> sets; ///< name=value
};

/// Two ways of drawing that are often compared: a button each.
struct ComparePair {
    std::string_view name; ///< for tests and links: `affine`
    PairMethod left, right;
    StripStep first_step, last_step; ///< steps in which the pair shows; from any other step, the
                                     ///< nearer of these is used
};

/// The pairs, in the order of their buttons.
std::span<const ComparePair> compare_pairs();

/// The way that run B uses: the right one, unless run A already has it.
const PairMethod& offer_of(const ComparePair& pair, const Settings& a);

/// Run B for this run A, which must be at a step in which the pair shows.
Settings offered_settings(const ComparePair& pair, const Settings& a);

/// These settings at the nearest step in which the pair shows.
Settings at_step_of(const ComparePair& pair, const Settings& settings);

/// The pair of which B has a way that A has not, if they differ in nothing else; null: none.
const ComparePair* pair_of_runs(const Session& session);

/// Compares run A, which changes only to a step in which the pair shows, with a run B that uses the
/// other way of the pair. Ends a comparison in progress first.
void start_pair(Session& session, const ComparePair& pair);

} // namespace rasterwalk
