#pragma once

#include <string_view>
#include <vector>

#include <imgui.h>

#include "ui/widgets/style.h"

namespace rasterwalk {

/// Words of the same colour in a line of code.
struct ColouredWords {
    std::string_view text;
    ImVec4 ink;
};

/// A line of C++ as words with their colours: leftPixels and rightPixels have those that they have
/// in the table.
/// @param quiet of keywords, types and comments
std::vector<ColouredWords> coloured_code(std::string_view line, Theme theme, const ImVec4& plain,
                                         const ImVec4& quiet);

} // namespace rasterwalk
