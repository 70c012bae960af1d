#pragma once

// Two runs of one scene, A and B, compared: how far apart their pictures are, and what else
// differs.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/image.h"
#include "compare/divergence.h"
#include "compare/picture_reasons.h"
#include "compare/run_walk.h"
#include "engines/engine_planes.h"
#include "engines/program_drawing.h"
#include "picture/view_image.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"
#include "pipeline/replay.h"
#include "pipeline/work.h"
#include "stages/polygon_rows.h"
#include "stages/rectangle.h"

namespace rasterwalk {

/// How far apart two pictures of the same size are. A pixel's difference is the largest of its
/// channels', in linear colour.
struct PixelDifference {
    std::int64_t pixels = 0;    ///< of the picture
    std::int64_t different = 0; ///< pixels whose colour is not the same to the last bit
    std::int64_t shown = 0;     ///< those whose 8 bits on the screen differ too
    float largest = 0.0f;
    double mean = 0.0;               ///< over all pixels of the picture
    std::optional<glm::ivec2> worst; ///< where the largest is, column and row; none: no difference

    friend bool operator==(const PixelDifference&, const PixelDifference&) = default;
};

/// Counts the differences; both framebuffers must have the same size.
PixelDifference pixel_difference(const Framebuffer& a, const Framebuffer& b);

/// The same some rows at a time, from the top.
class PixelCount {
  public:
    /// Goes on up to this row of the planes, which is not counted. Both framebuffers must be those
    /// of the earlier calls, unchanged.
    /// @param differs is called with column and row of each pixel that differs; may be null
    void count_to(const Framebuffer& a, const Framebuffer& b, int row,
                  const std::function<void(glm::ivec2)>& differs = {});

    /// How many rows have been counted.
    int rows() const { return rows_; }
    /// Their differences; the mean is over the whole picture.
    PixelDifference found() const;

  private:
    PixelDifference found_;
    double sum_ = 0.0;
    int rows_ = 0;
};

/// B minus A on every pixel, row by row from the top: for colour the channel that differs most, for
/// depth the buffer's values, for overdraw the fragments; for owners, 1 where they differ.
std::vector<float> signed_difference(const Framebuffer& a, const Framebuffer& b, View view);

/// The same for some pixels of the planes only, in values of all of them.
void update_signed_difference(const Framebuffer& a, const Framebuffer& b, View view,
                              const Rectangle& pixels, std::vector<float>& values);

/// The smallest of 1, 2 and 5 times a power of ten that is not below `value`: the end of the scale
/// of a difference picture. 1 for 0 and for values that are not finite.
float difference_limit(float value);

/// The colour of a signed difference on a scale from -limit to +limit: blue where B is less than A,
/// orange where it is more, black where they are the same.
glm::vec<3, std::uint8_t> difference_colour(float value, float limit);

/// The signed differences as a picture; values beyond the scale take the colour of its end.
Image difference_image(const std::vector<float>& values, Viewport size, float limit);

/// The same for some pixels only, in a picture of all of them.
void update_difference_image(const std::vector<float>& values, float limit, const Rectangle& pixels,
                             Image& image);

/// The work of counting a pixel, relative to a fragment.
inline constexpr double count_pixel_work = 0.5;

/// Drawing a moment or a row, reporting it and comparing it takes this many times the work of just
/// drawing it.
inline constexpr double compare_work_factor = 3.0;

/// Two runs compared over the whole frame, or up to a moment.
struct Comparison {
    PixelDifference pixels;
    std::int64_t different_rows = 0; ///< rows of row tables whose left or right end differs, or
                                     ///< that only one run has
    DivergenceList divergences;
    /// Why no moments were compared, a sentence; empty: they were. Then rows and divergences say
    /// nothing, and the reasons say why the pictures differ. With a student's program the only
    /// divergence is where the orders of the pixels part, and there are no reasons.
    std::string only_pictures;
    PictureReasons reasons;

    bool is_same() const {
        return pixels.different == 0 && different_rows == 0 && divergences.count == 0;
    }
};

/// Two runs being compared, part by part. Draws both in parallel and compares them moment by
/// moment, which takes a few times as long as drawing both frames, and the memory of two pictures.
/// If the runs divide the scene into different triangles, have several samples for each pixel, or
/// an engine without moments or a student's program draws one of them, only the pictures are
/// compared: no moment of one is a moment of the other.
class ComparisonWork {
  public:
    /// Starts over. The frames must be of the same scene, have viewports of the same size, and live
    /// until the work is done or restarted.
    /// @param program that has drawn B; null: none
    void begin(const Frame& a, const Frame& b, const Cursor& to = cursor_end,
               std::shared_ptr<const ProgramDrawing> program = nullptr);

    /// Goes on as far as the limit allows.
    void advance(const WorkLimit& limit = {});

    /// Is everything compared? Also true before anything was begun.
    bool is_done() const { return stage_ == ComparisonStage::done; }

    /// How many triangles have been compared, and how many there are.
    int triangles_done() const { return done_; }
    int triangles() const { return triangles_; }

    /// The result so far; the pixels are compared last.
    const Comparison& found() const { return found_; }

  private:
    /// The steps of the work, in order. For runs without a moment in common, pictures are drawn
    /// instead of cleared and walked through.
    enum class ComparisonStage : std::uint8_t { estimated, cleared, walked, drawn, counted, done };

    /// One of two pictures being drawn.
    struct PictureWork {
        /// Begins to draw everything before the moment.
        void begin(const Frame& frame, FrameWork& work, const Cursor& to);
        /// False: something is left.
        bool advance(const Frame& frame, FrameWork& work, const Cursor& to, const WorkLimit& limit);
        const Framebuffer& picture(const Cursor& to) {
            if (program != nullptr) return put.planes();
            return engine == Engine::steps ? steps.at(to) : planes.planes;
        }

        std::shared_ptr<const ProgramDrawing> program; ///< that has drawn it; null: none
        ProgramPlanes put;                             ///< its planes

        Engine engine = Engine::steps; ///< that draws it
        EnginePlanes planes;           ///< of another engine than the steps
        Replay steps{0};               ///< without copies of earlier moments
    };
    /// Both runs drawn in parallel.
    struct DrawnWalk {
        DrawnWalk(const Frame& in_a, const Frame& in_b, const Cursor& to, Framebuffer cleared_a,
                  Framebuffer cleared_b)
            : a(in_a, std::move(cleared_a)), b(in_b, std::move(cleared_b)),
              walk({in_a, a}, {in_b, b}, to) {}

        DrawnEvents a, b;
        RunWalk walk;
    };
    struct PicturePair {
        PictureWork a, b;
    };

    bool advance_stage(const WorkLimit& limit);
    bool estimate(const WorkLimit& limit);
    bool clear_pictures(const WorkLimit& limit);
    double missing_work() const;
    bool walk(const WorkLimit& limit);
    void end_triangles();
    bool draw_pictures(const WorkLimit& limit);
    bool count_pixels(const WorkLimit& limit);
    void end();

    const Frame* a_ = nullptr;
    const Frame* b_ = nullptr;
    Cursor to_;
    FrameWork work_a_, work_b_;
    ComparisonStage stage_ = ComparisonStage::done;
    Framebuffer cleared_a_, cleared_b_;     ///< what the walk will draw into
    std::unique_ptr<DrawnWalk> walk_;       ///< for the stages `walked` and `counted`
    std::unique_ptr<PicturePair> pictures_; ///< in its place if only those are compared
    DivergenceCollector divergences_;
    PolygonRows rows_a_, rows_b_; ///< kept to save allocations
    int done_ = 0, triangles_ = 0;
    PixelCount pixels_;
    Comparison found_;
};

/// Two runs compared in one call.
Comparison compare_runs(const Frame& a, const Frame& b, const Cursor& to = cursor_end);

} // namespace rasterwalk
