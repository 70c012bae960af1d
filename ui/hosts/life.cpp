#include "ui/hosts/life.h"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <functional>
#include <limits>

#include "base/error.h"
#include "base/image.h"
#include "lessons/progress.h"
#include "session/walk.h"
#include "ui/actions/compare.h"
#include "ui/actions/measure.h"
#include "ui/actions/mine.h"
#include "ui/actions/open_lesson.h"
#include "ui/app/app.h"
#include "ui/app/kept_options.h"
#include "ui/hosts/gl2.h"
#include "ui/start/start_choice.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"

namespace rasterwalk {

namespace {

/// Between two blinks of the text cursor, seconds.
constexpr double cursor_blink = 0.2;
/// How often the window looks how far the check of a program is, seconds.
constexpr double check_step = 0.1;
/// How often it looks for a file that the program may miss, seconds.
constexpr double missing_file_step = 1.0;
constexpr float shortest_step = 1e-4f;

/// True while a mouse button or key is held: its effect continues without further events.
bool is_held() {
    const ImGuiIO& io = ImGui::GetIO();
    return std::any_of(std::begin(io.MouseDown), std::end(io.MouseDown), std::identity{}) ||
           is_any_key_down();
}

/// Adds a number if the file already exists.
std::string picture_path() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    char stamp[32];
    std::strftime(stamp, sizeof stamp, "%Y%m%d-%H%M%S", &local);
    const std::string stem = std::string("rasterwalk-") + stamp;
    std::string path = stem + ".png";
    std::error_code ignored;
    for (int n = 2; std::filesystem::exists(path, ignored) && n < 100; ++n)
        path = stem + "-" + std::to_string(n) + ".png";
    return path;
}

} // namespace

void take_up(Ui& ui, bool is_plain) {
    const std::string folder = state_folder();
    keep_options(ui, folder.empty() ? "" : folder + "/window.toml");
    keep_progress(ui, folder.empty() ? "" : folder + "/progress.toml");
    const std::string notice = ui.session.notice;
    if (is_plain) {
        begin_at_start(ui);
    } else {
        take_up_lesson(ui); // again, now that there is a progress to note it in
    }
    if (!notice.empty()) ui.session.notice = notice;
}

double seconds_to_next_frame(const Ui& ui, int frames_due) {
    if (frames_due > 0 || is_animating(ui) || is_held() || is_input_waiting()) return 0.0;
    const double typing =
        ImGui::GetIO().WantTextInput ? cursor_blink : std::numeric_limits<double>::infinity();
    // What takes long on another thread needs its processor more than many frames.
    const double checking = is_checking_program(ui) ? check_step
                            : may_miss_file(ui)     ? missing_file_step
                                                    : std::numeric_limits<double>::infinity();
    return std::min({seconds_to_blink(ui), seconds_to_progress(ui), typing, checking});
}

float frame_step(float passed, float meant_sleep) {
    return std::clamp(passed, shortest_step, meant_sleep + longest_play_step);
}

void save_window_picture(Ui& ui, int width, int height) {
    ui.host.wants_picture = false;
    const std::string path = picture_path();
    try {
        write_png(read_gl2(width, height), path);
        if (ui.host.is_browser) ui.host.hand_out(path);
        std::error_code fault;
        const std::filesystem::path folder = std::filesystem::current_path(fault);
        const bool is_plain = static_cast<bool>(fault) || ui.host.is_browser;
        show_info(ui.session, "Picture of the window saved as " +
                                  (is_plain ? path : (folder / path).string()) + ".");
    } catch (const Error& error) {
        ui.session.notice = error.what();
    }
}

} // namespace rasterwalk
