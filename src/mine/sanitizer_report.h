#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mine/program_places.h"

namespace rasterwalk {

/// A fault that a sanitizer found.
struct SanitizerFault {
    std::string kind;     ///< in the sanitizer's own words: "heap-buffer-overflow", "signed integer
                          ///< overflow: 2147483647 + 1 cannot be represented in type 'int'"
    std::string sentence; ///< what it means, for a student
    ProgramPlace place;   ///< in the student's own files; line 0: not known
};

/// The first fault in what a program printed; none: there is none.
/// @param folder of the student's files: the innermost place in it is taken
std::optional<SanitizerFault> parse_sanitizer_report(std::string_view printed,
                                                     const std::string& folder);

} // namespace rasterwalk
