#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "base/text_parts.h"
#include "figures/figure.h"
#include "figures/figure_element.h"
#include "figures/figure_words.h"

namespace rasterwalk {

namespace {

using FigureKind = FigureShape::Kind;
using TagKind = FigureTag::Kind;

/// An attribute whose name begins so holds what its number follows.
constexpr std::string_view following = "data-";

/// Reads the tags of a figure, one after the other.
class FigureReader {
  public:
    FigureReader(std::string_view text, const std::string& path)
        : tags_(read_figure_tags(text, path)), path_(path) {}

    Figure read() {
        for (; at_ < tags_.size(); ++at_) {
            const FigureTag& tag = tags_[at_];
            if (tag.kind == TagKind::open) {
                open(tag);
            } else if (tag.kind == TagKind::close) {
                if (tag.name == "g") groups_.pop_back();
            } else {
                fail(tag.line, "text belongs in <text>.");
            }
        }
        return std::move(figure_);
    }

  private:
    /// A group that is open, with what it passes on.
    struct OpenGroup {
        int index = 0;
        FigureLook look;
    };

    [[noreturn]] void fail(int line, const std::string& sentence) const {
        throw InputError(path_, line, sentence);
    }

    void open(const FigureTag& tag) {
        FigureElement element(tag, path_);
        if (at_ == 0) {
            if (tag.name != "svg") fail(tag.line, "the outermost element must be <svg>.");
            read_head(element);
            return;
        }
        if (tag.name == "style" || tag.name == "title" || tag.name == "desc" ||
            tag.name == "defs") {
            read_aside(tag.name == "style" ? &figure_.style : nullptr);
            return;
        }
        if (tag.name == "g") {
            read_group(element);
            limit_numbers(tag);
            return;
        }
        read_shape(element);
        element.end();
        if (tag.name != "text" && tags_[at_ + 1].kind != TagKind::close)
            fail(tag.line, "nothing may be in <" + tag.name + ">.");
        if (figure_.shapes.size() > most_figure_shapes)
            fail(tag.line, fmt::format("a figure may have at most {} shapes.", most_figure_shapes));
        limit_numbers(tag);
    }

    /// Expressions, conditions and groups are evaluated in each frame, so they count, too.
    void limit_numbers(const FigureTag& tag) const {
        const std::size_t count = number_count_ + 2 * figure_.groups.size() +
                                  figure_.expressions.size() + figure_.conditions.size();
        if (count <= most_figure_numbers) return;
        fail(tag.line, fmt::format("a figure may have at most {} numbers.", most_figure_numbers));
    }

    void read_head(FigureElement& element) {
        for (const std::string_view name : {"xmlns", "width", "height", "role"})
            element.take(name);
        const FigureAttribute& box = element.need("viewBox");
        figure_.size = element.attempt(box, [&] {
            const std::vector<float> numbers = figure_numbers(box.value);
            const auto is_side = [](float side) {
                return side >= 1.0f && side <= largest_figure_side;
            };
            if (numbers.size() != 4 || numbers[0] != 0.0f || numbers[1] != 0.0f ||
                !is_side(numbers[2]) || !is_side(numbers[3])) {
                throw UsageError(fmt::format("write \"0 0 WIDTH HEIGHT\", each 1 to {}.",
                                             static_cast<int>(largest_figure_side)));
            }
            return glm::vec2(numbers[2], numbers[3]);
        });
        element.end();
        figure_.groups.emplace_back();
        groups_.push_back({0, {}});
    }

    /// Goes beyond an element that is not drawn.
    /// @param text null, or receives its text
    void read_aside(std::string* text) {
        int depth = 0;
        do {
            const FigureTag& tag = tags_[at_++];
            if (tag.kind == TagKind::open) ++depth;
            if (tag.kind == TagKind::close) --depth;
            if (tag.kind == TagKind::text && text != nullptr) *text += tag.name;
        } while (depth > 0);
        --at_;
    }

    void read_group(FigureElement& element) {
        FigureGroup group;
        group.outer = groups_.back().index;
        if (const FigureAttribute* const transform = element.take("transform")) {
            const glm::vec2 by =
                element.attempt(*transform, [&] { return figure_translation(transform->value); });
            group.x.value = by.x;
            group.y.value = by.y;
        }
        group.x.follows = expression(element, "data-translate-x", group.x.value);
        group.y.follows = expression(element, "data-translate-y", group.y.value);
        group.shown_if = condition(element);
        const FigureLook look = look_of(element, true);
        element.end();
        figure_.groups.push_back(group);
        groups_.push_back({static_cast<int>(figure_.groups.size()) - 1, look});
    }

    FigureLook look_of(FigureElement& element, bool is_of_group) {
        FigureLook look = groups_.back().look;
        if (const FigureAttribute* const classes = element.take("class")) {
            element.attempt(*classes,
                            [&] { add_figure_classes(classes->value, is_of_group, look); });
        }
        return look;
    }

    /// The expression in an attribute, as an index; -1: there is none.
    int expression(FigureElement& element, std::string_view name, std::optional<float> as_written) {
        const FigureAttribute* const found = element.take(name);
        if (found == nullptr) return -1;
        add_expression(element, *found, found->value, as_written);
        return static_cast<int>(figure_.expressions.size()) - 1;
    }
    void add_expression(const FigureElement& element, const FigureAttribute& attribute,
                        std::string_view text, std::optional<float> as_written) {
        element.attempt(attribute, [&] {
            figure_.expressions.push_back(
                {parse_expression(text), as_written, 1.0, attribute.line});
        });
    }

    int condition(FigureElement& element) {
        const FigureAttribute* const found = element.take("data-if");
        // Browsers do not evaluate conditions and do not show it.
        const FigureAttribute* const display = element.take("display");
        if (display != nullptr && (display->value != "none" || found == nullptr))
            element.fail(display->line, "display is \"none\", and goes with data-if.");
        if (found == nullptr) return -1;
        element.attempt(*found, [&] {
            figure_.conditions.push_back(
                {parse_condition(found->value), display != nullptr, found->line});
        });
        return static_cast<int>(figure_.conditions.size()) - 1;
    }

    /// The numbers of these attributes, and what each follows.
    void read_numbers(FigureElement& element, std::initializer_list<std::string_view> names) {
        FigureShape& shape = figure_.shapes.back();
        for (const std::string_view name : names) {
            const FigureAttribute& given = element.need(name);
            FigureNumber number;
            number.value = element.attempt(given, [&] { return figure_number(given.value); });
            number.follows = expression(element, std::string(following).append(name), number.value);
            shape.numbers.push_back(number);
        }
    }

    void read_shape(FigureElement& element) {
        static const std::vector<std::pair<std::string_view, FigureKind>> kinds{
            {"line", FigureKind::line},       {"polyline", FigureKind::polyline},
            {"polygon", FigureKind::polygon}, {"rect", FigureKind::rect},
            {"circle", FigureKind::circle},   {"path", FigureKind::path},
            {"text", FigureKind::text}};
        const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& known) {
            return known.first == element.name();
        });
        if (kind == kinds.end()) {
            std::vector<std::string_view> names{"g"};
            for (const auto& known : kinds)
                names.push_back(known.first);
            fail(element.line(), no_such_name("element", element.name(), names));
        }
        FigureShape& shape = figure_.shapes.emplace_back();
        shape.kind = kind->second;
        shape.line = element.line();
        shape.group = groups_.back().index;
        shape.look = look_of(element, false);
        shape.shown_if = condition(element);
        switch (shape.kind) {
        case FigureKind::line:
            read_numbers(element, {"x1", "y1", "x2", "y2"});
            break;
        case FigureKind::rect:
            read_numbers(element, {"x", "y", "width", "height"});
            break;
        case FigureKind::circle:
            read_numbers(element, {"cx", "cy", "r"});
            read_handle(element);
            break;
        case FigureKind::polyline:
        case FigureKind::polygon:
            read_corners(element);
            break;
        case FigureKind::path:
            read_path(element);
            break;
        case FigureKind::text:
            read_text(element);
            break;
        }
        number_count_ += figure_.shapes.back().numbers.size();
    }

    void read_corners(FigureElement& element) {
        FigureShape& shape = figure_.shapes.back();
        const FigureAttribute& points = element.need("points");
        for (const float value :
             element.attempt(points, [&] { return figure_numbers(points.value); }))
            shape.numbers.push_back({value, -1});
        const std::size_t least = shape.kind == FigureKind::polygon ? 6 : 4;
        if (shape.numbers.size() < least || shape.numbers.size() % 2 != 0)
            fail(points.line, fmt::format("<{}> needs at least {} corners, each x and y.",
                                          element.name(), least / 2));
        if (const FigureAttribute* const moving = element.take("data-points")) {
            const std::vector<std::string_view> parts = split(moving->value, ';');
            if (parts.size() != shape.numbers.size()) {
                fail(moving->line,
                     fmt::format(
                         "data-points has {}, points has {}.",
                         counted(static_cast<int>(parts.size()), "expression", "expressions"),
                         counted(static_cast<int>(shape.numbers.size()), "number", "numbers")));
            }
            for (std::size_t i = 0; i < parts.size(); ++i) {
                add_expression(element, *moving, trimmed(parts[i]), shape.numbers[i].value);
                shape.numbers[i].follows = static_cast<int>(figure_.expressions.size()) - 1;
            }
        }
        const bool is_filled = shape.look.is_filled || shape.look.is_soft;
        if (is_filled && !is_convex(shape.numbers))
            fail(points.line, "what is filled must not be dented; draw it in parts.");
    }

    void read_path(FigureElement& element) {
        FigureShape& shape = figure_.shapes.back();
        const FigureAttribute& d = element.need("d");
        const FigurePath path = element.attempt(d, [&] { return figure_path(d.value); });
        shape.commands = path.commands;
        for (const float value : path.numbers)
            shape.numbers.push_back({value, -1});
        if (shape.look.is_filled || shape.look.is_soft)
            fail(d.line, "a path is a line; what is filled is a polygon, a rect or a circle.");
    }

    void read_handle(FigureElement& element) {
        const FigureAttribute* const drag = element.take("data-drag");
        if (drag == nullptr) return;
        FigureHandle handle = element.attempt(*drag, [&] { return figure_handle(drag->value); });
        handle.shape = static_cast<int>(figure_.shapes.size()) - 1;
        const FigureShape& shape = figure_.shapes.back();
        const bool follows = std::any_of(
            shape.numbers.begin(), shape.numbers.end(),
            [&](const FigureNumber& number) { return depends_on(number, handle.setting); });
        if (!follows)
            fail(drag->line,
                 "what can be dragged must have data-cx or data-cy that depends on the setting.");
        if (figure_.handles.size() >= most_figure_handles)
            fail(drag->line,
                 fmt::format("at most {} circles can be dragged.", most_figure_handles));
        figure_.handles.push_back(std::move(handle));
    }

    bool depends_on(const FigureNumber& number, const std::string& setting) const {
        if (number.follows < 0) return false;
        const Expression& expression =
            figure_.expressions[static_cast<std::size_t>(number.follows)].expression;
        return std::any_of(
            expression.meanings.begin(), expression.meanings.end(),
            [&](const ExpressionMeaning& meaning) { return meaning.name == setting; });
    }

    // --- text

    void read_text(FigureElement& element) {
        read_numbers(element, {"x", "y"});
        FigureShape& shape = figure_.shapes.back();
        if (const FigureAttribute* const anchor = element.take("text-anchor"))
            shape.anchor = element.attempt(*anchor, [&] { return anchor_of(anchor->value); });
        FigureSpan whole;
        whole.look = shape.look;
        read_value(element, whole);
        // Blanks are one blank, and none at the ends.
        bool is_open = true, is_within = false;
        FigureSpan inner;
        for (++at_; is_open; ++at_) {
            const FigureTag& tag = tags_[at_];
            if (tag.kind == TagKind::text) {
                add_span(is_within ? inner : whole, tag.name);
            } else if (tag.kind == TagKind::open) {
                if (tag.name != "tspan" || is_within)
                    fail(tag.line, "in <text> there may be <tspan>, and nothing in that.");
                is_within = true;
                inner = read_tspan(tag, shape.look);
            } else if (is_within) {
                is_within = false;
            } else {
                is_open = false;
            }
        }
        at_ -= 1;
        if (shape.spans.empty()) fail(element.line(), "the text is empty.");
        std::string& last = shape.spans.back().text;
        if (last.ends_with(' ')) last.pop_back();
    }

    static FigureShape::Anchor anchor_of(const std::string& word) {
        if (word == "start") return FigureShape::Anchor::start;
        if (word == "middle") return FigureShape::Anchor::middle;
        if (word == "end") return FigureShape::Anchor::end;
        throw UsageError("write start, middle or end.");
    }

    FigureSpan read_tspan(const FigureTag& tag, FigureLook look) {
        FigureElement element(tag, path_);
        FigureSpan span;
        if (const FigureAttribute* const classes = element.take("class")) {
            std::string words = " " + classes->value + " ";
            const std::size_t lowered = words.find(" sub ");
            span.is_lowered = lowered != words.npos;
            if (span.is_lowered) words.erase(lowered, 4);
            element.attempt(*classes, [&] { add_figure_classes(words, false, look); });
        }
        span.look = look;
        read_value(element, span);
        element.end();
        return span;
    }

    /// A number in place of the text.
    void read_value(FigureElement& element, FigureSpan& span) {
        span.follows = expression(element, "data-value", std::nullopt);
        set_slack(span);
        const FigureAttribute* const digits = element.take("data-digits");
        if (digits == nullptr) return;
        const std::optional<int> count = parse_int(digits->value);
        if (!count || *count < 0 || *count > 6 || span.follows < 0)
            fail(digits->line, "data-digits is 0 to 6, and goes with data-value.");
        span.digits = *count;
        set_slack(span);
    }

    /// A number is written as it is shown, to its last digit.
    void set_slack(const FigureSpan& span) {
        if (span.follows < 0) return;
        figure_.expressions[static_cast<std::size_t>(span.follows)].slack =
            0.5001 * std::pow(10.0, -span.digits);
    }

    void add_span(const FigureSpan& like, std::string_view text) {
        FigureShape& shape = figure_.shapes.back();
        FigureSpan span = like;
        bool is_after_blank = shape.spans.empty() || shape.spans.back().text.ends_with(" ");
        for (const char c : text) {
            const bool is_blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
            if (!is_blank) {
                span.text += c;
            } else if (!is_after_blank) {
                span.text += ' ';
            }
            is_after_blank = is_blank;
        }
        if (span.follows >= 0) {
            // Other text than a number is drawn, but cannot be compared.
            figure_.expressions[static_cast<std::size_t>(span.follows)].as_written =
                written_number(text);
        }
        if (!span.text.empty()) shape.spans.push_back(std::move(span));
    }

    /// The number that a text is, whose minus may be a hyphen or a true minus sign.
    static std::optional<float> written_number(std::string_view text) {
        constexpr std::string_view minus = "−";
        std::string word(trimmed(text));
        if (word.starts_with(minus)) word.replace(0, minus.size(), "-");
        return parse_number(word, -largest_figure_number, largest_figure_number);
    }

    std::vector<FigureTag> tags_;
    const std::string& path_;
    Figure figure_;
    std::vector<OpenGroup> groups_;
    std::size_t at_ = 0;
    std::size_t number_count_ = 0;
};

} // namespace

Figure read_figure(std::string_view text, const std::string& path) {
    return FigureReader(text, path).read();
}

} // namespace rasterwalk
