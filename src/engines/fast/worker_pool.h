#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace rasterwalk {

/// Threads that wait for work. They stay awake for a moment, since the next step of a picture
/// follows at once, and then sleep. PinnedThreads can pin them to processors.
class WorkerPool {
  public:
    /// @param count threads that work, the caller's among them; at least 1
    explicit WorkerPool(int count);
    ~WorkerPool();
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    int count() const { return static_cast<int>(threads_.size()) + 1; }

    /// Calls work(i) for 0 <= i < count(), each on its own thread, and waits for all. If one of
    /// them throws, all finish first; then the first exception is rethrown here.
    void run(const std::function<void(int)>& work);

  private:
    void end();
    void wait_for_work(int index);
    void work_safely(int index);

    std::vector<std::thread> threads_;
    const std::function<void(int)>* work_ = nullptr;
    std::atomic<std::uint32_t> round_{0};
    std::atomic<int> working_{0};
    std::atomic<bool> is_over_{false};
    std::mutex fault_guard_;
    std::exception_ptr fault_; ///< of the round; null: none so far
};

} // namespace rasterwalk
