#include "ui/widgets/vector_letters.h"

#include <algorithm>

#include "explain/vectors.h"
#include "ui/ui.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

/// Does a name go on through this sign?
bool is_of_name(char sign) {
    const bool is_letter = (sign >= 'a' && sign <= 'z') || (sign >= 'A' && sign <= 'Z');
    return is_letter || (sign >= '0' && sign <= '9') || sign == '_';
}

} // namespace

std::optional<ImVec4> vector_letter_colour(const Ui& ui, char letter) {
    const std::optional<VectorReport>& report = ui.results.a.inspected.vectors;
    if (letter == 0 || !report) return std::nullopt;
    const std::vector<ShownVector>& vectors = report->vectors;
    const auto found = std::find_if(vectors.begin(), vectors.end(), [&](const ShownVector& vector) {
        return letter_of(vector.name) == letter;
    });
    if (found == vectors.end()) return std::nullopt;
    return colour_of(vector_meaning(found->name), ui.options.theme);
}

std::vector<LetterPart> vector_letters_in(std::string_view expression) {
    std::vector<LetterPart> parts;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < expression.size(); ++i) {
        const char before = i > 0 ? expression[i - 1] : ' ';
        const char after = i + 1 < expression.size() ? expression[i + 1] : ' ';
        const bool is_alone =
            !is_of_name(before) && before != '.' && !is_of_name(after) && after != '(';
        if (!is_alone || !is_vector_letter(expression[i])) continue;
        if (i > begin) parts.push_back({i, 0});
        parts.push_back({i + 1, expression[i]});
        begin = i + 1;
    }
    if (begin < expression.size()) parts.push_back({expression.size(), 0});
    return parts;
}

} // namespace rasterwalk
