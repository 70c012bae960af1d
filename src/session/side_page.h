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

} // namespace rasterwalk
