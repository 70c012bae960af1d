#include <algorithm>
#include <ostream>

#include "base/error.h"
#include "base/numbers.h"
#include "cli/commands.h"
#include "cli/json.h"
#include "lessons/lesson_list.h"
#include "lessons/progress.h"
#include "session/content.h"

namespace rasterwalk {

namespace {

/// The student's stored progress; a file that cannot be read counts as none.
Progress progress_so_far(std::ostream& err) {
    const std::string folder = state_folder();
    if (folder.empty()) return {};
    try {
        return read_progress(folder + "/progress.toml");
    } catch (const Error& fault) {
        err << "rasterwalk: your progress cannot be read: " << fault.what() << '\n';
        return {};
    }
}

int shown_step_count(const LessonProgress& progress, const Lesson& lesson) {
    const int count = static_cast<int>(lesson.steps.size());
    return static_cast<int>(std::count_if(progress.steps.begin(), progress.steps.end(),
                                          [&](int step) { return step >= 0 && step < count; }));
}

/// "The lab: 13 lessons, 2 h 59 min", and what it is about.
void print_track(const Course& course, const Track& track, LessonList& lessons, std::ostream& out) {
    const auto index = static_cast<std::size_t>(&track - course.tracks.data());
    const TrackSize size = size_of_track(course, index, lessons.all());
    out << track.title << ": " << counted(size.lessons, "lesson", "lessons") << ", "
        << hours_text(size.minutes) << "\n    " << track.about << "\n    Needs: " << track.needs
        << "\n\n";
}

} // namespace

void lessons_command(const LessonsOptions& options, std::ostream& out, std::ostream& err) {
    lessons_folder(); // or says that there is none
    LessonList lessons;
    const Progress progress = progress_so_far(err);
    const Course& course = lessons.course();
    if (!lessons.course_fault().empty()) err << "rasterwalk: " << lessons.course_fault() << '\n';
    const Track* shown_track = nullptr;
    Json list = Json::array();
    for (const Lesson& lesson : lessons.all()) {
        const LessonProgress& own = progress.of(lesson.id);
        const LessonScore score = score_of(progress, lesson);
        const int steps = static_cast<int>(lesson.steps.size());
        const int tasks = task_count(lesson);
        const int predictions = static_cast<int>(lesson.predictions.size());
        const int seen = shown_step_count(own, lesson);
        const Track* const track = track_of(course, lesson.id);
        if (!options.json) {
            if (track != nullptr && track != shown_track) print_track(course, *track, lessons, out);
            shown_track = track;
            if (const int number = missing_number(lessons.all(), list.size()))
                out << "Lesson " << number << "\n    To come.\n";
            const bool is_begun = seen > 0 || score.done > 0;
            out << lesson.id << "  " << lesson.title << "\n    " << lesson.minutes << " minutes, "
                << steps << " steps, " << tasks << " tasks, " << predictions
                << " predictions\n    ";
            if (score.is_done) {
                out << "Done.\n";
            } else if (is_begun) {
                out << "So far " << seen << " of " << steps << " steps, " << score.solved << " of "
                    << tasks << " tasks, " << score.answered << " of " << predictions
                    << " predictions.\n";
            } else {
                out << "Not started.\n";
            }
        }
        list.push_back({{"about", lesson.about},
                        {"done", score.is_done},
                        {"id", lesson.id},
                        {"last_step", score.last_step},
                        {"minutes", lesson.minutes},
                        {"needs", needs_of(course, lesson.id)},
                        {"predictions", predictions},
                        {"predictions_answered", score.answered},
                        {"section", lesson.section},
                        {"steps", steps},
                        {"steps_seen", seen},
                        {"tasks", tasks},
                        {"tasks_done", score.solved},
                        {"title", lesson.title},
                        {"track", track == nullptr ? std::string() : track->title}});
    }
    if (options.json) print_json({{"lessons", std::move(list)}}, out);
}

} // namespace rasterwalk
