#pragma once

// The values that conditions and predictions in lessons calculate with.

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pipeline/cursor.h"

namespace rasterwalk {

enum class ValueType : std::uint8_t { number, word, moment, truth };

/// A value; std::monostate if there is none, like the pixel when none is
/// picked.
using Value = std::variant<std::monostate, double, std::string, Cursor, bool>;

/// Is there a value?
inline bool is_there(const Value& value) {
    return !std::holds_alternative<std::monostate>(value);
}

/// What is known about a name in advance: its type and its possible values.
struct ValueRange {
    ValueType type = ValueType::number;
    std::vector<std::string_view> words; ///< if it is a word
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool is_whole = false; ///< a number without a fraction
};

} // namespace rasterwalk
