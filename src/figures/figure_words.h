#pragma once

// Values of attributes of figures: numbers, lists of them, paths, classes.

#include <string>
#include <string_view>
#include <vector>

#include "figures/figure.h"

namespace rasterwalk {

/// The number that a text is. Throws UsageError if it is none, or too large.
float figure_number(std::string_view text);

/// Numbers between blanks or commas.
std::vector<float> figure_numbers(std::string_view text);

/// A path: its commands, and the numbers of all of them.
struct FigurePath {
    std::string commands;
    std::vector<float> numbers;
};

/// Reads a path of the commands M, L, Q, C and Z, each with its letter. Throws UsageError.
FigurePath figure_path(std::string_view text);

/// How many places a command of a path has.
int places_of(char command);

/// Adds the classes between blanks to a look. Throws UsageError for one that does not exist.
/// @param is_of_group only what a group passes on is allowed
void add_figure_classes(std::string_view text, bool is_of_group, FigureLook& look);

/// What `data-drag` says, "SETTING FROM TO STEP"; the shape is not set. Throws UsageError.
FigureHandle figure_handle(std::string_view text);

/// The numbers in `translate(x, y)` or `translate(x)`. Throws UsageError for any other transform.
glm::vec2 figure_translation(std::string_view text);

/// Does a polygon of these corners, each x and y, turn to one side only? What is filled must.
bool is_convex(const std::vector<FigureNumber>& numbers);

} // namespace rasterwalk
