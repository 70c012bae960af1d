#pragma once

#include <cstddef>
#include <vector>

namespace rasterwalk::test {

/// How hard the randomized and exhaustive tests try: the environment's RASTERWALK_EFFORT, a number
/// from 0; 1 when it is not set. Anything else ends the test with a sentence.
double effort();

/// How often to repeat something: `full` times at effort 1, in proportion at others, but never less
/// than `fewest`, which must still mean something.
int rounds(int full, int fewest);

/// The members of `all` that effort leaves, evenly spread, the first and the last among them; never
/// less than `fewest` of them, nor more than all.
std::vector<std::size_t> spread(std::size_t all, std::size_t fewest);

template <class List>
auto some_of(const List& all, std::size_t fewest) {
    std::vector<typename List::value_type> chosen;
    for (const std::size_t i : spread(all.size(), fewest))
        chosen.push_back(all[i]);
    return chosen;
}

} // namespace rasterwalk::test
