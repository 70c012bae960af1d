#pragma once

// The lab's program, walked line by line together with the moments of its frame.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "code/code_machine.h"
#include "lab_code/lab_program.h"
#include "pipeline/cursor.h"
#include "pipeline/framebuffer.h"
#include "pipeline/timeline.h"
#include "stages/polygon_rows.h"

namespace rasterwalk {

/// Which line comes next: so many lines after the moment began.
struct CodePlace {
    Cursor cursor;
    int lines = 0; ///< -1: the last line before the next moment

    friend bool operator==(const CodePlace&, const CodePlace&) = default;
};

/// Where a walk is to stop.
enum class CodeGoal : std::uint8_t {
    line,    ///< at the next line
    over,    ///< at the next line of the same function, or of the one that called it
    out,     ///< in the function that called this one
    meeting, ///< before the line that is asked for, or where a line's condition holds
};

/// How a walk has ended.
enum class CodeArrival : std::uint8_t {
    arrived,
    on_the_way, ///< it has begun as many lines as it may at once
    ended,      ///< the frame is drawn, and it was not met
    failed,     ///< see CodeMachine::fault()
};

/// A line of a file at which a walk stops if a condition holds.
struct LineCondition {
    int file = 0; ///< in the order in which files are read
    int line = 0; ///< of the file, from 1
    std::string text;

    friend bool operator==(const LineCondition&, const LineCondition&) = default;
};

class CodeWalk {
  public:
    CodeWalk() = default;
    CodeWalk(const CodeWalk&) = delete;
    CodeWalk& operator=(const CodeWalk&) = delete;

    /// Takes up a frame, unless it has it already. Nothing may be asked while there is missing().
    /// Throws InputError if the code or a condition is not understood; then all is as before.
    /// @param number changes whenever the frame does
    /// @param conditions those of lines that other settings choose are passed over
    void take(const LabCode& code, const Frame& frame, std::uint64_t number,
              const std::vector<LineCondition>& conditions = {});

    /// Does it have this frame?
    bool has(const Frame& frame, std::uint64_t number) const {
        return frame_ == &frame && number_ == number;
    }
    /// Is the machine at place()? Not if the condition of a line has failed on the way, see
    /// CodeMachine::fault().
    bool is_there() const { return is_there_; }

    /// What the code has no lines for, see missing_code(); empty: nothing.
    const std::string& missing() const { return missing_; }
    const std::vector<ChosenLine>& lines() const { return lines_; }
    /// Does a statement begin in this line of the program, from 1?
    bool begins(int line) const { return begins_[static_cast<std::size_t>(line)]; }
    const CodeMachine& machine() const { return *machine_; }
    CodeMachine& machine() { return *machine_; }

    /// Goes to a place; the same if it is there already. A place beyond the last line of its moment
    /// is that line.
    /// @param planes the picture of that moment
    CodePlace seek(const CodePlace& place, const Framebuffer& planes);
    const CodePlace& place() const { return place_; }
    /// Lines of the program that were carried out for the last moment that is done, and since then.
    std::vector<int> recent_lines() const;

    /// Sets out for a goal from the place where it is.
    /// @param line for CodeGoal::meeting; 0: only conditions count
    void set_out(CodeGoal goal, int line = 0);
    /// Goes on toward it, over as many lines as it may at once.
    CodeArrival go_on(std::int64_t most_lines);

  private:
    static std::shared_ptr<const CodeProgram>
    compiled(const LabCode& code, const std::vector<ChosenLine>& lines, Viewport picture,
             const std::vector<LineCondition>& conditions);
    void make_machine();
    std::optional<Cursor> moment_of(std::size_t mark, std::span<const int> marks);
    const PolygonRows& rows_of(int triangle);
    int box_rows_before(int triangle, int of_fan);
    int pixels_left_of_picture(int triangle, int row);
    std::size_t mark_named(std::string_view name) const;
    bool is_just_ahead(const Cursor& moment) const;
    void arrive_at(const Cursor& moment, bool is_ahead, const Framebuffer& planes);
    void begin_at(const Cursor& cursor, const Framebuffer& planes);
    int lines_of_moment();
    CodeArrival run_until(const Cursor& moment);
    void settle();

    std::vector<ChosenLine> lines_;
    std::vector<bool> begins_; ///< by the number of the line
    std::string missing_;
    std::vector<LineCondition> conditions_;
    std::shared_ptr<const CodeProgram> program_;
    std::unique_ptr<CodeMachine> machine_;
    const Frame* frame_ = nullptr;
    std::uint64_t number_ = 0;
    Viewport picture_;
    PolygonRows rows_;          ///< of the last triangle that was asked for
    int triangle_of_rows_ = -1; ///< that it is; -1: none
    std::size_t triangle_ = 0, vertex_ = 0, plane_ = 0, cut_ = 0, cull_ = 0, edge_ = 0, sample_ = 0,
                fan_ = 0, box_row_ = 0, test_ = 0, pixel_column_ = 0, pixel_row_ = 0, row_ = 0,
                fragment_ = 0, square_ = 0, picture_row_ = 0, resolve_ = 0;
    std::optional<Cursor> wanted_; ///< moment before whose first line the machine pauses
    std::optional<Cursor> begun_;  ///< the last moment that has begun
    std::int64_t begun_at_ = 0;    ///< lines before it
    std::int64_t earlier_at_ = 0;  ///< lines before the moment that began before it
    bool is_there_ = false;        ///< the machine is at place_
    bool is_over_ = false;         ///< the program has ended
    CodePlace place_;
    CodeGoal goal_ = CodeGoal::line;
    int goal_line_ = 0;
    std::size_t goal_calls_ = 0; ///< functions that may be being carried out there; 0: any
};

} // namespace rasterwalk
