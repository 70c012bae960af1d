#pragma once

#include <string_view>
#include <vector>

namespace rasterwalk {

/// Pins threads of this process to processors while it lives, so that none is moved in the middle
/// of a measurement. If the system cannot do that, nothing happens.
class PinnedThreads {
  public:
    PinnedThreads();
    ~PinnedThreads();
    PinnedThreads(const PinnedThreads&) = delete;
    PinnedThreads& operator=(const PinnedThreads&) = delete;

    /// Gives each thread that is there now the next of the processors, the oldest thread the first.
    /// @param name the start of the names of the threads that are meant; empty: all are meant
    void pin(std::string_view name = "");

  private:
    std::vector<int> processors_; ///< those that the process may use
};

} // namespace rasterwalk
