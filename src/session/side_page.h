#pragma once

#include <cstdint>

#include "base/enum_words.h"

namespace rasterwalk {

/// The page next to the picture.
enum class SidePage : std::uint8_t {
    lesson, ///< the lesson; if none is open, the page about the stage
    stage,  ///< the page about the stage
    list,   ///< the list of lessons
};

template <>
inline constexpr auto enum_words<SidePage> = word_list("lesson", "stage", "list");
static_assert(words_match<SidePage>);

} // namespace rasterwalk
