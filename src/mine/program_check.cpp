#include "mine/program_check.h"

#include <utility>

#include "laboratory/bug.h"

namespace rasterwalk {

ProgramCheck::ProgramCheck(Work work, CheckProgramOptions options) {
    thread_ = std::thread(
        [this, work = std::move(work), options = std::move(options)] { run(work, options); });
}

ProgramCheck::~ProgramCheck() {
    stop();
    if (thread_.joinable()) thread_.join();
}

void ProgramCheck::run(const Work& work, CheckProgramOptions options) {
    options.is_stopped = [this] { return is_stopped_.load(); };
    options.say = [this](std::string_view what) {
        const std::lock_guard lock(mutex_);
        doing_ = what;
    };
    options.report = [this](const CheckedProgram& known) {
        auto copy = std::make_shared<const CheckedProgram>(known);
        const std::lock_guard lock(mutex_);
        so_far_ = std::move(copy);
    };
    try {
        auto whole = std::make_shared<const CheckedProgram>(work(options));
        const std::lock_guard lock(mutex_);
        so_far_ = std::move(whole);
    } catch (...) {
        fault_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    is_done_ = true;
    end_.notify_all();
}

std::string ProgramCheck::doing() const {
    const std::lock_guard lock(mutex_);
    return doing_;
}

std::shared_ptr<const CheckedProgram> ProgramCheck::so_far() const {
    const std::lock_guard lock(mutex_);
    return so_far_;
}

bool ProgramCheck::is_done(std::chrono::milliseconds patience) const {
    std::unique_lock lock(mutex_);
    return end_.wait_for(lock, patience, [&] { return is_done_; });
}

std::shared_ptr<const CheckedProgram> ProgramCheck::take() {
    if (thread_.joinable()) thread_.join();
    if (fault_) std::rethrow_exception(fault_);
    return so_far();
}

std::unique_ptr<ProgramCheck> begin_program_check(const std::string& path,
                                                  const CheckProgramOptions& options) {
    return std::make_unique<ProgramCheck>(
        [path](const CheckProgramOptions& in_thread) {
            return check_program(find_student_files(path), read_lab_scenes(), read_bugs(),
                                 in_thread);
        },
        options);
}

} // namespace rasterwalk
