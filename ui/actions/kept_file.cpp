#include "ui/actions/kept_file.h"

#include "base/error.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

constexpr double seconds_between_tries = 5.0;

void give_up(Ui& ui, KeptFile& file, const char* what, const Error& fault) {
    file = {};
    ui.session.notice = std::string(what).append(" will not be kept: ").append(fault.what());
}

} // namespace

void take_up_kept(Ui& ui, KeptFile& file, const std::string& path, const char* what,
                  const std::function<void()>& read) {
    file = {};
    file.path = path;
    try {
        if (path.empty()) throw AccessError("there is no home folder.");
        read();
    } catch (const Error& fault) {
        give_up(ui, file, what, fault);
    }
}

void write_kept(Ui& ui, KeptFile& file, const char* what, const std::function<void()>& write) {
    if (file.path.empty() || ImGui::GetTime() < file.next_try) return;
    try {
        write();
        ++file.writes;
        if (file.is_failing) show_info(ui.session, std::string(what).append(" is kept again."));
        file.is_failing = false;
        file.next_try = 0.0;
    } catch (const AccessError& fault) {
        file.next_try = ImGui::GetTime() + seconds_between_tries;
        if (file.is_failing) return;
        file.is_failing = true;
        // The second of them must not hide that the first, especially progress, is lost too.
        const bool are_both = ui.lesson.progress_file.is_failing && ui.options_file.is_failing;
        ui.session.notice = std::string(are_both ? "Progress and the look of the window" : what)
                                .append(" will not be kept until this is fixed: ")
                                .append(fault.what());
    } catch (const Error& fault) {
        give_up(ui, file, what, fault);
    }
}

} // namespace rasterwalk
