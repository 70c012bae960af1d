#pragma once

// The letters of vectors in text, in the colours of the arrows while these are shown.

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <imgui.h>

namespace rasterwalk {

struct Ui;

/// The colour of a vector's letter; none if no vector with this letter is shown.
std::optional<ImVec4> vector_letter_colour(const Ui& ui, char letter);

/// A stretch of an expression, from the end of the previous one.
struct LetterPart {
    std::size_t end = 0; ///< index of the byte after it
    char vector = 0;     ///< the letter of a vector, of which a component may follow; 0: other text
};

/// Cuts an expression at the letters of vectors: "(n.x" into "(", "n" and ".x". No stretch is
/// empty.
std::vector<LetterPart> vector_letters_in(std::string_view expression);

} // namespace rasterwalk
