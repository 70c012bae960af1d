#include "tests/support/effort.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

namespace rasterwalk::test {

double effort() {
    const char* const variable = std::getenv("RASTERWALK_EFFORT");
    if (!variable) return 1.0;
    const std::string_view text = variable;
    double value = -1.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{} || end != text.data() + text.size() || !(value >= 0.0) || value > 1e6)
        throw std::runtime_error("RASTERWALK_EFFORT is '" + std::string(text) +
                                 "', which is no number from 0 to 1000000");
    return value;
}

int rounds(int full, int fewest) {
    const double wanted = std::min(std::ceil(full * effort()), 2e9);
    return std::max(static_cast<int>(wanted), fewest);
}

std::vector<std::size_t> spread(std::size_t all, std::size_t fewest) {
    const double wanted = std::ceil(static_cast<double>(all) * std::min(effort(), 1.0));
    const std::size_t count = std::min(std::max(static_cast<std::size_t>(wanted), fewest), all);
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < count; ++i)
        chosen.push_back(count > 1 ? i * (all - 1) / (count - 1) : 0);
    return chosen;
}

} // namespace rasterwalk::test
