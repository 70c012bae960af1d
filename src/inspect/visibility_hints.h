#pragma once

// What the finished picture of a model shows, counted pixel by pixel, and which settings would show
// more of it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/frame.h"
#include "pipeline/frame_preparation.h"
#include "pipeline/framebuffer.h"
#include "pipeline/replay.h"
#include "pipeline/work.h"

namespace rasterwalk {

/// The pixels of a picture that show a surface.
struct VisiblePixels {
    std::int64_t surface = 0; ///< all of them
    std::int64_t backs = 0;   ///< of a triangle that faces away, see away_from_camera()
    std::int64_t lit = 0;     ///< those that are not black, see is_invisible()
    std::int64_t light = 0;   ///< the largest channels of all of them, in steps of 1/255

    friend bool operator==(const VisiblePixels&, const VisiblePixels&) = default;
};

/// Counts them in one pass over the owners and colours of a picture of this frame.
VisiblePixels count_visible(const Frame& frame, const Framebuffer& picture);

/// Larger pictures, and models of more triangles, get no hints: another framebuffer or frame of
/// that size, besides the one shown, takes too much memory.
inline constexpr std::size_t most_hinted_pixels = std::size_t{1} << 23;
inline constexpr int most_hinted_triangles = 1'000'000;

/// Something to say about a whole picture, and what helps. Two hints can be about the same thing,
/// with different help.
struct VisibilityHint {
    std::string finding;               ///< "Most of what you see is back faces, 90 of 100 pixels"
    std::string in_short;              ///< the same for tight spaces: "Back faces"
    std::string act;                   ///< what to do about it, on a button: "leave them out"
    std::vector<std::string> settings; ///< the ones that do it: name=value
    std::string help;                  ///< their names, and what they do: one sentence

    friend bool operator==(const VisibilityHint&, const VisibilityHint&) = default;
};

/// Looks for what there is to say about the whole picture of a model: that it shows mostly backs,
/// or that all of it is transparent or black. It names only settings that it has tried and counted,
/// which takes drawing the picture again, up to five times. It finds nothing if no setting helps,
/// nor in scenes that are not models, where such a picture is intended.
class VisibilityHintsWork {
  public:
    /// @param picture the finished picture of the frame; both must outlive this
    VisibilityHintsWork(const Frame& frame, const Framebuffer& picture);
    VisibilityHintsWork(const VisibilityHintsWork&) = delete; // its parts refer to each other
    VisibilityHintsWork& operator=(const VisibilityHintsWork&) = delete;

    /// Goes on as far as the limit allows. A picture that is more than `most` is not tried.
    void advance(const WorkLimit& limit = {});
    bool is_done() const { return is_done_; }

    /// The result; once is_done().
    std::vector<VisibilityHint> hints() const;

  private:
    /// Ways that may show more.
    enum class Remedy : std::uint8_t {
        opaque,
        without_backs,
        lit_from_both_sides,
        lamp_at_camera,
        without_images,
    };

    /// One of them, and what it would show.
    struct Try {
        Remedy remedy;
        std::vector<std::string> settings; ///< name=value
        VisiblePixels visible;
    };
    struct Count {
        int rows = 0; ///< of the picture counted so far
        VisiblePixels visible;
    };
    static bool count(const Frame& frame, const Framebuffer& picture, const WorkLimit& limit,
                      Count& count);
    void choose_tries();
    void begin_try();
    bool draw_try(const WorkLimit& limit);
    bool helps(const Try& tried) const;
    VisibilityHint hint_of(const Try& tried) const;
    bool are_backs() const { return 2 * now_.visible.backs > now_.visible.surface; }
    bool is_black() const { return now_.visible.lit == 0; }

    const Frame* frame_;
    const Framebuffer* picture_;
    Count now_;
    std::vector<Try> tries_;
    std::size_t done_ = 0; ///< of the tries, the number done
    Frame other_;          ///< of the current try, and the tools to draw it
    std::optional<FramePreparation> preparation_;
    FrameWork work_;
    Replay replay_{0};
    Count other_count_;
    bool is_begun_ = false, is_prepared_ = false; ///< the current try
    bool is_done_ = false;
};

/// All of it in one call.
std::vector<VisibilityHint> visibility_hints(const Frame& frame, const Framebuffer& picture);

} // namespace rasterwalk
