#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson.h"
#include "session/glossary.h"

namespace rasterwalk {

/// Where a search found its words.
struct SearchHit {
    std::string lesson;  ///< id; empty: a term of the glossary
    int step = 0;        ///< of the lesson
    std::string title;   ///< the step's heading, or the term
    std::string excerpt; ///< the words around the place, plain text
};

/// Finds every step and term that contains all words of the query, in any case: first terms, then
/// steps whose heading has them, then other steps, each in the order of the lessons.
std::vector<SearchHit> search_lessons(const std::vector<Lesson>& lessons,
                                      const std::vector<Term>& glossary, std::string_view query);

inline constexpr std::size_t most_search_hits = 60;

} // namespace rasterwalk
