#include "lab_code/code_walk.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "lab_code/code_frame.h"
#include "lab_code/missing_code.h"

namespace rasterwalk {

namespace {

/// A moment with more lines is given up: the window would stand still.
constexpr std::int64_t most_lines_of_moment = 20'000'000;
constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();
constexpr int nothing_skipped = std::numeric_limits<int>::min();

CodeArrival arrival_at(CodeEnd end) {
    switch (end) {
    case CodeEnd::paused:
        return CodeArrival::arrived;
    case CodeEnd::too_long:
        return CodeArrival::on_the_way;
    case CodeEnd::failed:
        return CodeArrival::failed;
    case CodeEnd::done:
        break;
    }
    return CodeArrival::ended;
}

/// A fault in a line of the program, "code:187: ...", with the file of that line.
std::string in_own_file(std::string_view fault, const LabCode& code,
                        const std::vector<ChosenLine>& lines) {
    constexpr std::string_view prefix = "code:";
    int line = 0;
    std::size_t at = prefix.size();
    while (at < fault.size() && fault[at] >= '0' && fault[at] <= '9' && line < 1'000'000)
        line = 10 * line + (fault[at++] - '0');
    if (!fault.starts_with(prefix) || line < 1 || line > static_cast<int>(lines.size()))
        return std::string(fault);
    const ChosenLine& own = lines[static_cast<std::size_t>(line - 1)];
    return fmt::format("{}:{}{}", code.files[static_cast<std::size_t>(own.file)].name, own.line,
                       fault.substr(at));
}

bool has_same_text(const std::vector<ChosenLine>& a, const std::vector<ChosenLine>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& x, const auto& y) { return x.text == y.text; });
}

} // namespace

std::size_t CodeWalk::mark_named(std::string_view name) const {
    const std::vector<std::string>& marks = program_->marks;
    return static_cast<std::size_t>(std::find(marks.begin(), marks.end(), name) - marks.begin());
}

std::shared_ptr<const CodeProgram>
CodeWalk::compiled(const LabCode& code, const std::vector<ChosenLine>& lines, Viewport picture,
                   const std::vector<LineCondition>& conditions) {
    std::vector<CodeStop> stops;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const LineCondition& condition : conditions) {
            if (condition.file == lines[i].file && condition.line == lines[i].line)
                stops.push_back({static_cast<int>(i) + 1, condition.text});
        }
    }
    std::shared_ptr<const CodeProgram> program;
    try {
        program = std::make_shared<const CodeProgram>(
            compile_code(source_text(lines, picture), "code", stops));
    } catch (const InputError& error) {
        throw InputError(in_own_file(error.what(), code, lines));
    }
    const auto has_mark = [&](std::string_view name) {
        const std::vector<std::string>& marks = program->marks;
        return std::find(marks.begin(), marks.end(), name) != marks.end();
    };
    const int draw = program->find_function("Draw");
    const bool has_draw =
        draw >= 0 && program->functions[static_cast<std::size_t>(draw)].parameters.empty();
    const bool are_whole =
        has_mark("resolve") == has_mark("pictureline") && has_mark("sample") == has_mark("edge") &&
        has_mark("cut") == has_mark("plane") && has_mark("test") == has_mark("boxrow") &&
        has_mark("test") == has_mark("pixelcolumn") && has_mark("test") == has_mark("pixelrow") &&
        (has_mark("row") || !has_mark("fragment"));
    if (!has_draw || !are_whole || !has_mark("triangle") || !has_mark("vertex"))
        throw InputError("the lab's code has no function Draw() without parameters, or lacks marks "
                         "of its moments.");
    return program;
}

void CodeWalk::take(const LabCode& code, const Frame& frame, std::uint64_t number,
                    const std::vector<LineCondition>& conditions) {
    if (has(frame, number) && conditions_ == conditions) return;
    std::string missing = missing_code(code, frame);
    std::vector<ChosenLine> lines;
    if (missing.empty()) lines = lines_for(code, frame);
    const Viewport picture = frame.settings.viewport;
    const bool is_known = machine_ != nullptr && picture == picture_ && conditions_ == conditions &&
                          has_same_text(lines, lines_);
    // Nothing has changed until the program is there.
    if (missing.empty() && !is_known) {
        program_ = compiled(code, lines, picture, conditions);
        make_machine();
    }
    if (!missing.empty()) machine_ = nullptr;
    missing_ = std::move(missing);
    lines_ = std::move(lines);
    begins_.assign(lines_.size() + 1, false);
    if (machine_ != nullptr) {
        for (const CodeLine& line : program_->lines)
            begins_[static_cast<std::size_t>(line.line)] = true;
    }
    conditions_ = conditions;
    picture_ = picture;
    frame_ = &frame;
    number_ = number;
    triangle_of_rows_ = -1;
    is_there_ = false;
    if (machine_ != nullptr) give_frame(*machine_, frame);
}

void CodeWalk::make_machine() {
    machine_ = std::make_unique<CodeMachine>(program_);
    if (machine_->begin() != CodeEnd::done) {
        const std::string fault = machine_->fault().sentence;
        machine_ = nullptr;
        throw InputError("the lab's code cannot give its variables their values" +
                         (fault.empty() ? "." : ": " + fault));
    }
    triangle_ = mark_named("triangle");
    vertex_ = mark_named("vertex");
    plane_ = mark_named("plane");
    cut_ = mark_named("cut");
    cull_ = mark_named("cull");
    edge_ = mark_named("edge");
    sample_ = mark_named("sample");
    fan_ = mark_named("fan");
    box_row_ = mark_named("boxrow");
    test_ = mark_named("test");
    pixel_column_ = mark_named("pixelcolumn");
    pixel_row_ = mark_named("pixelrow");
    row_ = mark_named("row");
    fragment_ = mark_named("fragment");
    square_ = mark_named("square");
    picture_row_ = mark_named("pictureline");
    resolve_ = mark_named("resolve");
    machine_->pause_when([this](std::size_t mark, std::span<const int> marks) {
        const std::optional<Cursor> moment = moment_of(mark, marks);
        // A moment begins with the first line of those that have its mark.
        if (!moment || begun_ == moment) return false;
        begun_ = moment;
        earlier_at_ = begun_at_;
        begun_at_ = machine_->lines();
        return wanted_ == moment;
    });
}

/// The moment that begins with the line that gives a mark its value; none if it begins none.
std::optional<Cursor> CodeWalk::moment_of(std::size_t mark, std::span<const int> marks) {
    if (mark == square_) return moment_of_square(marks[square_]);
    if (frame_->squares != nullptr) return std::nullopt;
    if (mark == resolve_) return moment_of_resolve(marks[picture_row_], marks[resolve_]);
    const int triangle = marks[triangle_];
    if (triangle < 0 || triangle >= frame_->triangle_count()) return std::nullopt;
    if (mark == vertex_ && frame_->has_moments(triangle))
        return Cursor{triangle, Phase::vertices, marks[vertex_], 0};
    const bool is_clipped = frame_->has_moments(triangle) && frame_->has_clip_events(triangle);
    if (mark == cut_ && is_clipped)
        return Cursor{triangle, Phase::clip, marks[plane_], marks[cut_]};
    if (mark == cull_ && frame_->is_cull_tested(triangle))
        return Cursor{triangle, Phase::cull, 0, 0};
    if (mark == sample_) return Cursor{triangle, Phase::edges, marks[edge_], marks[sample_]};
    // A pixel outside the picture is tested without a moment.
    if (mark == test_ && !contains(drawn_area(*frame_), marks[pixel_column_], marks[pixel_row_]))
        return std::nullopt;
    if (mark == test_) {
        const int before = fan_ < marks.size() ? box_rows_before(triangle, marks[fan_]) : 0;
        return Cursor{triangle, Phase::tests, before + marks[box_row_], marks[test_]};
    }
    if (mark == fragment_) {
        const int row = marks[row_];
        const int step = marks[fragment_] + pixels_left_of_picture(triangle, row);
        return Cursor{triangle, Phase::rows, row, step};
    }
    if (mark == row_ && !has_fragments(frame_->settings.stage))
        return Cursor{triangle, Phase::rows, marks[row_], 0};
    return std::nullopt;
}

/// The row table of a triangle.
const PolygonRows& CodeWalk::rows_of(int triangle) {
    if (triangle != triangle_of_rows_) compute_rows(*frame_, triangle, rows_);
    triangle_of_rows_ = triangle;
    return rows_;
}

/// How many rows the boxes of the first triangles of a fan have together.
int CodeWalk::box_rows_before(int triangle, int of_fan) {
    int rows = 0;
    for (const TestedTriangle& tested : rows_of(triangle).tested.triangles) {
        if (of_fan-- > 0) rows += tested.box.bottom - tested.box.top;
    }
    return rows;
}

/// How many pixels of a row lie to the left of the picture, and are not tested by the program. In
/// time, fragments are counted from the row's left end.
int CodeWalk::pixels_left_of_picture(int triangle, int row) {
    if (test_ >= program_->marks.size()) return 0;
    const PolygonRows& rows = rows_of(triangle);
    return row < 0 || row >= rows.size() ? 0 : std::max(-rows.left[row].column, 0);
}

/// Begins to draw at the triangle of the moment, and leaves out its rows before that of the moment:
/// what they draw is in the picture.
void CodeWalk::begin_at(const Cursor& cursor, const Framebuffer& planes) {
    give_planes(*machine_, planes);
    machine_->call(program_->find_function("Draw"));
    machine_->allow(machine_->lines() + most_lines_of_moment);
    machine_->pause_before(0);
    machine_->pause_outside(0);
    // The picture is divided when the rows of all triangles are known.
    const bool is_square = cursor.square >= 0;
    machine_->skip_to(triangle_, is_square ? nothing_skipped : cursor.triangle);
    const bool is_in_rows = cursor.phase == Phase::rows && row_ < program_->marks.size();
    if (is_in_rows) machine_->skip_to(row_, cursor.index);
    // Nor are pixels tested for those rows.
    const bool has_tests = test_ < program_->marks.size();
    const bool is_of_triangle =
        !is_square && cursor.triangle >= 0 && cursor.triangle < frame_->triangle_count();
    if (is_in_rows && has_tests && is_of_triangle && frame_->is_drawn(cursor.triangle)) {
        machine_->skip_to(box_row_, cursor.index);
        machine_->skip_to(pixel_row_, rows_of(cursor.triangle).first_row + cursor.index);
    }
    const bool resolves = picture_row_ < program_->marks.size();
    const bool is_after_all = cursor == beginning_of(frame_->triangle_count());
    if (resolves && is_resolve(cursor)) machine_->skip_to(picture_row_, cursor.index);
    if (resolves && is_after_all) machine_->skip_to(picture_row_, picture_.height);
    begun_ = std::nullopt;
    begun_at_ = machine_->lines();
    is_over_ = false;
    const CodeArrival arrival = run_until(cursor);
    // Earlier fragments of the row were drawn once more.
    give_planes(*machine_, planes);
    if (row_ < program_->marks.size()) machine_->skip_to(row_, nothing_skipped);
    if (has_tests) machine_->skip_to(box_row_, nothing_skipped);
    if (has_tests) machine_->skip_to(pixel_row_, nothing_skipped);
    if (resolves) machine_->skip_to(picture_row_, nothing_skipped);
    is_over_ = arrival == CodeArrival::ended;
    // Only at the end of the frame may the program have ended.
    const bool is_end = cursor.triangle >= frame_->triangle_count();
    is_there_ = arrival == CodeArrival::arrived || (is_over_ && is_end);
}

/// Runs to a moment's first line, passing over conditions of lines.
CodeArrival CodeWalk::run_until(const Cursor& moment) {
    wanted_ = moment;
    CodeEnd end = machine_->run();
    while (end == CodeEnd::paused && begun_ != moment)
        end = machine_->run();
    wanted_ = std::nullopt;
    return arrival_at(end);
}

/// How many lines the moment has at whose beginning the machine is. It is moved on.
int CodeWalk::lines_of_moment() {
    const std::int64_t first = machine_->lines();
    const Cursor moment = place_.cursor;
    const Timeline timeline(*frame_);
    const Cursor next = timeline.next(moment, Granularity::moment);
    machine_->allow(first + most_lines_of_moment);
    // The last moment ends with the program.
    run_until(next);
    return static_cast<int>(machine_->lines() - first);
}

/// Is it less work to go on to a moment than to start over: is all on the way needed for it too?
bool CodeWalk::is_just_ahead(const Cursor& moment) const {
    const Cursor& now = place_.cursor;
    if (!is_there_ || is_over_ || !(now < moment)) return false;
    if (moment.square >= 0) return now.square >= 0;
    // Rows that are left out on the way are not drawn.
    const bool needs_all = moment.phase == Phase::tests || moment.index <= now.index + 1;
    return needs_all && now.triangle == moment.triangle && now.phase == moment.phase;
}

/// Goes to a moment from where the machine is, or from the beginning.
void CodeWalk::arrive_at(const Cursor& moment, bool is_ahead, const Framebuffer& planes) {
    is_there_ = false;
    if (is_ahead) {
        machine_->allow(machine_->lines() + most_lines_of_moment);
        machine_->pause_before(0);
        machine_->pause_outside(0);
        is_there_ = run_until(moment) == CodeArrival::arrived;
    }
    if (!is_there_) begin_at(moment, planes);
}

CodePlace CodeWalk::seek(const CodePlace& place, const Framebuffer& planes) {
    if (is_there_ && place == place_) return place_;
    const bool is_ahead = is_just_ahead(place.cursor);
    place_ = place;
    place_.lines = 0;
    if (place.cursor == cursor_end) {
        const Cursor after_all = beginning_of(frame_->triangle_count());
        begin_at(after_all, planes);
        return place_;
    }
    arrive_at(place.cursor, is_ahead, planes);
    int lines = place.lines;
    if (!is_there_) return place_;
    if (lines < 0) {
        lines = std::max(lines_of_moment() - 1, 0);
        begin_at(place.cursor, planes);
    }
    for (int i = 0; i < lines && !is_over_; ++i) {
        const std::optional<Cursor> before = begun_;
        is_over_ = machine_->step_line() != CodeEnd::paused;
        if (is_over_ || begun_ != before) {
            // That was the last line.
            begin_at(place.cursor, planes);
            for (int again = 0; again < i; ++again)
                machine_->step_line();
            lines = i;
            break;
        }
        place_.lines = i + 1;
    }
    place_.lines = lines;
    return place_;
}

/// The place at which the machine is.
void CodeWalk::settle() {
    if (is_over_) {
        place_ = {cursor_end, 0};
    } else if (begun_) {
        place_ = {*begun_, static_cast<int>(machine_->lines() - begun_at_)};
    }
}

std::vector<int> CodeWalk::recent_lines() const {
    return machine_->recent_lines(machine_->lines() - earlier_at_);
}

void CodeWalk::set_out(CodeGoal goal, int line) {
    const std::size_t depth = machine_->calls().size();
    goal_ = goal;
    goal_line_ = goal == CodeGoal::meeting ? line : 0;
    goal_calls_ = goal == CodeGoal::over               ? depth
                  : goal == CodeGoal::out && depth > 0 ? depth - 1
                                                       : 0;
}

CodeArrival CodeWalk::go_on(std::int64_t most_lines) {
    if (is_over_) return CodeArrival::ended;
    if (!is_there_) return CodeArrival::failed;
    machine_->pause_before(goal_line_);
    machine_->pause_outside(goal_calls_);
    machine_->allow(machine_->lines() + most_lines);
    const CodeEnd end = goal_ == CodeGoal::line ? machine_->step_line() : machine_->run();
    machine_->pause_before(0);
    machine_->pause_outside(0);
    machine_->allow(no_limit);
    is_over_ = end == CodeEnd::done;
    is_there_ = end != CodeEnd::failed;
    if (is_there_) settle();
    return arrival_at(end);
}

} // namespace rasterwalk
