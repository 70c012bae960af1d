#pragma once

// Advice on lessons, which may be right as they are: long steps, minutes that do not suit what
// there is to do, words that have not been explained yet.

#include <span>
#include <vector>

#include "lessons/lesson.h"
#include "session/glossary.h"

namespace rasterwalk {

/// The words of a step that a student reads: those of its paragraphs, boxes, lists, tables, code
/// and formulas. Its heading, tasks, predictions, controls and footnotes do not count.
int count_words(const LessonStep& step);

/// How long a lesson takes by its length: a minute for 130 words, and one for each prediction,
/// each task and each puzzle. Minutes.
double minutes_by_length(const Lesson& lesson);

/// Advice on each lesson of a course, in the order of its lines, with the index of the lesson. A
/// word of the glossary is explained where it is *emphasized* or linked, for all lessons that
/// follow.
/// @param lessons in the order in which they are taken
std::vector<std::vector<Fault>> advice_on(std::span<const Lesson> lessons,
                                          std::span<const Term> glossary);

inline constexpr int most_step_words = 130;
inline constexpr int fewest_steps = 6, most_steps = 10; ///< of a lesson, without its opening
inline constexpr double most_minutes_off = 2.0;         ///< from minutes_by_length()

} // namespace rasterwalk
