#include "base/letter_case.h"

#include <algorithm>

namespace rasterwalk {

namespace {

char small_letter(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

} // namespace

std::string in_small_letters(std::string_view text) {
    std::string small(text);
    std::transform(small.begin(), small.end(), small.begin(), small_letter);
    return small;
}

bool contains_in_any_case(std::string_view text, std::string_view part) {
    const auto are_same = [](char a, char b) { return small_letter(a) == small_letter(b); };
    return std::search(text.begin(), text.end(), part.begin(), part.end(), are_same) != text.end();
}

} // namespace rasterwalk
