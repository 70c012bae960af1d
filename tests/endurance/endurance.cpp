// Does a great number of random actions in the window, without GL and with a clock of its own, and
// watches memory and faults. tests/endurance/endure runs it and says what its exit codes mean.
//   rasterwalk-endurance FOLDER [ACTIONS [SEED [FROM]]]
// FOLDER receives all that is written. ACTIONS are done, from FROM (1) on: with the same SEED, the
// same ones. RASTERWALK_EVERY_ACTION=1 prints each before it is done.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <malloc.h>
#include <sys/time.h>
#include <unistd.h>

#include "lessons/progress.h"
#include "tests/endurance/random_actions.h"
#include "tests/ui/driver.h"
#include "ui/actions/open_lesson.h"
#include "ui/app/app.h"
#include "ui/app/kept_options.h"

namespace {

using namespace rasterwalk;

constexpr int block = 10'000;       ///< actions from one line of figures to the next
constexpr int longest_act = 60;     ///< seconds of computing, however busy the machine is
constexpr double most_growth = 8.0; ///< MB, from the second tenth to the last
constexpr double megabyte = 1024.0 * 1024.0;

// For the handler of signals, which may not do more than write them.
volatile std::sig_atomic_t action_number = 0;
unsigned seed = 1;

extern "C" void end_by_signal(int signal) {
    char line[160];
    const int size = std::snprintf(
        line, sizeof line, "FAULT: signal %d (%s) at seed %u, action %d\n", signal,
        signal == SIGPROF ? "it takes too long" : "a crash", seed, static_cast<int>(action_number));
    if (::write(STDOUT_FILENO, line, static_cast<std::size_t>(size)) < 0) ::_exit(3);
    ::_exit(1);
}

/// SIGPROF comes when this much has been computed; 0: never.
void limit_computing(int seconds) {
    const itimerval limit{{0, 0}, {seconds, 0}};
    ::setitimer(ITIMER_PROF, &limit, nullptr);
}

double computed_since(std::clock_t start) {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double resident() {
    long all = 0, here = 0;
    std::ifstream("/proc/self/statm") >> all >> here;
    return static_cast<double>(here) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / megabyte;
}

/// At rest, after each block.
struct Figures {
    double resident = 0.0, allocated = 0.0; ///< MB
};

Figures figures_now() {
    ::malloc_trim(0);
    return {resident(), static_cast<double>(mallinfo2().uordblks) / megabyte};
}

/// The median of a member in the n-th tenth of the figures.
double in_tenth(const std::vector<Figures>& all, std::size_t n, double Figures::*member) {
    const std::size_t first = all.size() * (n - 1) / 10,
                      last = std::max(all.size() * n / 10, first + 1);
    std::vector<double> values;
    for (std::size_t i = first; i < last && i < all.size(); ++i)
        values.push_back(all[i].*member);
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
}

int run(const std::string& folder, int actions, int from) {
    const bool prints_all = std::getenv("RASTERWALK_EVERY_ACTION") != nullptr;
    const auto now = [] { return std::chrono::steady_clock::now(); };
    const auto seconds_since = [&](auto start) {
        return std::chrono::duration<double>(now() - start).count();
    };
    Driver driver;
    Ui& ui = driver.ui;
    const std::string progress_path = folder + "/progress.toml";
    keep_options(ui, folder + "/window.toml");
    keep_progress(ui, progress_path);
    endurance::RandomActions random(driver, seed, folder);
    std::vector<Figures> figures;
    int faults = 0;
    double slowest = 0.0;
    std::string slowest_act;
    const auto begin = now();
    std::printf("%9s %9s %10s %10s  %s\n", "actions", "per s", "resident", "allocated",
                "slowest since");
    for (int i = from; i < from + actions; ++i) {
        action_number = i;
        limit_computing(longest_act);
        const std::clock_t start = std::clock();
        const int caught = ui.faults;
        std::string what, wrong;
        try {
            what = random.act(i);
            wrong = fault_of_frame();
        } catch (const std::exception& fault) {
            wrong = std::string("an exception, ") + fault.what();
        }
        if (ui.faults > caught) wrong = "a part of the frame failed: " + ui.session.notice;
        if (prints_all) std::printf("%d %s\n", i, what.c_str());
        if (!wrong.empty()) {
            std::printf("FAULT: %s, at seed %u, action %d: %s\n", wrong.c_str(), seed, i,
                        what.c_str());
            ++faults;
        }
        if (const double took = computed_since(start); took > slowest) {
            slowest = took;
            slowest_act = what;
        }
        const int done = i - from + 1;
        if (done % block == 0 || done == actions) {
            random.come_to_rest();
            read_progress(progress_path); // is whole, or throws
            figures.push_back(figures_now());
            std::printf("%9d %9.0f %7.1f MB %7.1f MB  %.0f ms, %s\n", done,
                        done / seconds_since(begin), figures.back().resident,
                        figures.back().allocated, 1000.0 * slowest, slowest_act.c_str());
            slowest = 0.0;
        }
        std::fflush(stdout);
    }
    limit_computing(0);
    keep_everything(ui);
    const double before = in_tenth(figures, 2, &Figures::resident);
    const double after = in_tenth(figures, 10, &Figures::resident);
    const bool grows = figures.size() >= 10 && after - before > most_growth;
    std::printf(
        "%d actions, %d faults; at rest %.1f MB resident in the second tenth, %.1f MB in the "
        "last%s\n",
        actions, faults, before, after, grows ? ": IT GROWS" : "");
    return faults > 0 || grows ? 1 : 0;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2 || argc > 5) {
        std::fputs("usage: rasterwalk-endurance FOLDER [ACTIONS [SEED [FROM]]]\n", stderr);
        return 2;
    }
    try {
        const std::string folder = std::filesystem::absolute(argv[1]).lexically_normal().string();
        std::filesystem::create_directories(folder);
        std::filesystem::current_path(folder);
        // Nothing outside the folder is written or run.
        for (const char* const name :
             {"HOME", "TMPDIR", "XDG_CACHE_HOME", "XDG_STATE_HOME", "PATH"})
            ::setenv(name, folder.c_str(), 1);
        const int actions = argc > 2 ? std::max(std::atoi(argv[2]), 1) : block;
        if (argc > 3) seed = static_cast<unsigned>(std::atoi(argv[3]));
        const int from = argc > 4 ? std::atoi(argv[4]) : 1;
        for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGPROF})
            std::signal(signal, end_by_signal);
        return run(folder, actions, from);
    } catch (const std::exception& fault) {
        std::printf("FAULT: %s at seed %u, action %d\n", fault.what(), seed,
                    static_cast<int>(action_number));
        return 1;
    }
}
