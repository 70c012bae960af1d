#include "base/nearest_name.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "base/quoted.h"

namespace rasterwalk {

namespace {

/// Longer words are not slips of the pen, and would only cost time.
constexpr std::size_t longest_name = 64;

/// The edit distance of Levenshtein.
std::size_t letters_between(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j] + 1, diagonal + 1, changed});
        }
    }
    return row.back();
}

} // namespace

std::string_view nearest_name(std::string_view wanted, std::span<const std::string_view> names) {
    if (wanted.empty() || wanted.size() > longest_name) return {};
    std::string_view nearest;
    std::size_t fewest = std::max<std::size_t>(2, wanted.size() / 3) + 1;
    for (const std::string_view name : names) {
        // "power" for "light.power" is not a slip of the pen either, but worth a guess.
        const bool is_tail = name.size() > wanted.size() && name.ends_with(wanted) &&
                             name[name.size() - wanted.size() - 1] == '.';
        const std::size_t distance = is_tail ? 0 : letters_between(wanted, name);
        if (distance < fewest) {
            fewest = distance;
            nearest = name;
        }
    }
    return nearest;
}

std::string did_you_mean(std::string_view wanted, std::span<const std::string_view> names) {
    const std::string_view nearest = nearest_name(wanted, names);
    if (nearest.empty()) return {};
    return fmt::format(" Did you mean '{}'?", nearest);
}

std::string no_such_name(std::string_view what, std::string_view wanted,
                         std::span<const std::string_view> names) {
    return fmt::format("there is no {} {}; choose from {}.{}", what, in_quotes(wanted),
                       fmt::join(names, ", "), did_you_mean(wanted, names));
}

} // namespace rasterwalk
