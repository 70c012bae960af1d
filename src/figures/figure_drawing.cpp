#include "figures/figure_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/numbers.h"
#include "figures/figure_words.h"

namespace rasterwalk {

namespace {

constexpr int circle_corners = 48;
constexpr int curve_steps = 16;

std::optional<double> followed_now(const Figure& figure, int expression, const FactReader& fact) {
    if (expression < 0) return std::nullopt;
    return number_of(figure.expressions[static_cast<std::size_t>(expression)].expression, fact);
}

float number_now(const Figure& figure, const FigureNumber& number, const FactReader& fact) {
    const std::optional<double> value = followed_now(figure, number.follows, fact);
    if (!value || !std::isfinite(*value)) return number.value;
    const auto most = static_cast<double>(largest_figure_number);
    return static_cast<float>(std::clamp(*value, -most, most));
}

/// The first place of a shape, for which only the groups around it are evaluated.
glm::vec2 first_place_now(const Figure& figure, const FigureShape& shape, const FactReader& fact) {
    glm::vec2 place{number_now(figure, shape.numbers[0], fact),
                    number_now(figure, shape.numbers[1], fact)};
    for (int i = shape.group; i >= 0;) {
        const FigureGroup& group = figure.groups[static_cast<std::size_t>(i)];
        place += glm::vec2(number_now(figure, group.x, fact), number_now(figure, group.y, fact));
        i = group.outer;
    }
    return place;
}

/// The figure's numbers, conditions and groups under some facts.
class FigureState {
  public:
    FigureState(const Figure& figure, const FactReader& fact) : figure_(figure), fact_(fact) {
        for (const FigureGroup& group : figure.groups) {
            glm::vec2 by{number(group.x), number(group.y)};
            bool is_shown = holds_now(group.shown_if);
            if (group.outer >= 0) {
                by += moved_[static_cast<std::size_t>(group.outer)];
                is_shown = is_shown && is_shown_[static_cast<std::size_t>(group.outer)];
            }
            moved_.push_back(by);
            is_shown_.push_back(is_shown);
        }
    }

    float number(const FigureNumber& number) const { return number_now(figure_, number, fact_); }
    std::optional<double> followed(int expression) const {
        return followed_now(figure_, expression, fact_);
    }
    bool is_shown(const FigureShape& shape) const {
        return is_shown_[static_cast<std::size_t>(shape.group)] && holds_now(shape.shown_if);
    }
    /// The place of two numbers of a shape.
    glm::vec2 place(const FigureShape& shape, std::size_t index) const {
        return glm::vec2(number(shape.numbers[index]), number(shape.numbers[index + 1])) +
               moved_[static_cast<std::size_t>(shape.group)];
    }
    float number_at(const FigureShape& shape, std::size_t index) const {
        return number(shape.numbers[index]);
    }

  private:
    bool holds_now(int condition) const {
        return condition < 0 ||
               holds(figure_.conditions[static_cast<std::size_t>(condition)].expression, fact_);
    }

    const Figure& figure_;
    const FactReader& fact_;
    std::vector<glm::vec2> moved_;
    std::vector<bool> is_shown_;
};

/// Adds a Bézier curve of one or two places between its ends to a line that ends where it begins.
void add_curve(std::vector<glm::vec2>& line, const std::vector<glm::vec2>& places) {
    std::vector<glm::vec2> hull{line.back()};
    hull.insert(hull.end(), places.begin(), places.end());
    for (int step = 1; step <= curve_steps; ++step) {
        const float t = static_cast<float>(step) / static_cast<float>(curve_steps);
        // De Casteljau: the middle of middles.
        std::vector<glm::vec2> row = hull;
        for (std::size_t count = row.size() - 1; count > 0; --count) {
            for (std::size_t i = 0; i < count; ++i)
                row[i] += t * (row[i + 1] - row[i]);
        }
        line.push_back(row[0]);
    }
}

FigureLine line_of_path(const FigureShape& shape, const FigureState& state) {
    FigureLine line;
    std::size_t at = 0;
    for (const char command : shape.commands) {
        std::vector<glm::vec2> places;
        for (int i = 0; i < places_of(command); ++i, at += 2)
            places.push_back(state.place(shape, at));
        if (command == 'Z') {
            line.is_closed = true;
        } else if (places.size() == 1) {
            line.places.push_back(places[0]);
        } else {
            add_curve(line.places, places);
        }
    }
    return line;
}

FigureLine line_of(const FigureShape& shape, const FigureState& state) {
    using Kind = FigureShape::Kind;
    FigureLine line;
    line.is_closed = shape.kind != Kind::line && shape.kind != Kind::polyline;
    switch (shape.kind) {
    case Kind::path:
        line = line_of_path(shape, state);
        break;
    case Kind::rect: {
        const glm::vec2 low = state.place(shape, 0);
        const glm::vec2 size{state.number_at(shape, 2), state.number_at(shape, 3)};
        line.places = {low, {low.x + size.x, low.y}, low + size, {low.x, low.y + size.y}};
        break;
    }
    case Kind::circle: {
        const glm::vec2 centre = state.place(shape, 0);
        const float radius = state.number_at(shape, 2);
        for (int i = 0; i < circle_corners; ++i) {
            const float angle = 6.2831853f * static_cast<float>(i) / circle_corners;
            line.places.push_back(centre + radius * glm::vec2(std::cos(angle), std::sin(angle)));
        }
        break;
    }
    default:
        for (std::size_t i = 0; i + 1 < shape.numbers.size(); i += 2)
            line.places.push_back(state.place(shape, i));
        break;
    }
    line.look = shape.look;
    return line;
}

FigureText text_of(const FigureShape& shape, const FigureState& state) {
    FigureText text{state.place(shape, 0), shape.anchor, shape.spans};
    for (FigureSpan& span : text.spans) {
        const std::optional<double> value = state.followed(span.follows);
        if (!value) continue;
        // As in a lesson's sentences: no minus before a zero.
        std::string written = decimals(*value, span.digits);
        if (written.find_first_of("123456789") == written.npos && written[0] == '-')
            written.erase(0, 1);
        span.text = with_minus_signs(written);
    }
    return text;
}

/// Has every name in a condition a value that stays while frames are played? A figure that grows
/// with the cursor shows its end in a browser, and its beginning when the step opens.
bool is_settled(const Expression& condition, const FactReader& fact) {
    for (std::size_t i = 0; i < condition.meanings.size(); ++i) {
        if (!condition.is_leaf(static_cast<int>(i), ExpressionMeaning::Leaf::fact)) continue;
        const std::string& name = condition.meanings[i].name;
        if (name.starts_with("cursor") || !is_there(fact(name))) return false;
    }
    return true;
}

} // namespace

FigureDrawing draw_figure(const Figure& figure, const FactReader& fact) {
    const FigureState state(figure, fact);
    FigureDrawing drawing;
    for (std::size_t i = 0; i < figure.shapes.size(); ++i) {
        const FigureShape& shape = figure.shapes[i];
        if (!state.is_shown(shape)) continue;
        if (shape.kind == FigureShape::Kind::text) {
            drawing.texts.push_back(text_of(shape, state));
            continue;
        }
        drawing.lines.push_back(line_of(shape, state));
        for (std::size_t h = 0; h < figure.handles.size(); ++h) {
            if (figure.handles[h].shape != static_cast<int>(i)) continue;
            drawing.grips.push_back(
                {state.place(shape, 0), state.number_at(shape, 2), static_cast<int>(h)});
        }
    }
    return drawing;
}

float dragged_value(const Figure& figure, const FigureHandle& handle, glm::vec2 to,
                    const FactReader& fact) {
    const FigureShape& shape = figure.shapes[static_cast<std::size_t>(handle.shape)];
    const ControlRange& range = handle.range;
    const int stops = static_cast<int>(std::lround((range.largest - range.smallest) / range.step));
    double tried = range.smallest;
    const FactReader with_tried = [&](std::string_view name) -> Value {
        return name == handle.setting ? Value(tried) : fact(name);
    };
    float nearest = std::numeric_limits<float>::infinity();
    auto result = static_cast<float>(range.smallest);
    for (int stop = 0; stop <= stops; ++stop) {
        const float value = slider_stop(range, range.smallest, stop);
        tried = static_cast<double>(value);
        const float distance = glm::distance(first_place_now(figure, shape, with_tried), to);
        if (distance >= nearest) continue;
        nearest = distance;
        result = value;
    }
    return result;
}

std::vector<std::string> stale_numbers(const Figure& figure, const FactReader& fact) {
    std::vector<std::string> sentences;
    for (const FigureExpression& each : figure.expressions) {
        const std::optional<double> value = number_of(each.expression, fact);
        if (!value || !each.as_written ||
            std::abs(*value - static_cast<double>(*each.as_written)) <= each.slack)
            continue;
        sentences.push_back(fmt::format(
            "line {}: the file shows {} where '{}' is {} when the step opens.", each.line,
            number_text(*each.as_written), each.expression.tree.text, significant(*value, 5)));
    }
    for (const FigureCondition& each : figure.conditions) {
        if (!is_settled(each.expression, fact)) continue;
        const bool is_shown = holds(each.expression, fact);
        if (is_shown != each.is_hidden) continue;
        sentences.push_back(fmt::format("line {}: the file {} what '{}' {} when the step opens.",
                                        each.line, is_shown ? "hides" : "shows",
                                        each.expression.tree.text, is_shown ? "shows" : "hides"));
    }
    return sentences;
}

} // namespace rasterwalk
