#include "session/background_steps.h"

#include <exception>
#include <new>
#include <system_error>
#include <utility>

namespace rasterwalk {

BackgroundSteps::BackgroundSteps(std::function<bool()> step, StepMaker maker)
    : step_(std::move(step)) {
    if (maker == StepMaker::advance) return;
    try {
        thread_ = std::thread([this] {
            while (make_step()) {
            }
        });
    } catch (const std::system_error&) {
        // There are no threads here: advance() makes the steps.
    }
}

BackgroundSteps::~BackgroundSteps() {
    stop();
    if (thread_.joinable()) thread_.join();
}

void BackgroundSteps::advance() {
    if (!has_thread() && !is_done_) make_step();
}

bool BackgroundSteps::make_step() {
    std::string fault;
    bool has_more = false;
    try {
        has_more = !is_stopped_ && step_();
    } catch (const std::bad_alloc&) {
        fault = "There is not enough memory for this.";
    } catch (const std::exception& problem) {
        fault = problem.what();
    }
    if (!fault.empty()) {
        const std::lock_guard lock(mutex_);
        fault_ = fault;
    }
    is_done_ = !has_more;
    return has_more;
}

std::string BackgroundSteps::fault() const {
    const std::lock_guard lock(mutex_);
    return fault_;
}

} // namespace rasterwalk
