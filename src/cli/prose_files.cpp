#include "cli/prose_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/error.h"
#include "text/prose.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

void add_folder(const fs::path& folder, std::vector<std::string>& files) {
    std::vector<fs::path> entries;
    std::error_code fault;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault))
        entries.push_back(entry->path());
    if (fault) throw AccessError("cannot read '" + folder.string() + "': " + fault.message() + ".");
    std::sort(entries.begin(), entries.end());
    for (const fs::path& entry : entries) {
        const std::string name = entry.filename().string();
        std::error_code ignored;
        if (fs::is_symlink(entry, ignored) || name.starts_with('.') || name == "build") continue;
        if (fs::is_directory(entry, ignored)) {
            add_folder(entry, files);
        } else if (prose_kind(name) && name != "style.toml") {
            files.push_back(entry.string());
        }
    }
}

} // namespace

std::vector<std::string> prose_files(const std::vector<std::string>& paths) {
    std::vector<std::string> files;
    for (const std::string& path : paths) {
        std::error_code ignored;
        if (fs::is_directory(path, ignored)) {
            add_folder(fs::path(path).lexically_normal(), files);
        } else {
            files.push_back(path); // its reader will say why it cannot be read
        }
    }
    return files;
}

} // namespace rasterwalk
