#include "text/markdown_walk.h"

#include <algorithm>

#include "base/text_parts.h"
#include "text/markdown.h"
#include "text/markdown_text.h"

namespace rasterwalk {

namespace {

/// The parser looks through all lines of a paragraph for each bracket in it; this many take about a
/// tenth of a second.
constexpr std::size_t most_bracket_looks = 200'000'000;

/// Would the parser look through lines for brackets more often than allowed?
bool is_bracket_swamp(std::string_view text) {
    std::size_t lines = 0, brackets = 0, looks = 0;
    while (!text.empty()) {
        const std::string_view line = take_part(text, '\n');
        if (line.find_first_not_of(" \t") == std::string_view::npos) {
            looks += lines * brackets;
            lines = brackets = 0;
        } else {
            ++lines;
            brackets += static_cast<std::size_t>(std::count(line.begin(), line.end(), '['));
        }
    }
    return looks + lines * brackets > most_bracket_looks;
}

/// The answer to md4c, which ignores positive ones.
int answer(bool goes_on) {
    return goes_on ? 0 : -1;
}

MarkdownListener& listener_of(void* data) {
    return *static_cast<MarkdownListener*>(data);
}

} // namespace

std::string nesting_fault(int deepest) {
    return "The text is nested deeper than " + std::to_string(deepest) + " levels.";
}

std::string attribute_text(const MD_ATTRIBUTE& attribute) {
    std::string text;
    for (int i = 0; attribute.size > 0 && attribute.substr_offsets[i] < attribute.size; ++i) {
        const MD_OFFSET begin = attribute.substr_offsets[i];
        const std::string_view part(attribute.text + begin,
                                    attribute.substr_offsets[i + 1] - begin);
        if (attribute.substr_types[i] == MD_TEXT_ENTITY) {
            append_entity(text, part);
        } else if (attribute.substr_types[i] == MD_TEXT_NULLCHAR) {
            text += replacement_character;
        } else {
            text += part;
        }
    }
    return text;
}

std::string size_fault(std::string_view text) {
    return text.size() > largest_markdown ? "The text is longer than 1 MB." : std::string();
}

std::string walk_fault(std::string_view text) {
    return is_bracket_swamp(text) ? "A paragraph has too many lines and brackets." : std::string();
}

bool walk_markdown(std::string_view text, MarkdownListener& listener) {
    MD_PARSER parser{};
    parser.flags = MD_FLAG_TABLES | MD_FLAG_NOHTML | MD_FLAG_LATEXMATHSPANS;
    parser.enter_block = [](MD_BLOCKTYPE type, void* detail, void* data) {
        return answer(listener_of(data).enter(type, detail));
    };
    parser.leave_block = [](MD_BLOCKTYPE type, void*, void* data) {
        return answer(listener_of(data).leave(type));
    };
    parser.enter_span = [](MD_SPANTYPE type, void* detail, void* data) {
        return answer(listener_of(data).enter_span(type, detail));
    };
    parser.leave_span = [](MD_SPANTYPE type, void*, void* data) {
        return answer(listener_of(data).leave_span(type));
    };
    parser.text = [](MD_TEXTTYPE type, const MD_CHAR* part, MD_SIZE size, void* data) {
        return answer(listener_of(data).text(type, {part, size}));
    };
    return md_parse(text.data(), static_cast<MD_SIZE>(text.size()), &parser, &listener) == 0;
}

} // namespace rasterwalk
