#include "lessons/lesson_text.h"

#include <cctype>
#include <string>

#include "base/quoted.h"
#include "text/markdown.h"

namespace rasterwalk {

namespace {

using PartKind = MarkdownPart::Kind;

/// Nothing of a lesson whose text cannot be drawn is shown.
void refuse_fault(const MarkdownDocument& found, int first_line, FaultList& faults) {
    if (found.fault.empty()) return;
    std::string sentence = found.fault;
    sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
    faults.refuse(first_line + found.fault_line, std::move(sentence));
}

void add_part(const MarkdownPart& part, int line, LessonStep& step, FaultList& faults) {
    switch (part.kind) {
    case PartKind::link:
    case PartKind::picture:
        step.links.push_back({part.text, part.words, line, part.kind == PartKind::picture});
        break;
    case PartKind::formula:
        step.formulas.push_back({part.text, line});
        break;
    case PartKind::footnote:
        step.footnotes.push_back({part.text, line});
        break;
    case PartKind::address:
        faults.add(line, "write a link as [words](target), not " + in_quotes(part.text) + ".");
        break;
    case PartKind::split_target:
        faults.add(line, "the target of a link must not have spaces: " + in_quotes(part.text) +
                             "; write %20 for a space.");
        break;
    case PartKind::comment:
        faults.add(line, "a comment must be on lines of its own.");
        break;
    case PartKind::definition:
        faults.add(line, "write a link where it belongs, as [words](target).");
        break;
    case PartKind::table:
        if (part.columns <= most_table_columns) break;
        faults.refuse(line, "a table may have at most " + std::to_string(most_table_columns) +
                                " columns.");
        break;
    case PartKind::nesting:
        faults.refuse(line, "the text is nested deeper than " + std::to_string(deepest_lesson) +
                                " levels.");
        break;
    }
}

} // namespace

void add_inline_parts(std::string_view text, int first_line, LessonStep& step, FaultList& faults) {
    const MarkdownDocument found = parse_as_written(text, deepest_lesson);
    for (const MarkdownPart& part : found.parts)
        add_part(part, first_line + part.line, step, faults);
    refuse_fault(found, first_line, faults);
}

} // namespace rasterwalk
