#include "engines/fast/worker_pool.h"

#include <algorithm>

#if defined(__linux__)
#include <pthread.h>
#include <sched.h>
#endif

namespace rasterwalk {

namespace {

/// How often a thread looks before it sleeps: some ten microseconds.
constexpr int looks = 20000;

/// Keeps a thread on one core, so that what it has read stays in that core's cache. The system may
/// refuse, and nothing is lost.
void pin(std::thread& thread, int core) {
#if defined(__linux__)
    const unsigned cores = std::thread::hardware_concurrency();
    if (cores < 2) return;
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(static_cast<unsigned>(core) % cores, &set);
    pthread_setaffinity_np(thread.native_handle(), sizeof set, &set);
#else
    static_cast<void>(thread);
    static_cast<void>(core);
#endif
}

} // namespace

WorkerPool::WorkerPool(int count) {
    for (int i = 1; i < count; ++i) {
        threads_.emplace_back([this, i] { wait_for_work(i); });
        pin(threads_.back(), i);
    }
}

WorkerPool::~WorkerPool() {
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
    work(0);
    for (int look = 0; working_ != 0; ++look) {
        if (look > looks) std::this_thread::yield();
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
        (*work_)(index);
        --working_;
    }
}

} // namespace rasterwalk
