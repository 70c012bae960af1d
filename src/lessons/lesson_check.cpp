#include "lessons/lesson_check.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/quoted.h"
#include "base/text_parts.h"
#include "facts/facts.h"
#include "figures/figure_drawing.h"
#include "lessons/lesson_control.h"
#include "lessons/lesson_link.h"
#include "lessons/lesson_picture.h"
#include "lessons/lesson_run.h"
#include "lessons/puzzle_judge.h"
#include "pipeline/frame.h"
#include "session/content.h"
#include "text/math.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

/// Plays a lesson and records what goes wrong.
class Checker {
  public:
    Checker(const Lesson& lesson, const Session& like, LessonTrial& trial, const CheckWatch& watch)
        : lesson_(lesson), like_(like), trial_(trial), watch_(watch), faults_(lesson.faults) {}

    std::vector<Fault> check() {
        check_each("step", lesson_.steps, &Checker::check_step);
        check_each("task", lesson_.tasks, &Checker::check_task);
        check_each("question", lesson_.predictions, &Checker::check_prediction);
        check_each("puzzle", lesson_.puzzles, &Checker::check_puzzle);
        std::stable_sort(faults_.begin(), faults_.end(),
                         [](const Fault& a, const Fault& b) { return a.line < b.line; });
        return std::move(faults_);
    }

  private:
    template <typename Part>
    void check_each(const char* name, const std::vector<Part>& parts,
                    void (Checker::*check_part)(const Part&)) {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (watch_) watch_(fmt::format("{} {} of {}", name, i + 1, parts.size()));
            (this->*check_part)(parts[i]);
        }
    }

    /// A fault that one step passes on to the next is reported once.
    void add(int line, const std::string& sentence) {
        const Fault fault{line, sentence};
        if (std::find(faults_.begin(), faults_.end(), fault) == faults_.end()) {
            faults_.push_back(fault);
        }
    }
    void add_all(const std::vector<Fault>& faults) {
        for (const Fault& fault : faults)
            add(fault.line, fault.sentence);
    }

    Session fresh() const {
        Session session;
        session.presets = like_.presets;
        session.glossary = like_.glossary;
        return session;
    }

    // --- steps and their links

    void check_step(const LessonStep& step) {
        Session session = fresh();
        add_all(show_state(session, step.state, lesson_.folder));
        for (const TextPlace& formula : step.formulas) {
            std::vector<std::string> sentences;
            parse_math(formula.text, &sentences);
            for (const std::string& sentence : sentences)
                add(formula.line, sentence);
        }
        if (session.scene == nullptr) return;
        check_controls(step);
        // A link may build on earlier ones.
        Session walked = session;
        for (const LinkPlace& link : step.links) {
            if (link.is_picture && names_figure(link.target)) {
                check_figure(link, step);
            } else if (link.is_picture) {
                check_picture(link);
            } else {
                check_link(link, session, walked);
            }
        }
    }

    /// Controls must reach what the step opens with, and their read-outs must have numbers there.
    void check_controls(const LessonStep& step) {
        bool is_open = false; // for all of them
        for (const LessonPart& part : step.parts) {
            if (part.kind != LessonPart::Kind::control) continue;
            const LessonControl& control = lesson_.controls[static_cast<std::size_t>(part.index)];
            if (!is_open) trial_.open(step.state, lesson_.folder, like_);
            is_open = true;
            const Session& opened = trial_.session;
            const std::string misfit = misfit_of(control, opened.a.settings, *opened.scene);
            if (!misfit.empty()) add(control.line, misfit);
            if (control.read_out.empty()) continue;
            const std::string missing = missing_in(control.read_out, trial_.facts());
            if (!missing.empty()) {
                add(control.read_out_line,
                    fmt::format("'{}' has no value when the step opens.", missing));
            }
        }
    }

    /// A name in braces in the text that has no value; empty: all have one. Throws UsageError for
    /// an expression that is not understood.
    static std::string missing_in(std::string_view text, const Facts& facts) {
        std::string missing;
        fill_in(text, "", 0.0, [&](std::string_view name) {
            const Value value = facts(name);
            if (!is_there(value)) missing = std::string(name);
            return value;
        });
        return missing;
    }

    void check_words(const LinkPlace& picture, const std::string& kind) {
        if (!trimmed(picture.words).empty()) return;
        add(picture.line, "the " + kind + " " + in_quotes(picture.target) +
                              " has no text that describes it: ![text](" + kind + ").");
    }

    /// A browser must show the same drawing as the window when the step opens.
    void check_figure(const LinkPlace& place, const LessonStep& step) {
        check_words(place, "figure");
        try {
            const Figure figure = read_lesson_figure(lesson_.folder, place.target);
            if (!is_same_style(figure.style, figure_style())) {
                add(place.line, "the figure " + in_quotes(place.target) +
                                    " must have the style of all figures: copy its <style> from "
                                    "another one.");
            }
            if (figure.expressions.empty() && figure.conditions.empty()) return;
            trial_.open(step.state, lesson_.folder, like_);
            const Facts facts = trial_.facts();
            for (const std::string& sentence : stale_numbers(figure, std::cref(facts)))
                add(place.line, "the figure " + in_quotes(place.target) + ", " + sentence);
        } catch (const Error& fault) {
            add(place.line, fault.what());
        }
    }

    void check_picture(const LinkPlace& picture) {
        check_words(picture, "picture");
        // Each picture is read once.
        const auto [known, is_new] = pictures_.try_emplace(picture.target);
        if (is_new) {
            try {
                read_lesson_picture(lesson_.folder, picture.target);
            } catch (const Error& fault) {
                known->second = fault.what();
            }
        }
        if (!known->second.empty()) add(picture.line, known->second);
    }

    void check_link(const LinkPlace& place, const Session& opened, Session& walked) {
        try {
            const LessonLink link = parse_lesson_link(place.target);
            check_target(link);
            try {
                Session session = opened;
                follow(session, link);
            } catch (const Error&) {
                follow(walked, link);
                return;
            }
            // A link that cannot be followed here is no place to go on from.
            try {
                follow(walked, link);
            } catch (const Error&) {
                walked = opened;
                follow(walked, link);
            }
        } catch (const Error& fault) {
            add(place.line, fault.what());
        }
    }

    static void follow(Session& session, const LessonLink& link) {
        follow_lesson_link(session, prepare_frame(*session.scene, session.a.settings), link);
    }

    /// Reports what a link names that the session does not know.
    void check_target(const LessonLink& link) const {
        if (link.kind == LessonLink::Kind::lesson) {
            std::error_code ignored;
            const fs::path file = fs::path(lesson_.folder) / (link.argument + ".md");
            if (!fs::is_regular_file(file, ignored)) {
                throw UsageError("there is no lesson " + in_quotes(link.argument + ".md") + ".");
            }
        }
        if (link.kind != LessonLink::Kind::term) return;
        std::vector<std::string_view> words;
        for (const Term& term : like_.glossary)
            words.push_back(term.word);
        if (std::find(words.begin(), words.end(), link.argument) == words.end()) {
            throw UsageError(fmt::format("the glossary has no term {}.{}", in_quotes(link.argument),
                                         did_you_mean(link.argument, words)));
        }
    }

    // --- tasks

    const ViewState& state_of_step(int step) const {
        return lesson_.steps[static_cast<std::size_t>(step)].state;
    }

    /// The name of a formula, and the line that asks for it.
    struct AskedName {
        std::string name;
        int line = 0;
    };

    /// The formulas that the conditions and answers of a task ask for.
    static std::vector<AskedName> formulas_asked(const LessonTask& task) {
        std::vector<AskedName> asked;
        const auto add_name = [&](std::string_view name, int line) {
            if (is_formula_name(name)) asked.push_back({std::string(name), line});
        };
        const auto add_condition = [&](const Expression& condition, int line) {
            for (const ExpressionMeaning& meaning : condition.meanings)
                add_name(meaning.name, line);
        };
        add_condition(*task.done, task.done_line);
        for (const NotYet& one : task.not_yet) {
            add_condition(one.when, one.line);
            fill_in(one.says, "", 0.0, [&](std::string_view name) {
                add_name(name, one.line);
                return Value();
            });
        }
        return asked;
    }

    /// A formula that a lesson asks for may be missing for a while, but not always: then it is
    /// misspelt.
    static void keep_missing(std::vector<AskedName>& names, const Facts& facts) {
        std::erase_if(names, [&](const AskedName& one) { return is_there(facts(one.name)); });
    }

    void check_task(const LessonTask& task) {
        if (!task.done) return;
        for (const std::string& sentence : impossible_parts(*task.done))
            add(task.done_line, sentence);
        trial_.open(state_of_step(task.step), lesson_.folder, like_);
        Session& session = trial_.session;
        if (session.scene == nullptr) return;
        if (is_done(task, trial_.facts())) {
            add(task.done_line, "the task '" + task.id + "' is solved before it is started.");
            return;
        }
        const Facts opened = trial_.facts();
        for (const NotYet& one : task.not_yet) {
            for (const std::string& sentence : impossible_parts(one.when))
                add(one.line, sentence);
            if (holds(one.when, std::cref(opened))) {
                add(one.line, fmt::format("this sentence of the task '{}' already applies before "
                                          "anything is tried.",
                                          task.id));
            }
        }
        std::vector<AskedName> asked = formulas_asked(task);
        keep_missing(asked, opened);
        if (task.recipe.empty()) return; // already reported
        try {
            for (const std::string& target : task.recipe) {
                const LessonLink link = parse_lesson_link(target);
                check_target(link);
                follow(session, link);
            }
        } catch (const Error& fault) {
            add(task.recipe_line, fault.what());
            return;
        }
        finish(session, trial_.results);
        keep_missing(asked, trial_.facts());
        for (const AskedName& one : asked) {
            const std::vector<std::string> names = formula_names(trial_.facts());
            const std::vector<std::string_view> known(names.begin(), names.end());
            add(one.line, fmt::format("'{}' has no value, neither when the task '{}' opens nor "
                                      "after its recipe.{}",
                                      one.name, task.id, did_you_mean(one.name, known)));
        }
        if (!asked.empty()) return;
        if (!is_done(task, trial_.facts())) {
            add(task.recipe_line, "the recipe does not solve the task '" + task.id + "'.");
            return;
        }
        const std::string missing = missing_in(task.because, trial_.facts());
        if (!missing.empty()) {
            add(task.because_line,
                fmt::format("'{}' has no value when the task '{}' is solved.", missing, task.id));
        }
    }

    // --- predictions

    void check_prediction(const LessonPrediction& prediction) {
        Session session = fresh();
        const std::vector<Fault> faults = show_state(session, prediction.at, lesson_.folder);
        add_all(faults);
        if (prediction.then) {
            Session shown = fresh();
            add_all(show_state(shown, *prediction.then, lesson_.folder));
        }
        if (!faults.empty() || !is_complete(prediction) || !check_because(prediction)) return;
        check_misconceptions(prediction);
        if (prediction.kind == LessonPrediction::Kind::pixel) {
            check_pixel(prediction);
        } else {
            const GivenAnswer none{prediction.kind == LessonPrediction::Kind::number
                                       ? GivenAnswer{0.0}
                                       : GivenAnswer{0}};
            const Judgement judgement = judge(lesson_, prediction, none, like_, trial_);
            if (!judgement.fault.empty()) {
                add(prediction.answer_line,
                    fmt::format("the prediction '{}': {}", prediction.id, judgement.fault));
            }
        }
    }

    /// Answers from misconceptions must be wrong, and all replies must have their numbers.
    void check_misconceptions(const LessonPrediction& prediction) {
        if (prediction.misconceptions.empty()) return;
        const GivenAnswer none{prediction.kind == LessonPrediction::Kind::number ? GivenAnswer{0.0}
                                                                                 : GivenAnswer{0}};
        const Judgement own = judge(lesson_, prediction, none, like_, trial_);
        ViewState at = prediction.at;
        if (prediction.wrong_pixel) at.pixel = prediction.wrong_pixel;
        trial_.open(at, lesson_.folder, like_);
        const Facts facts = trial_.facts();
        const auto value = [&](const std::optional<Expression>& expression) {
            return expression ? number_of(*expression, std::cref(facts)) : std::optional(0.0);
        };
        for (const Misconception& one : prediction.misconceptions) {
            const std::string missing = missing_in(one.says, facts);
            if (!missing.empty()) {
                add(one.line,
                    fmt::format("'{}' has no value in the situation of the prediction '{}'.",
                                missing, prediction.id));
            }
            bool is_right = own.fault.empty() && one.choice >= 0 && one.choice == own.choice;
            if (prediction.kind == LessonPrediction::Kind::pixel) {
                for (const std::string& sentence : impossible_parts(*one.answer))
                    add(one.line, sentence);
            } else if (prediction.kind == LessonPrediction::Kind::number) {
                const auto number = value(one.answer);
                const auto off = value(one.tolerance ? one.tolerance : prediction.tolerance);
                if (!number || !off) {
                    add(one.line,
                        fmt::format("this answer to '{}' is not a number.", prediction.id));
                    continue;
                }
                // A near miss of the right answer is not a misconception.
                const double reach =
                    std::abs(*off) + std::abs(value(prediction.tolerance).value_or(0));
                is_right = own.fault.empty() && std::abs(*number - own.number) <= reach;
            }
            if (is_right) {
                add(one.line, fmt::format("the prediction '{}' accepts the answer of this "
                                          "misconception as right.",
                                          prediction.id));
            }
        }
    }

    static bool is_complete(const LessonPrediction& prediction) {
        switch (prediction.kind) {
        case LessonPrediction::Kind::number:
            return prediction.answer.has_value();
        case LessonPrediction::Kind::choice:
            return prediction.choices.size() >= 2 &&
                   prediction.choices.size() == prediction.right.size();
        case LessonPrediction::Kind::pixel:
            return prediction.where && prediction.right_pixel && prediction.wrong_pixel;
        }
        return false;
    }

    void check_pixel(const LessonPrediction& prediction) {
        for (const std::string& sentence : impossible_parts(*prediction.where))
            add(prediction.answer_line, sentence);
        const Judgement right =
            judge(lesson_, prediction, {*prediction.right_pixel}, like_, trial_);
        const Judgement wrong =
            judge(lesson_, prediction, {*prediction.wrong_pixel}, like_, trial_);
        for (const Judgement* judgement : {&right, &wrong}) {
            if (!judgement->fault.empty()) add(prediction.answer_line, judgement->fault);
        }
        if (right.fault.empty() && !right.is_right) {
            add(prediction.answer_line, "the pixel of 'recipe' does not satisfy 'where'.");
        }
        if (wrong.is_right) {
            add(prediction.answer_line, "the pixel of 'wrong' satisfies 'where'.");
        }
    }

    /// Every number shown after the answer must exist. False if it cannot be read.
    bool check_because(const LessonPrediction& prediction) {
        if (prediction.because.empty()) return true;
        ViewState at = prediction.at;
        if (prediction.right_pixel) at.pixel = prediction.right_pixel;
        trial_.open(at, lesson_.folder, like_);
        try {
            const std::string missing = missing_in(prediction.because, trial_.facts());
            if (!missing.empty()) {
                add(prediction.because_line,
                    fmt::format("'{}' has no value in the situation of the prediction '{}'.",
                                missing, prediction.id));
            }
        } catch (const Error& fault) {
            add(prediction.because_line, fault.what());
            return false;
        }
        return true;
    }

    /// Its own lines must be right, and must not be so in the order in which they are offered.
    void check_puzzle(const LessonPuzzle& puzzle) {
        const PuzzleVerdict own = judge_order(puzzle, right_order(puzzle));
        if (!own.is_right) {
            add(own.line > 0 ? puzzle.code_line : puzzle.line,
                fmt::format("the code of '{}' does not pass its own questions. {}", puzzle.id,
                            own.sentence));
        }
        std::vector<PlacedPiece> offered;
        for (const int piece : puzzle.order)
            offered.push_back({piece, 1});
        if (judge_order(puzzle, offered).is_right) {
            add(puzzle.line,
                fmt::format("the lines of '{}' are right as they are offered.", puzzle.id));
        }
    }

    const Lesson& lesson_;
    const Session& like_;
    LessonTrial& trial_;
    const CheckWatch& watch_;
    std::vector<Fault> faults_;
    std::map<std::string, std::string> pictures_; ///< the fault of each; empty: none
};

} // namespace

std::vector<Fault> check_lesson(const Lesson& lesson, const Session& session) {
    LessonTrial trial;
    return check_lesson(lesson, session, trial);
}

std::vector<Fault> check_lesson(const Lesson& lesson, const Session& session, LessonTrial& trial,
                                const CheckWatch& watch) {
    return Checker(lesson, session, trial, watch).check();
}

Session empty_session() {
    Session session;
    session.presets = read_presets(lessons_folder() + "/presets.toml");
    session.glossary = read_glossary(lessons_folder() + "/glossary.toml");
    return session;
}

} // namespace rasterwalk
