#include "mine/program_places.h"

#include <array>
#include <charconv>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "mine/guard/guard.h"

namespace rasterwalk {

namespace {

/// "FILE:LINE", "FILE:LINE (discriminator 2)", "??:0", "FILE:?".
void parse_file_and_line(std::string_view text, ProgramPlace& place) {
    if (const std::size_t remark = text.rfind(" (discriminator "); remark != std::string_view::npos)
        text = text.substr(0, remark);
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos || text.starts_with("??")) return;
    place.file = std::string(text.substr(0, colon));
    const std::string_view line = text.substr(colon + 1);
    std::from_chars(line.data(), line.data() + line.size(), place.line);
}

std::string find_addr2line() {
    for (const char* path : {"/usr/bin/addr2line", "/usr/local/bin/addr2line"})
        if (std::filesystem::exists(path)) return path;
    return {};
}

} // namespace

std::vector<std::vector<ProgramPlace>> parse_places(const std::string& printed) {
    std::vector<std::vector<ProgramPlace>> places;
    std::string_view rest = printed;
    bool is_function = true;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (line.starts_with("0x")) {
            places.emplace_back();
            is_function = true;
        } else if (!places.empty()) {
            if (is_function) {
                places.back().emplace_back();
                if (line != "??") places.back().back().function = std::string(line);
            } else {
                parse_file_and_line(line, places.back().back());
            }
            is_function = !is_function;
        }
    }
    return places;
}

std::vector<std::vector<ProgramPlace>> places_of(const std::string& program,
                                                 std::span<const std::uint64_t> addresses) {
    const std::string tool = find_addr2line();
    if (tool.empty() || addresses.empty()) return {};
    GuardedCommand command;
    command.words = {tool, "-a", "-f", "-i", "-C", "-e", program};
    for (const std::uint64_t address : addresses)
        command.words.push_back(fmt::format("{:#x}", address));
    command.environment = {"LC_ALL=C", "PATH=/usr/bin:/bin"};
    command.folder = "/";
    command.readable = {program};
    command.limits.may_start_programs = true;
    try {
        const GuardedRun run = run_guarded(command);
        if (run.end != GuardedEnd::exited || run.exit_code != 0) return {};
        return parse_places(run.output);
    } catch (const AccessError&) {
        return {}; // a line that is not known is no reason to report nothing
    }
}

bool is_in_folder(std::string_view file, std::string_view folder) {
    while (folder.ends_with('/'))
        folder.remove_suffix(1);
    // A program's #line may name anything.
    if (file.find("/../") != file.npos) return false;
    return file.starts_with(folder) && (file.size() == folder.size() || file[folder.size()] == '/');
}

const ProgramPlace* innermost_in(std::span<const std::vector<ProgramPlace>> stack,
                                 const std::string& folder) {
    for (const std::vector<ProgramPlace>& frames : stack)
        for (const ProgramPlace& place : frames)
            if (place.line > 0 && is_in_folder(place.file, folder)) return &place;
    return nullptr;
}

} // namespace rasterwalk
