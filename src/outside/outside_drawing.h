#pragma once

// The scene as seen by the eye outside, as a picture: its triangles at half their brightness, the
// one at work lit as far as it is drawn, and the picture of the moment on its pane.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/image.h"
#include "engines/fast/fast_shape.h"
#include "outside/eye_pane.h"
#include "outside/outline.h"
#include "outside/outside_eye.h"
#include "outside/sample_grid.h"
#include "outside/world_clipping.h"
#include "outside/world_triangle.h"
#include "pipeline/cursor.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"

namespace rasterwalk {

/// What is seen. All of it must outlive the update of the drawing.
struct OutsideSubject {
    std::shared_ptr<const Scene> scene; ///< of the frame, in world space
    const Frame& frame;
    std::uint64_t frame_number = 0; ///< changes whenever `frame` does
    Cursor cursor;
    std::optional<int> triangle; ///< at work, or selected
    const Image& picture;        ///< of the moment
    std::uint64_t picture_number = 0;
    const Framebuffer& framebuffer;   ///< that the picture was made from
    std::uint64_t picture_before = 0; ///< the picture with this number differs from it only in
    Rectangle picture_changed;        ///< these pixels; 0: not known
    WorldClipping clipping{};         ///< of the triangle
};

/// Its colours, 0..1.
struct OutsideStyle {
    glm::vec3 ground{0.04f};
    glm::vec3 line{0.5f};
    float drawn = 0.45f;                 ///< how much of its colour a drawn triangle has
    float coming = 0.15f;                ///< the same for one that is yet to come, or left out
    glm::vec3 cut_off{0.9f, 0.4f, 0.1f}; ///< what clipping takes of the triangle at work
    float cut_off_share = 0.25f;         ///< how much of that colour it has

    friend bool operator==(const OutsideStyle&, const OutsideStyle&) = default;
};

/// How it is seen.
struct OutsideLook {
    OutsideView view;
    glm::ivec2 size{1, 1}; ///< of the place it is shown in, screen pixels
    double margin = 0.0;   ///< around everything seen, screen pixels
    OutsideStyle style;

    friend bool operator==(const OutsideLook&, const OutsideLook&) = default;
};

/// What is under the pointer.
struct OutsidePick {
    std::optional<int> triangle;     ///< of the scene
    std::optional<glm::ivec2> pixel; ///< of the picture on its pane: column, row
};

/// Up to this many triangles, those yet to come are darker, and the whole scene is drawn in one
/// call unless its triangles are large.
inline constexpr int most_ordered = 5'000;

/// The most that one update draws, in units of some 4 ns: some 10 ms, plus the time to go through
/// the samples.
inline constexpr std::int64_t outside_work_at_once = 2'500'000;

class OutsideDrawing {
  public:
    /// Draws what has changed. If a scene is too much for one call, a part spread over all of it is
    /// drawn, and each further call draws more, as long as is_working().
    /// @return true if the image has changed
    bool update(const OutsideSubject& subject, const OutsideLook& look,
                std::int64_t work_at_once = outside_work_at_once);
    bool is_working() const { return !base_is_done_; }

    /// The picture; one of its pixels is pixel_size() screen pixels wide.
    const Image& image() const { return image_; }
    std::uint64_t number() const { return number_; } ///< changes with each image
    int pixel_size() const { return pixel_size_; }

    /// The eye, in screen pixels, and what it looks at.
    const OutsideEye& eye() const { return eye_; }
    const OutsideScene& outside_scene() const { return outside_scene_; }

    /// The thing at a point, screen pixels from the corner.
    OutsidePick at(glm::vec2 place) const;

  private:
    /// Determines where the triangles of the scene are seen.
    struct BaseKey {
        std::uint64_t frame_number = 0;
        OutsideLook look;

        friend bool operator==(const BaseKey&, const BaseKey&) = default;
    };
    /// Determines what is over them, and which of them are yet to come.
    struct MomentKey {
        Cursor cursor;
        std::optional<int> triangle;
        std::uint64_t picture_number = 0;

        friend bool operator==(const MomentKey&, const MomentKey&) = default;
    };

    void take_scene(const OutsideSubject& subject);
    void begin_base(const OutsideLook& look);
    void draw_base(const OutsideSubject& subject, const OutsideStyle& style,
                   std::int64_t work_at_once);
    std::vector<std::int32_t> next_triangles(std::int64_t work_at_once);
    void draw_outline(const OutsideStyle& style);
    class BasePainter;
    Rectangle box_of_triangle(std::optional<int> triangle) const;
    void colour_all(const OutsideSubject& subject, const OutsideStyle& style);
    Rectangle recolour(const OutsideSubject& subject, const OutsideStyle& style, int begun);
    Rectangle changed_by(const OutsideSubject& subject, const MomentKey& now,
                         const MomentKey& last) const;
    void compose(const OutsideSubject& subject, const OutsideStyle& style,
                 const Rectangle& samples);
    void find_triangle_at_work(std::optional<int> triangle);
    void draw_triangle_at_work(const OutsideSubject& subject, const OutsideStyle& style,
                               const Rectangle& samples);
    void shrink_picture(const OutsideSubject& subject, double samples_a_pixel);
    void draw_picture(const OutsideSubject& subject, const Rectangle& samples);
    void resolve(const Rectangle& samples);

    std::shared_ptr<const Scene> scene_; ///< all up to the box of the things belongs to it
    std::vector<OutlineEdge> outline_;
    std::vector<WorldTriangle> triangles_;
    std::optional<FastShape> shape_;
    OutsideScene outside_scene_;
    OutsideEye eye_;        ///< in screen pixels
    OutsideEye sample_eye_; ///< in samples
    std::optional<BaseKey> base_key_;
    std::optional<MomentKey> moment_key_;
    std::vector<std::uint32_t> colours_; ///< of all triangles, for those without texture
    FastPicture drawn_;                  ///< those that were drawn last
    SampleGrid base_;                    ///< the triangles of the scene
    SampleGrid grid_;                    ///< with what is over them
    /// The triangle at work alone, even where others are in front of it.
    struct AtWork {
        std::optional<int> triangle; ///< none: not found yet
        Rectangle box;               ///< of the samples that the picture shows
        FastPicture picture;
    } at_work_;
    bool base_is_done_ = true;
    int next_ = 0;          ///< how many triangles are drawn
    int begun_ = 0;         ///< those before it have the colour of drawn triangles
    std::int64_t work_ = 0; ///< on this base so far
    int samples_ = 1;       ///< across a pixel of the image
    int pixel_size_ = 1;
    DownsampledPicture shown_;
    std::uint64_t shown_number_ = 0; ///< of the picture it was made from; 0: none
    Image image_;
    std::uint64_t number_ = 0;
};

} // namespace rasterwalk
