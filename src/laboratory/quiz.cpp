#include "laboratory/quiz.h"

#include <algorithm>
#include <utility>

#include "base/dice.h"
#include "laboratory/bug.h"
#include "laboratory/bug_rule.h"
#include "laboratory/image_variant.h"
#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "session/glossary.h"
#include "session/session.h"
#include "stages/stages.h"

namespace rasterwalk {

namespace {

/// A power at which the lamp shows next to the indirect light.
constexpr float visible_power = 14.0f;

/// The larger side, pixels, of the picture for testing which mistakes show.
constexpr int largest_tried = 500;

std::uint64_t print_of(const Scene& scene, const Settings& settings) {
    return fingerprint(view_image(draw_frame(prepare_frame(scene, settings)), View::colour));
}

/// The settings that a quiz begins with, without any mistake.
Settings quiz_settings(const Session& session) {
    Settings settings = with_handout_rules(session.a.settings);
    set_step(settings, StripStep::pixel_light);
    settings.light.power = glm::max(settings.light.power, glm::vec3(visible_power));
    return settings;
}

/// The same, with a picture small enough to be drawn once for each mistake while the student waits.
Settings settings_to_try(const Session& session) {
    Settings settings = quiz_settings(session);
    Viewport& size = settings.viewport;
    const int larger = std::max(size.width, size.height);
    if (larger <= largest_tried || session.scene->space == SceneSpace::pixels) return settings;
    const float share = static_cast<float>(largest_tried) / static_cast<float>(larger);
    const auto shrunk = [&](int side) {
        return std::max(static_cast<int>(share * static_cast<float>(side)), 1);
    };
    size = {shrunk(size.width), shrunk(size.height)};
    settings.camera.focal_length *= share;
    return settings;
}

Settings with_bug(Settings settings, const Bug& bug) {
    apply_bug_rule(bug, settings);
    return settings;
}

/// The mistakes that show, each with the fingerprint of its picture.
struct Shown {
    std::vector<const Bug*> bugs;
    std::vector<std::uint64_t> prints;
};

Shown bugs_that_show(const Session& session, const std::vector<Bug>& bugs) {
    Shown shown;
    const Settings right = settings_to_try(session);
    const std::uint64_t reference = print_of(*session.scene, right);
    for (const Bug& bug : bugs) {
        if (!changes_rule(bug)) continue;
        const Settings wrong = with_bug(right, bug);
        if (wrong == right) continue;
        const std::uint64_t print = print_of(*session.scene, wrong);
        if (print == reference) continue;
        shown.bugs.push_back(&bug);
        shown.prints.push_back(print);
    }
    return shown;
}

std::string first_stage(const Scene& scene, const Settings& right, const Bug& bug) {
    for (const StageInfo& info : stage_list()) {
        Settings settings = right;
        set_step(settings, info.step);
        if (print_of(scene, settings) != print_of(scene, with_bug(settings, bug))) {
            return std::string(info.name);
        }
    }
    return "";
}

QuizQuestion question_about(const Session& session, const Shown& shown, std::size_t chosen) {
    QuizQuestion question;
    question.bugs.push_back(shown.bugs[chosen]->id);
    for (std::size_t i = 0; i < shown.bugs.size(); ++i) {
        if (i != chosen && shown.prints[i] == shown.prints[chosen]) {
            question.bugs.push_back(shown.bugs[i]->id);
        }
    }
    question.first_stage =
        first_stage(*session.scene, settings_to_try(session), *shown.bugs[chosen]);
    return question;
}

/// Can both be made together so that each still shows?
bool can_meet(const Session& session, const Shown& shown, std::size_t a, std::size_t b) {
    if (a == b || shown.prints[a] == shown.prints[b]) return false;
    for (const auto& [name, value] : shown.bugs[a]->set) {
        for (const auto& [other, ignored] : shown.bugs[b]->set) {
            if (name == other && name != "stage") return false;
        }
    }
    const Settings both =
        with_bug(with_bug(settings_to_try(session), *shown.bugs[a]), *shown.bugs[b]);
    const std::uint64_t print = print_of(*session.scene, both);
    return print != shown.prints[a] && print != shown.prints[b];
}

/// One or two mistakes, by number; two only if two can be made together.
std::vector<std::size_t> choose(const Session& session, const Shown& shown, int count, Dice& dice) {
    const std::size_t all = shown.bugs.size();
    const std::size_t first = dice.below(all), second = dice.below(all);
    for (std::size_t i = 0; count > 1 && i < all * all; ++i) {
        const std::size_t a = (first + i / all) % all, b = (second + i) % all;
        if (can_meet(session, shown, a, b)) return {a, b};
    }
    return {first};
}

} // namespace

bool start_quiz(Session& session, const std::vector<Bug>& bugs, std::uint32_t seed, int count) {
    end_quiz(session);
    end_comparison(session);
    const Shown shown = bugs_that_show(session, bugs);
    if (shown.bugs.empty()) return false;
    Dice dice(seed);
    Quiz quiz;
    quiz.seed = seed;
    quiz.before = session.a.settings;
    Settings settings = quiz_settings(session);
    const std::vector<std::size_t> chosen = choose(session, shown, count, dice);
    for (const std::size_t i : chosen) {
        quiz.questions.push_back(question_about(session, shown, i));
        apply_bug_rule(*shown.bugs[i], settings);
    }
    session.a.settings = settings;
    session.quiz = std::move(quiz);
    session.undo = {};
    return true;
}

Settings quiz_reference(const Session& session) {
    Settings settings = with_handout_rules(session.a.settings);
    if (session.quiz) {
        // The lamp's power may be the mistake.
        settings.light.power = glm::max(session.quiz->before.light.power, glm::vec3(visible_power));
    }
    return settings;
}

bool guess(Quiz& quiz, std::string_view bug) {
    for (const QuizGuess& before : quiz.guesses) {
        if (before.bug == bug) return before.is_right;
    }
    const bool is_right = std::any_of(
        quiz.questions.begin(), quiz.questions.end(), [&](const QuizQuestion& question) {
            return std::find(question.bugs.begin(), question.bugs.end(), bug) !=
                   question.bugs.end();
        });
    if (!is_over(quiz)) quiz.guesses.push_back({std::string(bug), is_right});
    return is_right;
}

std::vector<std::string> quiz_hints(const QuizQuestion& question, const std::vector<Bug>& bugs) {
    const Bug* const bug = question.bugs.empty() ? nullptr : bug_of_id(bugs, question.bugs.front());
    if (bug == nullptr) return {};
    const StageInfo* const stage = find_stage(question.first_stage);
    const std::string title(stage == nullptr ? question.first_stage : stage->title);
    return {"It belongs to “" + section_words(bug->section) + "”.",
            "It first shows at the " + title + " stage.", bug->symptom, bug->look};
}

bool give_hint(Quiz& quiz, const std::vector<Bug>& bugs) {
    if (is_over(quiz)) return false;
    for (QuizQuestion& question : quiz.questions) {
        if (is_found(quiz, question)) continue;
        if (question.hints >= static_cast<int>(quiz_hints(question, bugs).size())) continue;
        ++question.hints;
        return true;
    }
    return false;
}

std::vector<std::string> hints_given(const Quiz& quiz, const std::vector<Bug>& bugs) {
    std::vector<std::string> given;
    for (const QuizQuestion& question : quiz.questions) {
        const std::vector<std::string> hints = quiz_hints(question, bugs);
        const std::size_t count =
            std::min(hints.size(), static_cast<std::size_t>(std::max(question.hints, 0)));
        given.insert(given.end(), hints.begin(), hints.begin() + static_cast<long>(count));
    }
    return given;
}

int score(const Quiz& quiz) {
    int points = 0;
    for (const QuizQuestion& question : quiz.questions) {
        if (!is_found(quiz, question)) continue;
        points += std::max(0, points_of_question - cost_of_hint * question.hints);
    }
    for (const QuizGuess& guess : quiz.guesses)
        points -= guess.is_right ? 0 : cost_of_wrong_guess;
    return std::max(points, 0);
}

} // namespace rasterwalk
