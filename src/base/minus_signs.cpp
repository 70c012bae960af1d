#include "base/minus_signs.h"

namespace rasterwalk {

std::string with_minus_signs(std::string_view text) {
    std::string shown;
    for (const char c : text)
        shown += c == '-' ? std::string("−") : std::string(1, c);
    return shown;
}

} // namespace rasterwalk
