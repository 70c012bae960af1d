#include "opening/view_link.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/quoted.h"
#include "lessons/lesson_list.h"
#include "opening/command_line_text.h"
#include "opening/view_options.h"
#include "session/content.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view lesson_ending = ".md", hexadecimal = "0123456789ABCDEF";

struct LinkPair {
    std::string name, value;
};

// --- from a link

/// Is it UTF-8 on one line, without control characters?
bool is_plain_text(std::string_view text) {
    return is_utf8(text) && text.find('\t') == text.npos && visible_line(text) == text;
}

/// The value of a hexadecimal digit in either case.
std::optional<unsigned> digit_of(char c) {
    const char large = c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c;
    const std::size_t digit = hexadecimal.find(large);
    if (digit == hexadecimal.npos) return std::nullopt;
    return static_cast<unsigned>(digit);
}

/// The text without its percent escapes.
std::string decoded(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            result += text[i];
            continue;
        }
        const std::string_view escape = text.substr(i, 3);
        const auto high = escape.size() == 3 ? digit_of(escape[1]) : std::nullopt;
        const auto low = escape.size() == 3 ? digit_of(escape[2]) : std::nullopt;
        if (!high || !low) {
            throw UsageError(fmt::format("the link has {}, but a % must be followed by two "
                                         "hexadecimal digits, as in %20.",
                                         in_quotes(escape)));
        }
        result += static_cast<char>(*high << 4u | *low);
        i += 2;
    }
    if (!is_plain_text(result)) {
        throw UsageError("the link has " + in_quotes(result) +
                         ", which is not plain UTF-8 text on one line.");
    }
    return result;
}

LinkPair parse_pair(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos) {
        throw UsageError("the link has " + in_quotes(text) +
                         ", which is not a name and a value, like step=3.");
    }
    LinkPair pair{decoded(text.substr(0, equals)), decoded(text.substr(equals + 1))};
    if (pair.value.empty()) {
        throw UsageError("the link names " + in_quotes(pair.name) + " without a value.");
    }
    return pair;
}

std::vector<LinkPair> parse_pairs(std::string_view link) {
    std::vector<LinkPair> pairs;
    if (link.empty()) return pairs;
    for (;;) {
        const std::size_t end = link.find('&');
        pairs.push_back(parse_pair(link.substr(0, end)));
        if (end == link.npos) return pairs;
        link.remove_prefix(end + 1);
    }
}

/// Checks that each name is an option's, and is there once unless it may be repeated.
void check_names(const CLI::App& app, const std::vector<LinkPair>& pairs) {
    std::vector<std::string_view> known;
    std::set<std::string_view> single;
    for (const CLI::Option* option : app.get_options()) {
        const std::string& name = option->get_lnames().front();
        known.push_back(name);
        if (option->get_items_expected_max() == 1) single.insert(name);
    }
    std::set<std::string_view> given;
    for (const LinkPair& pair : pairs) {
        if (std::find(known.begin(), known.end(), pair.name) == known.end()) {
            throw UsageError(fmt::format("a link cannot set {}.{}", in_quotes(pair.name),
                                         did_you_mean(pair.name, known)));
        }
        if (!given.insert(pair.name).second && single.count(pair.name) != 0) {
            throw UsageError("the link names " + in_quotes(pair.name) + " twice.");
        }
    }
}

/// The options as given, whatever files they name.
ViewOptions read_pairs(const std::vector<LinkPair>& pairs) {
    ViewOptions options;
    CLI::App app;
    app.set_help_flag();
    add_view_options(app, options);
    add_look_options(app, options);
    check_names(app, pairs);
    std::vector<std::string> arguments;
    // One word each, so that no value is mistaken for an option.
    for (const LinkPair& pair : pairs)
        arguments.push_back(fmt::format("--{}={}", pair.name, pair.value));
    std::reverse(arguments.begin(), arguments.end()); // as CLI11 wants them
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::ParseError& error) {
        throw UsageError(std::string("the link cannot be read: ") + error.what());
    }
    return options;
}

[[noreturn]] void refuse_lesson(const std::string& id) {
    LessonList list;
    std::vector<std::string_view> ids;
    for (const Lesson& lesson : list.all())
        ids.push_back(lesson.id);
    throw UsageError(fmt::format("there is no lesson {}.{}", in_quotes(id), did_you_mean(id, ids)));
}

/// The path of the file within lessons_folder(), if there is one.
std::optional<std::string> find_own_file(const std::string& name) {
    try {
        return find_lesson_file(lessons_folder(), name);
    } catch (const UsageError&) {
        return std::nullopt;
    }
}

/// The options' name for the lesson that a link names: its id, or its path in a subfolder.
std::string lesson_of_link(std::string name) {
    if (name.ends_with(lesson_ending)) name.resize(name.size() - lesson_ending.size());
    const std::string file = name + std::string(lesson_ending);
    if (name.find('/') != name.npos) return find_lesson_file(lessons_folder(), file);
    if (!find_own_file(file)) refuse_lesson(name);
    return name;
}

// --- to a link

std::string encoded(std::string_view text) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                       "0123456789-._~/,:@+=";
    std::string result;
    for (const char c : text) {
        if (plain.find(c) != plain.npos) {
            result += c;
        } else {
            result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        }
    }
    return result;
}

/// The name of an existing file, from its path or its name relative to lessons_folder().
std::optional<std::string> name_of_own_file(const std::string& path) {
    const std::optional<std::string> name =
        name_in_lessons_folder((fs::path(lessons_folder()) / path).string());
    return name && find_own_file(*name) ? name : std::nullopt;
}

[[noreturn]] void refuse_file(std::string_view what, const std::string& path) {
    throw UsageError(fmt::format("the {} {} is not one of the page's own files, so a link cannot "
                                 "name it; save the view instead.",
                                 what, in_quotes(fs::path(path).filename().string())));
}

/// The text in a link for the word of an option.
std::string value_for_link(std::string_view name, const std::string& word) {
    if (name == "scene" || name == "texture") {
        const std::optional<std::string> scene = name_of_own_file(word);
        if (!scene) refuse_file(name, word);
        return *scene;
    }
    if (name == "lesson") {
        const bool is_path = word.ends_with(lesson_ending);
        const std::string file = is_path ? word : word + std::string(lesson_ending);
        const std::optional<std::string> lesson = name_of_own_file(file);
        if (!lesson) refuse_file(name, file);
        return lesson->substr(0, lesson->size() - lesson_ending.size());
    }
    return word;
}

} // namespace

ViewOptions parse_view_link(std::string_view fragment) {
    if (fragment.starts_with('#')) fragment.remove_prefix(1);
    if (fragment.size() > longest_view_link) {
        throw UsageError(fmt::format("the link is longer than {} bytes.", longest_view_link));
    }
    ViewOptions options = read_pairs(parse_pairs(fragment));
    if (!options.step.empty() && options.lesson.empty()) {
        throw UsageError("step can only be used with lesson.");
    }
    if (!options.lesson.empty()) options.lesson = lesson_of_link(options.lesson);
    // A path, because otherwise a file where the program was started could come first.
    if (!options.scene.empty()) options.scene = find_lesson_file(lessons_folder(), options.scene);
    if (!options.texture.empty())
        options.texture = find_lesson_file(lessons_folder(), options.texture);
    return options;
}

std::string view_link(const Session& session) {
    const std::vector<std::string> words = command_line_words(session);
    std::string link;
    for (std::size_t i = 1; i + 1 < words.size(); i += 2) {
        const std::string name = words[i].substr(std::string_view("--").size());
        const std::string value = value_for_link(name, words[i + 1]);
        if (!is_plain_text(value)) {
            throw UsageError(in_quotes(value) + " cannot be written in a link; save the view "
                                                "instead.");
        }
        link += fmt::format("{}{}={}", link.empty() ? "" : "&", name, encoded(value));
    }
    if (link.size() > longest_view_link) {
        throw UsageError(fmt::format("the link would be longer than {} bytes; save the view "
                                     "instead.",
                                     longest_view_link));
    }
    return "#" + link;
}

std::string step_link(const Session& session) {
    if (session.lesson.empty()) return {};
    const fs::path folder =
        session.lesson_folder.empty() ? lessons_folder() : session.lesson_folder;
    const std::optional<std::string> lesson =
        name_of_own_file((folder / (session.lesson + std::string(lesson_ending))).string());
    if (!lesson) return {};
    return fmt::format("#lesson={}&step={}",
                       encoded(lesson->substr(0, lesson->size() - lesson_ending.size())),
                       session.step);
}

} // namespace rasterwalk
