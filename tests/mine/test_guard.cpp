#include "mine/guard/guard.h"

#include <csignal>
#include <cstring>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "tests/support/catch.h"
#include "tests/support/guard_runs.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using namespace std::chrono_literals;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Each test of the guard is run in these ways.
GuardWay any_way() {
    return GENERATE(GuardWay{User::ordinary, true}, GuardWay{User::ordinary, false},
                    GuardWay{User::same, true});
}

/// Runs it, and checks that nothing of it is left.
GuardedRun guarded(const GuardWay& way, const GuardedCommand& command,
                   std::chrono::milliseconds stop_after = {}) {
    CAPTURE(command.words, way.use_landlock, way.user == User::ordinary);
    const GuardSeen seen = seen_run(way, command, stop_after);
    CHECK(seen.children == 0);
    CHECK(seen.descriptors == 0);
    CHECK(count_processes(hostile_folder()) == 0);
    if (!way.use_landlock) CHECK_FALSE(seen.run.has_landlock);
    return seen.run;
}

GuardedRun guarded(const GuardWay& way, const std::vector<std::string>& deed) {
    return guarded(way, hostile_command(deed));
}

/// Every line of the output says that something was not done.
void check_all_refused(const GuardedRun& run, std::size_t deeds) {
    INFO(run.output);
    CHECK(run.end == GuardedEnd::exited);
    CHECK(run.output.find("done") == std::string::npos);
    std::size_t lines = 0;
    for (const char c : run.output)
        lines += c == '\n';
    CHECK(lines == deeds);
}

/// A folder outside, of the user who runs the program.
struct Outside {
    explicit Outside(User user) {
        folder.write("file", "precious");
        ::mkdir(folder.file("empty").c_str(), 0700);
        path = folder.file("");
        ::chmod(folder.file("file").c_str(), 0600);
        give_to(user, path);
    }

    TemporaryFolder folder;
    std::string path;
};

} // namespace

TEST_CASE("An ordinary program runs under guard") {
    const GuardWay way = any_way();
    const GuardedRun run = guarded(way, {"exit", "7"});
    CHECK(run.end == GuardedEnd::exited);
    CHECK(run.exit_code == 7);
    CHECK(run.signal == 0);
    CHECK(run.output == "out\nerr\n");
    CHECK_FALSE(run.is_output_cut);
    CHECK(guarded(way, {"threads"}).output == "4000\n");
    CHECK(guarded(way, {"descriptors"}).output == "0 1 2 input 0\n");
    const GuardedRun aborted = guarded(way, {"abort"});
    CHECK(aborted.end == GuardedEnd::signalled);
    CHECK(aborted.signal == SIGABRT);
}

TEST_CASE("A guarded program that never ends is killed when its time is up") {
    const GuardWay way = any_way();
    for (const char* deed : {"loop", "sleep", "stop"}) {
        const GuardedRun run = guarded(way, endless_command({deed}));
        CHECK(run.end == GuardedEnd::out_of_time);
        CHECK(run.signal == SIGXCPU);
        CHECK(run.time >= 200ms);
    }
}

TEST_CASE("Watching a guarded program takes next to no time of the processor") {
    // In a process of its own, whose children are then the supervisor and the program alone.
    const std::string said = as_ordinary_user([] {
        GuardedCommand sleeps = endless_command({"sleep"});
        sleeps.limits.time = 1s;
        run_guarded(sleeps);
        rusage use{};
        ::getrusage(RUSAGE_CHILDREN, &use);
        const auto milliseconds = [](const timeval& time) {
            return 1000 * time.tv_sec + time.tv_usec / 1000;
        };
        return fmt::format("{}", milliseconds(use.ru_utime) + milliseconds(use.ru_stime));
    });
    CHECK(std::stol(said) < 100);
}

TEST_CASE("A guarded program whose time is up has a moment for last words") {
    GuardedCommand speaks = hostile_command({"last words"});
    speaks.limits.time = 1s;
    const GuardedRun spoke = guarded({}, speaks);
    CHECK(spoke.end == GuardedEnd::out_of_time);
    CHECK(spoke.output == "last words");
    CHECK(spoke.exit_code == 9);
    speaks.words = hostile_command({"prompt"}).words;
    const GuardedRun waited = guarded({}, speaks);
    CHECK(waited.end == GuardedEnd::out_of_time);
    CHECK(waited.output == "prompt: done\n");
    GuardedCommand ignores = hostile_command({"ignore"});
    ignores.limits.time = 1s;
    const GuardedRun ignored = guarded({}, ignores);
    CHECK(ignored.end == GuardedEnd::out_of_time);
    CHECK(ignored.signal == SIGKILL);
}

TEST_CASE("The time of a guarded program's threads counts together") {
    GuardedCommand command = hostile_command({"busy threads"});
    command.limits.time = 1s;
    CHECK(guarded({}, command).end == GuardedEnd::out_of_time);
}

TEST_CASE("A guarded program is killed when it is to be stopped") {
    const GuardWay way = any_way();
    GuardedCommand command = hostile_command({"ignore"});
    const GuardedRun run = guarded(way, command, 50ms);
    CHECK(run.end == GuardedEnd::stopped);
    CHECK(run.signal == SIGKILL);
}

TEST_CASE("A guarded program takes no more memory than it may") {
    const GuardWay way = any_way();
    GuardedCommand at_once = hostile_command({"all at once"});
    CHECK(guarded(way, at_once).end == GuardedEnd::out_of_memory);
    GuardedCommand slowly = hostile_command({"slowly"});
    slowly.limits.memory = 0;
    slowly.limits.resident = std::size_t{200} << 20;
    CHECK(guarded(way, slowly).end == GuardedEnd::out_of_memory);
    slowly.limits.memory = std::size_t{200} << 20;
    const GuardedRun limited = guarded(way, slowly);
    CHECK(limited.end == GuardedEnd::signalled); // malloc() gave it none
    CHECK(limited.signal == SIGSEGV);
    const GuardedRun deep = guarded(way, {"recurse"});
    CHECK(deep.end == GuardedEnd::signalled);
    CHECK(deep.signal == SIGSEGV);
}

TEST_CASE("A guarded program starts no other") {
    const GuardWay way = any_way();
    const GuardedRun forks = guarded(way, {"fork"});
    CHECK_THAT(forks.output, ContainsSubstring("0 forks\n"));
    CHECK(forks.output.find("done") == std::string::npos);
    check_all_refused(guarded(way, {"start"}), 4);
    CHECK(guarded(way, {"daemon"}).end == GuardedEnd::exited);
    CHECK(guarded(way, {"leave"}).output.find("done") == std::string::npos);
    // Where nothing handles what is refused, it is the end.
    GuardedCommand unhandled = hostile_command({"leave"});
    unhandled.environment = {"UNHANDLED=1"};
    const GuardedRun run = guarded(way, unhandled);
    CHECK(run.end == GuardedEnd::signalled);
    CHECK(run.signal == SIGSYS);
    CHECK_THAT(unguarded_output({"start"}), ContainsSubstring("system: done") &&
                                                ContainsSubstring("posix_spawn: done") &&
                                                ContainsSubstring("the shell runs"));
}

TEST_CASE("What a guarded program starts ends with it") {
    const GuardWay way = any_way();
    GuardedCommand children = endless_command({"children"});
    children.limits.may_start_programs = true;
    CHECK(guarded(way, children).end == GuardedEnd::out_of_time);
    for (const char* deed : {"daemon", "leave"}) {
        GuardedCommand command = hostile_command({deed});
        command.limits.may_start_programs = true;
        const GuardedRun run = guarded(way, command);
        CHECK(run.end == GuardedEnd::exited);
        CHECK(run.output == (deed == std::string("daemon")
                                 ? ""
                                 : "setsid: Operation not permitted\n"
                                   "setpgid: Operation not permitted\n"
                                   "setsid of a child: Operation not permitted\n"
                                   "setpgid of a child: Operation not permitted\n"));
    }
    GuardedCommand bomb = hostile_command({"bomb"});
    bomb.limits.may_start_programs = true;
    CHECK(guarded(way, bomb).end == GuardedEnd::too_many_threads);
}

TEST_CASE("A guarded program ends when the one that guards it is killed") {
    const GuardWay way = any_way();
    GuardedCommand command = hostile_command({"children"});
    command.limits.may_start_programs = true;
    command.limits.use_landlock = way.use_landlock;
    const pid_t child = ::fork();
    if (child == 0) {
        if (way.user == User::ordinary) become_ordinary_user();
        run_guarded(command);
        ::_exit(0);
    }
    const std::string& folder = hostile_folder();
    CHECK(wait_for_processes(folder, 4, 4));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    CHECK(wait_for_processes(folder, 0, 0));
}

TEST_CASE("A guarded program does nothing to other processes") {
    const GuardWay way = any_way();
    const pid_t victim = ::fork();
    if (victim == 0) {
        if (way.user == User::ordinary) become_ordinary_user();
        while (true)
            ::pause();
    }
    check_all_refused(guarded(way, {"signal", std::to_string(victim)}), 10);
    CHECK(::waitpid(victim, nullptr, WNOHANG) == 0);
    ::kill(victim, SIGKILL);
    ::waitpid(victim, nullptr, 0);
}

TEST_CASE("A guarded program does not loosen its guard") {
    const GuardWay way = any_way();
    check_all_refused(guarded(way, {"loosen"}), 11);
    for (const char* deed : {"32 bits", "x32"}) {
        const GuardedRun run = guarded(way, {deed});
        CHECK(run.end == GuardedEnd::signalled);
        // Or the system does not know 32 bits at all.
        CHECK((run.signal == SIGSYS || run.signal == SIGSEGV));
    }
}

TEST_CASE("A guarded program changes no files outside") {
    const GuardWay way = any_way();
    const Outside outside(way.user);
    struct stat before {};
    struct stat after {};
    REQUIRE(::stat(outside.folder.file("file").c_str(), &before) == 0);
    check_all_refused(guarded(way, {"files", outside.path}), 18);
    REQUIRE(::stat(outside.folder.file("file").c_str(), &after) == 0);
    CHECK(before.st_mode == after.st_mode);
    CHECK(before.st_ctim.tv_sec == after.st_ctim.tv_sec);
    CHECK(before.st_ctim.tv_nsec == after.st_ctim.tv_nsec);
    CHECK(bytes_of(outside.folder.file("file")) == "precious");
    CHECK(outside.folder.file_count() == 2);
    // Without a guard it does all that.
    const Outside unguarded(User::ordinary);
    INFO(unguarded_output({"files", unguarded.path}));
    CHECK(bytes_of(unguarded.folder.file("file")) == "");
    CHECK(unguarded.folder.file_count() == 6);
}

TEST_CASE("A guarded program reads only what it is given, where the system can see to that") {
    const GuardWay way = any_way();
    const Outside outside(way.user);
    const std::string file = outside.folder.file("file");
    const GuardedRun run = guarded(way, {"read", file});
    CHECK(run.output == (run.has_landlock ? "open: Permission denied\n" : "precious\n"));
    GuardedCommand given = hostile_command({"read", file});
    given.readable = {outside.path};
    CHECK(guarded(way, given).output == "precious\n");
    given.readable = {file};
    CHECK(guarded(way, given).output == "precious\n");
    CHECK(unguarded_output({"read", "/proc/self/maps"}).size() > 50);
    CHECK(guarded(way, {"read", "/proc/self/maps"}).output.size() > 50);
    if (run.has_landlock)
        CHECK(guarded(way, {"read", "/proc/1/status"}).output == "open: Permission denied\n");
}

TEST_CASE("Under guard root is an ordinary user") {
    if (!is_root()) return; // others are ordinary anyway
    const Outside outside(User::ordinary);
    const std::string file = outside.folder.file("file");
    ::chmod(outside.path.c_str(), 0755);
    GuardedCommand command = hostile_command({"read", file});
    command.readable = {outside.path};
    CHECK(guarded({User::ordinary, true}, command).output == "precious\n");
    CHECK(guarded({User::same, true}, command).output == "open: Permission denied\n");
}

TEST_CASE("A guarded program writes where it may, up to its limit") {
    const GuardWay way{GENERATE(User::ordinary, User::same), true};
    const Outside inside(way.user);
    GuardedCommand command = hostile_command({"large file", inside.folder.file("large")});
    command.limits.file_size = std::size_t{3} << 20;
    command.writable = {inside.path};
    const GuardedRun run = guarded(way, command);
    if (!run.has_landlock) return;
    CHECK(run.end == GuardedEnd::signalled);
    CHECK(run.signal == SIGXFSZ);
    CHECK(bytes_of(inside.folder.file("large")).size() == command.limits.file_size);
    // Names in its own folder, but nothing that lies in wait for its reader, and no modes.
    GuardedCommand files = hostile_command({"files", inside.path});
    files.writable = {inside.path};
    const std::string output = guarded(way, files).output;
    CHECK_THAT(output, ContainsSubstring("create: done") && ContainsSubstring("mkdir: done") &&
                           ContainsSubstring("rename: done"));
    CHECK(output.find("symlink: done") == std::string::npos);
    CHECK(output.find("mkfifo: done") == std::string::npos);
    CHECK(output.find("chmod: done") == std::string::npos);
}

TEST_CASE("A guarded program has no network") {
    const GuardWay way = any_way();
    const TemporaryFolder folder;
    check_all_refused(guarded(way, {"network", "9", folder.file("socket")}), 4);
    CHECK_THAT(unguarded_output({"network", "9", "/tmp"}), ContainsSubstring("UDP: done"));
}

TEST_CASE("The output of a guarded program is cut, and a flood of it ends the program") {
    const GuardWay way = any_way();
    GuardedCommand command = hostile_command({"print"});
    command.limits.output = 1000;
    const GuardedRun run = guarded(way, command);
    CHECK(run.end == GuardedEnd::too_much_output);
    CHECK(run.is_output_cut);
    CHECK(run.output == std::string(1000, 'x'));
    const GuardedRun closed = guarded(way, {"close"});
    CHECK(closed.end == GuardedEnd::exited);
    CHECK(closed.exit_code == 3);
    CHECK(closed.output.empty());
}

TEST_CASE("A guarded program cannot take the memory away that it was given") {
    const GuardWay way = any_way();
    constexpr std::size_t size = 1 << 16;
    const int memory = ::memfd_create("test", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    REQUIRE(memory >= 0);
    REQUIRE(::ftruncate(memory, size) == 0);
    GuardedCommand command = hostile_command({"descriptor", std::to_string(size)});
    command.descriptor = memory;
    const GuardedRun run = guarded(way, command);
    CHECK(run.end == GuardedEnd::exited);
    struct stat state {};
    REQUIRE(::fstat(memory, &state) == 0);
    CHECK(state.st_size == size);
    std::string bytes(size, '\0');
    CHECK(::pread(memory, bytes.data(), size, 0) == static_cast<ssize_t>(size));
    CHECK(bytes == std::string(size, '\xff'));
    CHECK(run.output.find("done") == std::string::npos);
    command.words = hostile_command({"descriptors"}).words;
    CHECK(guarded(way, command).output == "0 1 2 3 input 0\n");
    ::close(memory);
}

TEST_CASE("A program that cannot be guarded is an error that says why") {
    const auto complaint = [](const GuardedCommand& command) -> std::string {
        return as_ordinary_user([&]() -> std::string {
            try {
                run_guarded(command);
            } catch (const AccessError& fault) {
                return fault.what();
            }
            return "it was started";
        });
    };
    GuardedCommand command = hostile_command({"exit"});
    command.folder = "/nowhere";
    CHECK_THAT(complaint(command), ContainsSubstring("hostile' in '/nowhere': No such file"));
    command = hostile_command({"exit"});
    command.words.front() = "/nowhere/at-all";
    CHECK(complaint(command) == "cannot start '/nowhere/at-all': No such file or directory.");
    command.words.front() = "hostile";
    CHECK(complaint(command) == "a program to run needs an absolute path.");
    command = hostile_command({"exit"});
    command.words.front() += ".txt";
    const TemporaryFolder folder;
    ::chmod(folder.file("").c_str(), 0755);
    command.words.front() = folder.write("text", "not a program");
    ::chmod(command.words.front().c_str(), 0755);
    CHECK_THAT(complaint(command), ContainsSubstring("Exec format error."));
}

TEST_CASE("Several threads guard programs at the same time") {
    const std::string said = as_ordinary_user([] {
        std::vector<std::string> outputs(8);
        std::vector<std::thread> threads;
        for (std::size_t i = 0; i < outputs.size(); ++i)
            threads.emplace_back([i, &outputs] {
                const GuardedRun run = run_guarded(i % 2 == 0 ? hostile_command({"threads"})
                                                              : endless_command({"loop"}));
                outputs[i] = run.end == GuardedEnd::out_of_time ? "late\n" : run.output;
            });
        std::string all;
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            threads[i].join();
            all += outputs[i];
        }
        return all;
    });
    CHECK(said == "4000\nlate\n4000\nlate\n4000\nlate\n4000\nlate\n");
    CHECK(count_processes(hostile_folder()) == 0);
}
