#include "mine/compile/student_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"
#include "mine/compile/project_folder.h"
#include "mine/compile/source_text.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

/// A program is looked for in this many folders, one in the other: "hand-in/lab3/Source".
constexpr int deepest_main = 2;
constexpr std::size_t most_sources = 200;

std::size_t skip_blanks(std::string_view code, std::size_t at) {
    while (at < code.size() && std::isspace(static_cast<unsigned char>(code[at])) != 0)
        ++at;
    return at;
}

/// Behind the bracket that closes the one at `open`.
std::size_t behind_brackets(std::string_view code, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < code.size(); ++i) {
        if (code[i] == '(') ++depth;
        if (code[i] == ')' && --depth == 0) return i + 1;
    }
    return code.size();
}

/// The word that ends before this place; empty if something else does.
std::string_view word_before(std::string_view code, std::size_t at) {
    while (at > 0 && std::isspace(static_cast<unsigned char>(code[at - 1])) != 0)
        --at;
    std::size_t begin = at;
    while (begin > 0 && is_name_letter(code[begin - 1]))
        --begin;
    return code.substr(begin, at - begin);
}

/// None of these comes between an #include and the text that it brings in.
std::string text_or_nothing(const std::string& path) {
    try {
        return read_source(path);
    } catch (const Error&) {
        return {};
    }
}

std::string absolute(const std::string& path) {
    std::error_code fault;
    const fs::path found = fs::canonical(path, fault);
    if (fault) throw AccessError(fmt::format("cannot read '{}': {}.", path, fault.message()));
    return found.string();
}

/// The headers and sources that a source reads by an #include that leads to them from its folder
/// or from that of the program, itself included.
void add_read_files(const std::string& path, const std::string& folder,
                    std::set<std::string>& read) {
    if (read.size() > most_sources || !read.insert(path).second) return;
    for (const Include& include : includes_of(text_or_nothing(path))) {
        std::string name = include.name;
        std::replace(name.begin(), name.end(), '\\', '/');
        for (const fs::path& place : {fs::path(path).parent_path(), fs::path(folder)}) {
            std::error_code fault;
            const fs::path found = fs::canonical(place / name, fault);
            if (fault || !fs::is_regular_file(found, fault)) continue;
            if (is_below(found.string(), folder)) add_read_files(found.string(), folder, read);
            break;
        }
    }
}

/// What is known of a program while its sources are gathered.
struct Gathered {
    std::set<std::string> read;  ///< files that are compiled, and what they include
    std::set<std::string> stems; ///< of those
    std::set<std::string> declared, defined;
};

void take_in(Gathered& all, const std::string& source, const std::string& folder) {
    std::set<std::string> read;
    add_read_files(source, folder, read);
    for (const std::string& path : read) {
        if (!all.read.insert(path).second) continue;
        all.stems.insert(file_stem(path));
        const FunctionNames names = function_names(text_or_nothing(path));
        all.declared.insert(names.declared.begin(), names.declared.end());
        all.defined.insert(names.defined.begin(), names.defined.end());
    }
}

/// Does it define what is declared and defined nowhere yet, or belong to a header that is read?
bool is_needed(const Gathered& all, const std::string& source) {
    if (all.read.contains(source)) return false;
    const FunctionNames names = function_names(text_or_nothing(source));
    const bool defines_twice =
        std::any_of(names.defined.begin(), names.defined.end(),
                    [&all](const std::string& name) { return all.defined.contains(name); });
    if (all.stems.contains(file_stem(source)) && !(defines_twice && is_name_of_copy(source))) {
        return true;
    }
    return !defines_twice &&
           std::any_of(names.defined.begin(), names.defined.end(),
                       [&all](const std::string& name) { return all.declared.contains(name); });
}

/// The other sources that are compiled with the main one: those it needs, and those they need.
std::vector<std::string> needed_sources(const std::string& main, const std::string& folder,
                                        std::vector<std::string> candidates) {
    Gathered all;
    take_in(all, main, folder);
    // Of two that define the same, the one that is no copy is taken.
    std::stable_partition(candidates.begin(), candidates.end(),
                          [](const std::string& path) { return !is_name_of_copy(path); });
    std::vector<std::string> taken;
    for (bool is_changed = true; is_changed;) {
        is_changed = false;
        for (const std::string& candidate : candidates) {
            if (!is_needed(all, candidate)) continue;
            take_in(all, candidate, folder);
            taken.push_back(candidate);
            is_changed = true;
            break;
        }
    }
    std::sort(taken.begin(), taken.end());
    return taken;
}

/// The sources in a folder and below it, with and without a main().
struct Sorted {
    std::vector<FoundFile> with_main;
    std::vector<std::string> others;
};

Sorted sorted_sources(const std::string& folder, int depth) {
    Sorted sorted;
    std::size_t count = 0;
    for (const FoundFile& file : files_in(folder, depth)) {
        if (!is_source_name(file.path) || ++count > most_sources) continue;
        const std::string path = absolute(file.path);
        if (defines_main(text_or_nothing(path))) {
            sorted.with_main.push_back({path, file.depth});
        } else {
            sorted.others.push_back(path);
        }
    }
    return sorted;
}

StudentFiles program_of_file(const std::string& path) {
    StudentFiles files;
    files.main = absolute(path);
    files.name = file_name(path);
    files.folder = fs::path(files.main).parent_path().string();
    if (!is_source_name(path)) {
        throw InputError(fmt::format("{}: this is no C++ source (.cpp, .cc, .cxx).", path));
    }
    if (!defines_main(read_source(files.main))) {
        throw InputError(fmt::format("{}: the file has no main().", path));
    }
    // Sources in a folder next to it, such as src, are found too.
    files.sources =
        needed_sources(files.main, files.folder, sorted_sources(files.folder, 1).others);
    return files;
}

StudentFiles program_of_folder(const std::string& path) {
    StudentFiles files;
    files.folder = absolute(path);
    files.name = file_name(files.folder);
    const Sorted sorted = sorted_sources(files.folder, deepest_main);
    std::vector<FoundFile> mains = sorted.with_main;
    if (mains.empty()) {
        // A source that cannot be read may have had it.
        for (const std::string& source : sorted.others)
            read_source(source);
        throw InputError(fmt::format("{}: no source in this folder has a main().", path));
    }
    std::erase_if(mains,
                  [&mains](const FoundFile& file) { return file.depth > mains.front().depth; });
    if (mains.size() > 1) {
        std::erase_if(mains, [](const FoundFile& file) { return is_name_of_copy(file.path); });
    }
    if (mains.size() != 1) {
        std::string names;
        for (const FoundFile& file : mains.empty() ? sorted.with_main : mains) {
            names += (names.empty() ? "" : ", ") + file_name(file.path);
        }
        throw InputError(
            fmt::format("{}: several sources have a main(): {}. Name one of them.", path, names));
    }
    files.main = mains.front().path;
    files.sources = needed_sources(files.main, files.folder, sorted.others);
    return files;
}

bool has_sources(const std::string& folder) {
    const std::vector<FoundFile> found = files_in(folder, deepest_main);
    return std::any_of(found.begin(), found.end(),
                       [](const FoundFile& file) { return is_source_name(file.path); });
}

/// A hand-in that cannot be checked.
StudentFiles not_checked(const std::string& path, const std::string& fault) {
    StudentFiles files;
    files.name = file_name(path);
    files.folder = absolute(path);
    files.fault = fault;
    return files;
}

/// The sentence of an error without the path that it begins with.
std::string without_path(std::string_view sentence, const std::string& path) {
    const std::string before = path + ": ";
    if (sentence.starts_with(before)) sentence.remove_prefix(before.size());
    return std::string(sentence);
}

/// What else is in a folder of hand-ins and may be one: folders without sources, and archives.
void add_others(const std::string& folder, std::vector<StudentFiles>& found) {
    for (const std::string& inner : folders_in(folder)) {
        std::error_code fault;
        const bool is_empty = fs::is_empty(inner, fault) && !fault;
        if (!has_sources(inner))
            found.push_back(not_checked(inner, is_empty ? "the folder is empty."
                                                        : "no C++ source is in this folder."));
    }
    for (const FoundFile& file : files_in(folder, 0)) {
        if (is_archive_name(file.path))
            found.push_back(not_checked(file.path, "an archive must be unpacked first."));
    }
}

} // namespace

bool defines_main(std::string_view source) {
    const std::string code = bare_code(source);
    const std::string_view text = code;
    for (const std::string_view name : {"main", "_tmain"}) {
        for (std::size_t at = text.find(name); at != std::string_view::npos;
             at = text.find(name, at + 1)) {
            const std::size_t end = at + name.size();
            if ((at > 0 && is_name_letter(text[at - 1])) || end >= text.size()) continue;
            const std::string_view type = word_before(text, at);
            if (type != "int" && type != "void" && type != "auto" && type != "signed") continue;
            const std::size_t open = skip_blanks(text, end);
            if (open >= text.size() || text[open] != '(') continue;
            const std::size_t next = skip_blanks(text, behind_brackets(text, open));
            const std::string_view rest = text.substr(std::min(next, text.size()));
            if (rest.starts_with("{") || rest.starts_with("->") || rest.starts_with("try") ||
                rest.starts_with("noexcept")) {
                return true;
            }
        }
    }
    return false;
}

StudentFiles find_student_files(const std::string& path) {
    std::error_code fault;
    return fs::is_directory(path, fault) ? program_of_folder(path) : program_of_file(path);
}

std::vector<StudentFiles> find_hand_ins(const std::string& folder) {
    std::vector<StudentFiles> found;
    for (const std::string& inner : folders_in(folder)) {
        try {
            found.push_back(program_of_folder(inner));
        } catch (const Error& fault) {
            if (has_sources(inner))
                found.push_back(not_checked(inner, without_path(fault.what(), inner)));
        }
    }
    for (const FoundFile& file : files_in(folder, 0)) {
        if (is_source_name(file.path) && defines_main(text_or_nothing(file.path))) {
            found.push_back(program_of_file(file.path));
        }
    }
    // A single program may have folders and archives next to it.
    if (found.size() > 1) add_others(folder, found);
    std::sort(found.begin(), found.end(), [](const StudentFiles& a, const StudentFiles& b) {
        return a.name != b.name ? a.name < b.name : a.folder < b.folder;
    });
    return found;
}

} // namespace rasterwalk
