#pragma once

// The overlay of vectors on the picture, and how its lines look in both views.

#include <vector>

#include <imgui.h>

#include "explain/vectors.h"
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

/// An arrow; one that points at the eye, or away from it, is a dot.
void draw_vector(const VectorPen& pen, VectorName name, ImVec2 from, ImVec2 to);
/// The shadow of v on u, which is thicker than u.
void draw_shadow(const VectorPen& pen, ImVec2 from, ImVec2 to);
/// The perpendicular that ends the shadow, with its sign.
void draw_dropped(const VectorPen& pen, ImVec2 from, ImVec2 to);
/// One of the other two sides of the parallelogram.
void draw_opposite(const VectorPen& pen, ImVec2 from, ImVec2 to);

/// Draws the overlay on the picture of run A, if it is shown.
/// @param labels names that are there already; those of the vectors are added
void draw_vector_marks(const Ui& ui, ImDrawList* list, ImVec2 low, ImVec2 high,
                       std::vector<CanvasLabel>& labels);

} // namespace rasterwalk
