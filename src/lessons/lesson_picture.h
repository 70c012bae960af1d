#pragma once

#include <string>
#include <string_view>

#include "base/image.h"
#include "figures/figure.h"

namespace rasterwalk {

/// Reads a picture that a lesson shows. It is a PNG in the folder of the lessons or in
/// ../screenshots/; no path and no symbolic link leads out of there. Throws UsageError with a
/// sentence that names it.
/// @param folder of the lesson
/// @param target as written in the lesson
Image read_lesson_picture(const std::string& folder, const std::string& target);

/// Does the target name a figure, which is drawn, and not a picture?
bool names_figure(std::string_view target);

/// Reads a figure that a lesson shows: an SVG file in the folder of the lessons. Throws UsageError
/// with a sentence that names it, and its line.
Figure read_lesson_figure(const std::string& folder, const std::string& target);

inline constexpr int largest_lesson_picture = 4096; ///< pixels per side

} // namespace rasterwalk
