#pragma once

// The overlay of vectors on the picture, and how its lines look in both views.

#include <vector>

#include <imgui.h>

#include "explain/vectors.h"
#include "outside/outside_marks.h"
#include "ui/canvas/vertex_labels.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

struct Ui;

/// How long a direction of length 1 is drawn if it is seen face on, screen pixels: less where the
/// view is small.
/// @param u design pixel
float direction_length(ImVec2 room, float u);

/// The side of a right-angle sign, design pixels.
inline constexpr float right_angle_side = 10.0f;

/// How strongly the parallelogram is tinted, 0..1.
inline constexpr float span_tint = 0.09f;

/// The colour of a vector, for its arrow and its letter.
ImVec4 vector_colour(VectorName name, Theme theme);

/// What the lines are drawn with.
struct VectorPen {
    ImDrawList* list;
    float u; ///< design pixel
    Theme theme;
    ImU32 casing;
};

/// Draws a line of the overlay: an arrow, which is a dot if it points at the eye or away from it;
/// the shadow of v on u, which is thicker than u; the perpendicular; a side of the right angle or
/// of the parallelogram.
/// @param kind one of the overlay's; any other draws nothing
/// @param name of an arrow
/// @param from, to screen pixels
void draw_vector_line(const VectorPen& pen, OutsideLineKind kind, VectorName name, ImVec2 from,
                      ImVec2 to);

/// Draws the overlay on the picture of run A, if it is shown.
/// @param labels names that are there already; those of the vectors are added
void draw_vector_marks(const Ui& ui, ImDrawList* list, ImVec2 low, ImVec2 high,
                       std::vector<CanvasLabel>& labels);

} // namespace rasterwalk
