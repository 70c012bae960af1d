#pragma once

// Finds the numbers that a program chooses freely from its picture: the position and brightness of
// the lamp, the position and direction of the camera. Levenberg and Marquardt's damped least
// squares (Marquardt 1963) from several starts, with derivatives by differences; large differences
// count less (Huber 1964), so that a mistake elsewhere does not mislead the search.

#include <array>
#include <cstdint>
#include <vector>

#include "base/image.h"
#include "pipeline/frame_drawing.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Which numbers to find.
enum class FitSubject : std::uint8_t {
    lamp,   ///< position, power of each channel and indirect light, from the colours themselves
    camera, ///< position, yaw and focal length, from hues, which light does not change
};

/// How much work to spend.
enum class FitEffort : std::uint8_t {
    quick,    ///< only for the lamp, on a small picture: near enough to show likely mistakes
    closer,   ///< as thorough, but only from numbers that are nearly right already
    thorough, ///< on a larger picture, and rounded as a person would have chosen them
};

/// Where the search starts.
struct FitStart {
    Settings settings; ///< all else stays as it is here; the picture's size
    Settings usual;    ///< its numbers are taken if they are hardly worse
};

/// One search, in parts.
class ParameterFit {
  public:
    /// Picture and scene must outlive this.
    void begin(const Image& picture, const Scene& scene, const FitStart& start, FitSubject subject,
               FitEffort effort);

    /// Continues the search.
    /// @param most roughly the most work to do
    /// @return roughly the work done
    double advance(double most);

    bool is_done() const { return phase_ == Phase::done; }

    /// The start with the numbers that bring the picture nearest, or its own if no others are
    /// clearly better.
    Settings found() const { return with(best_.place); }

  private:
    /// The lamp has seven, the camera five, and its last two stay 0.
    static constexpr std::size_t most_numbers = 7;
    using Numbers = std::array<double, most_numbers>;

    enum class Phase : std::uint8_t { scan, approach, slopes, step, rounding, done };

    /// The picture in a smaller size, to compare with what is drawn.
    struct Sight {
        Viewport size{};
        int shrunk = 1;             ///< pixels of the picture per pixel of this, each way
        std::vector<float> colours; ///< three per pixel; see values_of()
    };
    /// Numbers that were tried.
    struct Probe {
        Numbers place{};
        std::uint32_t free = 0; ///< a bit for each number that may change
        double cost = 0.0;
        std::vector<float> colours{};
    };

    std::size_t number_count() const { return subject_ == FitSubject::lamp ? 7 : 5; }
    Settings with(const Numbers& numbers) const;
    Settings in_sight(const Numbers& numbers) const;
    Numbers numbers_of(const Settings& settings) const;
    Sight make_sight(int largest_side) const;
    std::vector<float> values_of(const Image& image) const;
    double cost_of(const std::vector<float>& colours) const;
    /// A difference of a channel above this, steps of 255, counts by its size and not by its
    /// square.
    static constexpr double far_apart = 20.0;
    /// The cost of a difference. A byte may be cut or rounded, so one step is not a difference.
    static double huber(double difference);
    void begin_scan();
    void end_scan();
    Numbers moved(Numbers numbers, std::size_t which, double part) const;
    void approach();
    void take_approach();
    void begin_descent();
    bool is_free(std::size_t number) const { return (from_.free >> number & 1u) != 0; }
    void begin_slopes(const Probe& from);
    void take_slopes();
    void solve_step();
    void take_step();
    void end_descent();
    void begin_rounding();
    void take_rounding();
    void next();

    const Image* picture_ = nullptr;
    const Scene* scene_ = nullptr;
    Settings start_;
    Numbers usual_{};
    FitSubject subject_ = FitSubject::lamp;
    FitEffort effort_ = FitEffort::quick;
    Phase phase_ = Phase::done;
    Sight sight_;
    Numbers reach_{}; ///< how far from its start to look for each number of the camera
    Numbers steps_{}; ///< the change of each number for its derivative

    std::vector<Probe> probes_; ///< requested, and drawn up to drawn_
    std::size_t drawn_ = 0;
    FrameDrawing drawing_;
    bool is_drawing_ = false;
    Image image_;

    std::vector<Probe> starts_;  ///< of descents still to do
    std::size_t approached_ = 0; ///< starts that the coarse search has finished
    double stride_ = 0.0;        ///< of that search, a part of what was scanned
    Probe from_;                 ///< where the descent is
    std::array<std::array<double, most_numbers>, most_numbers> squares_{};
    Numbers slopes_{};
    double damping_ = 0.0;
    int steps_taken_ = 0, steps_refused_ = 0;
    bool is_white_ = false;   ///< the lamp's channels are equally strong
    bool is_larger_ = false;  ///< the sight, for the end of the search
    std::size_t rounded_ = 0; ///< rounded numbers; all together count as one
    Probe best_;              ///< for the sight in use
};

} // namespace rasterwalk
