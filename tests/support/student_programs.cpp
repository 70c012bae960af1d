#include "support/student_programs.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>

#include "base/error.h"
#include "base/files.h"
#include "base/toml_input.h"
#include "support/project_root.h"

namespace rasterwalk::test {

namespace {

constexpr const char* file_of_mistakes = "mistakes.toml";

std::string programs_folder() {
    return project_root() + "/tests/mine/";
}

bool is_cpp(const std::filesystem::path& path) {
    return path.extension() == ".cpp" || path.extension() == ".h";
}

/// A text, or a list of texts.
std::vector<std::string> texts_of(const TomlInput& table, std::string_view key) {
    const toml::node* node = table.find(key);
    if (node == nullptr || !node->is_array()) return {table.text_or_empty(key)};
    std::vector<std::string> texts;
    for (const toml::node& item : table.list(key)) {
        if (!item.is_string()) table.fail(item, "Each change must be a text.");
        texts.push_back(item.as_string()->get());
    }
    return texts;
}

/// A change of one place.
struct Edit {
    HandInSource* source;
    std::size_t at;
    std::size_t size;
    std::string text;
};

/// The only place where the text is.
Edit found(std::vector<HandInSource>& sources, const std::string& text, const TomlInput& table) {
    std::vector<Edit> places;
    for (HandInSource& source : sources) {
        std::size_t at = source.text.find(text);
        while (at != std::string::npos) {
            places.push_back({&source, at, text.size(), {}});
            at = source.text.find(text, at + 1);
        }
    }
    if (text.empty() || places.size() != 1) {
        table.fail("The text to be found is there " + std::to_string(places.size()) +
                   " times: " + text);
    }
    return places.front();
}

/// All places are found before any of them is changed, so that a change cannot hide another.
void change(std::vector<HandInSource>& sources, const TomlInput& table) {
    const std::vector<std::string> old_texts = texts_of(table, "find");
    const std::vector<std::string> new_texts = texts_of(table, "replace");
    if (old_texts.size() != new_texts.size()) {
        table.fail("'find' and 'replace' must have as many texts.");
    }
    std::vector<Edit> edits;
    for (std::size_t i = 0; i < old_texts.size(); ++i) {
        edits.push_back(found(sources, old_texts[i], table));
        edits.back().text = new_texts[i];
    }
    // From the end, so that the earlier places stay where they are.
    std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.at > b.at; });
    for (const Edit& edit : edits) {
        edit.source->text.replace(edit.at, edit.size, edit.text);
    }
}

HandIn program_of(const TomlInput& table, const std::vector<HandIn>& styles) {
    table.allow_only({"name", "style", "bug", "right", "find", "replace", "note"});
    HandIn program;
    program.name = table.text("name");
    program.style = table.text("style");
    program.bug = table.text_or_empty("bug");
    program.note = table.text("note");
    const toml::node* right = table.find("right");
    program.right = right != nullptr && right->value_or(false);
    const auto style = std::find_if(styles.begin(), styles.end(), [&program](const HandIn& each) {
        return each.name == program.style;
    });
    if (style == styles.end()) table.fail("There is no style " + program.style + ".");
    program.sources = style->sources;
    change(program.sources, table);
    return program;
}

} // namespace

std::vector<HandInSource> student_sources(const std::string& path) {
    const std::filesystem::path whole = programs_folder() + path;
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(whole)) {
        for (const auto& entry : std::filesystem::directory_iterator(whole)) {
            if (is_cpp(entry.path())) files.push_back(entry.path());
        }
    } else {
        files.push_back(whole);
    }
    std::sort(files.begin(), files.end());
    std::vector<HandInSource> sources;
    for (const std::filesystem::path& file : files) {
        sources.push_back({file.filename().string(), read_file(file.string())});
    }
    return sources;
}

std::vector<HandIn> student_styles() {
    std::vector<HandIn> styles;
    for (const auto& entry : std::filesystem::directory_iterator(programs_folder() + "styles")) {
        if (!entry.is_directory() && !is_cpp(entry.path())) continue;
        HandIn style;
        style.name = entry.path().stem().string();
        style.style = style.name;
        style.right = true;
        style.sources = student_sources("styles/" + entry.path().filename().string());
        styles.push_back(std::move(style));
    }
    std::sort(styles.begin(), styles.end(),
              [](const HandIn& a, const HandIn& b) { return a.name < b.name; });
    return styles;
}

std::vector<HandIn> student_mistakes() {
    const std::vector<HandIn> styles = student_styles();
    const std::string path = programs_folder() + file_of_mistakes;
    return parse_tables<HandIn>(read_file(path), path, "program", "the file of mistakes",
                                [&styles](const TomlInput& table, const std::vector<HandIn>&) {
                                    return program_of(table, styles);
                                });
}

} // namespace rasterwalk::test
