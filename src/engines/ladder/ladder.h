#pragma once

// The ladder: from the loop of the lab as a student writes it to the fast engine, one change at a
// time. Each rung is a short file that can be read next to the one before.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engines/picture_agreement.h"
#include "engines/timed_engine.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// One rung: the same picture as the rung before, drawn faster by one change.
struct Rung {
    std::string_view name;   ///< for commands and tests: "kept_vectors"
    std::string_view title;  ///< "Vectors that stay"
    std::string_view change; ///< what changed, one sentence
    std::string_view why;    ///< why that helped, or why it did not, one sentence
    std::string_view file;   ///< below src/engines/ladder: "kept_vectors.cpp"
    /// The one rung that changes the rule of coverage: the pixels that differ are counted. They are
    /// on outlines, or where light changes so quickly that half a pixel shows: it is now that of
    /// the pixel's centre.
    bool has_other_edges = false;
    int threads = 1;
    /// The rung that it is compared with; empty: the one before it on the ladder.
    std::string_view against{};
    /// May its picture differ from one run to the next?
    bool is_random = false;
    /// An engine that draws the scene, which must outlive it. ladder_refuses() must not name the
    /// scene.
    std::unique_ptr<TimedEngine> (*make)(const Scene& scene, const Settings& settings) = nullptr;
};

/// From the lab's loop to the fast engine.
std::span<const Rung> ladder();

/// Changes that make it slower, or wrong; each is compared with a rung of the ladder.
std::span<const Rung> wrong_turnings();

/// How many both lists have together.
std::size_t rung_count();

/// A rung by its place: those of ladder() come first, then those of wrong_turnings().
/// @param place below rung_count()
const Rung& rung_at(std::size_t place);

/// The place of the rung that this one is compared with; for the first, its own.
/// @param place below rung_count()
std::size_t rung_before(std::size_t place);

/// The rung or wrong turning of that name; null: there is none.
const Rung* find_rung(std::string_view name);

/// Threads that rungs with more than one draw with: as many as Rung::threads, or 1 where a program
/// has no threads, as in a browser.
int ladder_threads();

/// Corners are drawn up to this many pixels from the picture's corner, either sign.
inline constexpr float ladder_guard = 8192.0f;

/// The most pixels in the boxes around all triangles together. The lab's loop walks through half of
/// them, in the picture or not.
inline constexpr double most_ladder_pixels = 2e7;

/// The most pixels of a picture, as each rung keeps its own: 8 bytes for each pixel.
inline constexpr std::int64_t most_ladder_picture = 4'000'000;

/// How many times each rung is measured if nothing else is asked for.
inline constexpr int usual_ladder_rounds = 15;

/// Why the rungs cannot draw this: a sentence, without the full stop; empty if they can.
std::string ladder_refuses(const Scene& scene, const Settings& settings);

/// A rung, measured.
struct RungTime {
    /// Of one picture in each round: processor time of the thread, or elapsed time if the rung has
    /// more than one.
    std::vector<double> milliseconds;
    double median = 0.0; ///< of them; 0: none yet
    /// From the rung it is compared with; of the lab's loop: none, as no picture is before it.
    /// Without pixels before it is compared.
    PictureDifference from_previous;
};

/// Measures all rungs and wrong turnings in turn, a picture at a time, so that anything else the
/// machine does affects all of them. Before the first round each draws a picture that is compared
/// and not timed.
class LadderWork {
  public:
    /// Starts again. Throws UsageError with ladder_refuses().
    /// @param rounds at least 1
    void begin(std::shared_ptr<const Scene> scene, const Settings& settings, int rounds);

    /// Draws one picture of one rung; nothing if it is done.
    void advance();

    bool is_done() const { return step_ == step_count(); }
    /// Rounds that all have finished.
    int rounds_done() const;
    /// Done, 0 to 1; 1 before begin().
    float share() const;
    /// One of each rung_at().
    const std::vector<RungTime>& times() const { return times_; }

  private:
    int step_count() const;
    void compare(std::size_t place);

    std::shared_ptr<const Scene> scene_; ///< null before begin()
    Settings settings_;
    int rounds_ = 0;
    int step_ = 0;                                      ///< pictures that are drawn
    std::vector<std::unique_ptr<TimedEngine>> engines_; ///< those that were needed so far
    std::vector<EnginePicture> pictures_;               ///< one each, until they are compared
    std::vector<RungTime> times_;
};

} // namespace rasterwalk
