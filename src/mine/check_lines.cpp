#include "mine/check_lines.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/numbers.h"
#include "mine/checked_program.h"
#include "stages/stages.h"

namespace rasterwalk {

namespace {

CheckLine compiled_line(const CheckedProgram& checked) {
    CheckLine line{CheckLineKind::compiled, 0, CheckLineState::right, "compiled", {}, {}};
    const auto& messages = checked.compiled.messages;
    if (!checked.compiles()) {
        line.state = CheckLineState::wrong;
        const auto errors = std::count_if(messages.begin(), messages.end(),
                                          [](const CompileMessage& m) { return m.is_error; });
        line.count = counted(static_cast<std::int64_t>(errors), "error", "errors");
    } else if (!messages.empty()) {
        line.count = counted(static_cast<std::int64_t>(messages.size()), "warning", "warnings");
    }
    line.words = checked.compiled.compiler;
    return line;
}

CheckLine ran_line(const CheckedProgram& checked) {
    CheckLine line{CheckLineKind::ran, 0, CheckLineState::waiting, "first frame", {}, {}};
    if (!checked.run) return line;
    const ProgramRun& run = *checked.run;
    // What happened while a function was asked belongs to that function.
    const auto fault = std::find_if(run.faults.begin(), run.faults.end(), [](const auto& one) {
        return one.part == rasterwalk_kit::part_picture;
    });
    line.state = fault == run.faults.end() ? CheckLineState::right : CheckLineState::wrong;
    if (fault != run.faults.end()) {
        line.count = fault->is_hang ? "did not end" : "ended early";
        line.words = fault->sentence;
    } else if (!run.has_frame()) {
        line.state = CheckLineState::open;
        line.count = "none drawn";
    } else {
        line.count = counted(static_cast<std::int64_t>(run.recording.progress.puts), "pixel put",
                             "pixels put");
    }
    return line;
}

CheckLineState state_of(CheckState state) {
    switch (state) {
    case CheckState::right:
        return CheckLineState::right;
    case CheckState::wrong:
    case CheckState::died:
    case CheckState::unreadable:
        return CheckLineState::wrong;
    case CheckState::not_written:
    case CheckState::not_asked:
        break;
    }
    return CheckLineState::open;
}

CheckLine function_line(const CheckedProgram& checked, std::size_t index) {
    const FunctionCheck& check = checked.functions[index];
    CheckLine line{CheckLineKind::function, index, state_of(check.state), check.function, {}, {}};
    const bool has_counts = check.asked > 0 && line.state != CheckLineState::open &&
                            check.state != CheckState::unreadable;
    line.count = has_counts ? fmt::format("{} of {}", check.right, check.asked)
                            : std::string(state_words(checked, check));
    line.words = check.fed;
    return line;
}

CheckLine picture_line(const CheckedProgram& checked, bool is_whole) {
    CheckLine line{CheckLineKind::picture, 0, CheckLineState::waiting, "picture", {}, {}};
    if (!checked.picture) {
        const bool is_empty = checked.run && draws_nothing(*checked.run);
        if (!is_whole && !is_empty) return line;
        line.state = is_empty ? CheckLineState::wrong : CheckLineState::open;
        line.count = is_empty ? "no pixel put" : "not compared";
        return line;
    }
    const PictureCheck& picture = *checked.picture;
    line.words = fmt::format("at the step “{}”", stage_info(picture.reference).title);
    if (picture.is_right) {
        line.state = CheckLineState::right;
        line.count = "same as ours";
    } else {
        line.state = picture.is_judged ? CheckLineState::wrong : CheckLineState::open;
        line.count = counted(picture.different, "pixel differs", "pixels differ");
    }
    return line;
}

CheckLine sequence_line(const CheckedProgram& checked, bool is_whole) {
    CheckLine line{CheckLineKind::sequence, 0, CheckLineState::waiting, "order of pixels", {}, {}};
    if (checked.sequence) {
        // Another order is as right.
        line.state = CheckLineState::right;
        line.count = checked.sequence->parting ? "another, as right" : "same as ours";
    } else if (checked.picture || is_whole) {
        line.state = CheckLineState::open;
        line.count = "not compared";
    }
    return line;
}

CheckLine keys_line(const CheckedProgram& checked, bool is_whole) {
    CheckLine line{CheckLineKind::keys, 0, CheckLineState::waiting, "keys held", {}, {}};
    line.words = "with sanitizers";
    if (checked.is_key_tested) {
        line.state = checked.key_faults.empty() ? CheckLineState::right : CheckLineState::wrong;
        line.count =
            checked.key_faults.empty()
                ? "nothing found"
                : counted(static_cast<std::int64_t>(checked.key_faults.size()), "fault", "faults");
    } else if (is_whole) {
        line.state = CheckLineState::open;
        line.count = "not done";
    }
    return line;
}

const CheckLine* line_of(const std::vector<CheckLine>& lines, const CheckLine& wanted) {
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const CheckLine& line) {
        return line.kind == wanted.kind && line.name == wanted.name;
    });
    return found == lines.end() ? nullptr : &*found;
}

/// A line as the subject of a sentence.
std::string subject_of(const CheckLine& line) {
    switch (line.kind) {
    case CheckLineKind::compiled:
        return "The code";
    case CheckLineKind::ran:
        return "The first frame";
    case CheckLineKind::function:
        return line.name;
    case CheckLineKind::picture:
        return "The picture";
    case CheckLineKind::sequence:
        return "The order of pixels";
    case CheckLineKind::keys:
        return "What happens while keys are held";
    }
    return {};
}

void add_changes(const std::vector<CheckLine>& before, const std::vector<CheckLine>& now,
                 CheckLineState from, CheckLineState to, std::vector<LineChange>& changes) {
    const bool is_better = to == CheckLineState::right;
    for (const CheckLine& line : now) {
        const CheckLine* const earlier = line_of(before, line);
        if (earlier == nullptr || earlier->state != from || line.state != to) continue;
        changes.push_back(
            {fmt::format("{} was {} and is {} now.", subject_of(line),
                         is_better ? "wrong" : "right", is_better ? "right" : "wrong"),
             is_better});
    }
}

} // namespace

std::vector<CheckLine> check_lines(const CheckedProgram& checked, bool is_whole) {
    std::vector<CheckLine> lines{compiled_line(checked)};
    if (!checked.compiles()) return lines;
    lines.push_back(ran_line(checked));
    for (std::size_t i = 0; i < checked.functions.size(); ++i)
        lines.push_back(function_line(checked, i));
    lines.push_back(picture_line(checked, is_whole));
    lines.push_back(sequence_line(checked, is_whole));
    lines.push_back(keys_line(checked, is_whole));
    return lines;
}

std::size_t first_wrong(const std::vector<CheckLine>& lines) {
    auto found = std::find_if(lines.begin(), lines.end(), [](const CheckLine& line) {
        return line.state == CheckLineState::wrong;
    });
    if (found == lines.end())
        found = std::find_if(lines.begin(), lines.end(), [](const CheckLine& line) {
            return line.kind == CheckLineKind::picture;
        });
    return found == lines.end() ? 0 : static_cast<std::size_t>(found - lines.begin());
}

std::vector<LineChange> changed_lines(const std::vector<CheckLine>& before,
                                      const std::vector<CheckLine>& now) {
    std::vector<LineChange> changes;
    add_changes(before, now, CheckLineState::right, CheckLineState::wrong, changes);
    add_changes(before, now, CheckLineState::wrong, CheckLineState::right, changes);
    return changes;
}

} // namespace rasterwalk
