// The table of checked programs as a page. It is made from what `mine --json` prints, which may
// come from anywhere: all of its text is escaped, and numbers are numbers.

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/html.h"
#include "cli/mine_json.h"

namespace rasterwalk {

namespace {

constexpr std::string_view page_head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
<title>Rasterwalk: checked programs</title>
<style>
:root { color-scheme: light dark; --line: #8884; --right: #1a7f4b; --wrong: #b3390e; --quiet: #777; }
@media (prefers-color-scheme: dark) { :root { --right: #5cc98f; --wrong: #ff8a5c; --quiet: #999; } }
body { font: 15px/1.45 system-ui, sans-serif; margin: 2rem auto; max-width: 80rem; padding: 0 1rem; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: .45rem .7rem; border-bottom: 1px solid var(--line); }
td:first-child { white-space: nowrap; } td.number { white-space: nowrap; text-align: right; font-variant-numeric: tabular-nums; }
.right { color: var(--right); } .wrong { color: var(--wrong); } .quiet { color: var(--quiet); }
code, pre { font: 13px/1.4 ui-monospace, monospace; } pre { white-space: pre-wrap; }
img { width: 24rem; max-width: 100%; height: auto; border: 1px solid var(--line); }
section { margin-top: 2.5rem; } figure { display: inline-block; margin: 0 1rem 0 0; }
figcaption { color: var(--quiet); font-size: 13px; }
</style>
</head>
<body>
)";

/// A text of an object, escaped; empty if it has none.
std::string escaped(const Json& object, const char* key) {
    return in_html(text_of(object, key));
}

std::int64_t number_of(const Json& object, const char* key) {
    const auto found = object.is_object() ? object.find(key) : object.end();
    if (!object.is_object() || found == object.end() || !found->is_number()) return 0;
    const double number = found->get<double>();
    constexpr double largest = 1e15;
    return number > -largest && number < largest ? static_cast<std::int64_t>(number) : 0;
}

/// A list of an object; empty if it has none.
const Json& list_of(const Json& object, const char* key) {
    static const Json none = Json::array();
    const auto found = object.is_object() ? object.find(key) : object.end();
    return object.is_object() && found != object.end() && found->is_array() ? *found : none;
}

const Json& object_of(const Json& object, const char* key) {
    static const Json none = Json::object();
    const auto found = object.find(key);
    return found != object.end() && found->is_object() ? *found : none;
}

/// "skeleton.cpp:142", or nothing.
std::string place_text(const Json& object) {
    const std::int64_t line = number_of(object, "line");
    if (line <= 0) return {};
    std::string file = escaped(object, "file");
    if (const std::size_t slash = file.rfind('/'); slash != std::string::npos)
        file.erase(0, slash + 1);
    return fmt::format("<code>{}:{}</code> ", file, line);
}

std::string mistake_text(const Json& mistake) {
    std::string html = place_text(mistake);
    const Json& bugs = list_of(mistake, "bugs");
    const Json& names = list_of(mistake, "names");
    for (std::size_t i = 0; i < bugs.size(); ++i) {
        if (!bugs[i].is_string()) continue;
        html +=
            fmt::format("{}<b>{}</b>", i > 0 ? " or " : "", in_html(bugs[i].get<std::string>()));
        if (i < names.size() && names[i].is_string())
            html += ' ' + in_html(names[i].get<std::string>());
    }
    if (!bugs.empty()) html += ". ";
    return html + escaped(mistake, "sentence");
}

/// A picture if it is one of ours: an address of any other kind could load something.
std::string picture_html(const Json& picture, const char* key, std::string_view caption) {
    const std::string address = escaped(picture, key);
    if (!address.starts_with("data:image/png;base64,")) return {};
    return fmt::format("<figure><img alt=\"{}\" src=\"{}\"><figcaption>{}</figcaption></figure>\n",
                       caption, address, caption);
}

/// How many of the functions that are written are right: "4 of 5".
std::string functions_text(const Json& program) {
    int right = 0, written = 0;
    for (const Json& function : list_of(program, "functions")) {
        const std::string state = escaped(function, "state");
        if (state.starts_with("not ")) continue; // not written yet, not found, not asked
        ++written;
        if (state == "right") ++right;
    }
    return written > 0 ? fmt::format("{} of {}", right, written) : "–";
}

std::string picture_words(const Json& program) {
    const Json& picture = object_of(program, "picture");
    if (picture.empty()) return "none";
    if (is_set(picture, "right")) return "right";
    return fmt::format("{} pixels differ", number_of(picture, "different"));
}

/// The class of a state or a verdict, which gives it its colour.
std::string_view class_of(std::string_view words) {
    if (words == "right") return "right";
    return words == "wrong" || words == "died" || words == "differs" ? "wrong" : "quiet";
}

/// The step that a program has reached: "vertex light".
std::string stage_words(const Json& program) {
    std::string words = escaped(object_of(program, "picture"), "stage");
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

std::string row_html(const Json& program, std::size_t index) {
    const std::string_view verdict = verdict_words(program);
    std::string first;
    if (const std::string fault = fault_of(program); !fault.empty()) {
        first = in_html(fault);
    } else if (!is_set(program, "compiles")) {
        first = "It does not compile.";
    } else if (const Json& mistakes = list_of(program, "mistakes"); !mistakes.empty()) {
        first = mistake_text(mistakes.front());
    }
    const std::size_t faults =
        list_of(object_of(program, "run"), "faults").size() + list_of(program, "keys").size();
    return fmt::format("<tr><td><a href=\"#p{}\">{}</a></td><td class=\"{}\">{}</td><td>{}</td>"
                       "<td class=\"number\">{}</td><td>{}</td><td class=\"number\">{}</td>"
                       "<td>{}</td></tr>\n",
                       index, escaped(program, "name"), class_of(verdict), verdict,
                       stage_words(program), functions_text(program), picture_words(program),
                       faults, first);
}

std::string messages_html(const Json& program) {
    std::string html;
    for (const Json& message : list_of(program, "messages")) {
        if (!is_set(message, "error")) continue;
        html += fmt::format("<p>{}{} <span class=\"quiet\">{}</span></p>\n", place_text(message),
                            escaped(message, "text"), escaped(message, "cause"));
    }
    return html;
}

std::string functions_html(const Json& program) {
    std::string html;
    for (const Json& function : list_of(program, "functions")) {
        const std::string state = escaped(function, "state");
        const bool has_counts = !state.starts_with("not ");
        const std::string counts = has_counts
                                       ? fmt::format("{} of {}", number_of(function, "right"),
                                                     number_of(function, "asked"))
                                       : std::string();
        html += fmt::format("<tr><td><code>{}</code></td><td class=\"{}\">{}</td>"
                            "<td class=\"number\">{}</td><td>{} <span class=\"quiet\">{}"
                            "</span></td></tr>\n",
                            escaped(function, "name"), class_of(state), state, counts,
                            escaped(function, "first"), escaped(function, "rule"));
    }
    return html.empty() ? html : "<table>\n" + html + "</table>\n";
}

std::string section_html(const Json& program, std::size_t index) {
    std::string html =
        fmt::format("<section id=\"p{}\">\n<h2>{}</h2>\n", index, escaped(program, "name"));
    if (const std::string fault = fault_of(program); !fault.empty())
        html += "<p>" + in_html(fault) + "</p>\n";
    html += messages_html(program);
    for (const Json& mistake : list_of(program, "mistakes"))
        html += "<p>" + mistake_text(mistake) + "</p>\n";
    html += functions_html(program);
    const Json& picture = object_of(program, "picture");
    html += picture_html(picture, "theirs", "the program's picture");
    html += picture_html(picture, "ours", "ours, by its rules");
    return html + "</section>\n";
}

} // namespace

std::string html_page(const Json& programs) {
    std::string html(page_head);
    const auto count = [&](std::string_view verdict) {
        return std::count_if(programs.begin(), programs.end(), [&](const Json& program) {
            return verdict_words(program) == verdict;
        });
    };
    html += fmt::format("<h1>{} of {} programs are right", count("right"), programs.size());
    if (const auto open = count("not judged"); open > 0)
        html += fmt::format(", {} could not be judged", open);
    if (const auto left = count("not checked"); left > 0)
        html += fmt::format(", {} not checked", left);
    html += "</h1>\n<table>\n<tr><th>program</th><th></th><th>step</th><th>functions</th>"
            "<th>picture</th><th>faults</th><th>fix first</th></tr>\n";
    for (std::size_t i = 0; i < programs.size(); ++i)
        html += row_html(programs[i], i);
    html += "</table>\n";
    for (std::size_t i = 0; i < programs.size(); ++i)
        html += section_html(programs[i], i);
    return html + "</body>\n</html>\n";
}

} // namespace rasterwalk
