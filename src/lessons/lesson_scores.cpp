#include "lessons/lesson_scores.h"

namespace rasterwalk {

void LessonScores::renew(const Progress& progress, LessonList& lessons) {
    const std::vector<Lesson>& all = lessons.all();
    const bool is_same =
        number_ > 0 && progress_ == progress.number() && lessons_ == lessons.number();
    if (is_same) return;
    scores_.clear();
    for (const Lesson& lesson : all)
        scores_.push_back(score_of(progress, lesson));
    to_open_ = lesson_to_open(progress, all);
    progress_ = progress.number();
    lessons_ = lessons.number();
    ++number_;
}

} // namespace rasterwalk
