#include "mine/compile/two_at_a_time.h"

#include <atomic>
#include <future>
#include <memory>
#include <mutex>
#include <thread>

namespace rasterwalk {

void do_two_at_a_time(std::size_t count, const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    const auto take = [&] {
        for (std::size_t i = next++; i < count; i = next++)
            work(i);
    };
    std::future<void> helper;
    if (count > 1 && std::thread::hardware_concurrency() > 1)
        helper = std::async(std::launch::async, take);
    take();
    if (helper.valid()) helper.get();
}

std::function<bool()> asked_one_at_a_time(const std::function<bool()>& is_stopped) {
    if (!is_stopped) return {};
    return [is_stopped, asking = std::make_shared<std::mutex>()] {
        const std::lock_guard lock(*asking);
        return is_stopped();
    };
}

} // namespace rasterwalk
