#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lessons/lesson_list.h"
#include "lessons/progress.h"

namespace rasterwalk {

/// How far each lesson of a list is done; computed again only after an answer, or when a lesson was
/// read again.
class LessonScores {
  public:
    /// Brings them up to date; costs nothing if nothing has changed.
    void renew(const Progress& progress, LessonList& lessons);

    /// The score of the lesson with this index in the list, at the last renew().
    const LessonScore& of(std::size_t lesson) const { return scores_[lesson]; }
    /// The id of the lesson to go on with, see lesson_to_open().
    const std::string& to_open() const { return to_open_; }
    /// How often they were computed.
    std::uint64_t number() const { return number_; }

  private:
    std::uint64_t number_ = 0;
    std::uint64_t progress_ = 0, lessons_ = 0; ///< numbers of what they were computed from
    std::vector<LessonScore> scores_;
    std::string to_open_;
};

} // namespace rasterwalk
