#include "mine/guard/guard_filter.h"

#ifdef RASTERWALK_HAS_GUARD

#include <array>
#include <cerrno>
#include <cstdint>
#include <initializer_list>

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace rasterwalk {

namespace {

#ifdef __x86_64__
constexpr std::uint32_t own_architecture = AUDIT_ARCH_X86_64;
#else
constexpr std::uint32_t own_architecture = AUDIT_ARCH_AARCH64;
#endif

/// Calls with this bit are those of the x32 processor model.
constexpr std::uint32_t x32_bit = 0x40000000;

// Calls that headers of older systems do not name yet. Numbers of 424 and above are the
// same everywhere.
constexpr std::uint32_t call_clone3 = 435;
constexpr std::uint32_t call_openat2 = 437;
/// Later calls are not known here, so they are said to be missing, and programs do without.
constexpr std::uint32_t first_unknown_call = 449;

/// Refused to every program.
constexpr std::uint32_t refused_calls[] = {
    // The network, and programs that listen on this machine.
    SYS_socket, SYS_socketpair, SYS_connect, SYS_bind, SYS_listen, SYS_accept, SYS_accept4,
    // Other processes.
    SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_kcmp, SYS_setsid, SYS_setpgid,
    SYS_setpriority, SYS_ioprio_set, SYS_migrate_pages, SYS_move_pages,
    // Memory and messages that outlive the program.
    SYS_shmget, SYS_shmat, SYS_shmctl, SYS_semget, SYS_semop, SYS_semtimedop, SYS_semctl,
    SYS_msgget, SYS_msgsnd, SYS_msgrcv, SYS_msgctl, SYS_mq_open, SYS_mq_unlink, SYS_memfd_create,
    // What Landlock does not cover.
    SYS_chroot, SYS_fchown, SYS_fchownat, SYS_utimensat, SYS_setxattr, SYS_lsetxattr, SYS_fsetxattr,
    SYS_removexattr, SYS_lremovexattr, SYS_fremovexattr, SYS_mknodat, SYS_name_to_handle_at,
    SYS_open_by_handle_at, SYS_fanotify_init, SYS_fanotify_mark,
    // The system.
    SYS_mount, SYS_umount2, SYS_pivot_root, SYS_unshare, SYS_setns, SYS_bpf, SYS_keyctl,
    SYS_add_key, SYS_request_key, SYS_perf_event_open, SYS_userfaultfd, SYS_personality, SYS_reboot,
    SYS_swapon, SYS_swapoff, SYS_init_module, SYS_finit_module, SYS_delete_module, SYS_kexec_load,
    SYS_acct, SYS_quotactl, SYS_settimeofday, SYS_clock_settime, SYS_adjtimex, SYS_clock_adjtime,
    SYS_sethostname, SYS_setdomainname, SYS_syslog, SYS_vhangup, SYS_execveat,
#ifdef SYS_kexec_file_load
    SYS_kexec_file_load,
#endif
#ifdef __x86_64__
    SYS_chown, SYS_lchown, SYS_utime, SYS_utimes, SYS_futimesat, SYS_mknod, SYS_iopl, SYS_ioperm,
    SYS_modify_ldt,
#endif
    424, // pidfd_send_signal
    425, // io_uring_setup
    426, // io_uring_enter
    427, // io_uring_register
    428, // open_tree
    429, // move_mount
    430, // fsopen
    431, // fsconfig
    432, // fsmount
    433, // fspick
    434, // pidfd_open
    438, // pidfd_getfd
    440, // process_madvise
    442, // mount_setattr
    443, // quotactl_fd
    447, // memfd_secret
    448, // process_mrelease
};

/// Names of files: refused where there is no Landlock, to all but a compiler.
constexpr std::uint32_t naming_calls[] = {
    SYS_renameat2, SYS_unlinkat, SYS_mkdirat,
#ifdef SYS_renameat
    SYS_renameat,
#endif
#ifdef __x86_64__
    SYS_creat,     SYS_rename,   SYS_unlink,  SYS_mkdir, SYS_rmdir,
#endif
};

/// Other names for files: refused where there is no Landlock.
constexpr std::uint32_t linking_calls[] = {
    SYS_linkat,
    SYS_symlinkat,
#ifdef __x86_64__
    SYS_link,
    SYS_symlink,
#endif
};

/// A half of an argument, as the filter loads it.
constexpr std::uint32_t argument(std::size_t index, bool is_high_half = false) {
    return static_cast<std::uint32_t>(offsetof(seccomp_data, args) + 8 * index +
                                      (is_high_half ? 4 : 0));
}

constexpr std::uint32_t call_number = offsetof(seccomp_data, nr);

constexpr std::uint16_t load_word = BPF_LD | BPF_W | BPF_ABS;
constexpr std::uint16_t jump_if_equal = BPF_JMP | BPF_JEQ | BPF_K;
constexpr std::uint16_t jump_if_at_least = BPF_JMP | BPF_JGE | BPF_K;
constexpr std::uint16_t keep_bits = BPF_ALU | BPF_AND | BPF_K;
constexpr std::uint16_t answer = BPF_RET | BPF_K;
constexpr std::uint32_t all_bits = 0xffffffff;

/// Have these bits of an argument this value?
struct ArgumentTest {
    std::uint32_t word; ///< argument()
    std::uint32_t mask;
    std::uint32_t value;
};

/// Writes the filter from its first instruction to its last.
class FilterWriter {
  public:
    explicit FilterWriter(std::uint32_t refusal) : refusal_(refusal) {}

    void put(std::uint16_t operation, std::uint32_t value, std::uint8_t if_true = 0,
             std::uint8_t if_false = 0) {
        filter.code.push_back({operation, if_true, if_false, value});
    }

    void answer_call(std::uint32_t call, std::uint32_t result) {
        put(jump_if_equal, call, 0, 1);
        put(answer, result);
    }

    void refuse(std::uint32_t call) { answer_call(call, refusal_); }

    void refuse_if(std::uint32_t call, const ArgumentTest& test) {
        put_test(call, test, true, refusal_);
    }

    void refuse_unless(std::uint32_t call, const ArgumentTest& test) {
        answer_unless(call, test, refusal_);
    }

    void answer_unless(std::uint32_t call, const ArgumentTest& test, std::uint32_t result) {
        put_test(call, test, false, result);
    }

    /// The first argument is a process, and must be the program's own.
    void refuse_unless_own_process(std::uint32_t call) {
        refuse_unless(call, {argument(0), all_bits, 0});
        filter.own_process.push_back(filter.code.size() - 3);
    }

    SystemCallFilter filter;

  private:
    /// Begins and ends with the number of the call loaded.
    void put_test(std::uint32_t call, const ArgumentTest& test, bool is_if_equal,
                  std::uint32_t result) {
        put(jump_if_equal, call, 0, 5);
        put(load_word, test.word);
        put(keep_bits, test.mask);
        put(jump_if_equal, test.value, is_if_equal ? 0 : 1, is_if_equal ? 1 : 0);
        put(answer, result);
        put(load_word, call_number);
    }

    std::uint32_t refusal_;
};

/// How programs and threads are started.
void write_starting(FilterWriter& writer, const FilterChoices& choices) {
    // The C library then takes clone, whose flags the filter can see.
    writer.answer_call(call_clone3, SECCOMP_RET_ERRNO | ENOSYS);
    constexpr std::uint32_t namespaces = CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS |
                                         CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;
    writer.refuse_unless(SYS_clone, {argument(0), namespaces, 0});
    if (choices.may_start_programs) return;
    // Without SIGSYS: the C library blocks signals here, and a blocked SIGSYS is the end, even of a
    // program that only wanted to wait for a key.
    constexpr std::uint32_t failure = SECCOMP_RET_ERRNO | EPERM;
    writer.answer_unless(SYS_clone, {argument(0), CLONE_THREAD, CLONE_THREAD}, failure);
#ifdef __x86_64__
    writer.answer_call(SYS_fork, failure);
    writer.answer_call(SYS_vfork, failure);
#endif
    const auto address = reinterpret_cast<std::uintptr_t>(choices.path);
    writer.refuse_unless(SYS_execve, {argument(0), all_bits, static_cast<std::uint32_t>(address)});
    writer.refuse_unless(SYS_execve,
                         {argument(0, true), all_bits, static_cast<std::uint32_t>(address >> 32U)});
}

/// What can be done to other processes by a call that is also of use.
void write_processes(FilterWriter& writer) {
    for (const std::uint32_t call :
         {SYS_kill, SYS_tkill, SYS_tgkill, SYS_rt_sigqueueinfo, SYS_rt_tgsigqueueinfo})
        writer.refuse_unless_own_process(call);
    for (const std::uint32_t call : {SYS_prlimit64, SYS_sched_setscheduler, SYS_sched_setparam,
                                     SYS_sched_setattr, SYS_sched_setaffinity})
        writer.refuse_unless(call, {argument(0), all_bits, 0});
    // A signal when a pipe has something to read goes to whatever process is named.
    for (const std::uint32_t command : {F_SETOWN, F_SETOWN_EX})
        writer.refuse_if(SYS_fcntl, {argument(1), all_bits, command});
    constexpr std::uint32_t set_owner = 0x8901, set_group = 0x8902;
    constexpr std::uint32_t type_into_terminal = TIOCSTI, paste_into_terminal = 0x541c;
    for (const std::uint32_t request :
         {set_owner, set_group, type_into_terminal, paste_into_terminal})
        writer.refuse_if(SYS_ioctl, {argument(1), all_bits, request});
    // It dies with this program, and its memory stays to be seen.
    for (const std::uint32_t option : {PR_SET_PDEATHSIG, PR_SET_DUMPABLE})
        writer.refuse_if(SYS_prctl, {argument(0), all_bits, option});
}

/// The mode of files. A linker makes its program executable: for the owner alone, which is all that
/// the mask of new files leaves.
void write_modes(FilterWriter& writer, const FilterChoices& choices) {
    struct ModeCall {
        std::uint32_t call;
        std::size_t mode; ///< index of the argument
    };
    for (const ModeCall& mode : {
#ifdef __x86_64__
             ModeCall{SYS_chmod, 1},
#endif
             ModeCall{SYS_fchmod, 1}, ModeCall{SYS_fchmodat, 2}}) {
        if (choices.may_start_programs) {
            writer.refuse_unless(mode.call, {argument(mode.mode), all_bits, 0700});
        } else {
            writer.refuse(mode.call);
        }
    }
}

/// Opening and naming files.
void write_files(FilterWriter& writer, const FilterChoices& choices) {
    // Its flags are in memory, which a filter cannot read.
    writer.answer_call(call_openat2, SECCOMP_RET_ERRNO | ENOSYS);
    if (choices.landlock_version < 3) writer.refuse(SYS_truncate);
    struct OpenCall {
        std::uint32_t call;
        std::size_t flags; ///< index of the argument
    };
    const bool is_writing_refused = choices.landlock_version == 0 && !choices.may_start_programs;
    for (const OpenCall& open : {
#ifdef __x86_64__
             OpenCall{SYS_open, 1},
#endif
             OpenCall{SYS_openat, 2}}) {
        // Opened for reading, a file can still be emptied, which older Landlocks do not notice.
        writer.refuse_if(open.call, {argument(open.flags), O_TRUNC | O_ACCMODE, O_TRUNC});
        if (is_writing_refused)
            writer.refuse_unless(open.call,
                                 {argument(open.flags), O_ACCMODE | O_CREAT | O_TRUNC, O_RDONLY});
    }
    if (choices.landlock_version > 0) return;
    for (const std::uint32_t call : linking_calls)
        writer.refuse(call);
    if (choices.may_start_programs) return;
    for (const std::uint32_t call : naming_calls)
        writer.refuse(call);
}

} // namespace

SystemCallFilter make_filter(const FilterChoices& choices) {
    FilterWriter writer(choices.may_start_programs ? SECCOMP_RET_ERRNO | EPERM : SECCOMP_RET_TRAP);
    writer.put(load_word, offsetof(seccomp_data, arch));
    writer.put(jump_if_equal, own_architecture, 1, 0);
    writer.put(answer, SECCOMP_RET_KILL_PROCESS);
    writer.put(load_word, call_number);
    writer.put(jump_if_at_least, x32_bit, 0, 1);
    writer.put(answer, SECCOMP_RET_KILL_PROCESS);
    writer.put(jump_if_at_least, first_unknown_call, 0, 1);
    writer.put(answer, SECCOMP_RET_ERRNO | ENOSYS);
    for (const std::uint32_t call : refused_calls)
        writer.refuse(call);
    write_starting(writer, choices);
    write_processes(writer);
    write_modes(writer, choices);
    write_files(writer, choices);
    writer.put(answer, SECCOMP_RET_ALLOW);
    return writer.filter;
}

int install_filter(SystemCallFilter& filter) noexcept {
    const auto process = static_cast<std::uint32_t>(::getpid());
    for (const std::size_t place : filter.own_process)
        filter.code[place].k = process;
    const sock_fprog program{static_cast<unsigned short>(filter.code.size()), filter.code.data()};
    return ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0 ? 0 : errno;
}

} // namespace rasterwalk

#endif
