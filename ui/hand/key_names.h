#pragma once

#include <string_view>

#include "ui/hand/hand.h"

namespace rasterwalk {

/// A key with the modifiers held with it.
struct KeyPress {
    int key = 0; ///< see ui/widgets/keys.h
    Modifiers modifiers;
};

/// Reads a key by name: "A", "7", "F1", "Space", "Ctrl+Shift+Z", "Ctrl++". Upper and lower case
/// are the same. Throws UsageError.
KeyPress parse_key(std::string_view text);

} // namespace rasterwalk
