#include "scene/companion_file.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/letter_case.h"
#include "base/quoted.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_file_name = 4096;

bool has_step_up(const fs::path& name) {
    return std::find(name.begin(), name.end(), "..") != name.end();
}

/// Is this a place in the folder above, or below it: "../textures/wood.png"?
bool is_below_parent(const fs::path& name) {
    return name.begin() != name.end() && *name.begin() == ".." &&
           !has_step_up(name.lexically_relative(".."));
}

bool leads_out(const fs::path& name) {
    return !name.is_relative() || (has_step_up(name) && !is_below_parent(name));
}

bool is_usable(std::string_view name) {
    return !name.empty() && name.size() <= longest_file_name && name.find('\0') == name.npos;
}

std::string slashed(std::string_view name) {
    std::string with_slashes(name);
    std::replace(with_slashes.begin(), with_slashes.end(), '\\', '/');
    return with_slashes;
}

/// The folder of a file that names other files; never empty.
fs::path folder_of(const std::string& namer) {
    const fs::path folder = fs::path(namer).parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

/// Is a place really below the parent of the namer's folder, with all links resolved?
bool stays_below_parent(const fs::path& folder, const fs::path& place) {
    std::error_code fault;
    const fs::path parent = fs::canonical(folder / "..", fault);
    const fs::path real = fault ? fs::path() : fs::canonical(place, fault);
    return !fault && !has_step_up(real.lexically_relative(parent));
}

} // namespace

CompanionFiles::CompanionFiles(std::vector<std::string> namers) : namers_(std::move(namers)) {}

CompanionFile CompanionFiles::find(const std::vector<std::string>& names) {
    const auto remark = [&](const std::string& used) {
        return "there is no file " + in_quotes(names.front()) + "; " + in_quotes(used) + " is used";
    };
    CompanionFile first;
    for (const std::string& name : names) {
        CompanionFile file = find_exactly(name);
        const bool is_first = &name == &names.front();
        if (file.problem.empty()) {
            if (!is_first) file.remark = remark(name);
            return file;
        }
        if (is_first) first = std::move(file);
    }
    for (const std::string& name : names) {
        const std::string path = find_similar(name);
        if (!path.empty()) return {path, "", remark(fs::path(path).lexically_normal().string())};
    }
    return first;
}

CompanionFile CompanionFiles::find_exactly(const std::string& name) const {
    if (name.empty()) return {"", "no file is named", ""};
    const fs::path whole(slashed(name)), last = whole.filename();
    std::vector<fs::path> candidates;
    for (const fs::path& candidate : {fs::path(name), whole, last}) {
        if (is_usable(name) && !candidate.empty() && !leads_out(candidate))
            candidates.push_back(candidate);
    }
    for (const std::string& namer : namers_) {
        const fs::path folder = fs::path(namer).parent_path();
        for (const fs::path& candidate : candidates) {
            std::error_code fault;
            const fs::path place = folder / candidate;
            const fs::file_status status = fs::status(place, fault);
            if (!fs::exists(status)) continue;
            if (!stays_below_parent(folder_of(namer), place)) continue;
            if (fs::is_regular_file(status)) return {place.string(), "", ""};
            const bool is_folder = fs::is_directory(status);
            return {"", in_quotes(name) + (is_folder ? " is a folder" : " is a pipe or a device"),
                    ""};
        }
    }
    const std::string none = "there is no file " + in_quotes(name);
    return {"",
            none + (leads_out(whole) ? " in its folder, below it or in a folder next to it" : ""),
            ""};
}

/// The path of a file with the same last part; empty if there is none.
std::string CompanionFiles::find_similar(const std::string& name) {
    if (!is_usable(name)) return {};
    const fs::path whole(slashed(name));
    if (!has_searched_) {
        for (auto namer = namers_.begin(); namer != namers_.end(); ++namer) {
            const bool is_known =
                std::any_of(namers_.begin(), namer, [&](const std::string& before) {
                    return folder_of(before) == folder_of(*namer);
                });
            if (!is_known) look_around(*namer);
        }
        has_searched_ = true;
    }
    const auto found = known_.find(in_small_letters(whole.filename().string()));
    if (found == known_.end()) return {};
    const std::string wanted = in_small_letters(whole.parent_path().filename().string());
    const std::vector<KnownFile>& files = found->second;
    const auto in_wanted = std::find_if(files.begin(), files.end(), [&](const KnownFile& file) {
        return in_small_letters(file.folder) == wanted;
    });
    return (in_wanted != files.end() ? *in_wanted : files.front()).path;
}

void CompanionFiles::look_around(const std::string& namer) {
    const fs::path folder = folder_of(namer);
    std::vector<std::string> below, next, deeper;
    look_into(folder.string(), below);
    for (const std::string& of : below)
        look_into(of, deeper);
    std::error_code fault;
    const fs::path parent = folder / "..";
    for (fs::directory_iterator entry(parent, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        if (++names_checked_ > most_names_checked) break;
        std::error_code ignored;
        if (fs::is_directory(entry->symlink_status(ignored)) &&
            !fs::equivalent(entry->path(), folder, ignored))
            next.push_back(entry->path().string());
    }
    std::sort(next.begin(), next.end());
    std::vector<std::string> unsearched;
    for (const std::string& of : next)
        look_into(of, unsearched);
    for (std::size_t i = 0; i < deeper.size(); ++i) {
        std::vector<std::string> found;
        look_into(deeper[i], found);
        deeper.insert(deeper.end(), found.begin(), found.end());
    }
}

/// Adds the plain files of a folder to the known ones, and its subfolders to a list.
void CompanionFiles::look_into(const std::string& folder, std::vector<std::string>& folders) {
    std::vector<std::string> names;
    std::error_code fault;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        if (++names_checked_ > most_names_checked) break;
        std::error_code ignored;
        const fs::file_status status = entry->symlink_status(ignored);
        if (fs::is_directory(status)) folders.push_back(entry->path().string());
        if (fs::is_regular_file(status)) names.push_back(entry->path().filename().string());
    }
    std::sort(names.begin(), names.end());
    std::sort(folders.begin(), folders.end());
    for (const std::string& name : names) {
        known_[in_small_letters(name)].push_back(
            {fs::path(folder).filename().string(), (fs::path(folder) / name).string()});
    }
}

void CompanionBytes::add(const std::string& path) {
    std::error_code fault;
    const std::uintmax_t size = fs::file_size(path, fault);
    if (fault) return; // reading the file will report why
    if (size > most_ - count_) {
        throw InputError(fmt::format("{}: with this file, {} exceed {} MB in total.", path, plural_,
                                     most_ >> 20));
    }
    count_ += size;
}

} // namespace rasterwalk
