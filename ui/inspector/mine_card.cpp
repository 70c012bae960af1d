#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "engines/program_drawing.h"
#include "text/markdown_text.h"
#include "ui/actions/lab.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/mine.h"
#include "ui/inspector/lab_parts.h"
#include "ui/inspector/mine_parts.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// The most messages of a compiler that are listed: the first is the one to mend.
constexpr std::size_t most_messages = 12;
constexpr const char* walk_label = "Walk to where the order parts";
constexpr std::size_t most_text = 600; ///< letters of what a compiler or a program says

/// A named sentence that wraps; nothing if it is empty.
void say(Ui& ui, const std::string& name, const std::string& words, const std::string& help = {}) {
    if (words.empty()) return;
    wrapped_text(words);
    register_widget(ui, name, help, words);
}

void say_quietly(Ui& ui, const std::string& name, const std::string& words,
                 const std::string& help = {}) {
    if (words.empty()) return;
    wrapped_text_in(palette(ui.options.theme).dim, words, ui.fonts.small);
    register_widget(ui, name, help, words);
}

/// A message of the compiler, a link to its line, and what is likely to be its cause.
void draw_message(Ui& ui, const CheckedProgram& checked, std::size_t index) {
    MineLook& mine = ui.mine;
    const CompileMessage& message = checked.compiled.messages[index];
    const std::string name = fmt::format("mine.message.{}", index);
    const std::string place = place_text(checked, {{}, message.file, message.line});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
    if (!place.empty() && button(ui, name, place, mine.message == index ? Look::quiet : Look::link,
                                 "Shows this line.")) {
        mine.message = index;
    }
    ImGui::PopStyleVar();
    if (message.is_error) {
        say(ui, name + ".text", clean_text(message.text.substr(0, most_text)));
    } else {
        say_quietly(ui, name + ".text", clean_text(message.text.substr(0, most_text)));
    }
    say_quietly(ui, name + ".cause", message.cause, "What this message usually means.");
    if (mine.message == index) draw_source(ui, checked, {{}, message.file, message.line});
}

void draw_messages(Ui& ui, const CheckedProgram& checked) {
    const auto& messages = checked.compiled.messages;
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < messages.size(); ++i)
        if (messages[i].is_error || checked.compiles()) shown.push_back(i);
    if (shown.empty()) {
        say(ui, "mine.compiled",
            checked.compiles() ? "It compiles without a message."
                               : "It does not compile, and the compiler says more than is kept; "
                                 "the error is not in what is.");
        return;
    }
    const bool is_shown = std::find(shown.begin(), shown.end(), ui.mine.message) != shown.end();
    if (!is_shown) ui.mine.message = shown.front();
    const std::size_t left = shown.size() > most_messages ? shown.size() - most_messages : 0;
    if (left > 0) shown.resize(most_messages);
    for (const std::size_t index : shown)
        draw_message(ui, checked, index);
    if (left > 0)
        say_quietly(ui, "mine.messages.more",
                    fmt::format("and {}", counted(static_cast<std::int64_t>(left), "more",
                                                  "more, which may follow from these")));
}

void draw_run(Ui& ui, const CheckedProgram& checked) {
    const ProgramRun& run = *checked.run;
    for (std::size_t i = 0; i < run.faults.size(); ++i) {
        say(ui, fmt::format("mine.fault.{}", i), run.faults[i].sentence);
        if (i == 0) draw_source(ui, checked, run.faults[i].place);
    }
    if (run.faults.empty())
        say(ui, "mine.ran",
            run.has_frame() ? "It drew its first frame to the end." : "It drew no frame.");
    for (std::size_t i = 0; i < run.refused.size(); ++i) {
        const RefusedCall& call = run.refused[i];
        const std::string place = place_text(checked, call.place);
        say(ui, fmt::format("mine.refused.{}", i),
            fmt::format("It was not allowed {}{}{}.", call.what,
                        call.count > 1 ? fmt::format(", {} times", call.count) : "",
                        place.empty() ? "" : ": " + place),
            "A program that is checked may not do this; it went on without it.");
    }
    if (!run.has_landlock)
        say_quietly(ui, "mine.no_landlock",
                    "This system cannot restrict which files a program reads; it was kept from "
                    "writing any.");
    if (!run.output.empty())
        say_quietly(ui, "mine.output", "It printed: " + clean_text(run.output.substr(0, most_text)),
                    "What the program wrote to its output.");
}

/// Where the function died; line 0: it did not, or that is not known.
ProgramPlace place_of_fault(const CheckedProgram& checked, const FunctionCheck& check) {
    for (const ProgramFault& fault : checked.run->faults)
        if (fault.part == check.part && fault.place.line > 0) return fault.place;
    return {};
}

const ProgramPlace& definition_in(Ui& ui, const CheckedProgram& checked,
                                  const FunctionCheck& check) {
    MineLook& mine = ui.mine;
    // Its sources are searched once, not in each frame.
    if (mine.defined_in != mine.number || mine.defined_at.function != check.function) {
        mine.defined_at = definition_of(checked.files, check.function);
        mine.defined_at.function = check.function;
        mine.defined_in = mine.number;
    }
    return mine.defined_at;
}

/// What the picture alone suggests, if no function contradicts it; empty: nothing.
std::vector<std::string> mistakes_of_picture(const CheckedProgram& checked) {
    const auto& picture = checked.picture;
    if (!picture || picture->is_right || !picture->is_judged) return {};
    const Candidate* const likely = likely_candidate(picture->diagnosis);
    return likely == nullptr ? std::vector<std::string>() : likely->ids();
}

void draw_function(Ui& ui, const CheckedProgram& checked, const FunctionCheck& check) {
    std::vector<std::string> bugs = check.bugs.empty() ? check.together : check.bugs;
    name_mistakes(ui, bugs);
    // What the answers do not name, the picture may.
    if (bugs.empty() && check.state == CheckState::wrong) {
        bugs = mistakes_of_picture(checked);
        if (!bugs.empty()) say(ui, "mine.by_picture", "The picture points to a mistake:");
        name_mistakes(ui, bugs);
    }
    say_quietly(ui, "mine.fed", check.fed.empty() ? "" : "Asked with " + check.fed + ".",
                "The input is ours, so a mistake in another function does not show here.");
    say(ui, "mine.rule", check.rule, "How it works, as its answers show; other ways are as right.");
    say(ui, "mine.first", check.first, "The first of our questions that it answers differently.");
    for (std::size_t i = 0; i < check.causes.size(); ++i)
        say(ui, fmt::format("mine.cause.{}", i), check.causes[i],
            "This alone explains all of its answers.");
    if (check.state == CheckState::wrong || check.state == CheckState::died) {
        draw_both_row_tables(ui, check);
        const ProgramPlace fault = place_of_fault(checked, check);
        if (fault.line > 0) {
            draw_source(ui, checked, fault);
        } else {
            draw_source(ui, checked, definition_in(ui, checked, check), PlaceKind::definition);
        }
    }
    for (std::size_t i = 0; i < check.notes.size(); ++i)
        say_quietly(ui, fmt::format("mine.note.{}", i), check.notes[i]);
    draw_remedies(ui, bugs);
}

void draw_pictures(Ui& ui, const CheckedProgram& checked) {
    const PictureCheck& picture = *checked.picture;
    LabPictures& pictures = ui.mine.pictures;
    if (ui.mine.pictures_of != ui.mine.number) {
        pictures.own = picture.theirs;
        pictures.right = picture.right;
        ++pictures.number;
        ui.mine.pictures_of = ui.mine.number;
    }
    draw_lab_pictures(ui, pictures, "mine",
                      {picture.is_right ? "Ours" : "Where it differs",
                       picture.is_right ? "The same but for rounding." : "Orange: different."});
}

/// Both as two runs: the whole picture, and the walk to where the orders of pixels part.
void draw_ways_to_compare(Ui& ui, const PictureCheck& picture) {
    if (button(ui, "mine.compare", "Compare with ours", picture.is_right ? Look::plain : Look::main,
               "Shows your picture as run B and ours as run A, with a divider between them.")) {
        compare_my_program(ui, false);
    }
    same_line_if_room(walk_label);
    if (!picture.is_right && button(ui, "mine.walk", walk_label, Look::plain,
                                    "Stands at the moment where your program first puts a pixel in "
                                    "another place than ours; from there you can walk through "
                                    "both.")) {
        compare_my_program(ui, true);
    }
}

void draw_no_picture(Ui& ui, const CheckedProgram& checked) {
    if (!draws_nothing(*checked.run)) {
        say(ui, "mine.picture", "There is no picture that could be compared with ours.");
        return;
    }
    say(ui, "mine.picture", "Your program puts no pixel on the screen.");
    const auto next = std::find_if(
        checked.functions.begin(), checked.functions.end(),
        [](const FunctionCheck& check) { return check.state == CheckState::not_written; });
    if (next != checked.functions.end())
        say(ui, "mine.next",
            fmt::format("{} comes next: it is not written yet, or does nothing.", next->function));
    for (std::size_t i = 0; i < checked.functions.size(); ++i) {
        const FunctionCheck& check = checked.functions[i];
        if (check.state == CheckState::not_written && !check.notes.empty())
            say_quietly(ui, fmt::format("mine.nothing.{}", i),
                        check.function + ": " + check.notes.front(), "Why nothing may be drawn.");
    }
}

void draw_picture(Ui& ui, const CheckedProgram& checked) {
    if (!checked.picture) {
        draw_no_picture(ui, checked);
        return;
    }
    const PictureCheck& picture = *checked.picture;
    const std::vector<std::string> bugs = mistakes_of_picture(checked);
    name_mistakes(ui, bugs);
    if (!picture.is_right)
        say(ui, "mine.picture",
            picture.is_judged ? picture.diagnosis.verdict : std::string(not_judged_words(checked)));
    draw_pictures(ui, checked);
    if (has_known_order(*checked.run)) draw_ways_to_compare(ui, picture);
    say(ui, "mine.picture.place", picture.diagnosis.place);
    for (std::size_t i = 0; i < picture.diagnosis.findings.size(); ++i)
        say(ui, fmt::format("mine.finding.{}", i), picture.diagnosis.findings[i],
            "What the pixels that differ have in common.");
    if (!picture.diagnosis.rules.empty())
        say_quietly(ui, "mine.picture.rules", "It is drawn with " + picture.diagnosis.rules + ".",
                    "Ours is drawn by the same rules.");
    draw_remedies(ui, bugs);
}

void draw_sequence(Ui& ui, const CheckedProgram& checked) {
    if (!checked.sequence) {
        say(ui, "mine.sequence",
            checked.picture && checked.picture->is_right
                ? "Your program writes pixels by itself, without PutPixelSDL, so their order is "
                  "not known."
                : "The order is compared once the picture is right.");
        return;
    }
    const auto& parting = checked.sequence->parting;
    say(ui, "mine.sequence",
        parting ? parting_text(*parting) + " Any order that gives the right picture is right."
                : counted(checked.sequence->puts, "pixel is", "pixels are") +
                      " put, in the same order as ours.");
}

void draw_keys(Ui& ui, const CheckedProgram& checked) {
    if (!checked.is_key_tested) {
        const auto& messages = checked.sanitizer_messages;
        const auto error = std::find_if(messages.begin(), messages.end(),
                                        [](const CompileMessage& one) { return one.is_error; });
        say(ui, "mine.keys",
            error == messages.end() ? "It was not run with sanitizers."
                                    : "With sanitizers it does not compile: " +
                                          clean_text(error->text.substr(0, most_text)));
        return;
    }
    if (checked.key_faults.empty())
        say(ui, "mine.keys", "With sanitizers, and with each of its keys held, nothing was found.");
    for (std::size_t i = 0; i < checked.key_faults.size(); ++i) {
        const KeyFault& fault = checked.key_faults[i];
        const std::string when =
            fault.key.name.empty()
                ? "In the first frame"
                : fmt::format("While {} is held, in frame {}", fault.key.name, fault.frame);
        say(ui, fmt::format("mine.key_fault.{}", i), when + ": " + fault.fault.sentence);
        if (i == 0) draw_source(ui, checked, fault.fault.place);
    }
}

/// Mistakes that belong to no line: a function that is written and not called.
void draw_rest(Ui& ui, const CheckedProgram& checked, const CheckLine& line) {
    if (line.kind != CheckLineKind::picture && line.kind != CheckLineKind::ran) return;
    for (const LikelyMistake& mistake : checked.mistakes)
        if (mistake.is_not_called) say(ui, "mine.not_called", mistake.sentence);
}

} // namespace

void name_mistakes(Ui& ui, const std::vector<std::string>& ids) {
    std::string names;
    for (const std::string& id : ids) {
        const Bug* const bug = bug_of_id(lab_bugs(ui), id);
        if (bug != nullptr) names += (names.empty() ? "" : ", or ") + bug->id + " " + bug->name;
    }
    if (names.empty()) return;
    wrapped_text_in(colour_of(Meaning::fail, ui.options.theme), "Known mistake: " + names,
                    ui.fonts.bold);
    register_widget(ui, "mine.known", "A mistake of the laboratory; more about it is below.",
                    names);
}

void draw_remedies(Ui& ui, const std::vector<std::string>& ids) {
    std::string text;
    for (const std::string& id : ids) {
        const Bug* const bug = bug_of_id(lab_bugs(ui), id);
        if (bug == nullptr) continue;
        text += (text.empty() ? "" : "\n\n") + std::string("**") + bug->id + ".** " +
                as_markdown(bug->sentence) + "\n\n" + remedy_of(ui, *bug);
    }
    if (text.empty()) return;
    ImGui::Spacing();
    const MarkdownEvents events =
        draw_markdown(ui, ui.mine.remedy, text, ImGui::CalcItemWidth(), "mine.link.");
    register_widget(ui, "mine.remedy", "What the laboratory says about it, and how to mend it.",
                    text);
    answer_links(ui, document_of(*ui.mine.remedy), events);
}

void draw_line_card(Ui& ui, const CheckedProgram& checked, const CheckLine& line) {
    begin_card(ui);
    put_text(line.name, ui.fonts.bold);
    if (line.state == CheckLineState::waiting) {
        say_quietly(ui, "mine.waiting", ui.mine.check ? "Not checked yet." : "Not checked.");
        end_card(ui);
        return;
    }
    draw_rest(ui, checked, line);
    switch (line.kind) {
    case CheckLineKind::compiled:
        draw_messages(ui, checked);
        break;
    case CheckLineKind::ran:
        draw_run(ui, checked);
        break;
    case CheckLineKind::function:
        draw_function(ui, checked, checked.functions[line.function]);
        break;
    case CheckLineKind::picture:
        draw_picture(ui, checked);
        break;
    case CheckLineKind::sequence:
        draw_sequence(ui, checked);
        break;
    case CheckLineKind::keys:
        draw_keys(ui, checked);
        break;
    }
    end_card(ui);
}

} // namespace rasterwalk
