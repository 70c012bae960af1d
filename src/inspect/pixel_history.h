#pragma once

// Everything that fell on one pixel: found by playing the frame again for just that pixel.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "inspect/uncovered.h"
#include "pipeline/cursor.h"
#include "pipeline/event_source.h"
#include "pipeline/work.h"

namespace rasterwalk {

/// One fragment that fell on the pixel. In stages before `fill` it is a mark: a vertex, an edge
/// sample or the end of a row; marks have no depth value.
struct PixelEntry {
    Cursor cursor;   ///< its piece of work; holds the triangle
    int row = -1;    ///< row of the triangle's row table, from 0; -1 for vertices and edge samples
    int column = -1; ///< from the left end of that row, from 0; -1 for vertices and edge samples
    float zinv = 0.0f;   ///< interpolated 1/z
    float z = 0.0f;      ///< how far in front of the camera
    float depth = 0.0f;  ///< its value for the depth buffer
    float stored = 0.0f; ///< the depth buffer's previous value
    float margin = 0.0f; ///< how much nearer than stored: above 0 it passes, if there is a test
    float margin_to_winner = 0.0f; ///< how much nearer than the entry that stays; 0 for that one
    Fate fate = Fate::written;
    float alpha = 1.0f; ///< how opaque it is, see FragmentAlpha
    float share = 0.0f; ///< of its colour in the final one, 0 to 1; also below 1 if it is
                        ///< half-transparent, or something half-transparent is over it
    glm::vec3 colour_before{0.0f};
    glm::vec3 colour_after{0.0f};
    // Of a pixel with several samples, as in FragmentEvent; else both are 0. Depths and colours are
    // those of one sample.
    SampleMask covered = 0;
    SampleMask passed = 0;
};

/// Some of the samples of a pixel as signs, in order: "●●○○" for the first two.
std::string sample_signs(SampleMask mask);

/// The history of a pixel over the whole frame.
struct PixelHistory {
    glm::ivec2 pixel{0, 0};          ///< column and row of the picture
    std::vector<PixelEntry> entries; ///< in the order of drawing
    int winner = -1;                 ///< the entry whose colour stays; -1: nothing was written. Of
                                     ///< several samples, the one that stays on most of them
    bool depth_tested = false;       ///< whether margins decided anything
    std::vector<TestEvent> tests;    ///< if edge functions test pixels: each test of this one
    std::optional<ResolveEvent> resolve; ///< if the pixel has several samples: what becomes of them
    std::vector<NearTriangle> nearest;   ///< if nothing fell here: what came nearest, or nearly
                                         ///< as near; see uncovered.h
};

/// The history of a pixel of the picture. Costs drawing the triangles whose box it lies in, and a
/// look at the others. The pixel must lie in the picture.
PixelHistory pixel_history(const EventSource& source, const glm::ivec2& pixel);

/// The same in parts.
class HistoryWork {
  public:
    /// The source's frame must outlive this.
    HistoryWork(EventSource source, const glm::ivec2& pixel);

    /// Goes on as far as the limit allows; always makes progress.
    void advance(const WorkLimit& limit = {});
    bool is_done() const { return is_done_; }

    /// How many triangles have been drawn into the pixel.
    int triangles_done() const { return drawn_; }

    const glm::ivec2& pixel() const { return history_.pixel; }

    /// The result; once is_done().
    PixelHistory take() { return std::move(history_); }

  private:
    void draw_part(int triangles);
    void find_winner();

    EventSource source_;
    const Frame* frame_;
    PixelHistory history_;
    int drawn_ = 0;                        ///< see triangles_done()
    std::optional<NearestSearch> nearest_; ///< once it is known that nothing fell there
    bool is_done_ = false;
};

} // namespace rasterwalk
