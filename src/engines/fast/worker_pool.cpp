#include "engines/fast/worker_pool.h"

#include <utility>

namespace rasterwalk {

namespace {

/// How often a thread looks before it sleeps: some ten microseconds.
constexpr int looks = 20000;

} // namespace

WorkerPool::WorkerPool(int count) {
    try {
        for (int i = 1; i < count; ++i)
            threads_.emplace_back([this, i] { wait_for_work(i); });
    } catch (...) {
        end(); // ends those that could be started
        throw;
    }
}

WorkerPool::~WorkerPool() {
    end();
}

void WorkerPool::end() {
    is_over_ = true;
    ++round_;
    round_.notify_all();
    for (std::thread& thread : threads_)
        thread.join();
}

void WorkerPool::run(const std::function<void(int)>& work) {
    if (threads_.empty()) {
        work(0);
        return;
    }
    work_ = &work;
    working_ = static_cast<int>(threads_.size());
    ++round_;
    round_.notify_all();
    work_safely(0);
    for (int look = 0; working_ != 0; ++look) {
        if (look > looks) std::this_thread::yield();
    }
    if (fault_ != nullptr) std::rethrow_exception(std::exchange(fault_, nullptr));
}

void WorkerPool::work_safely(int index) {
    try {
        (*work_)(index);
    } catch (...) {
        const std::lock_guard guard(fault_guard_);
        if (fault_ == nullptr) fault_ = std::current_exception();
    }
}

void WorkerPool::wait_for_work(int index) {
    std::uint32_t seen = 0;
    while (true) {
        for (int look = 0; round_ == seen && look < looks; ++look) {
        }
        round_.wait(seen);
        // The next round does not begin before this one's work is done.
        seen = round_;
        if (is_over_) return;
        work_safely(index);
        --working_;
    }
}

} // namespace rasterwalk
