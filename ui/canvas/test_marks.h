#pragma once

#include <span>
#include <utility>

#include <glm/vec2.hpp>
#include <imgui.h>

namespace rasterwalk {

struct Marks;
struct Ui;

/// What edge functions have done on the picture so far for the triangle shown: while they test it,
/// and where their numbers are in the cells, the pixels found inside and outside are tinted. Costs
/// what is visible.
void draw_tested_pixels(const Marks& m);

/// The box whose pixels are tested, and along each edge a band on its inner side.
void draw_tested_box(const Marks& m);

/// Are the tests marked on the picture, so that their colours are explained?
bool shows_tests(const Ui& ui);

/// The edge functions of a tested pixel, or the weights of the corners there, one below another in
/// the edges' colours. All three if the pixel lies inside; if it lies outside, only those that keep
/// it out. A 0 that is kept is filled, one that is given away is framed.
/// @param low   the cell's upper left corner
/// @param lines that lie on the cells and make room for the numbers
void draw_test_numbers(const Marks& m, glm::ivec2 pixel, ImVec2 low,
                       std::span<const std::pair<ImVec2, ImVec2>> lines);

/// The width of a cell that has room for them, screen pixels.
float test_numbers_zoom(const Ui& ui);

/// How strongly pixels found inside and outside are tinted, 0..1, so that numbers can be read on
/// them.
inline constexpr float inside_tint = 0.3f, outside_tint = 0.18f;

} // namespace rasterwalk
