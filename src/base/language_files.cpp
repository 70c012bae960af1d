#include "base/language_files.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/error.h"
#include "base/files.h"
#include "base/quoted.h"
#include "base/toml_input.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

constexpr const char* languages_folder = "languages";
constexpr const char* texts_name = "texts.toml";
constexpr std::size_t longest_code = 8;

} // namespace

Language parse_language(std::string_view text, const std::string& path) {
    const toml::table root = parse_toml(text, path);
    const TomlInput input(root, path, "the language");
    input.allow_only({"name", "texts"});
    Language language;
    language.name = input.text("name");
    if (!can_be_drawn(language.name, {}))
        input.fail(*input.find("name"), "the name must have letters, and no control characters.");
    const toml::node* const texts = input.find("texts");
    if (texts == nullptr) input.fail("the language has no [texts].");
    const TomlInput table = input.table(*texts, "the table of texts");
    for (const auto& [key, node] : table.nodes()) {
        const toml::value<std::string>* const words = node.as_string();
        if (words == nullptr)
            table.fail(node, "the translation of " + in_quotes(key.str()) + " must be a text.");
        const std::string& translation = words->get();
        if (can_be_drawn(translation, key.str()) && places_in(translation) == places_in(key.str()))
            language.texts.emplace(key.str(), translation);
    }
    return language;
}

Language read_language(const std::string& folder, const std::string& code) {
    if (!is_language_code(code))
        throw UsageError(in_quotes(code) + " is not the code of a language, such as sv.");
    const std::string path = texts_file(folder, code);
    Language language = parse_language(read_file(path, largest_language), path);
    language.code = code;
    return language;
}

bool is_language_code(std::string_view code) {
    return !code.empty() && code.size() <= longest_code &&
           code.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string_view::npos;
}

std::vector<std::string> language_codes(const std::string& folder) {
    std::vector<std::string> codes;
    std::error_code fault;
    for (fs::directory_iterator entry(fs::path(folder) / languages_folder, fault), end;
         !fault && entry != end; entry.increment(fault)) {
        const std::string code = entry->path().filename().string();
        std::error_code ignored;
        if (is_language_code(code) && fs::is_regular_file(entry->path() / texts_name, ignored))
            codes.push_back(code);
    }
    std::sort(codes.begin(), codes.end());
    return codes;
}

std::string texts_file(const std::string& folder, std::string_view code) {
    return translated_lesson(folder, code, texts_name);
}

std::string translated_lesson(const std::string& folder, std::string_view code,
                              std::string_view lesson) {
    return (fs::path(folder) / languages_folder / code / lesson).string();
}

std::string lessons_folder_of(const std::string& file) {
    const fs::path folder = fs::path(file).parent_path();
    std::error_code fault, ignored;
    const fs::path whole = fs::absolute(file, fault).lexically_normal().parent_path();
    const auto has_texts = [&](const fs::path& of) {
        return fs::is_regular_file(of / texts_name, ignored);
    };
    const bool is_language = !fault && whole.parent_path().filename() == languages_folder &&
                             is_language_code(whole.filename().string()) &&
                             (has_texts(whole) || has_texts(whole.parent_path()));
    if (!is_language) return folder.string();
    // As it was written: the file may have come by a relative path.
    fs::path above = (folder / ".." / "..").lexically_normal();
    if (!above.has_filename()) above = above.parent_path();
    return above.string();
}

bool is_list_of_texts(const std::string& file) {
    std::error_code fault;
    const fs::path whole = fs::absolute(file, fault).lexically_normal();
    return !fault && whole.filename() == texts_name &&
           whole.parent_path().filename() == languages_folder;
}

} // namespace rasterwalk
