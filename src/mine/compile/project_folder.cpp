#include "mine/compile/project_folder.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"
#include "base/letter_case.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_found = 5'000;

bool is_left_out(const std::string& folder_name) {
    const std::string name = in_small_letters(folder_name);
    constexpr std::string_view exact[] = {
        "build", "cmakefiles", "glm",         "bin", "obj",         "debug",  "lib",     "release",
        "x64",   "x86",        "include_sdl", "out", "third_party", "extern", "__macosx"};
    return name.empty() || name.front() == '.' || name.starts_with("sdl") ||
           name.starts_with("glm-") || name.starts_with("cmake-build") ||
           name.starts_with("build-") || name.ends_with(".dir") ||
           std::find(std::begin(exact), std::end(exact), name) != std::end(exact);
}

/// A regular file, and not a link to one that is elsewhere.
bool is_own_file(const fs::directory_entry& entry, const std::string& root) {
    std::error_code fault;
    if (!entry.is_regular_file(fault) || fault) return false;
    if (!entry.is_symlink(fault)) return true;
    const fs::path target = fs::canonical(entry.path(), fault);
    return !fault && is_below(target.string(), root);
}

void add_files(const fs::path& folder, const std::string& root, int depth, int deepest,
               std::vector<FoundFile>& found) {
    std::error_code fault;
    fs::directory_iterator entry(folder, fault);
    if (fault && depth == 0) {
        throw AccessError(fmt::format("cannot read '{}': {}.", folder.string(), fault.message()));
    }
    std::vector<fs::path> deeper;
    for (const fs::directory_iterator end; !fault && entry != end && found.size() < most_found;
         entry.increment(fault)) {
        std::error_code ignored;
        if (is_own_file(*entry, root)) {
            found.push_back({entry->path().string(), depth});
        } else if (depth < deepest && entry->is_directory(ignored) && !entry->is_symlink(ignored) &&
                   !is_left_out(entry->path().filename().string())) {
            deeper.push_back(entry->path());
        }
    }
    for (const fs::path& path : deeper)
        add_files(path, root, depth + 1, deepest, found);
}

bool has_ending(std::string_view path, std::initializer_list<std::string_view> endings) {
    const std::string name = in_small_letters(file_name(path));
    // What begins with a dot is no student's: macOS leaves "._main.cpp" in its archives.
    if (name.starts_with('.')) return false;
    return std::any_of(endings.begin(), endings.end(), [&name](std::string_view ending) {
        return name.size() > ending.size() && name.ends_with(ending);
    });
}

} // namespace

std::vector<FoundFile> files_in(const std::string& folder, int depth) {
    std::error_code fault;
    const fs::path root = fs::canonical(folder, fault);
    if (fault) throw AccessError(fmt::format("cannot read '{}': {}.", folder, fault.message()));
    std::vector<FoundFile> found;
    add_files(folder, root.string(), 0, depth, found);
    std::sort(found.begin(), found.end(), [](const FoundFile& a, const FoundFile& b) {
        return a.depth != b.depth ? a.depth < b.depth : a.path < b.path;
    });
    return found;
}

std::vector<std::string> folders_in(const std::string& folder) {
    std::error_code fault;
    fs::directory_iterator entry(folder, fault);
    if (fault) throw AccessError(fmt::format("cannot read '{}': {}.", folder, fault.message()));
    std::vector<std::string> folders;
    for (const fs::directory_iterator end; !fault && entry != end && folders.size() < most_found;
         entry.increment(fault)) {
        std::error_code ignored;
        if (entry->is_directory(ignored) && !entry->is_symlink(ignored) &&
            !is_left_out(entry->path().filename().string())) {
            folders.push_back(entry->path().string());
        }
    }
    std::sort(folders.begin(), folders.end());
    return folders;
}

bool is_source_name(std::string_view path) {
    return has_ending(path, {".cpp", ".cc", ".cxx", ".c++"});
}

bool is_header_name(std::string_view path) {
    return has_ending(path, {".h", ".hh", ".hpp", ".hxx", ".inl"});
}

bool is_archive_name(std::string_view path) {
    return has_ending(path, {".zip", ".tar", ".tgz", ".gz", ".bz2", ".xz", ".7z", ".rar"});
}

bool is_name_of_copy(std::string_view path) {
    const std::string stem = in_small_letters(file_stem(path));
    const auto is_letter = [&stem](std::size_t at) {
        return at < stem.size() && std::isalpha(static_cast<unsigned char>(stem[at])) != 0;
    };
    for (const std::string_view word : {"backup", "copy", "old", "bak", "kopia", "orig", "prev"}) {
        for (std::size_t at = stem.find(word); at != std::string::npos;
             at = stem.find(word, at + 1)) {
            // "threshold" and "bold" are no copies.
            const bool begins = at == 0 || !is_letter(at - 1);
            if (begins && !is_letter(at + word.size())) return true;
        }
    }
    return stem.ends_with(')') && stem.rfind('(') != std::string::npos;
}

std::string file_name(std::string_view path) {
    return std::string(path.substr(path.find_last_of('/') + 1));
}

std::string file_stem(std::string_view path) {
    const std::string name = file_name(path);
    return name.substr(0, name.find_last_of('.'));
}

bool is_below(std::string_view path, std::string_view folder) {
    while (folder.size() > 1 && folder.ends_with('/'))
        folder.remove_suffix(1);
    if (!path.starts_with(folder)) return false;
    return path.size() == folder.size() || folder == "/" || path[folder.size()] == '/';
}

} // namespace rasterwalk
