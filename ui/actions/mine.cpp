#include "ui/actions/mine.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/quoted.h"
#include "mine/compile/project_folder.h"
#include "mine/program_check.h"
#include "mine/program_drawing.h"
#include "session/second_run.h"
#include "ui/actions/compare.h"
#include "ui/actions/lab.h"
#include "ui/actions/open_tab.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_watched = 60;
constexpr int depth_watched = 2; ///< folders below the program's that its sources may be in
constexpr std::chrono::milliseconds poll_pause{20};

std::string time_of_day() {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm parts{};
    localtime_r(&now, &parts);
    return fmt::format("{:02}:{:02}:{:02}", parts.tm_hour, parts.tm_min, parts.tm_sec);
}

void watch(std::vector<WatchedFile>& files, const std::string& path) {
    const bool is_known = std::any_of(files.begin(), files.end(),
                                      [&](const WatchedFile& one) { return one.path == path; });
    if (!is_known && !path.empty() && files.size() < most_watched)
        files.push_back({path, file_state(path)});
}

void watch_sources(std::vector<WatchedFile>& files, const StudentFiles& program) {
    watch(files, program.main);
    for (const std::string& source : program.sources)
        watch(files, source);
}

/// The files whose change means that the program has changed: its sources, and those next to them.
/// Their states are those before the check reads them, so no change is missed.
/// @param depth folders below the program's that are looked into
std::vector<WatchedFile> files_to_watch(const MineLook& mine, int depth) {
    std::vector<WatchedFile> files;
    std::error_code fault;
    const bool is_folder = fs::is_directory(mine.path, fault);
    if (!is_folder) watch(files, mine.path);
    if (mine.last) watch_sources(files, mine.last->files);
    const fs::path folder = is_folder ? fs::path(mine.path) : fs::path(mine.path).parent_path();
    try {
        for (const FoundFile& file : files_in(folder.string(), depth))
            if (is_source_name(file.path) || is_header_name(file.path)) watch(files, file.path);
    } catch (const Error&) {
        return files; // the check itself says why the folder cannot be read
    }
    return files;
}

/// Begins as soon as the check that may still be running has stopped: both use the same folder.
void want_check(Ui& ui) {
    MineLook& mine = ui.mine;
    stop_program_check(ui);
    mine.is_given_up = mine.is_whole = false;
    mine.is_wanted = true;
    mine.fault.clear();
    mine.message = 0;
    mine.changes.clear();
    ++mine.checks;
    mine.was_edited = false;
    mine.watched = files_to_watch(mine, depth_watched);
    mine.checked_at = time_of_day();
}

bool is_running(const MineLook& mine) {
    return mine.check != nullptr || mine.is_wanted;
}

void begin_check(MineLook& mine) {
    mine.is_wanted = false;
    try {
        CheckProgramOptions options;
        options.search = mine.search;
        mine.check = begin_program_check(mine.path, options);
    } catch (const std::system_error&) {
        mine.fault = "There is no thread to check the program on.";
    }
}

/// From now on, a line is compared with what it is now.
void remember_lines(MineLook& mine) {
    for (const CheckLine& line : mine.lines) {
        const auto known =
            std::find_if(mine.before.begin(), mine.before.end(),
                         [&](const CheckLine& one) { return one.name == line.name; });
        if (known == mine.before.end()) {
            mine.before.push_back(line);
        } else {
            *known = line;
        }
    }
}

/// What the program has drawn, in this room. Null: nothing that could be compared.
std::shared_ptr<const ProgramDrawing> drawing_in(const MineLook& mine,
                                                 const std::shared_ptr<const Scene>& room) {
    return mine.last && mine.last->picture ? drawing_of(*mine.last, room) : nullptr;
}

/// If the program is compared with ours, its latest picture is. All else stays as it is.
void renew_compared(Ui& ui) {
    Session& session = ui.session;
    MineLook& mine = ui.mine;
    const bool is_compared =
        session.b && session.b->program != nullptr && session.b->program->scene == session.scene;
    if (!is_compared || mine.compared == mine.last_of) return;
    const auto drawing = drawing_in(mine, session.scene);
    if (drawing == nullptr) return;
    mine.compared = mine.last_of;
    const bool follows = session.a.settings == session.b->settings;
    session.b = Run{drawing->settings, drawing};
    // It is no choice of the student's that could be undone.
    session.undo.now.b = session.b;
    if (!follows) return;
    session.a.settings = drawing->settings;
    session.undo.now.a = session.a;
    if (!session.replaced) return;
    session.replaced->after = session.a;
    session.undo.now.replaced = session.replaced;
}

bool does_not_compile(const MineLook& mine) {
    return mine.last && !mine.last->compiles();
}

/// Is there another source or header, where one may be missing? Looks once a second.
bool was_file_added(MineLook& mine) {
    const auto now = std::chrono::steady_clock::now();
    if (!does_not_compile(mine) || is_running(mine) || now < mine.next_listing) return false;
    mine.next_listing = now + std::chrono::seconds(1);
    // In the program's own folder: more would take too long for a frame.
    const std::vector<WatchedFile> files = files_to_watch(mine, 1);
    return std::any_of(files.begin(), files.end(), [&](const WatchedFile& file) {
        return std::none_of(mine.watched.begin(), mine.watched.end(),
                            [&](const WatchedFile& known) { return known.path == file.path; });
    });
}

void take_over(Ui& ui, const std::shared_ptr<const CheckedProgram>& known, bool is_whole) {
    MineLook& mine = ui.mine;
    mine.last = known;
    mine.last_of = mine.checks;                // the check before has been stopped
    watch_sources(mine.watched, known->files); // the check has found which they are
    ++mine.number;
    mine.is_whole = is_whole;
    mine.lines = check_lines(*known, is_whole);
    mine.changes = changed_lines(mine.before, mine.lines);
    if (is_whole) remember_lines(mine);
    renew_compared(ui);
}

} // namespace

void check_my_program(Ui& ui, std::string path) {
    MineLook& mine = ui.mine;
    std::error_code fault;
    const fs::path whole = fs::absolute(path, fault);
    if (!fault) path = whole.string();
    if (path != mine.path) {
        stop_program_check(ui);
        MineLook fresh;
        fresh.stopped = std::move(mine.stopped);
        fresh.checks = mine.checks;
        fresh.number = mine.number;
        fresh.search = mine.search;
        fresh.look_pause = mine.look_pause;
        fresh.pictures = std::move(mine.pictures); // its textures are used again
        fresh.path = path;
        mine = std::move(fresh);
    }
    // A file of options holds text only.
    if (visible_line(path) == path) ui.options.program = path;
    open_tab(ui, "mine");
    if (ui.host.is_browser) return; // the tab says that a browser cannot
    want_check(ui);
}

void check_my_program_again(Ui& ui) {
    if (!ui.mine.path.empty()) check_my_program(ui, ui.mine.path);
}

void poll_program_check(Ui& ui) {
    MineLook& mine = ui.mine;
    std::erase_if(mine.stopped, [](const auto& one) { return one->is_done(); });
    if (program_was_edited(ui) || was_file_added(mine)) want_check(ui);
    if (mine.is_wanted && mine.stopped.empty()) begin_check(mine);
    if (!mine.check) return;
    if (!mine.check->is_done()) {
        const auto known = mine.check->so_far();
        if (known && known != mine.last) take_over(ui, known, false);
        return;
    }
    const std::shared_ptr<ProgramCheck> done = std::move(mine.check);
    try {
        take_over(ui, done->take(), true);
    } catch (const std::exception& fault) {
        mine.fault = fault.what();
    }
}

void stop_program_check(Ui& ui) {
    MineLook& mine = ui.mine;
    mine.is_given_up = mine.is_given_up || is_checking_program(ui);
    mine.is_wanted = false;
    if (!mine.check) return;
    mine.check->stop();
    mine.stopped.push_back(std::move(mine.check));
}

void compare_my_program(Ui& ui, bool to_parting) {
    MineLook& mine = ui.mine;
    Session& session = ui.session;
    if (refuses_settings(session)) return;
    try {
        const auto drawing = drawing_in(mine, usual_room(session));
        if (drawing == nullptr) {
            session.notice = "Which pixels your program puts, and in which order, is not known.";
            return;
        }
        compare_with_program(session, drawing);
        mine.compared = mine.last_of;
        session.notice.clear();
        if (!to_parting) return;
        const std::optional<Cursor> parting = moment_of_parting(*drawing);
        if (parting) session.cursor = *parting;
        if (!parting)
            show_info(session, "Both put the same pixels in the same order; their colours differ.");
    } catch (const Error& fault) {
        session.notice = fault.what();
    }
}

bool is_checking_program(const Ui& ui) {
    return is_running(ui.mine);
}

bool may_miss_file(const Ui& ui) {
    return does_not_compile(ui.mine);
}

bool program_was_edited(Ui& ui) {
    MineLook& mine = ui.mine;
    const auto now = std::chrono::steady_clock::now();
    if (mine.was_edited || now < mine.next_look) return mine.was_edited;
    mine.next_look = now + mine.look_pause;
    mine.was_edited =
        std::any_of(mine.watched.begin(), mine.watched.end(),
                    [](const WatchedFile& file) { return file_state(file.path) != file.state; });
    return mine.was_edited;
}

void finish_program_check(Ui& ui) {
    MineLook& mine = ui.mine;
    while (is_checking_program(ui)) {
        const ProgramCheck* const running = mine.check             ? mine.check.get()
                                            : mine.stopped.empty() ? nullptr
                                                                   : mine.stopped.front().get();
        if (running != nullptr) running->is_done(poll_pause);
        poll_program_check(ui);
    }
}

} // namespace rasterwalk
