#include "cli/whole_number.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/numbers.h"
#include "base/quoted.h"

namespace rasterwalk {

int whole_number(std::string_view option, const std::string& word, int smallest, int largest) {
    const auto number = parse_int(word);
    if (number && *number >= smallest && *number <= largest) return *number;
    throw UsageError(fmt::format("{} must be a whole number from {} to {}, not {}.", option,
                                 smallest, largest, in_quotes(word)));
}

} // namespace rasterwalk
