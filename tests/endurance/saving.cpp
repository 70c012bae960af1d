// What is kept on the disk, while programs are killed, disks are full and homes are missing.
// tests/endurance/endure runs it and says what its exit codes mean.
//   rasterwalk-endurance-saving kills FOLDER [KILLS [SEED]]
//   rasterwalk-endurance-saving windows FOLDER [SAVES]
//   rasterwalk-endurance-saving homes FOLDER
// FOLDER receives all that is written.

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iterator>
#include <new>
#include <string>
#include <vector>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "lessons/progress.h"
#include "session/content.h"
#include "tests/support/random.h"
#include "tests/ui/driver.h"
#include "ui/actions/open_lesson.h"
#include "ui/app/kept_options.h"
#include "view/state_file.h"

namespace {

using namespace rasterwalk;
namespace fs = std::filesystem;

constexpr const char* lesson = "01-pinhole-camera";
constexpr int view_steps = 60; ///< after which the steps of the saved view begin again
int faults = 0;

void report(const std::string& fault) {
    std::printf("FAULT: %s\n", fault.c_str());
    ++faults;
}

/// Runs an action in a process of its own, which ends without a word.
pid_t begin_process(const std::function<int()>& action) {
    std::fflush(stdout);
    const pid_t child = ::fork();
    if (child != 0) return child;
    int code = 1;
    try {
        code = action();
    } catch (const std::exception& fault) {
        std::printf("FAULT: %s\n", fault.what());
    }
    std::fflush(stdout);
    ::_exit(code);
}

int end_of(pid_t child) {
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
}

/// Has it ended? end_of() can still be asked how.
bool has_ended(pid_t child) {
    siginfo_t about{};
    const auto id = static_cast<id_t>(child);
    return ::waitid(P_PID, id, &about, WEXITED | WNOHANG | WNOWAIT) == 0 && about.si_pid == child;
}

/// How often each file was written, as the processes say that write it.
struct Written {
    std::atomic<int> progress, options, view;
};

Written& shared_count() {
    void* const memory =
        ::mmap(nullptr, sizeof(Written), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    return *new (memory) Written{};
}

int tasks_in(const std::string& path) {
    return static_cast<int>(read_progress(path).of(lesson).tasks.size());
}

int score_in(const std::string& path) {
    return fs::exists(path) ? parse_options(read_file(path), path, {}).score.points : 0;
}

int step_in(const std::string& path) {
    if (!fs::exists(path)) return 0;
    return read_view(path).step;
}

/// Saves everything that the program saves, one more each time, until it is killed.
[[noreturn]] void save_for_ever(const std::string& folder, Written& written) {
    const std::string progress_path = folder + "/progress.toml",
                      view_path = folder + "/view.walk.toml";
    ImGui::CreateContext(); // the clock
    Ui ui;
    ui.options_file.path = folder + "/window.toml";
    ui.options = ui.kept_options = parse_options(
        fs::exists(ui.options_file.path) ? read_file(ui.options_file.path) : "", "", {});
    Session session = open_session(lessons_folder().append("/").append(usual_scene));
    session.lesson = lesson;
    session.step = step_in(view_path);
    Progress kept = read_progress(progress_path);
    for (int i = 1;; ++i) {
        Progress mine = kept;
        mine.record_task(lesson, "task-" + std::to_string(mine.of(lesson).tasks.size()));
        kept = write_progress(kept, mine, progress_path);
        written.progress = static_cast<int>(kept.of(lesson).tasks.size());
        ui.options.score.is_kept = true;
        ui.options.score.rounds = ui.options.score.points = ui.options.score.points + 1;
        save_options(ui);
        written.options = ui.options.score.points;
        session.step = (session.step + 1) % view_steps;
        write_view(session, view_path);
        written.view = session.step;
    }
}

/// A file must have what was last said to be in it, or one more.
void check_file(const char* name, int is, int said, int turn = 1 << 30) {
    if (is != said && is != (said + 1) % turn)
        report(fmt::format("{} has {} after {} were written", name, is, said));
}

int files_in(const std::string& folder) {
    return static_cast<int>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

int kills(const std::string& folder, int count, unsigned seed) {
    Written& written = shared_count();
    test::Random random(seed);
    int most_files = 0;
    for (int i = 0; i < count; ++i) {
        const int least = written.progress;
        const pid_t child = begin_process([&]() -> int { save_for_ever(folder, written); });
        // Not before it has saved for the first time, or most would be killed while starting.
        while (written.progress == least && !has_ended(child))
            ::usleep(100);
        ::usleep(static_cast<useconds_t>(random.integer(0, 10'000)));
        ::kill(child, SIGKILL);
        const int status = end_of(child);
        if (!WIFSIGNALED(status) || WTERMSIG(status) != SIGKILL)
            report("a process ended by itself");
        check_file("progress.toml", tasks_in(folder + "/progress.toml"), written.progress);
        check_file("window.toml", score_in(folder + "/window.toml"), written.options);
        check_file("view.walk.toml", step_in(folder + "/view.walk.toml"), written.view, view_steps);
        written.progress = tasks_in(folder + "/progress.toml");
        written.options = score_in(folder + "/window.toml");
        written.view = step_in(folder + "/view.walk.toml");
        most_files = std::max(most_files, files_in(folder));
    }
    constexpr int own_files = 5; // three, and two locks
    if (most_files > own_files + 3) report(fmt::format("there were {} files", most_files));
    std::printf("%d kills: progress saved %d times, the window's look %d times; never more than %d "
                "files; %d faults\n",
                count, int{written.progress}, int{written.options}, most_files, faults);
    return faults > 0 ? 1 : 0;
}

/// One of several windows, which saves what it did in its own lesson.
int save_as_window(const std::string& folder, const std::string& own, int saves, int& late) {
    const std::string path = folder + "/progress.toml";
    Progress kept = read_progress(path);
    for (int i = 0; i < saves; ++i) {
        Progress mine = kept;
        mine.record_task(own, "task-" + std::to_string(i));
        while (true) {
            try {
                kept = write_progress(kept, mine, path);
                break;
            } catch (const AccessError&) {
                ++late; // the window says so, and tries again
            }
        }
    }
    return 0;
}

int windows(const std::string& folder, int saves) {
    for (const int count : {2, 5}) {
        const std::string own_folder = fmt::format("{}/{}-windows", folder, count);
        std::vector<pid_t> children;
        for (int i = 0; i < count; ++i) {
            children.push_back(begin_process([&] {
                int late = 0;
                const int code =
                    save_as_window(own_folder, fmt::format("lesson-{}", i), saves, late);
                if (late > 0) std::printf("window %d had to wait %d times\n", i, late);
                return code;
            }));
        }
        for (const pid_t child : children)
            if (end_of(child) != 0) report("a window could not save");
        const Progress all = read_progress(own_folder + "/progress.toml");
        int lost = 0;
        for (int i = 0; i < count; ++i)
            lost += saves - static_cast<int>(all.of(fmt::format("lesson-{}", i)).tasks.size());
        if (lost > 0) report(fmt::format("{} saves of {} windows are lost", lost, count));
        if (files_in(own_folder) != 2) report("there are temporary files left");
        std::printf("%d windows at once: %d saves each, %d lost\n", count, saves, lost);
    }
    return faults > 0 ? 1 : 0;
}

/// A place where nothing can be kept, and how it is put right; null: not while the program runs.
struct Home {
    const char* about;
    std::function<void(const std::string& folder)> make;
    std::function<void(const std::string& folder)> mend{};
};

void set_home(const std::string& home) {
    ::unsetenv("XDG_STATE_HOME");
    ::setenv("HOME", home.c_str(), 1);
}

void limit_files(rlim_t bytes) {
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = std::min(bytes, limit.rlim_max);
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

/// Root may write into any folder.
void be_nobody() {
    constexpr uid_t nobody = 65534;
    if (::getuid() == 0 && (::setgid(nobody) != 0 || ::setuid(nobody) != 0)) ::_exit(1);
}

std::vector<Home> bad_homes() {
    return {
        {"HOME is not set",
         [](const std::string&) {
             ::unsetenv("HOME");
             ::unsetenv("XDG_STATE_HOME");
         }},
        {"HOME is empty", [](const std::string&) { set_home(""); }},
        {"HOME is a file",
         [](const std::string& folder) {
             write_file(folder + "/home", "");
             set_home(folder + "/home");
         },
         [](const std::string& folder) { fs::remove(folder + "/home"); }},
        {"HOME is not there, nor may it be made",
         [](const std::string&) { set_home("/proc/home"); }},
        {"HOME is read-only",
         [](const std::string& folder) {
             set_home(folder);
             fs::permissions(folder, fs::perms(0555));
             be_nobody();
         }},
        {"the disk is full",
         [](const std::string& folder) {
             set_home(folder);
             std::signal(SIGXFSZ, SIG_IGN);
             limit_files(0);
         },
         [](const std::string&) { limit_files(RLIM_INFINITY); }},
    };
}

/// The window at such a home: it says so once, goes on, and saves when that has become possible.
int live_in(const Home& home, const std::string& folder) {
    home.make(folder);
    Driver driver;
    Ui& ui = driver.ui;
    const std::string state = state_folder();
    keep_options(ui, state.empty() ? "" : state + "/window.toml");
    const std::string progress_path = state.empty() ? "" : state + "/progress.toml";
    keep_progress(ui, progress_path);
    std::string notice = ui.session.notice;
    open_lesson(ui, lesson, 1);
    ui.options.theme = Theme::light;
    driver.hand.frames(2);
    if (notice.empty()) notice = ui.session.notice;
    if (notice.find("will not be kept") == notice.npos) {
        std::printf("FAULT: nothing is said, but '%s'\n", notice.c_str());
        return 1;
    }
    std::printf("%-38s %s\n", home.about, notice.c_str());
    driver.hand.click("stage.depth");
    if (ui.session.a.settings.stage != Stage::depth) return 1;
    if (!home.mend) return 0;
    home.mend(folder);
    driver.hand.frames(10, 1.0f);
    if (read_progress(progress_path).was_step_shown(lesson, 1)) return 0;
    std::printf("FAULT: progress is not kept again\n");
    return 1;
}

int homes(const std::string& folder) {
    int number = 0;
    for (const Home& home : bad_homes()) {
        const std::string own = fmt::format("{}/home-{}", folder, ++number);
        fs::create_directory(own);
        if (end_of(begin_process([&] { return live_in(home, own); })) != 0) report(home.about);
    }
    return faults > 0 ? 1 : 0;
}

int run(const std::string& what, const std::string& folder, int count, unsigned seed) {
    fs::create_directories(folder);
    fs::current_path(folder);
    if (what == "kills") return kills(folder, count > 0 ? count : 1000, seed);
    if (what == "windows") return windows(folder, count > 0 ? count : 200);
    return homes(folder);
}

} // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "";
    if (argc < 3 || argc > 5 || (what != "kills" && what != "windows" && what != "homes")) {
        std::fputs("usage: rasterwalk-endurance-saving kills|windows|homes FOLDER [COUNT [SEED]]\n",
                   stderr);
        return 2;
    }
    try {
        return run(what, fs::absolute(argv[2]).lexically_normal().string(),
                   argc > 3 ? std::atoi(argv[3]) : 0,
                   argc > 4 ? static_cast<unsigned>(std::atoi(argv[4])) : 1u);
    } catch (const std::exception& fault) {
        std::printf("FAULT: %s\n", fault.what());
        return 1;
    }
}
