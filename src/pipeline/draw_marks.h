#pragma once

// Marks: what stages without fragments put into the picture, in one colour and without a depth.

#include "pipeline/drawing.h"

namespace rasterwalk {

/// Stage `points`: the three vertices of a drawn triangle, before it is clipped. They are reported
/// to an observer in every stage, even for a triangle that is not drawn.
void show_vertices(Drawing& d, int triangle);

/// Listens to the coverage of one triangle: shows the samples of its edges, and reports them to the
/// observer.
class EdgeDrawing : public SampleSink {
  public:
    EdgeDrawing(Drawing& drawing, int triangle);

    /// Are samples shown or observed, and does one lie in the window?
    bool is_wanted() const;

    void edge_sample(const EdgeSample& sample) override;

  private:
    Drawing& d_;
    int triangle_;
    bool shown_, watched_;
};

/// Stage `rows`: both ends of each row of the drawing's table, the left one first.
void show_row_ends(Drawing& d, int triangle);

} // namespace rasterwalk
