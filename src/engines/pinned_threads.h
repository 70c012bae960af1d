#pragma once

#include <string_view>
#include <vector>

namespace rasterwalk {

/// Holds threads of this process to processors while it lives, so that none is moved in the middle
/// of a measurement. Where the system cannot do that, nothing happens.
class PinnedThreads {
  public:
    PinnedThreads();
    ~PinnedThreads();
    PinnedThreads(const PinnedThreads&) = delete;
    PinnedThreads& operator=(const PinnedThreads&) = delete;

    /// Gives each thread that is there now the next of the processors, the oldest thread the first.
    /// @param name how the names of the threads that are meant begin; empty: all are meant
    void pin(std::string_view name = "");

  private:
    std::vector<int> processors_; ///< that the process may use
};

} // namespace rasterwalk
