#include "lessons/task_luck.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/dice.h"
#include "lessons/lesson_link.h"
#include "pipeline/frame.h"
#include "pipeline/timeline.h"
#include "settings/control_range.h"

namespace rasterwalk {

namespace {

/// Where on its slider to try a number.
enum class Stop : std::uint8_t { random, smallest, largest };

/// A value between the ends.
double value_at(Stop place, double smallest, double largest, Dice& dice) {
    if (place == Stop::smallest) return smallest;
    if (place == Stop::largest) return largest;
    return smallest + dice.share() * (largest - smallest);
}

/// The numbers of a setting: one, or three.
std::vector<float> numbers_of(const Setting& setting, const Settings& settings) {
    if (const auto* const vector = std::get_if<VectorSetting>(&setting.kind)) {
        Settings copy = settings;
        const glm::vec3& value = vector->value(copy);
        return {value.x, value.y, value.z};
    }
    return {slider_value(setting, {}, settings)};
}

void set_numbers(const Setting& setting, const std::vector<float>& numbers, Settings& settings) {
    for (int i = 0; i < static_cast<int>(numbers.size()); ++i) {
        ControlRange part;
        part.part = numbers.size() > 1 ? i : -1;
        set_slider_value(setting, part, numbers[static_cast<std::size_t>(i)], settings);
    }
}

/// Tries one task repeatedly.
class Trier {
  public:
    Trier(const Lesson& lesson, const LessonTask& task, const Session& like, LessonTrial& trial)
        : lesson_(lesson), task_(task), trial_(trial),
          is_open_(trial.open(step().state, lesson.folder, like).empty()), opened_(trial.session) {
        for (const std::string& target : task.recipe)
            links_.push_back(parse_lesson_link(target));
    }

    /// The name of what can be tried at random; empty: nothing.
    std::string control() const {
        std::vector<std::string> names;
        if (!is_open_) return {};
        for (const LessonLink& link : links_) {
            const std::string name = name_of(link);
            if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
                names.push_back(name);
        }
        return fmt::format("{}", fmt::join(names, " and "));
    }

    bool has_slider() const {
        return std::any_of(links_.begin(), links_.end(), [&](const LessonLink& link) {
            return slider_of(setting_of(link)) != nullptr;
        });
    }

    /// Does a try solve it? @param unanswered receives what was tried if the task has no reply
    bool solves(Stop place, Dice& dice, std::string& unanswered) {
        trial_.session = opened_;
        std::string tried;
        for (const LessonLink& link : links_) {
            const std::string one = follow(link, place, dice);
            if (!one.empty()) tried.append(tried.empty() ? "" : " ").append(one);
        }
        finish(trial_.session, trial_.results);
        const Facts facts = trial_.facts();
        if (is_done(task_, facts)) return true;
        unanswered = not_yet(task_, facts).empty() && !is_as_opened() ? tried : std::string();
        return false;
    }

  private:
    const LessonStep& step() const { return lesson_.steps[static_cast<std::size_t>(task_.step)]; }

    /// Has a try changed nothing, by chance?
    bool is_as_opened() const {
        const Session& now = trial_.session;
        return now.a.settings == opened_.a.settings && now.selection == opened_.selection &&
               now.cursor == opened_.cursor;
    }

    static const Setting* setting_of(const LessonLink& link) {
        if (!link.is_of("set") || link.argument.find('&') != link.argument.npos) return nullptr;
        const Assignment assignment = read_assignment(link.argument);
        return is_slider(*assignment.setting) ? assignment.setting : nullptr;
    }

    const LessonControl* slider_of(const Setting* setting) const {
        if (setting == nullptr) return nullptr;
        for (const LessonPart& part : step().parts) {
            if (part.kind != LessonPart::Kind::control) continue;
            const LessonControl& one = lesson_.controls[static_cast<std::size_t>(part.index)];
            if (one.setting == setting) return &one;
        }
        return nullptr;
    }

    std::string name_of(const LessonLink& link) const {
        if (link.is_of("pixel") && link.argument != "none") return "pixel";
        if (link.is_of("triangle") && link.argument != "none") return "triangle";
        if (link.is_of("row") && link.argument != "none") return "row";
        if (link.is_of("cursor")) return "moment";
        const Setting* const setting = setting_of(link);
        if (setting == nullptr) return {};
        const LessonControl* const slider = slider_of(setting);
        return slider != nullptr ? slider->name : std::string(setting->name);
    }

    /// Carries out a link of the recipe, with other values; returns what was tried.
    std::string follow(const LessonLink& link, Stop place, Dice& dice) {
        Session& session = trial_.session;
        const std::string name = name_of(link);
        const auto text_of = [&](auto value) { return fmt::format("{}:{}", name, value); };
        if (name.empty()) {
            follow_lesson_link(session, prepare_frame(*session.scene, session.a.settings), link);
            return {};
        }
        if (name == "pixel") {
            const Viewport& size = session.a.settings.viewport;
            const auto below = [&](int side) {
                return static_cast<int>(dice.below(static_cast<std::size_t>(side)));
            };
            const int column = below(size.width);
            session.selection.pixel = glm::ivec2(column, below(size.height));
            return fmt::format("pixel:{},{}", session.selection.pixel->x,
                               session.selection.pixel->y);
        }
        if (name == "triangle") {
            const auto count = static_cast<std::size_t>(session.scene->triangle_count());
            if (count == 0) return {};
            session.selection.triangle = static_cast<int>(dice.below(count));
            return text_of(*session.selection.triangle);
        }
        if (name == "row") {
            finish(session, trial_.results); // for the table of what was tried earlier
            const Value top = trial_.facts()("table.first_row");
            const Value rows = trial_.facts()("table.rows");
            const double* const first = std::get_if<double>(&top);
            const double* const count = std::get_if<double>(&rows);
            if (first == nullptr || count == nullptr || *count < 1.0) return {};
            session.selection.row = static_cast<int>(*first) +
                                    static_cast<int>(dice.below(static_cast<std::size_t>(*count)));
            return text_of(*session.selection.row);
        }
        if (name == "moment") {
            const Frame frame = prepare_frame(*session.scene, session.a.settings);
            session.cursor = Timeline(frame).at_place(dice.share());
            return text_of(to_text(session.cursor));
        }
        return turn(*setting_of(link), link, place, dice);
    }

    std::string turn(const Setting& setting, const LessonLink& link, Stop place, Dice& dice) {
        Settings& settings = trial_.session.a.settings;
        const std::vector<float> before = numbers_of(setting, opened_.a.settings);
        set_from_text(settings, link.argument);
        std::vector<float> numbers = numbers_of(setting, settings);
        if (const LessonControl* const slider = slider_of(&setting)) {
            const ControlRange& range = slider->range;
            const double last = std::round((range.largest - range.smallest) / range.step);
            const double stop = std::floor(value_at(place, 0.0, last + 1.0, dice));
            const double value = range.smallest + std::min(stop, last) * range.step;
            set_slider_value(setting, range, slider_stop(range, value), settings);
            return fmt::format("{}={}", setting.name, value_text(setting, settings));
        }
        const NumberBounds bounds = bounds_of(setting);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            constexpr float reach = 4.0f;
            const float distance = reach * std::abs(numbers[i] - before[i]);
            if (distance == 0.0f) continue;
            const double tried =
                value_at(Stop::random, std::max(before[i] - distance, bounds.smallest),
                         std::min(before[i] + distance, bounds.largest), dice);
            numbers[i] = static_cast<float>(tried);
        }
        set_numbers(setting, numbers, settings);
        return fmt::format("{}={}", setting.name, value_text(setting, settings));
    }

    const Lesson& lesson_;
    const LessonTask& task_;
    LessonTrial& trial_;
    bool is_open_; ///< all that the step shows could be shown
    Session opened_;
    std::vector<LessonLink> links_;
};

} // namespace

TaskLuck luck_of(const Lesson& lesson, const LessonTask& task, int tries, const Session& like,
                 LessonTrial& trial) {
    Trier trier(lesson, task, like, trial);
    TaskLuck luck;
    luck.control = trier.control();
    if (luck.control.empty()) return luck;
    constexpr std::uint32_t seed = 36;
    Dice dice(seed);
    luck.tries = tries;
    std::string unanswered;
    for (int i = 0; i < tries; ++i) {
        luck.passed += trier.solves(Stop::random, dice, unanswered) ? 1 : 0;
        if (unanswered.empty()) continue;
        ++luck.unanswered;
        luck.unanswered_by = std::exchange(unanswered, {});
    }
    if (tries > 0 && trier.has_slider()) {
        for (const Stop end : {Stop::smallest, Stop::largest})
            luck.ends_pass = trier.solves(end, dice, unanswered) || luck.ends_pass;
    }
    return luck;
}

bool is_luck(const TaskLuck& luck) {
    return 10 * luck.passed > luck.tries;
}

} // namespace rasterwalk
