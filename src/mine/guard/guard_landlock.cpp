#include "mine/guard/guard_landlock.h"

#ifdef RASTERWALK_HAS_GUARD

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>

#include <elf.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "base/error.h"
#include "base/quoted.h"

namespace rasterwalk {

namespace {

// Headers of older systems lack these. The numbers are the same everywhere.
constexpr long call_create_ruleset = 444;
constexpr long call_add_rule = 445;
constexpr long call_restrict_self = 446;
constexpr unsigned ask_version = 1;
constexpr int rule_path_beneath = 1;

constexpr std::uint64_t may_execute = 1U << 0U;
constexpr std::uint64_t may_write_file = 1U << 1U;
constexpr std::uint64_t may_read_file = 1U << 2U;
constexpr std::uint64_t may_read_folder = 1U << 3U;
constexpr std::uint64_t may_remove_folder = 1U << 4U;
constexpr std::uint64_t may_remove_file = 1U << 5U;
constexpr std::uint64_t may_make_folder = 1U << 7U;
constexpr std::uint64_t may_make_file = 1U << 8U;
constexpr std::uint64_t may_move = 1U << 13U;     ///< from one folder to another; version 2
constexpr std::uint64_t may_truncate = 1U << 14U; ///< version 3

constexpr std::uint64_t may_read = may_read_file | may_read_folder;
/// No pipes, sockets, devices or symbolic links: programs that read the folder later do not expect
/// them.
constexpr std::uint64_t may_write = may_read | may_write_file | may_remove_folder |
                                    may_remove_file | may_make_folder | may_make_file | may_move |
                                    may_truncate;
/// What makes sense for a single file.
constexpr std::uint64_t file_rights = may_execute | may_write_file | may_read_file | may_truncate;

/// Signals and sockets without a file stay among the program's own processes; version 6.
constexpr std::uint64_t scoped_sockets_and_signals = 3;

/// What the system takes; parts that are zero may be unknown to it.
struct HandledRights {
    std::uint64_t files;
    std::uint64_t network;
    std::uint64_t scoped;
};
struct [[gnu::packed]] RightsBelow {
    std::uint64_t rights;
    std::int32_t place;
};

constexpr std::array system_places{
    "/usr",       "/lib",       "/lib64",           "/lib32",           "/bin",
    "/nix/store", "/gnu/store", "/etc/ld.so.cache", "/etc/alternatives"};
constexpr std::array readable_devices{"/dev/zero", "/dev/urandom", "/dev/random"};

/// Every right of files that this version knows: without a rule each is refused.
std::uint64_t rights_of_version(int version) {
    const int count = version >= 5 ? 16 : version >= 3 ? 15 : version == 2 ? 14 : 13;
    return (std::uint64_t{1} << static_cast<unsigned>(count)) - 1;
}

/// @return 0, or an errno
int allow_below(int rules, const char* path, std::uint64_t rights) noexcept {
    const int place = ::open(path, O_PATH | O_CLOEXEC);
    if (place < 0) return errno;
    struct stat state {};
    int fault = ::fstat(place, &state) == 0 ? 0 : errno;
    if (fault == 0) {
        const RightsBelow rule{S_ISDIR(state.st_mode) ? rights : rights & file_rights, place};
        if (::syscall(call_add_rule, rules, rule_path_beneath, &rule, 0) != 0) fault = errno;
    }
    ::close(place);
    return fault;
}

/// The program that the system starts to load this one; empty: it is loaded without one.
std::string loader_of(const std::string& program) {
    std::ifstream file(program, std::ios::binary);
    Elf64_Ehdr header{};
    if (!file.read(reinterpret_cast<char*>(&header), sizeof header)) return {};
    if (std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0) return {};
    for (unsigned i = 0; i < header.e_phnum; ++i) {
        Elf64_Phdr part{};
        file.seekg(static_cast<std::streamoff>(header.e_phoff + i * sizeof part));
        if (!file.read(reinterpret_cast<char*>(&part), sizeof part)) return {};
        constexpr Elf64_Xword longest_path = 4096;
        if (part.p_type != PT_INTERP || part.p_filesz > longest_path) continue;
        std::string path(part.p_filesz, '\0');
        file.seekg(static_cast<std::streamoff>(part.p_offset));
        file.read(path.data(), static_cast<std::streamsize>(path.size()));
        return path.substr(0, path.find('\0'));
    }
    return {};
}

void add_rules(int rules, const GuardedCommand& command, std::uint64_t known) {
    const auto allow_if_there = [&](const char* path, std::uint64_t rights) {
        allow_below(rules, path, rights & known);
    };
    const auto allow = [&](const std::string& path, std::uint64_t rights) {
        const int fault = allow_below(rules, path.c_str(), rights & known);
        if (fault != 0)
            throw AccessError(
                fmt::format("cannot open {}: {}.", in_quotes(path), std::strerror(fault)));
    };
    const std::uint64_t read =
        command.limits.may_start_programs ? may_read | may_execute : may_read;
    for (const char* place : system_places)
        allow_if_there(place, read);
    for (const char* device : readable_devices)
        allow_if_there(device, may_read_file);
    allow_if_there("/dev/null", may_read_file | may_write_file);
    allow(command.words.front(), may_read_file | may_execute);
    const std::string loader = loader_of(command.words.front());
    if (!loader.empty()) allow_if_there(loader.c_str(), may_read_file | may_execute);
    for (const std::string& path : command.readable)
        allow(path, read);
    for (const std::string& path : command.writable)
        allow(path, may_write);
}

} // namespace

int landlock_version() {
    const long version = ::syscall(call_create_ruleset, nullptr, 0, ask_version);
    return version > 0 ? static_cast<int>(version) : 0;
}

int make_file_rules(const GuardedCommand& command, int version) {
    const HandledRights handled{rights_of_version(version), 0,
                                version >= 6 ? scoped_sockets_and_signals : 0};
    const int rules = static_cast<int>(::syscall(call_create_ruleset, &handled, sizeof handled, 0));
    if (rules < 0)
        throw AccessError(fmt::format("this system cannot guard files: {}.", std::strerror(errno)));
    try {
        add_rules(rules, command, handled.files);
    } catch (...) {
        ::close(rules);
        throw;
    }
    return rules;
}

int follow_file_rules(int rules) noexcept {
    // Only now is this process the one that /proc/self leads to. Sanitizers read its memory map;
    // without it they say so themselves.
    allow_below(rules, "/proc/self", may_read);
    return ::syscall(call_restrict_self, rules, 0) == 0 ? 0 : errno;
}

} // namespace rasterwalk

#endif
