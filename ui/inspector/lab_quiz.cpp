#include <algorithm>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "laboratory/quiz.h"
#include "session/second_run.h"
#include "text/markdown_text.h"
#include "ui/actions/lab.h"
#include "ui/actions/lesson_links.h"
#include "ui/inspector/lab_parts.h"
#include "ui/page/markdown.h"
#include "ui/ui.h"
#include "ui/widgets/formula_view.h"
#include "ui/widgets/line_clip.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

std::string titled(Ui& ui, const std::string& id) {
    const Bug* const bug = bug_of_id(lab_bugs(ui), id);
    return bug == nullptr ? id : id + " " + bug->name;
}

void draw_score(Ui& ui) {
    const QuizScore& score = ui.options.score;
    if (score.rounds == 0) return;
    text_in(palette(ui.options.theme).dim, counted(score.points, "point", "points") + " in " +
                                               counted(score.rounds, "round", "rounds"));
    register_widget(ui, "lab.points",
                    score.is_kept ? "In all rounds since you began keeping score."
                                  : "Since the program was opened.");
}

/// The score is kept only if the student wants it.
void draw_keeping(Ui& ui) {
    QuizScore& score = ui.options.score;
    ImGui::Checkbox("keep my score", &score.is_kept);
    register_widget(ui, "lab.keep_score",
                    "Your points are still there the next time you open the program.");
    if (score.rounds == 0) return;
    ImGui::SameLine();
    if (button(ui, "lab.reset_score", "forget it", Look::quiet, "Sets points and rounds to 0.")) {
        score.points = score.rounds = 0;
    }
}

void draw_beginning(Ui& ui) {
    wrapped_text("The program makes a mistake in the open scene and hides the settings. Find out "
                 "which mistake it is, using the tabs, the overlays, the timeline and a look at "
                 "the correct run.");
    ImGui::Spacing();
    ImGui::Checkbox("two mistakes at once", &ui.lab.wants_two);
    register_widget(ui, "lab.two", "Harder: two mistakes that show side by side.");
    ImGui::SetNextItemWidth(120.0f * ui.options.text_scale);
    ImGui::InputInt("seed (0: any)", &ui.lab.seed, 0);
    ui.lab.seed = std::clamp(ui.lab.seed, 0, 999'999);
    register_widget(ui, "lab.seed",
                    "The same number makes the same quiz for everyone. With 0, the program picks a "
                    "number.");
    draw_keeping(ui);
    ImGui::Spacing();
    if (button(ui, "lab.quiz.start", "begin", Look::main,
               "Makes a mistake. The current settings come back when the quiz ends.")) {
        begin_quiz(ui);
    }
    draw_score(ui);
}

void draw_correct_run_switch(Ui& ui) {
    const bool comparing = ui.session.b.has_value();
    if (button(ui, "lab.quiz.compare",
               comparing ? "without the correct run" : "next to the correct run",
               comparing ? Look::chosen : Look::plain,
               "Shows where the picture is wrong; the question is why.")) {
        if (comparing) {
            stop_comparing(ui.session);
        } else {
            compare_with(ui.session, quiz_reference(ui.session));
        }
    }
}

void draw_hints(Ui& ui) {
    const std::vector<std::string> hints = hints_given(*ui.session.quiz, lab_bugs(ui));
    if (hints.empty()) return;
    std::string text = "**Hints**\n\n";
    for (const std::string& hint : hints)
        text.append("- ")
            .append(hint.find("](") == hint.npos ? as_markdown(hint) : hint)
            .append("\n");
    const MarkdownEvents events =
        draw_markdown(ui, ui.lab.page, text, ImGui::CalcItemWidth(), "lab.hint.");
    answer_links(ui, document_of(*ui.lab.page), events);
}

void draw_guesses(Ui& ui) {
    for (const QuizGuess& guess : ui.session.quiz->guesses) {
        const Meaning meaning = guess.is_right ? Meaning::pass : Meaning::fail;
        text_in(colour_of(meaning, ui.options.theme),
                shortened((guess.is_right ? "✓ " : "✗ ") + titled(ui, guess.bug),
                          ImGui::CalcItemWidth()));
    }
}

/// A possible answer; its tooltip describes it.
void draw_choice(Ui& ui, const Bug& bug) {
    const std::string name = "lab.choice." + bug.id;
    if (ImGui::Selectable((bug.id + "  " + bug.name + "###" + name).c_str(),
                          ui.lab.chosen == bug.id)) {
        ui.lab.chosen = bug.id;
    }
    keep_selectable_whole();
    register_widget(ui, name, bug.sentence);
}

void draw_question_card(Ui& ui) {
    Quiz& quiz = *ui.session.quiz;
    begin_card(ui);
    draw_guesses(ui);
    const bool has_choice = bug_of_id(lab_bugs(ui), ui.lab.chosen) != nullptr;
    ImGui::BeginDisabled(!has_choice);
    const bool is_small = ui.inspector.is_narrow || ui.inspector.is_low;
    const std::string label = has_choice ? "it is " + ui.lab.chosen
                              : is_small ? "choose"
                                         : "choose one above";
    if (button(ui, "lab.guess", label, Look::main,
               "Submits the guess. A wrong one costs " + std::to_string(cost_of_wrong_guess) +
                   " points.")) {
        guess(quiz, ui.lab.chosen);
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (button(ui, "lab.hint", "hint", Look::plain,
               "Tells you a little more. Costs " + std::to_string(cost_of_hint) + " points.")) {
        if (!give_hint(quiz, lab_bugs(ui))) ui.session.notice = "There are no more hints.";
    }
    ImGui::SameLine();
    if (button(ui, "lab.give_up", "give up", Look::quiet, "Tells you which mistake it is.")) {
        quiz.given_up = true;
    }
    draw_hints(ui);
    end_card(ui);
}

void draw_answer(Ui& ui) {
    const Quiz& quiz = *ui.session.quiz;
    const bool won = is_solved(quiz);
    begin_card(ui);
    text_in(colour_of(won ? Meaning::pass : Meaning::fail, ui.options.theme),
            won ? "✓ Found: " + std::to_string(score(quiz)) + " points" : "Not found",
            ui.fonts.bold);
    register_widget(ui, "lab.verdict",
                    "A hundred points for each mistake, minus hints and wrong guesses.");
    for (const QuizQuestion& question : quiz.questions) {
        std::string names;
        for (const std::string& id : question.bugs)
            names += (names.empty() ? "" : ", or ") + titled(ui, id);
        wrapped_text("It was " + names + ".");
        const Bug* const bug = bug_of_id(lab_bugs(ui), question.bugs.front());
        if (bug == nullptr) continue;
        ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.options.theme).dim);
        wrapped_text(bug->sentence);
        wrapped_text("Cure: " + bug->cure);
        ImGui::PopStyleColor();
    }
    if (button(ui, "lab.quiz.again", "another one", Look::main,
               "Ends this quiz and starts a new "
               "one.")) {
        finish_quiz(ui);
        begin_quiz(ui);
    }
    ImGui::SameLine();
    if (button(ui, "lab.quiz.end", "end", Look::plain,
               "Brings back the settings from before the quiz.")) {
        finish_quiz(ui);
    }
    end_card(ui);
}

} // namespace

void draw_lab_quiz(Ui& ui) {
    if (!ui.session.quiz) {
        draw_beginning(ui);
        return;
    }
    const Quiz& quiz = *ui.session.quiz;
    put_text(quiz.questions.size() == 1 ? "Which mistake is it?" : "Which two mistakes are they?",
             ui.fonts.bold);
    ImGui::SameLine();
    text_in(palette(ui.options.theme).dim, "seed " + std::to_string(quiz.seed));
    register_widget(ui, "lab.quiz.seed", "The same seed makes the same quiz.");
    draw_correct_run_switch(ui);
    if (is_over(quiz)) {
        draw_answer(ui);
        if (ui.session.quiz) draw_score(ui);
        return;
    }
    ImGui::SameLine();
    if (button(ui, "lab.quiz.stop", "end", Look::quiet,
               "Ends the quiz and brings back the settings from before.")) {
        finish_quiz(ui);
        return;
    }
    // Where lines are few: one list that scrolls, with the card in it, like the list of mistakes.
    const bool has_card = ui.inspector.has_card;
    const Bug* const chosen = bug_of_id(lab_bugs(ui), ui.lab.chosen);
    // The list of the mistakes may have shown the same one.
    if (chosen == nullptr && !has_card) ui.lab.in_sight.clear();
    std::vector<PanelBlock> choices{{[] {}, chosen == nullptr}};
    for (const Bug& bug : lab_bugs(ui)) {
        const bool is_chosen = &bug == chosen;
        const auto draw = [&ui, &bug, is_kept = is_chosen && !has_card] {
            draw_choice(ui, bug);
            if (is_kept) keep_in_sight(ui, bug, height_of_card_head());
        };
        choices.push_back({draw, is_chosen});
    }
    draw_panel(ui, "quiz", choices, [&] { draw_question_card(ui); });
}

} // namespace rasterwalk
