#pragma once

#include <string>
#include <string_view>

#include "lessons/lesson.h"

namespace rasterwalk {

/// Reads the text of a lesson line by line: headings make its steps, comments hold its blocks, the
/// rest is Markdown. What is wrong goes to its faults. The text is at most largest_lesson long.
/// @param path names the lesson, and is used in messages
Lesson read_lesson_lines(std::string_view text, const std::string& path);

} // namespace rasterwalk
