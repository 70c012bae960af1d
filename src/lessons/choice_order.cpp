#include "lessons/choice_order.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace rasterwalk {

namespace {

/// Source: G. Fowler, L. C. Noll, K. Vo, FNV-1a, 64 bits, and a last mix as in splitmix64. Not
/// std::hash, which differs between libraries.
std::uint64_t hash_of(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char letter : text) {
        hash ^= static_cast<unsigned char>(letter);
        hash *= 0x100000001b3u;
    }
    // The last letters of a text hardly reach the upper bits, which decide the order.
    hash ^= hash >> 32;
    hash *= 0xbf58476d1ce4e5b9u;
    return hash ^ (hash >> 32);
}

} // namespace

std::vector<int> shuffled(int count, std::string_view name) {
    std::vector<std::pair<std::uint64_t, int>> keyed;
    for (int i = 0; i < count; ++i)
        keyed.emplace_back(hash_of(std::string(name).append("/").append(std::to_string(i))), i);
    std::sort(keyed.begin(), keyed.end());
    std::vector<int> order;
    for (const auto& [key, number] : keyed)
        order.push_back(number);
    return order;
}

} // namespace rasterwalk
