#pragma once

// What conditions and predictions in lessons calculate with.

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pipeline/cursor.h"

namespace rasterwalk {

enum class ValueType : std::uint8_t { number, word, moment, truth };

/// A value; without one (std::monostate) what was asked for is not there, as the pixel where none
/// is picked.
using Value = std::variant<std::monostate, double, std::string, Cursor, bool>;

/// Is there a value?
inline bool is_there(const Value& value) {
    return !std::holds_alternative<std::monostate>(value);
}

/// What is known of a name before it is asked: its type and which values it can have.
struct ValueRange {
    ValueType type = ValueType::number;
    std::vector<std::string_view> words; ///< of a word
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool is_whole = false; ///< a number without a fraction
};

} // namespace rasterwalk
