#include "mine/compile/compile_messages.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "base/text_parts.h"

namespace rasterwalk {

namespace {

constexpr std::size_t most_notes = 2;

/// Takes ":12" off the end of a text; 0 if it does not end so.
int take_number(std::string_view& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos || colon + 1 == text.size()) return 0;
    int number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data() + colon + 1, end, number);
    if (fault != std::errc{} || stop != end || number < 0) return 0;
    text = text.substr(0, colon);
    return number;
}

/// "file:3:14" or "file:3".
void read_place(std::string_view text, std::string& file, int& line, int& column) {
    line = take_number(text);
    if (line == 0) return;
    if (const int before = take_number(text); before != 0) {
        column = line;
        line = before;
    }
    file = text;
}

/// A line "PLACE: KIND: TEXT"; no kind if it is another one.
struct SaidLine {
    std::string_view place, kind, text;
};

SaidLine read_line(std::string_view line) {
    SaidLine said;
    std::size_t first = std::string_view::npos;
    for (const std::string_view kind : {"error", "fatal error", "warning", "note",
                                        "internal compiler error", "sorry, unimplemented"}) {
        const std::string mark = fmt::format(": {}: ", kind);
        const std::size_t at = line.find(mark);
        if (at >= first) continue;
        first = at;
        said = {line.substr(0, at), kind, line.substr(at + mark.size())};
    }
    return said;
}

/// "warning: ... [-Wparentheses]" without the name of the option.
std::string_view without_option(std::string_view text) {
    const std::size_t open = text.rfind(" [-");
    return open != std::string_view::npos && text.ends_with(']') ? text.substr(0, open) : text;
}

/// What the linker says about a line: "/usr/bin/ld: /home/a/main.cpp:12: undefined reference to
/// `f()'"
bool read_linker_line(std::string_view line, std::vector<SaidMessage>& messages) {
    std::size_t at = line.find("undefined reference to ");
    if (at == std::string_view::npos) at = line.find("multiple definition of ");
    if (at == std::string_view::npos) return false;
    std::string_view place = trimmed(line.substr(0, at));
    if (place.ends_with(':')) place.remove_suffix(1);
    // Newer linkers add where it is in the object: "main.cpp:12:(.text+0xa):".
    if (const std::size_t section = place.rfind(":("); section != std::string_view::npos)
        place = place.substr(0, section);
    for (std::size_t linker = place.find("ld: "); linker != std::string_view::npos;
         linker = place.find("ld: ")) {
        place = place.substr(linker + 4);
    }
    // "object.o:/home/a/main.cpp:12"
    if (const std::size_t object = place.find(".o:/"); object != std::string_view::npos) {
        place = place.substr(object + 3);
    }
    SaidMessage said;
    read_place(place, said.message.file, said.message.line, said.message.column);
    std::string_view text = line.substr(at);
    // "; object.o:/home/a/other.cpp:3: first defined here"
    if (const std::size_t more = text.find("; "); more != std::string_view::npos) {
        text = text.substr(0, more);
    }
    said.message.text = text;
    const auto is_same = [&said](const SaidMessage& other) {
        return other.message.text == said.message.text;
    };
    // Each call has a message; one is enough.
    if (std::none_of(messages.begin(), messages.end(), is_same)) messages.push_back(said);
    return true;
}

bool only_says_that_it_failed(std::string_view text) {
    return text.starts_with("ld returned ") || text.starts_with("linker command failed");
}

} // namespace

std::vector<SaidMessage> read_compile_messages(std::string_view output) {
    std::vector<SaidMessage> messages;
    std::vector<SaidMessage::Place> through;
    std::size_t notes = 0;
    for (const std::string_view line : split_lines(output)) {
        if (read_linker_line(line, messages)) continue;
        const std::size_t required = line.find(":   required from ");
        if (required != std::string_view::npos) {
            SaidMessage::Place place;
            int column = 0;
            read_place(line.substr(0, required), place.file, place.line, column);
            through.insert(through.begin(), place);
            continue;
        }
        const SaidLine said = read_line(line);
        if (said.kind.empty() || only_says_that_it_failed(said.text)) continue;
        if (said.kind == "note") {
            SaidMessage::Place place;
            int column = 0;
            read_place(said.place, place.file, place.line, column);
            if (messages.empty()) continue;
            SaidMessage& owner = messages.back();
            owner.notes.push_back(place);
            if (said.text.starts_with("in instantiation of ")) {
                owner.through.insert(owner.through.begin(), place);
            } else if (!place.file.starts_with("/usr/") && notes < most_notes) {
                ++notes;
                owner.message.text += fmt::format("\nline {}: {}", place.line, trimmed(said.text));
            }
            continue;
        }
        SaidMessage message;
        read_place(said.place, message.message.file, message.message.line, message.message.column);
        message.message.is_error = said.kind != "warning";
        message.message.text = without_option(said.text);
        message.through = std::move(through);
        through.clear();
        notes = 0;
        messages.push_back(std::move(message));
    }
    for (SaidMessage& said : messages)
        said.message.cause = likely_cause(said.message.text);
    return messages;
}

} // namespace rasterwalk
