#include "lessons/choice_order.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace rasterwalk {

namespace {

/// Source: G. Fowler, L. C. Noll, K. Vo, FNV-1a, 64 bits. Not std::hash: that is another one in
/// every library.
std::uint64_t hash_of(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char letter : text) {
        hash ^= static_cast<unsigned char>(letter);
        hash *= 0x100000001b3u;
    }
    return hash;
}

} // namespace

std::vector<int> shuffled(int count, std::string_view name) {
    std::vector<std::pair<std::uint64_t, int>> keyed;
    // The number first: the last letters of a text hardly reach the upper bits.
    for (int i = 0; i < count; ++i)
        keyed.emplace_back(hash_of(std::to_string(i).append("/").append(name)), i);
    std::sort(keyed.begin(), keyed.end());
    std::vector<int> order;
    for (const auto& [key, number] : keyed)
        order.push_back(number);
    return order;
}

} // namespace rasterwalk
