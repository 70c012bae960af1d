#include "mine/compile/kit_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "base/error.h"
#include "base/files.h"
#include "mine/compile/fingerprint.h"
#include "mine/compile/kit_parts.h"

namespace rasterwalk {

namespace {

struct JoinedFile {
    std::string name, text;
};

const std::vector<JoinedFile>& joined_files() {
    static const std::vector<JoinedFile> files = [] {
        std::vector<JoinedFile> joined;
        for (const KitPart& part : kit_parts()) {
            if (joined.empty() || joined.back().name != part.name)
                joined.push_back({part.name, {}});
            joined.back().text += part.text;
        }
        return joined;
    }();
    return files;
}

} // namespace

const std::vector<KitFile>& kit_files() {
    static const std::vector<KitFile> files = [] {
        std::vector<KitFile> list;
        for (const JoinedFile& file : joined_files())
            list.push_back({file.name, file.text});
        std::sort(list.begin(), list.end(),
                  [](const KitFile& a, const KitFile& b) { return a.name < b.name; });
        return list;
    }();
    return files;
}

const std::string& kit_version() {
    static const std::string version = [] {
        Fingerprint fingerprint;
        for (const KitFile& file : kit_files())
            fingerprint.add(file.name).add(file.text);
        return fingerprint.text();
    }();
    return version;
}

void write_kit(const std::string& folder) {
    namespace fs = std::filesystem;
    std::error_code fault;
    if (fs::is_directory(folder, fault)) return;
    // Another process may be doing the same: the folder appears complete or not at all.
    const fs::path unfinished = fmt::format("{}.{}.part", folder, ::getpid());
    fs::remove_all(unfinished, fault);
    for (const KitFile& file : kit_files()) {
        const fs::path path = unfinished / file.name;
        fs::create_directories(path.parent_path(), fault);
        write_file(path.string(), file.text);
    }
    fs::rename(unfinished, folder, fault);
    if (!fault) return;
    const std::string reason = fault.message();
    fs::remove_all(unfinished, fault);
    if (!fs::is_directory(folder, fault)) {
        throw AccessError(fmt::format("cannot write '{}': {}.", folder, reason));
    }
}

} // namespace rasterwalk
