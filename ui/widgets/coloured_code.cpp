#include "ui/widgets/coloured_code.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace rasterwalk {

namespace {

constexpr std::array keywords{
    std::string_view("const"),   std::string_view("continue"), std::string_view("else"),
    std::string_view("float"),   std::string_view("double"),   std::string_view("for"),
    std::string_view("if"),      std::string_view("int"),      std::string_view("bool"),
    std::string_view("mat3"),    std::string_view("return"),   std::string_view("struct"),
    std::string_view("vec3"),    std::string_view("vector"),   std::string_view("void"),
    std::string_view("while"),   std::string_view("break"),    std::string_view("Pixel"),
    std::string_view("Vertex"),  std::string_view("Triangle"), std::string_view("vec2"),
    std::string_view("Texture"), std::string_view("vec4"),     std::string_view("Axes"),
    std::string_view("Vec4d"),   std::string_view("Matrix"),   std::string_view("Edge"),
    std::string_view("true"),    std::string_view("false"),
};

bool is_of_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

} // namespace

std::vector<ColouredWords> coloured_code(std::string_view line, Theme theme, const ImVec4& plain,
                                         const ImVec4& quiet) {
    const auto ink_of = [&](std::string_view word) {
        if (word == "leftPixels") return colour_of(Meaning::left_end, theme);
        if (word == "rightPixels") return colour_of(Meaning::right_end, theme);
        const bool is_keyword = std::find(keywords.begin(), keywords.end(), word) != keywords.end();
        return is_keyword ? quiet : plain;
    };
    std::vector<ColouredWords> words;
    const std::size_t comment = std::min(line.find("//"), line.size());
    std::size_t at = 0;
    while (at < comment) {
        std::size_t end = at;
        const bool is_word = is_of_word(line[at]);
        while (end < comment && is_of_word(line[end]) == is_word)
            ++end;
        const std::string_view text = line.substr(at, end - at);
        words.push_back({text, is_word ? ink_of(text) : plain});
        at = end;
    }
    if (comment < line.size()) words.push_back({line.substr(comment), quiet});
    return words;
}

} // namespace rasterwalk
