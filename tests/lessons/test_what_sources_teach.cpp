// Holds the table "What the sources teach" of src/README.md to the files that it names.

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "base/text_parts.h"
#include "session/content.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

namespace fs = std::filesystem;

constexpr std::string_view none = "–";

/// A row of the table. A file is named from the folder of its column; `none` stands for no file.
struct TaughtRow {
    std::string what, source, file, lesson, scene, test;
};

/// What is between two bars, without blanks and backquotes around it.
std::string cell_of(std::string_view text) {
    const auto is_edge = [](char letter) { return letter == ' ' || letter == '`'; };
    while (!text.empty() && is_edge(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_edge(text.back()))
        text.remove_suffix(1);
    return std::string(text);
}

std::vector<TaughtRow> read_rows(std::string_view text) {
    constexpr std::string_view heading = "## What the sources teach\n";
    const std::size_t begin = text.find(heading);
    REQUIRE(begin != text.npos);
    text.remove_prefix(begin + heading.size());
    text = text.substr(0, text.find("\n## "));
    std::vector<TaughtRow> rows;
    while (!text.empty()) {
        std::string_view line = take_part(text, '\n');
        if (!line.starts_with("| ")) continue;
        line.remove_prefix(1);
        std::vector<std::string> cells;
        while (!line.empty())
            cells.push_back(cell_of(take_part(line, '|')));
        INFO(cells.front());
        REQUIRE(cells.size() == 6);
        rows.push_back({cells[0], cells[1], cells[2], cells[3], cells[4], cells[5]});
    }
    REQUIRE(rows.size() > 1);
    rows.erase(rows.begin()); // the titles of the columns
    return rows;
}

/// The names and numbers of a source: "Foley", "3.6.3".
std::vector<std::string> words_of_source(std::string_view source) {
    std::vector<std::string> words;
    std::string word;
    for (const char letter : std::string(source) + " ") {
        if (std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '.' ||
            letter == '-') {
            word += letter;
        } else if (!word.empty()) {
            words.push_back(std::exchange(word, {}));
        }
    }
    return words;
}

bool has_row(const std::vector<TaughtRow>& rows, std::string TaughtRow::*column,
             const std::string& name) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const TaughtRow& row) { return row.*column == name; });
}

const std::string& root() {
    static const std::string folder = own_lessons_folder() + "/..";
    return folder;
}

const std::vector<TaughtRow>& rows_of_readme() {
    static const std::vector<TaughtRow> rows = read_rows(read_file(root() + "/src/README.md"));
    return rows;
}

} // namespace

TEST_CASE("Every file that the table of what is taught names is there") {
    for (const TaughtRow& row : rows_of_readme()) {
        INFO(row.what);
        CHECK(fs::is_regular_file(root() + "/src/" + row.file));
        CHECK(fs::is_regular_file(root() + "/tests/" + row.test));
        for (const std::string& name : {row.lesson, row.scene})
            CHECK((name == none || fs::is_regular_file(root() + "/lessons/" + name)));
    }
}

TEST_CASE("Every lesson of the table of what is taught uses the scene next to it") {
    for (const TaughtRow& row : rows_of_readme()) {
        if (row.lesson == none || row.scene == none) continue;
        INFO(row.what);
        const std::string lesson = read_file(root() + "/lessons/" + row.lesson);
        CHECK(lesson.find('"' + row.scene + '"') != lesson.npos);
    }
}

TEST_CASE("Every file of the table of what is taught cites the source next to it") {
    for (const TaughtRow& row : rows_of_readme()) {
        if (row.source == none) continue;
        INFO(row.what);
        const std::string file = read_file(root() + "/src/" + row.file);
        REQUIRE(file.find("Source:") != file.npos);
        for (const std::string& word : words_of_source(row.source)) {
            INFO(word);
            CHECK(file.find(word) != file.npos);
        }
    }
}

TEST_CASE("Every lesson, and every stage that cites a source, is in the table of what is taught") {
    for (const fs::directory_entry& entry : fs::directory_iterator(root() + "/lessons")) {
        const std::string name = entry.path().filename().string();
        if (std::isdigit(static_cast<unsigned char>(name.front())) == 0) continue;
        INFO(name);
        CHECK(has_row(rows_of_readme(), &TaughtRow::lesson, name));
    }
    for (const fs::directory_entry& entry : fs::directory_iterator(root() + "/src/stages")) {
        if (entry.path().extension() != ".h") continue;
        const std::string name = entry.path().filename().string();
        if (read_file(entry.path().string()).find("Source:") == std::string::npos) continue;
        INFO(name);
        CHECK(has_row(rows_of_readme(), &TaughtRow::file, "stages/" + name));
    }
}
