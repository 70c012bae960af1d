// A program that does one thing that a student's program should not do, or should be able to do.
// The tests of the guard compile it and run it under guard: hostile DEED [ARGUMENTS].

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <vector>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sched.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <ucontext.h>
#include <unistd.h>

namespace {

/// Refused calls fail with EPERM, as under the kit.
void refuse(int, siginfo_t*, void* context) {
    auto& machine = static_cast<ucontext_t*>(context)->uc_mcontext;
#ifdef __x86_64__
    machine.gregs[REG_RAX] = -EPERM;
#else
    machine.regs[0] = static_cast<unsigned long long>(-EPERM);
#endif
}

/// Says whether something was done, or why not.
void tell(const char* deed, long result) {
    if (result >= 0) {
        std::printf("%s: done\n", deed);
    } else {
        std::printf("%s: %s\n", deed, std::strerror(errno));
    }
    std::fflush(stdout);
}

[[noreturn]] void loop() {
    volatile bool is_on = true;
    while (is_on) {
    }
    std::abort();
}

[[noreturn]] void sleep_for_ever() {
    while (true)
        ::pause();
}

/// Takes a page of the stack for each step down.
int descend(long steps) {
    volatile char here[4096];
    here[0] = static_cast<char>(steps);
    return steps == 0 ? 0 : descend(steps - 1) + here[0];
}

void fork_without_end() {
    int forks = 0;
    for (int i = 0; i < 100; ++i) {
        const pid_t child = ::fork();
        if (child == 0) sleep_for_ever();
        if (child > 0) ++forks;
    }
    std::printf("%d forks\n", forks);
    tell("vfork", ::syscall(SYS_clone, CLONE_VFORK | SIGCHLD, 0, 0, 0, 0));
    tell("clone", ::syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0));
    tell("clone3", ::syscall(435, nullptr, 0));
}

void leave_group() {
    tell("setsid", ::setsid());
    tell("setpgid", ::setpgid(0, 0));
    int ends[2];
    if (::pipe(ends) != 0) return;
    const pid_t child = ::fork();
    if (child == 0) {
        tell("setsid of a child", ::setsid());
        tell("setpgid of a child", ::setpgid(0, 0));
        ::close(ends[0]);
        ::close(ends[1]);
        sleep_for_ever();
    }
    ::close(ends[1]);
    char byte = 0;
    if (::read(ends[0], &byte, 1) > 0) ::abort();
}

void become_daemon() {
    if (::fork() != 0) ::_exit(0);
    ::setsid();
    if (::fork() != 0) ::_exit(0);
    for (int i = 0; i < 64; ++i)
        ::close(i);
    sleep_for_ever();
}

void signal_others(pid_t victim) {
    tell("kill", ::kill(victim, SIGKILL));
    tell("kill the parent", ::kill(::getppid(), SIGKILL));
    tell("signal to everyone", ::kill(-1, 0));
    tell("tgkill", ::syscall(SYS_tgkill, victim, victim, SIGKILL));
    tell("tkill", ::syscall(SYS_tkill, victim, SIGKILL));
    siginfo_t info{};
    info.si_code = SI_QUEUE;
    tell("sigqueue", ::syscall(SYS_rt_sigqueueinfo, victim, SIGKILL, &info));
    tell("pidfd_open", ::syscall(434, victim, 0));
    int ends[2];
    if (::pipe(ends) != 0) return;
    tell("fcntl", ::fcntl(ends[0], F_SETOWN, victim));
    const rlimit none{1, 1};
    tell("prlimit", ::prlimit(victim, RLIMIT_CPU, &none, nullptr));
    tell("setpriority", ::setpriority(PRIO_PROCESS, static_cast<id_t>(victim), 10));
}

/// As many as a computer withstands if they are not stopped: 600.
void start_very_many() {
    auto* const left = static_cast<std::atomic<int>*>(::mmap(nullptr, sizeof(std::atomic<int>),
                                                             PROT_READ | PROT_WRITE,
                                                             MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    if (left == MAP_FAILED) return;
    *left = 600;
    while (left->fetch_sub(1) > 0)
        ::fork();
    sleep_for_ever();
}

/// In a folder that holds a file "file" and an empty folder "empty".
void change_files(const char* folder) {
    if (::chdir(folder) != 0) return tell("chdir", -1);
    tell("write", ::open("file", O_WRONLY));
    tell("append", ::open("file", O_WRONLY | O_APPEND));
    tell("read and empty", ::open("file", O_RDONLY | O_TRUNC));
    tell("create", ::open("new", O_WRONLY | O_CREAT, 0600));
    tell("create without a name", ::open(".", O_TMPFILE | O_WRONLY, 0600));
    tell("truncate", ::truncate("file", 0));
    tell("fchmod", ::fchmod(::open("file", O_RDONLY), 0700));
    tell("chmod", ::chmod("file", 0));
    tell("chown", ::chown("file", ::getuid(), ::getgid()));
    tell("utimensat", ::utimensat(AT_FDCWD, "file", nullptr, 0));
    tell("setxattr", ::syscall(SYS_setxattr, "file", "user.a", "b", 1, 0));
    tell("link", ::link("file", "link"));
    tell("symlink", ::symlink("file", "symlink"));
    tell("mkfifo", ::mkfifo("fifo", 0600));
    tell("mkdir", ::mkdir("folder", 0700));
    tell("rmdir", ::rmdir("empty"));
    tell("rename", ::rename("file", "other"));
    tell("unlink", ::unlink("file"));
}

void read_file(const char* path) {
    const int file = ::open(path, O_RDONLY);
    if (file < 0) return tell("open", file);
    char text[100];
    const ssize_t count = ::read(file, text, sizeof text);
    std::printf("%.*s\n", static_cast<int>(count < 0 ? 0 : count), text);
}

/// What is only of use to get away from the guard.
void loosen_guard() {
    tell("outlive the parent", ::prctl(PR_SET_PDEATHSIG, 0));
    tell("hide", ::prctl(PR_SET_DUMPABLE, 0));
    tell("unshare", ::unshare(CLONE_NEWUSER));
    tell("io_uring", ::syscall(425, 1, nullptr));
    tell("ptrace", ::syscall(SYS_ptrace, 16, ::getppid(), 0, 0));
    tell("shmget", ::syscall(SYS_shmget, 4711, 4096, 0600 | 01000));
    tell("memfd_create", ::syscall(SYS_memfd_create, "", 0));
    tell("a call that is not known yet", ::syscall(449));
    const rlimit more{1 << 20, 1 << 20};
    tell("setrlimit", ::setrlimit(RLIMIT_NOFILE, &more));
    const char stuffed = 'x';
    tell("ioctl", ::ioctl(0, TIOCSTI, &stuffed));
    const int parent = ::open("/proc/self/../1/mem", O_RDWR);
    tell("memory of others", parent);
}

/// Calls of other processor models, whose numbers mean something else.
void call_as_others([[maybe_unused]] bool is_32_bit) {
#ifdef __x86_64__
    if (is_32_bit) {
        long call = 20; // getpid
        asm volatile("int $0x80" : "+a"(call) : : "memory");
        return;
    }
    ::syscall(0x40000000 | SYS_getpid);
#else
    ::raise(SIGSYS);
#endif
}

void start_others() {
    char shell[] = "/bin/sh", option[] = "-c", script[] = "echo the shell runs";
    char* const words[] = {shell, option, script, nullptr};
    char* const environment[] = {nullptr};
    tell("system", ::system(script) == 0 ? 0 : -1);
    pid_t child = 0;
    errno = ::posix_spawn(&child, shell, nullptr, nullptr, words, environment);
    tell("posix_spawn", errno == 0 ? 0 : -1);
    if (child > 0) ::waitpid(child, nullptr, 0);
    tell("execveat", ::syscall(SYS_execveat, AT_FDCWD, shell, words, environment, 0));
    tell("exec", ::execve(shell, words, environment));
}

void use_network(const char* port, const char* path) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(static_cast<uint16_t>(std::atoi(port)));
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const auto* const address = reinterpret_cast<const sockaddr*>(&place);
    const int stream = ::socket(AF_INET, SOCK_STREAM, 0);
    tell("TCP", stream < 0 ? stream : ::connect(stream, address, sizeof place));
    const int datagrams = ::socket(AF_INET, SOCK_DGRAM, 0);
    tell("UDP", datagrams < 0 ? -1 : ::sendto(datagrams, "hello", 5, 0, address, sizeof place));
    sockaddr_un file{};
    file.sun_family = AF_UNIX;
    std::strncpy(file.sun_path, path, sizeof file.sun_path - 1);
    const int local = ::socket(AF_UNIX, SOCK_STREAM, 0);
    tell("unix",
         local < 0 ? -1 : ::bind(local, reinterpret_cast<const sockaddr*>(&file), sizeof file));
    int pair[2];
    tell("socketpair", ::socketpair(AF_UNIX, SOCK_DGRAM, 0, pair));
}

void attack_descriptor(std::size_t size) {
    void* const memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, 3, 0);
    if (memory == MAP_FAILED) return tell("mmap", -1);
    std::memset(memory, 0xff, size);
    tell("shrink", ::ftruncate(3, 0));
    tell("grow", ::ftruncate(3, 1 << 20));
    tell("empty", ::open("/proc/self/fd/3", O_RDWR | O_TRUNC));
}

void list_descriptors() {
    for (int i = 0; i < 1024; ++i)
        if (::fcntl(i, F_GETFD) >= 0) std::printf("%d ", i);
    char byte = 0;
    std::printf("input %zd\n", ::read(0, &byte, 1));
}

void count_in_threads() {
    std::vector<int> counts(4);
    std::vector<std::thread> threads;
    for (int& count : counts)
        threads.emplace_back([&count] {
            for (int i = 0; i < 1000; ++i)
                ++count;
        });
    for (std::thread& thread : threads)
        thread.join();
    std::printf("%d\n", counts[0] + counts[1] + counts[2] + counts[3]);
}

void use_memory(bool is_at_once) {
    constexpr std::size_t much = std::size_t{100} << 30, some = std::size_t{8} << 20;
    if (is_at_once) {
        volatile char* const block = new char[much];
        block[much / 2] = 1;
        std::printf("%d\n", block[much / 2]);
        return;
    }
    for (std::size_t taken = 0; taken < much; taken += some)
        std::memset(::malloc(some), 1, some);
}

void last_words(int) {
    const char text[] = "last words";
    if (::write(1, text, sizeof text - 1) < 0) ::_exit(1);
    ::_exit(9);
}

} // namespace

int main(int count, char** words) {
    if (count < 2) return 2;
    const char* const first = count > 2 ? words[2] : "";
    const char* const second = count > 3 ? words[3] : "";
    const auto is = [&](const char* name) { return std::strcmp(words[1], name) == 0; };
    if (std::getenv("UNHANDLED") == nullptr) {
        struct sigaction action {};
        action.sa_sigaction = refuse;
        action.sa_flags = SA_SIGINFO;
        ::sigaction(SIGSYS, &action, nullptr);
    }
    if (is("exit")) {
        std::puts("out");
        std::fflush(stdout);
        std::fputs("err\n", stderr);
        return std::atoi(first);
    }
    if (is("loop")) loop();
    if (is("sleep")) sleep_for_ever();
    if (is("prompt")) {
        tell("prompt", 0);
        sleep_for_ever();
    }
    if (is("stop")) {
        ::raise(SIGSTOP);
        sleep_for_ever();
    }
    if (is("ignore")) {
        for (int signal = 1; signal < SIGSYS; ++signal)
            ::signal(signal, SIG_IGN);
        loop();
    }
    if (is("last words")) {
        ::signal(SIGXCPU, last_words);
        sleep_for_ever();
    }
    if (is("abort")) std::abort();
    if (is("recurse")) return descend(1'000'000'000);
    if (is("fork")) fork_without_end();
    if (is("children")) {
        for (int i = 0; i < 3; ++i)
            if (::fork() == 0) sleep_for_ever();
        sleep_for_ever();
    }
    if (is("bomb")) start_very_many();
    if (is("leave")) leave_group();
    if (is("daemon")) become_daemon();
    if (is("signal")) signal_others(std::atoi(first));
    if (is("files")) change_files(first);
    if (is("read")) read_file(first);
    if (is("start")) start_others();
    if (is("loosen")) loosen_guard();
    if (is("32 bits")) call_as_others(true);
    if (is("x32")) call_as_others(false);
    if (is("busy threads")) {
        std::thread(loop).detach();
        std::thread(loop).detach();
        loop();
    }
    if (is("network")) use_network(first, second);
    if (is("descriptor")) attack_descriptor(static_cast<std::size_t>(std::atol(first)));
    if (is("descriptors")) list_descriptors();
    if (is("threads")) count_in_threads();
    if (is("all at once")) use_memory(true);
    if (is("slowly")) use_memory(false);
    if (is("print"))
        for (const std::vector<char> block(1 << 16, 'x'); ::write(1, block.data(), 1 << 16) > 0;) {
        }
    if (is("close")) {
        for (int i = 0; i < 64; ++i)
            ::close(i);
        ::usleep(100'000);
        return 3;
    }
    if (is("large file")) {
        const std::vector<char> block(1 << 20, 'x');
        const int file = ::open(first, O_WRONLY | O_CREAT, 0600);
        while (::write(file, block.data(), block.size()) > 0) {
        }
    }
    return 0;
}
