#include "ui/actions/measure.h"

#include <limits>
#include <utility>

#include "engines/processor.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// Frames take time from what is measured, so there are few.
constexpr double progress_seconds = 0.2;

/// Ends the measurement without waiting for the picture that is being drawn.
void end_run(LadderLook& ladder) {
    if (!ladder.run) return;
    ladder.run->steps().stop();
    ladder.stopped.push_back(std::move(ladder.run));
}

void drop_times(LadderLook& ladder) {
    end_run(ladder);
    ladder.of = std::nullopt;
    ladder.times = {};
    ladder.fault.clear();
}

bool are_times_of_run(const Ui& ui) {
    return ui.ladder.of && !ui.session.quiz && *ui.ladder.of == ladder_subject(ui.session);
}

} // namespace

const std::string& obstacle_to_measuring(Ui& ui) {
    LadderLook& ladder = ui.ladder;
    // The reason would give the answer away.
    static const std::string quiz = "It cannot be measured during a quiz.";
    if (ui.session.quiz) return quiz;
    // Every triangle is looked at, which is too long for each frame.
    LadderSubject subject = ladder_subject(ui.session);
    if (ladder.asked == subject) return ladder.obstacle;
    const std::string refusal = ladder_refuses(*subject.scene, subject.settings);
    ladder.obstacle = refusal.empty() ? refusal : "It cannot be measured: " + refusal + ".";
    ladder.asked = std::move(subject);
    return ladder.obstacle;
}

void measure_ladder(Ui& ui) {
    if (!obstacle_to_measuring(ui).empty()) return;
    LadderLook& ladder = ui.ladder;
    drop_times(ladder);
    ladder.of = ladder_subject(ui.session);
    ladder.processor = processor_name();
    ladder.run = std::make_unique<LadderRun>(*ladder.of, ladder.rounds, ladder.maker);
}

void stop_measuring(Ui& ui) {
    LadderLook& ladder = ui.ladder;
    if (!ladder.run) return;
    ladder.times = ladder.run->times();
    end_run(ladder);
    if (!ladder.times.has_all()) drop_times(ladder);
}

namespace {

void poll_race(LadderLook& ladder) {
    if (!ladder.race) return;
    const bool is_done = ladder.race->is_done();
    ladder.wrong = ladder.race->wrong();
    if (is_done) ladder.race = nullptr;
}

} // namespace

void begin_race(Ui& ui) {
    if (is_racing(ui)) return;
    ui.ladder.wrong.clear();
    ui.ladder.race = std::make_unique<RaceRun>(usual_race_runs);
}

bool is_racing(const Ui& ui) {
    return ui.ladder.race != nullptr;
}

void poll_ladder(Ui& ui) {
    LadderLook& ladder = ui.ladder;
    poll_race(ladder);
    // Without a thread, a step that finds the work stopped is its last.
    for (const auto& one : ladder.stopped)
        one->steps().advance();
    std::erase_if(ladder.stopped, [](const auto& one) { return one->steps().is_done(); });
    if (!ladder.of) return;
    if (!are_times_of_run(ui)) {
        drop_times(ladder);
        return;
    }
    if (!ladder.run) return;
    ladder.run->steps().advance();
    const bool is_done = ladder.run->steps().is_done();
    ladder.times = ladder.run->times();
    if (!is_done) return;
    ladder.fault = ladder.run->steps().fault();
    ladder.run = nullptr;
}

bool is_measuring(const Ui& ui) {
    return ui.ladder.run != nullptr;
}

bool is_measured_by_frames(const Ui& ui) {
    return is_measuring(ui) && !ui.ladder.run->steps().has_thread();
}

double seconds_to_progress(const Ui& ui) {
    return is_measuring(ui) || is_racing(ui) ? progress_seconds
                                             : std::numeric_limits<double>::infinity();
}

const LadderTimes& shown_times(const Ui& ui) {
    static const LadderTimes none;
    return are_times_of_run(ui) ? ui.ladder.times : none;
}

} // namespace rasterwalk
