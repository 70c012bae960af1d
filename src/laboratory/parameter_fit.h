#pragma once

// The numbers that a program chooses freely, found from its picture: where the lamp is and how
// bright, where the camera stands and how it looks. Levenberg's and Marquardt's damped least
// squares (Marquardt 1963) from several starts, with derivatives by differences; what differs by
// far counts for little (Huber 1964), so that a mistake elsewhere does not lead astray.

#include <array>
#include <cstdint>
#include <vector>

#include "base/image.h"
#include "pipeline/frame_drawing.h"
#include "scene/scene.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Which numbers are found.
enum class FitSubject : std::uint8_t {
    lamp,   ///< position, power of each channel and indirect light, from the colours as they are
    camera, ///< position, yaw and focal length, from hues: light does not change them
};

/// How much is spent on it.
enum class FitEffort : std::uint8_t {
    quick,    ///< of the lamp only, on a small picture: near enough to show which mistake it may be
    closer,   ///< as thorough, but only from numbers that are nearly right already
    thorough, ///< on a larger one, and rounded as a person would have chosen them
};

/// From where it begins.
struct FitStart {
    Settings settings; ///< all that is not found stays as it is here; the picture's size
    Settings usual;    ///< whose numbers are taken where they are hardly worse
};

/// One search, in parts.
class ParameterFit {
  public:
    /// Picture and scene must live as long.
    void begin(const Image& picture, const Scene& scene, const FitStart& start, FitSubject subject,
               FitEffort effort);

    /// Goes on.
    /// @param most about how much work that may be
    /// @return about how much it was
    double advance(double most);

    bool is_done() const { return phase_ == Phase::done; }

    /// The start with the numbers with which the picture comes nearest: those of the start where no
    /// others are clearly better.
    Settings found() const { return with(best_.place); }

  private:
    /// Of the lamp there are seven, of the camera five: the last two then stay 0.
    static constexpr std::size_t most_numbers = 7;
    using Numbers = std::array<double, most_numbers>;

    enum class Phase : std::uint8_t { scan, approach, slopes, step, rounding, done };

    /// The picture as it is compared with what is drawn, in a smaller size.
    struct Sight {
        Viewport size{};
        int shrunk = 1;             ///< pixels of the picture for one of these, each way
        std::vector<float> colours; ///< three a pixel; see values_of()
    };
    /// Numbers that were tried.
    struct Probe {
        Numbers place{};
        std::uint32_t free = 0; ///< a bit for each number that is changed on the way
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
    Numbers reach_{}; ///< how far from its start each number of the camera is looked for
    Numbers steps_{}; ///< by which each number is changed to see what it does

    std::vector<Probe> probes_; ///< that are asked for, and drawn up to drawn_
    std::size_t drawn_ = 0;
    FrameDrawing drawing_;
    bool is_drawing_ = false;
    Image image_;

    std::vector<Probe> starts_;  ///< from which a descent is still to go
    std::size_t approached_ = 0; ///< starts that are as near as a coarse search brings them
    double stride_ = 0.0;        ///< of it, a part of what was scanned
    Probe from_;                 ///< of the descent
    std::array<std::array<double, most_numbers>, most_numbers> squares_{};
    Numbers slopes_{};
    double damping_ = 0.0;
    int steps_taken_ = 0, steps_refused_ = 0;
    bool is_white_ = false;   ///< the lamp's channels are equally strong
    bool is_larger_ = false;  ///< the sight, for the end of the search
    std::size_t rounded_ = 0; ///< numbers that are rounded, all together counting as one
    Probe best_;              ///< of the sight that is compared
};

} // namespace rasterwalk
