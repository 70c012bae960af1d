#include "figures/figure_words.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "base/text_parts.h"

namespace rasterwalk {

namespace {

constexpr std::string_view figure_separators = " ,\t\r\n";

/// Takes the first word off the text; empty at its end.
std::string_view take_figure_word(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(figure_separators), text.size()));
    const std::string_view word =
        text.substr(0, std::min(text.find_first_of(figure_separators), text.size()));
    text.remove_prefix(word.size());
    return word;
}

bool is_letter_of_path(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

} // namespace

float figure_number(std::string_view text) {
    const std::optional<float> value =
        parse_number(trimmed(text), -largest_figure_number, largest_figure_number);
    if (value) return *value;
    throw UsageError(fmt::format("{0} is not a number from -{1} to {1}.", in_quotes(text),
                                 static_cast<int>(largest_figure_number)));
}

std::vector<float> figure_numbers(std::string_view text) {
    std::vector<float> numbers;
    while (true) {
        const std::string_view word = take_figure_word(text);
        if (word.empty()) return numbers;
        numbers.push_back(figure_number(word));
    }
}

int places_of(char command) {
    switch (command) {
    case 'M':
    case 'L':
        return 1;
    case 'Q':
        return 2;
    case 'C':
        return 3;
    default:
        return 0;
    }
}

FigurePath figure_path(std::string_view text) {
    constexpr std::string_view letters = "MLQCZ";
    FigurePath path;
    std::size_t at = text.find_first_not_of(figure_separators);
    while (at < text.size()) {
        const char command = text[at];
        if (letters.find(command) == letters.npos) {
            throw UsageError(
                "a path has the commands M, L, Q, C and Z, each with its letter, not " +
                in_quotes(text.substr(at, 1)) + ".");
        }
        if (path.commands.empty() != (command == 'M'))
            throw UsageError("a path begins with M and has no second one.");
        const auto next = std::find_if(text.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                                       text.end(), is_letter_of_path);
        const auto end = static_cast<std::size_t>(next - text.begin());
        const std::vector<float> numbers = figure_numbers(text.substr(at + 1, end - at - 1));
        const auto needed = static_cast<std::size_t>(2 * places_of(command));
        if (numbers.size() != needed)
            throw UsageError(
                fmt::format("{} takes {} numbers, not {}.", command, needed, numbers.size()));
        path.commands += command;
        path.numbers.insert(path.numbers.end(), numbers.begin(), numbers.end());
        at = end;
        if (command == 'Z' && at < text.size())
            throw UsageError("Z is the last command of a path.");
    }
    // A place is two numbers.
    if (path.numbers.size() < 4) throw UsageError("a path has at least two places.");
    return path;
}

void add_figure_classes(std::string_view text, bool is_of_group, FigureLook& look) {
    const std::vector<FigureClass>& known = figure_classes();
    while (true) {
        const std::string_view word = take_figure_word(text);
        if (word.empty()) return;
        const auto found = std::find_if(known.begin(), known.end(),
                                        [&](const FigureClass& each) { return each.name == word; });
        if (found == known.end()) {
            std::vector<std::string_view> names;
            for (const FigureClass& each : known)
                names.push_back(each.name);
            throw UsageError(no_such_name("class", word, names));
        }
        if (is_of_group && !found->is_inherited)
            throw UsageError("a group does not pass the class " + in_quotes(word) +
                             " on to its parts; give it to them.");
        if (found->flag != nullptr) {
            look.*(found->flag) = true;
        } else {
            look.colour = found->colour;
        }
    }
}

glm::vec2 figure_translation(std::string_view text) {
    constexpr std::string_view begin = "translate(";
    text = trimmed(text);
    if (!text.starts_with(begin) || !text.ends_with(")"))
        throw UsageError("the only transform is translate(x, y).");
    text = text.substr(begin.size(), text.size() - begin.size() - 1);
    const std::vector<float> numbers = figure_numbers(text);
    if (numbers.empty() || numbers.size() > 2)
        throw UsageError("the only transform is translate(x, y).");
    return {numbers[0], numbers.size() > 1 ? numbers[1] : 0.0f};
}

bool is_convex(const std::vector<FigureNumber>& numbers) {
    const std::size_t corners = numbers.size() / 2;
    bool turns_left = false, turns_right = false;
    for (std::size_t i = 0; i < corners; ++i) {
        const auto place = [&](std::size_t k) {
            k = (i + k) % corners;
            return glm::dvec2(numbers[2 * k].value, numbers[2 * k + 1].value);
        };
        const glm::dvec2 a = place(1) - place(0), b = place(2) - place(1);
        const double turn = a.x * b.y - a.y * b.x;
        turns_left = turns_left || turn < 0.0;
        turns_right = turns_right || turn > 0.0;
    }
    return !(turns_left && turns_right);
}

} // namespace rasterwalk
