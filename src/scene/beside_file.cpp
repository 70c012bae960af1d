#include "scene/beside_file.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/quoted.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

bool leads_out(const fs::path& name) {
    return !name.is_relative() || std::find(name.begin(), name.end(), "..") != name.end();
}

} // namespace

BesideFile find_beside(std::initializer_list<std::string_view> namers, std::string_view name) {
    constexpr std::size_t longest_name = 4096;
    if (name.empty()) return {"", "no file is named"};
    std::string slashed(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    const fs::path whole(slashed), last = whole.filename();
    std::vector<fs::path> ways;
    for (const fs::path& way : {fs::path(name), whole, last}) {
        if (!way.empty() && !leads_out(way)) ways.push_back(way);
    }
    if (name.size() > longest_name || name.find('\0') != name.npos) ways.clear();
    for (const std::string_view namer : namers) {
        const fs::path folder = fs::path(namer).parent_path();
        for (const fs::path& way : ways) {
            std::error_code fault;
            const fs::path place = folder / way;
            const fs::file_status status = fs::status(place, fault);
            if (!fs::exists(status)) continue;
            if (fs::is_regular_file(status)) return {place.string(), ""};
            return {"", in_quotes(name) +
                            (fs::is_directory(status) ? " is a folder" : " is a pipe or a device")};
        }
    }
    const std::string none = "there is no file " + in_quotes(name);
    return {"", leads_out(whole) ? none + " beside it or in a folder below" : none};
}

void BesideBytes::add(const std::string& path) {
    std::error_code fault;
    const std::uintmax_t size = fs::file_size(path, fault);
    if (fault) return; // reading it says why
    if (size > most_ - count_) {
        throw InputError(
            fmt::format("{}: with it {} have more than {} MB.", path, plural_, most_ >> 20));
    }
    count_ += size;
}

} // namespace rasterwalk
