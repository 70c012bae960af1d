#pragma once

#include <cstdint>

#include "base/enum_words.h"

namespace rasterwalk {

/// What is read beside the picture.
enum class SidePage : std::uint8_t {
    lesson, ///< the lesson; where none is open, the page about the stage
    stage,  ///< the page about the stage
    list,   ///< the list of lessons
};

template <>
inline constexpr auto enum_words<SidePage> = word_list("lesson", "stage", "list");
static_assert(words_match<SidePage>);

} // namespace rasterwalk
