#include "ui/actions/code.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "session/content.h"
#include "session/walk.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// Lines that are carried out in a frame, so that it does not take long.
constexpr std::int64_t lines_of_frame = 150'000;
/// Pictures with more pixels take too long to hand over.
constexpr std::int64_t most_pixels = 4'000'000;

/// Goes to a moment of the frame that is shown, which may be a face of a shadow map.
void go_to_moment(Ui& ui, const Cursor& cursor) {
    scrub_to(ui.session, in_pass(cursor, ui.results.a.frame.pass));
}

/// The session's cursor goes where the code is.
void take_place(Ui& ui) {
    CodeLook& look = ui.code;
    look.place = look.walk.place();
    look.call = std::nullopt;
    if (look.place.cursor != ui.results.a.cursor) go_to_moment(ui, look.place.cursor);
}

bool is_too_large(const Frame& frame) {
    const Viewport picture = frame.settings.viewport;
    return std::int64_t{picture.width} * picture.height > most_pixels;
}

void read_code(CodeLook& look) {
    if (!look.code) look.code = read_lab_code(lessons_folder() + "/code");
}

/// A condition that cannot be kept would be in the way of everything.
/// @param line of the program, whose condition it is; 0: not known, and none is kept
void drop_conditions(Ui& ui, const std::string& why, int line = 0) {
    CodeLook& look = ui.code;
    const std::vector<ChosenLine>& lines = look.walk.lines();
    const bool is_known = line > 0 && line <= static_cast<int>(lines.size());
    const auto is_of_line = [&](const LineCondition& one) {
        const ChosenLine& own = lines[static_cast<std::size_t>(line - 1)];
        return one.file == own.file && one.line == own.line;
    };
    const std::size_t dropped = is_known ? std::erase_if(look.conditions, is_of_line) : 0;
    if (dropped == 0) look.conditions.clear();
    look.edited = std::nullopt;
    ui.session.notice = (dropped == 0 ? "The conditions of lines are removed. "
                                      : "The condition of the line is removed. ") +
                        why;
}

void take_frame(Ui& ui) {
    CodeLook& look = ui.code;
    const RunResults& a = ui.results.a;
    try {
        look.walk.take(*look.code, a.frame, a.frame_number, look.conditions);
    } catch (const Error& error) {
        if (look.conditions.empty()) throw;
        drop_conditions(ui, error.what());
        look.walk.take(*look.code, a.frame, a.frame_number);
    }
}

/// The code is where the picture is, unless it is being drawn.
void seek_moment(Ui& ui) {
    CodeLook& look = ui.code;
    const RunResults& a = ui.results.a;
    read_code(look);
    take_frame(ui);
    if (!look.walk.missing().empty() || !a.is_drawn() || a.engine != Engine::steps) return;
    if (look.place.cursor != a.cursor) {
        look.place = {a.cursor, 0};
        look.call = std::nullopt;
    }
    look.place = look.walk.seek(look.place, *a.framebuffer);
    look.is_ready = look.walk.is_there();
    if (look.is_ready) return;
    const CodeFault& fault = look.walk.machine().fault();
    if (!look.conditions.empty()) {
        drop_conditions(ui, fault.sentence, fault.line);
        return;
    }
    throw InputError(fault.sentence.empty() ? "The code does not come to this moment."
                                            : fault.sentence);
}

/// What is said when the end of the program is reached instead.
std::string not_met_text(const CodeLook& look) {
    if (look.asked_line > 0) return "Every triangle is drawn, and the line was not reached again.";
    return "Every triangle is drawn, and no condition held.";
}

void go_on_running(Ui& ui) {
    CodeLook& look = ui.code;
    const CodeArrival arrival = look.walk.go_on(lines_of_frame);
    if (arrival == CodeArrival::on_the_way) return;
    look.is_running = false;
    if (arrival == CodeArrival::failed) {
        look.is_ready = false;
        const CodeFault& fault = look.walk.machine().fault();
        drop_conditions(ui, fault.sentence, fault.line);
        return;
    }
    take_place(ui);
    if (arrival == CodeArrival::ended && look.is_meeting) show_info(ui.session, not_met_text(look));
}

void set_out(Ui& ui, CodeGoal goal, int line = 0) {
    CodeLook& look = ui.code;
    if (!look.is_ready || look.is_running) return;
    ui.session.play.running = false;
    look.walk.set_out(goal, line);
    look.is_meeting = goal == CodeGoal::meeting;
    look.asked_line = line;
    look.is_running = true;
    go_on_running(ui);
}

} // namespace

bool is_code_wanted(const Ui& ui) {
    return tab_below(ui.session) == code_tab || ui.session.play.granularity == Granularity::code;
}

void follow_code(Ui& ui) {
    CodeLook& look = ui.code;
    const bool was_ready = std::exchange(look.is_ready, false);
    if (!is_code_wanted(ui)) {
        look.is_running = false;
        return;
    }
    if (is_too_large(ui.results.a.frame)) {
        look.fault = "The Code tab works with pictures of up to 4 million pixels.";
        return;
    }
    // While it runs, the picture stays at the moment where it set out.
    const RunResults& a = ui.results.a;
    const bool is_same =
        look.place.cursor == a.cursor && was_ready && look.walk.has(a.frame, a.frame_number);
    if (look.is_running && is_same) {
        look.is_ready = true;
        go_on_running(ui);
        if (look.is_running) return;
    }
    look.is_running = false;
    // What has failed is not tried again in each frame.
    if (look.failed_at == std::pair{a.frame_number, a.cursor}) return;
    look.failed_at = std::nullopt;
    try {
        look.fault.clear();
        seek_moment(ui);
    } catch (const Error& error) {
        look.fault = error.what();
        look.failed_at = std::pair{a.frame_number, a.cursor};
    }
}

bool steps_code(const Ui& ui) {
    return ui.session.play.granularity == Granularity::code && ui.code.is_ready;
}

void step_code(Ui& ui, CodeGoal goal) {
    set_out(ui, goal);
}

void step_code_back(Ui& ui) {
    CodeLook& look = ui.code;
    if (!look.is_ready || look.is_running) return;
    ui.session.play.running = false;
    look.call = std::nullopt;
    if (look.place.lines > 0) {
        --look.place.lines;
        return;
    }
    const Timeline timeline(ui.results.a.frame);
    const Cursor before = timeline.previous(look.place.cursor, Granularity::moment);
    if (before == look.place.cursor) return;
    go_to_moment(ui, before);
    look.place = {before, -1};
}

void run_code_to(Ui& ui, int line) {
    set_out(ui, CodeGoal::meeting, line);
}

bool is_code_running(const Ui& ui) {
    return ui.code.is_running;
}

void stop_code(Ui& ui) {
    if (!ui.code.is_running) return;
    ui.code.is_running = false;
    take_place(ui);
}

bool play_code(Ui& ui, float seconds) {
    Play& play = ui.session.play;
    CodeLook& look = ui.code;
    const Speed speed = speed_in(play.speed, ui.results.length.of(Granularity::code));
    if (play.granularity != Granularity::code || speed.unit != SpeedUnit::steps || !look.is_ready)
        return false;
    if (look.is_running) return true;
    if (!play.running || std::exchange(play.has_just_begun, false)) return true;
    play.passed += static_cast<double>(std::clamp(seconds, 0.0f, longest_play_step)) * speed.value;
    const double whole = std::floor(play.passed);
    play.passed -= whole;
    for (double line = 0.0; line < whole && play.running; ++line) {
        look.walk.set_out(CodeGoal::line);
        play.running = look.walk.go_on(lines_of_frame) == CodeArrival::arrived;
    }
    if (whole < 1.0) return true;
    const bool runs = play.running;
    take_place(ui);
    play.running = runs;
    return true;
}

void set_line_condition(Ui& ui, const LineCondition& condition) {
    CodeLook& look = ui.code;
    std::vector<LineCondition> wanted = look.conditions;
    std::erase_if(wanted, [&](const LineCondition& one) {
        return one.file == condition.file && one.line == condition.line;
    });
    if (!condition.text.empty()) wanted.push_back(condition);
    look.condition_fault.clear();
    if (!look.is_ready || look.is_running) return;
    ui.session.play.running = false;
    look.is_ready = false;
    try {
        look.walk.take(*look.code, ui.results.a.frame, ui.results.a.frame_number, wanted);
        look.conditions = std::move(wanted);
        look.edited = std::nullopt;
    } catch (const Error& error) {
        // The line is the one next to the field.
        const std::string_view sentence = error.what();
        const std::size_t place = sentence.find(": ");
        look.condition_fault = sentence.substr(place == std::string_view::npos ? 0 : place + 2);
    }
}

} // namespace rasterwalk
