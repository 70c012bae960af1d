#include "lessons/lesson_reader.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

#include "base/faults.h"
#include "base/language_files.h"
#include "base/nearest_name.h"
#include "base/quoted.h"
#include "base/text_parts.h"
#include "lessons/choice_order.h"
#include "lessons/lesson_blocks.h"
#include "lessons/lesson_comment.h"
#include "lessons/lesson_control.h"
#include "lessons/lesson_lines.h"
#include "lessons/lesson_text.h"
#include "lessons/look_back.h"
#include "lessons/puzzle_block.h"
#include "text/markdown_text.h"
#include "view/view_table.h"

namespace rasterwalk {

namespace {

class Reader {
  public:
    Reader(std::string_view text, const std::string& path)
        : lines_(split_lines(text)), faults_(path) {
        lesson_.path = path;
        lesson_.folder = lessons_folder_of(path);
        lesson_.id = std::filesystem::path(path).stem().string();
        begin_step("", 1);
    }

    Lesson read() {
        if (check_lines(lines_, faults_)) {
            while (next_ < lines_.size() && !faults_.is_beyond_limits())
                read_line();
            end_text();
            if (!faults_.is_beyond_limits()) finish();
        }
        if (faults_.is_beyond_limits()) drop_all();
        lesson_.faults = faults_.take();
        return std::move(lesson_);
    }

  private:
    int line_number() const { return static_cast<int>(next_) + 1; }
    LessonStep& step() { return lesson_.steps.back(); }
    int step_number() const { return static_cast<int>(lesson_.steps.size()) - 1; }

    /// Drops what was read, so that it is not shown.
    void drop_all() {
        Lesson dropped;
        dropped.id = lesson_.id;
        dropped.path = lesson_.path;
        dropped.folder = lesson_.folder;
        dropped.steps.emplace_back();
        lesson_ = std::move(dropped);
    }

    void read_line() {
        const std::string_view line = lines_[next_];
        if (in_code_ || is_fence(line)) {
            if (is_fence(line)) {
                in_code_ = !in_code_;
                code_line_ = line_number();
            }
            add_text(line);
            ++next_;
        } else if (line.starts_with("<!--")) {
            read_block();
        } else if (line.starts_with("# ") || line.starts_with("## ")) {
            read_heading(line);
        } else if (line.starts_with("[^") && line.find("]:") != line.npos) {
            read_footnote(line);
        } else {
            add_text(line);
            ++next_;
        }
    }

    void add_text(std::string_view line) {
        // Comments may be between blank lines and the text, so the first line of words counts.
        if (trimmed(text_).empty()) {
            text_.clear();
            text_line_ = line_number();
        }
        text_.append(line).append("\n");
    }

    /// Blank lines around a text are not part of it, and blank lines alone are not a text.
    void end_text() {
        const std::size_t last = text_.find_last_not_of(" \t\n");
        if (last != text_.npos) {
            text_.erase(last + 1);
            look_through(text_, text_line_);
            step().parts.push_back({LessonPart::Kind::text, text_, -1, text_line_});
        }
        text_.clear();
    }

    void look_through(std::string_view text, int line) {
        std::size_t next = step().links.size();
        add_inline_parts(text, line, step(), faults_);
        for (; next < step().links.size(); ++next) {
            if (++links_ <= most_lesson_links) continue;
            faults_.refuse(step().links[next].line, "a lesson may have at most " +
                                                        std::to_string(most_lesson_links) +
                                                        " links.");
            return;
        }
    }

    // --- headings

    void begin_step(std::string_view heading, int line) {
        LessonStep made;
        made.heading = std::string(trimmed(heading));
        made.line = line;
        if (!lesson_.steps.empty()) made.state = step().state;
        made.state.line = line;
        lesson_.steps.push_back(std::move(made));
        may_have_block_ = true;
    }

    void read_heading(std::string_view line) {
        const bool is_title = line.starts_with("# ");
        std::string_view words = trimmed(line.substr(is_title ? 2 : 3));
        while (words.ends_with('#'))
            words.remove_suffix(1);
        end_text();
        if (is_title) {
            if (step_number() > 0 || !step().heading.empty()) {
                faults_.add(line_number(),
                            "a lesson has one heading with '#'; the headings of its steps have "
                            "'##'.");
            } else {
                step().heading = std::string(trimmed(words));
                step().line = line_number();
                may_have_block_ = true;
                if (!step().parts.empty()) {
                    faults_.add(line_number(), "the heading with '#' must come before all text.");
                }
            }
        } else if (step_number() >= most_lesson_steps) {
            if (!has_reported_steps_) {
                faults_.add(line_number(), "a lesson may have at most " +
                                               std::to_string(most_lesson_steps) + " steps.");
            }
            has_reported_steps_ = true;
        } else {
            begin_step(words, line_number());
        }
        ++next_;
    }

    void read_footnote(std::string_view line) {
        const std::size_t close = line.find("]:");
        LessonFootnote note;
        note.label = std::string(line.substr(2, close - 2));
        note.text = std::string(trimmed(line.substr(close + 2)));
        note.line = line_number();
        add_text(""); // keeps the line numbers of what follows
        ++next_;
        while (next_ < lines_.size() && lines_[next_].starts_with("  ") &&
               !trimmed(lines_[next_]).empty()) {
            note.text.append(" ").append(trimmed(lines_[next_]));
            add_text("");
            ++next_;
        }
        for (const LessonFootnote& other : lesson_.footnotes) {
            if (other.label == note.label) {
                faults_.add(note.line, "there are two footnotes " + in_quotes(note.label) + ".");
            }
        }
        if (note.text.empty()) faults_.add(note.line, "the footnote has no text.");
        if (lesson_.footnotes.size() >= most_lesson_footnotes) {
            faults_.refuse(note.line, "a lesson may have at most " +
                                          std::to_string(most_lesson_footnotes) + " footnotes.");
            return;
        }
        look_through(note.text, note.line);
        lesson_.footnotes.push_back(std::move(note));
    }

    // --- comments

    void read_block() {
        const LessonComment comment = read_comment(lines_, next_, faults_);
        if (comment.kind == "note") {
            // for authors
        } else if (comment.kind == "lesson") {
            read_lesson_comment(comment);
        } else if (comment.kind == "step") {
            read_step_comment(comment);
        } else if (comment.kind == "task" || comment.kind == "prediction") {
            read_question(comment);
        } else if (comment.kind == "order") {
            read_order(comment);
        } else if (comment.kind == "control") {
            read_control_comment(comment);
        } else {
            constexpr std::string_view block_kinds[] = {"lesson", "step",    "task", "prediction",
                                                        "order",  "control", "note"};
            faults_.add(
                comment.line,
                "there is no block " + in_quotes(comment.kind) +
                    "; the blocks are lesson, step, task, prediction, order, control and note." +
                    did_you_mean(comment.kind, block_kinds));
        }
    }

    void read_lesson_comment(const LessonComment& comment) {
        if (has_lesson_block_ || step_number() > 0 || !step().heading.empty() ||
            !trimmed(text_).empty() || !step().parts.empty()) {
            faults_.add(comment.line, "the block 'lesson' must appear once, at the top of the "
                                      "file.");
            return;
        }
        has_lesson_block_ = true;
        lesson_state_ = read_lesson_block(comment.table, comment.line, lesson_, faults_);
        step().state = lesson_state_;
        for (const std::string& source : lesson_.sources)
            look_through(source, comment.line);
    }

    void read_step_comment(const LessonComment& comment) {
        if (!may_have_block_ || !trimmed(text_).empty()) {
            faults_.add(comment.line,
                        "the block 'step' may appear once in a step, directly under its heading.");
            return;
        }
        may_have_block_ = false;
        text_.clear(); // or what follows would be counted from the blank line before the block
        ViewState own = read_view_state(comment.table, comment.line, faults_);
        step().state = combined(lesson_state_, own);
        step().state.point_at = own.point_at;
    }

    /// The block quote right after the comment, without its marks.
    std::string take_quote() {
        std::string text;
        while (next_ < lines_.size() && lines_[next_].starts_with(">")) {
            std::string_view line = lines_[next_].substr(1);
            if (line.starts_with(" ")) line.remove_prefix(1);
            text.append(line).append("\n");
            ++next_;
        }
        return std::string(trimmed(text));
    }

    bool is_new_id(const std::string& id, int line) {
        if (id.empty() || ids_.insert(id).second) return true;
        faults_.add(line, "there are two questions with the id " + in_quotes(id) + ".");
        return false;
    }

    /// The quote after a block, which must have one.
    std::string take_text(const LessonComment& comment) {
        end_text();
        may_have_block_ = false;
        const int quote_line = line_number();
        std::string text = take_quote();
        if (text.empty()) {
            faults_.add(comment.line, "the block '" + std::string(comment.kind) +
                                          "' must be directly followed by its text, a quote: > "
                                          "...");
        }
        look_through(text, quote_line);
        return text;
    }

    /// May the lesson have one more? If not, that is reported once.
    bool has_room_for_question(int line) {
        const std::size_t count =
            lesson_.tasks.size() + lesson_.predictions.size() + lesson_.puzzles.size();
        if (count < static_cast<std::size_t>(most_lesson_questions)) return true;
        if (!has_reported_questions_) {
            faults_.add(line, "a lesson may have at most " + std::to_string(most_lesson_questions) +
                                  " tasks, puzzles and predictions.");
        }
        has_reported_questions_ = true;
        return false;
    }

    void read_question(const LessonComment& comment) {
        const int quote_line = line_number();
        std::string text = take_text(comment);
        if (!comment.is_good || !has_room_for_question(comment.line)) return;
        if (comment.kind == "task") {
            add_task(read_task(comment.table, comment.line, faults_), std::move(text), quote_line);
        } else {
            add_prediction(read_prediction(comment.table, comment.line, step().state, faults_),
                           std::move(text), quote_line);
        }
    }

    void add_task(LessonTask task, std::string text, int quote_line) {
        if (!is_new_id(task.id, task.line)) return;
        task.text = std::move(text);
        task.step = step_number();
        look_through(task.hint, task.line);
        look_through(task.because, task.because_line);
        for (const NotYet& one : task.not_yet)
            look_through(one.says, one.line);
        step().parts.push_back(
            {LessonPart::Kind::task, {}, static_cast<int>(lesson_.tasks.size()), quote_line});
        lesson_.tasks.push_back(std::move(task));
    }

    void add_prediction(LessonPrediction prediction, std::string text, int quote_line) {
        if (!is_new_id(prediction.id, prediction.line)) return;
        prediction.text = std::move(text);
        prediction.step = step_number();
        prediction.order =
            shuffled(static_cast<int>(prediction.choices.size()), lesson_.id + "/" + prediction.id);
        look_through(prediction.because, prediction.because_line);
        for (const std::string& choice : prediction.choices)
            look_through(choice, prediction.answer_line);
        for (const Misconception& one : prediction.misconceptions)
            look_through(one.says, one.line);
        step().parts.push_back({LessonPart::Kind::prediction,
                                {},
                                static_cast<int>(lesson_.predictions.size()),
                                quote_line});
        lesson_.predictions.push_back(std::move(prediction));
    }

    /// The lines of the fenced code that comes next; none, which is reported, if none comes.
    std::optional<std::vector<std::string_view>> take_code(const LessonComment& comment) {
        while (next_ < lines_.size() && trimmed(lines_[next_]).empty())
            ++next_;
        if (next_ == lines_.size() || !is_fence(lines_[next_])) {
            faults_.add(comment.line, "the text of the block 'order' must be followed by its code, "
                                      "between lines of ```.");
            return std::nullopt;
        }
        std::vector<std::string_view> code;
        code_line_ = line_number();
        ++next_;
        while (next_ < lines_.size() && !is_fence(lines_[next_]))
            code.push_back(lines_[next_++]);
        in_code_ = next_ == lines_.size();
        if (!in_code_) ++next_;
        return code;
    }

    void read_order(const LessonComment& comment) {
        const int quote_line = line_number();
        std::string text = take_text(comment);
        const std::optional<std::vector<std::string_view>> code = take_code(comment);
        if (!comment.is_good || !code || !has_room_for_question(comment.line)) return;
        LessonPuzzle puzzle = read_puzzle(comment.table, comment.line, *code, code_line_, faults_);
        if (puzzle.lines.empty() || !is_new_id(puzzle.id, puzzle.line)) return;
        puzzle.text = std::move(text);
        puzzle.step = step_number();
        puzzle.order = shuffled(piece_count(puzzle), lesson_.id + "/" + puzzle.id);
        look_through(puzzle.because, puzzle.line);
        step().parts.push_back(
            {LessonPart::Kind::puzzle, {}, static_cast<int>(lesson_.puzzles.size()), quote_line});
        lesson_.puzzles.push_back(std::move(puzzle));
    }

    void read_control_comment(const LessonComment& comment) {
        end_text();
        may_have_block_ = false;
        if (!comment.is_good) return;
        const std::vector<LessonPart>& parts = step().parts;
        const auto count = std::count_if(parts.begin(), parts.end(), [](const LessonPart& part) {
            return part.kind == LessonPart::Kind::control;
        });
        if (count >= most_step_controls) {
            if (reported_controls_of_ != step_number()) {
                faults_.add(comment.line, "a step may have at most " +
                                              std::to_string(most_step_controls) + " controls.");
            }
            reported_controls_of_ = step_number();
            return;
        }
        LessonControl control = read_control(comment.table, comment.line, faults_);
        if (control.setting == nullptr) return;
        const bool is_there = std::any_of(parts.begin(), parts.end(), [&](const LessonPart& part) {
            return part.kind == LessonPart::Kind::control &&
                   lesson_.controls[static_cast<std::size_t>(part.index)].name == control.name;
        });
        if (is_there) {
            faults_.add(comment.line, "the step already has a control for " + control.name + ".");
            return;
        }
        step().parts.push_back({LessonPart::Kind::control,
                                {},
                                static_cast<int>(lesson_.controls.size()),
                                comment.line});
        lesson_.controls.push_back(std::move(control));
    }

    // --- the whole

    void finish() {
        if (!has_lesson_block_)
            faults_.add(1, "the block 'lesson' is missing at the top of the file.");
        if (lesson_.steps.front().heading.empty()) {
            faults_.add(1, "the heading with '#' is missing.");
        }
        if (in_code_) faults_.add(code_line_, "the code block does not end.");
        if (lesson_.picture > step_number()) {
            faults_.add(lesson_state_.line_of("picture"),
                        "'picture' names step " + std::to_string(lesson_.picture) +
                            ", but the last step is " + std::to_string(step_number()) + ".");
        }
        check_looks_back(lesson_, faults_);
        std::set<std::string> used;
        for (const LessonStep& one : lesson_.steps) {
            for (const TextPlace& place : one.footnotes) {
                used.insert(place.text);
                if (!has_footnote(place.text)) {
                    faults_.add(place.line, "there is no footnote [^" + place.text.substr(0, 40) +
                                                "]: at the end of the file.");
                }
            }
        }
        for (const LessonFootnote& note : lesson_.footnotes) {
            if (used.count(note.label) == 0) {
                faults_.add(note.line,
                            "nothing refers to the footnote " + in_quotes(note.label) + ".");
            }
        }
    }

    bool has_footnote(const std::string& label) const {
        return std::any_of(lesson_.footnotes.begin(), lesson_.footnotes.end(),
                           [&](const LessonFootnote& note) { return note.label == label; });
    }

    std::vector<std::string_view> lines_;
    std::size_t next_ = 0;
    FaultList faults_;
    Lesson lesson_;
    ViewState lesson_state_;
    int links_ = 0;
    std::string text_; ///< of the part being read
    int text_line_ = 1;
    bool in_code_ = false;
    int code_line_ = 0; ///< where the block of code began or ended
    bool has_lesson_block_ = false;
    bool may_have_block_ = true; ///< the step has none yet, and no text
    bool has_reported_steps_ = false, has_reported_questions_ = false;
    int reported_controls_of_ = -1; ///< the step already reported to have too many
    std::set<std::string> ids_;
};

} // namespace

Lesson read_lesson_lines(std::string_view text, const std::string& path) {
    return Reader(text, path).read();
}

} // namespace rasterwalk
