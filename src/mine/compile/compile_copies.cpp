#include "mine/compile/compile_copies.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/letter_case.h"
#include "mine/compile/fingerprint.h"
#include "mine/compile/kit_files.h"
#include "mine/compile/project_folder.h"
#include "mine/compile/source_text.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_copies = 1'000;
constexpr std::size_t most_copied_bytes = std::size_t{32} << 20;
constexpr int deepest_header = 4;
constexpr const char* system_folders[] = {"/usr/include", "/usr/local/include"};

std::string with_slashes(std::string_view name) {
    std::string path(name);
    std::replace(path.begin(), path.end(), '\\', '/');
    return path;
}

bool is_in_system(const std::string& name) {
    std::error_code fault;
    return std::any_of(
        std::begin(system_folders), std::end(system_folders),
        [&](const char* folder) { return fs::is_regular_file(fs::path(folder) / name, fault); });
}

/// SDL itself: the student's program brings none of it along.
bool is_library_name(const std::string& kit_file) {
    const std::string stem = in_small_letters(file_stem(kit_file));
    return stem == "sdl" || stem.starts_with("sdl_");
}

/// What other systems have, and a program may bring along.
bool is_of_other_system(std::string_view name) {
    return name == "stdafx.h" || name == "tchar.h" || name == "windows.h";
}

/// A file that is copied, and the copies that its includes lead to.
struct CopiedFile {
    std::string copy;
    std::string text;
    std::vector<std::string> reads; ///< originals
};

class Copier {
  public:
    Copier(const StudentFiles& files, std::string folder, KitUse kit)
        : files_(files), folder_(std::move(folder)), kit_(kit) {}

    /// Copies a file and those it includes; `appended` comes after its text.
    void add(const std::string& original, const std::string& prefix, const std::string& appended);

    /// Writes the copies; returns how to compile these sources.
    ProgramCopies finish(const std::vector<std::string>& sources);

    void leave_to_kit(const std::string& own_file) { own_files_.insert(own_file); }

    /// Is this file, or one of this name, replaced by the kit's?
    bool is_kits(const std::string& kit_file, bool has_own) const {
        if (kit_file.empty()) return false;
        if (has_own && is_of_other_system(in_small_letters(kit_file))) return false;
        return kit_ != KitUse::own_helper || !has_own || is_library_name(kit_file);
    }

  private:
    std::string target_of(const Include& include, const std::string& reader,
                          std::vector<std::string>& reads);
    std::string own_file(const Include& include, const std::string& name,
                         const std::string& reader);
    std::string copy_path(const std::string& original, const std::string& prefix) const;
    void add_closure(const std::string& original, std::set<std::string>& closure) const;
    const std::vector<FoundFile>& project();

    const StudentFiles& files_;
    std::string folder_;
    KitUse kit_;
    std::map<std::string, CopiedFile> copies_; ///< by original
    std::set<std::string> own_files_;
    std::optional<std::vector<FoundFile>> project_;
    std::size_t bytes_ = 0;
};

const std::vector<FoundFile>& Copier::project() {
    if (!project_) project_ = files_in(files_.folder, deepest_header);
    return *project_;
}

std::string Copier::copy_path(const std::string& original, const std::string& prefix) const {
    std::string name = file_name(original);
    for (char& letter : name) {
        if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '.') letter = '_';
    }
    return fmt::format("{}/{}{}-{}", folder_, prefix, Fingerprint().add(original).text(),
                       name.substr(0, 100));
}

/// The student's file that an #include leads to; empty: none.
std::string Copier::own_file(const Include& include, const std::string& name,
                             const std::string& reader) {
    std::error_code fault;
    std::vector<fs::path> folders{fs::path(reader).parent_path(), files_.folder,
                                  fs::path(files_.main).parent_path()};
    if (!include.is_quoted) folders.erase(folders.begin());
    for (const fs::path& folder : folders) {
        const fs::path found = fs::canonical(folder / name, fault);
        if (!fault && fs::is_regular_file(found, fault) &&
            is_below(found.string(), files_.folder)) {
            return found.string();
        }
    }
    // Its path is one of another computer: then a file of the same name is meant.
    const std::string wanted = in_small_letters(file_name(name));
    for (const FoundFile& file : project()) {
        if (in_small_letters(file_name(file.path)) == wanted) {
            return fs::canonical(file.path, fault).string();
        }
    }
    return {};
}

/// What stands after #include in the copy.
std::string Copier::target_of(const Include& include, const std::string& reader,
                              std::vector<std::string>& reads) {
    const std::string name = with_slashes(include.name);
    if (const std::string glm = glm_file_for(name); !glm.empty()) return "<" + glm + ">";
    const std::string as_it_was = include.is_quoted ? "\"" + name + "\"" : "<" + name + ">";
    const std::string kit_file = kit_file_for(name);
    const bool may_be_systems = !include.is_quoted && kit_file.empty();
    if (may_be_systems && (name.find('.') == std::string::npos || is_in_system(name))) {
        return as_it_was;
    }
    const std::string own = own_file(include, name, reader);
    if (is_kits(kit_file, !own.empty())) {
        if (!own.empty()) own_files_.insert(own);
        return "\"" + kit_file + "\"";
    }
    if (own.empty()) return as_it_was;
    reads.push_back(own);
    return quoted_for_line(copy_path(own, {}));
}

void Copier::add(const std::string& original, const std::string& prefix,
                 const std::string& appended) {
    if (copies_.contains(original)) return;
    const std::string text = read_source(original);
    bytes_ += text.size();
    if (copies_.size() == most_copies || bytes_ > most_copied_bytes) {
        throw InputError(fmt::format("{}: the program reads more than {} files, or {} MB.",
                                     files_.folder, most_copies, most_copied_bytes >> 20));
    }
    CopiedFile& copied = copies_[original];
    copied.copy = copy_path(original, prefix);
    copied.text = fmt::format("#line 1 {}\n", quoted_for_line(original));
    std::vector<std::string> reads;
    std::size_t done = 0;
    for (const Include& include : includes_of(text)) {
        copied.text.append(text, done, include.begin - done);
        copied.text += target_of(include, original, reads);
        done = include.end;
    }
    copied.text.append(text, done, std::string::npos);
    // Two, because the last line may end with a backslash.
    copied.text += "\n\n" + appended;
    copied.reads = reads;
    for (const std::string& read : reads)
        add(read, {}, {});
}

void Copier::add_closure(const std::string& original, std::set<std::string>& closure) const {
    if (!closure.insert(original).second) return;
    for (const std::string& read : copies_.at(original).reads)
        add_closure(read, closure);
}

ProgramCopies Copier::finish(const std::vector<std::string>& sources) {
    ProgramCopies program;
    for (const auto& [original, copied] : copies_) {
        write_file(copied.copy, copied.text);
        program.originals.insert(original);
    }
    for (const std::string& source : sources) {
        std::set<std::string> closure;
        add_closure(source, closure);
        Fingerprint fingerprint;
        fingerprint.add(source);
        for (const std::string& original : closure)
            fingerprint.add(copies_.at(original).text);
        program.sources.push_back({source, copies_.at(source).copy, fingerprint.text()});
    }
    program.own_files.assign(own_files_.begin(), own_files_.end());
    return program;
}

} // namespace

std::string kit_file_for(std::string_view include_name) {
    static const std::map<std::string, std::string> files = [] {
        std::map<std::string, std::string> by_name;
        for (const KitFile& file : kit_files()) {
            const std::string name = in_small_letters(file_name(file.name));
            const bool is_for_students = name.starts_with("sdl") || name.starts_with("testmodel") ||
                                         is_of_other_system(name);
            if (!is_for_students || !is_header_name(name) || file.name.starts_with("new/")) {
                continue;
            }
            // "SDL.h" and "SDL2/SDL.h" are one.
            std::string& known = by_name[name];
            if (known.empty() || file.name.size() < known.size()) known = file.name;
        }
        return by_name;
    }();
    const auto found = files.find(in_small_letters(file_name(with_slashes(include_name))));
    return found == files.end() ? std::string() : found->second;
}

std::string glm_file_for(std::string_view include_name) {
    const std::string name = with_slashes(include_name);
    if (name == "glm.hpp") return "glm/glm.hpp";
    for (std::size_t at = name.find("glm/"); at != std::string::npos;
         at = name.find("glm/", at + 1)) {
        if (at > 0 && name[at - 1] != '/') continue;
        if (is_in_system(name.substr(at))) return name.substr(at);
    }
    return {};
}

std::string quoted_for_line(std::string_view path) {
    std::string quoted = "\"";
    for (const char letter : path) {
        if (letter == '"' || letter == '\\') quoted += '\\';
        quoted += letter == '\n' || letter == '\r' ? '?' : letter;
    }
    return quoted + "\"";
}

ProgramCopies copy_program(const StudentFiles& files, const std::string& folder, KitUse kit,
                           const std::string& driver) {
    std::error_code fault;
    fs::create_directories(folder, fault);
    Copier copier(files, folder, kit);
    std::string appended;
    if (!driver.empty()) {
        appended = fmt::format("#line 1 \"driver\"\n#include {}\n", quoted_for_line(driver));
    }
    copier.add(files.main, driver.empty() ? "" : "asked-", appended);
    std::vector<std::string> sources{files.main};
    for (const std::string& source : files.sources) {
        // The other half of a header that the kit replaces.
        if (copier.is_kits(kit_file_for(file_stem(source) + ".h"), true)) {
            copier.leave_to_kit(source);
            continue;
        }
        copier.add(source, {}, {});
        sources.push_back(source);
    }
    return copier.finish(sources);
}

} // namespace rasterwalk
