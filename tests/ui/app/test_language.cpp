#include "base/language.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "base/error.h"
#include "base/files.h"
#include "compare/divergence.h"
#include "inspect/clip_history.h"
#include "lessons/translation_check.h"
#include "session/speed.h"
#include "session/strip.h"
#include "settings/depth_words.h"
#include "stages/warnock.h"
#include "support/project_root.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "tests/ui/situations.h"
#include "ui/actions/actions.h"
#include "ui/actions/language.h"
#include "ui/actions/open_lesson.h"
#include "ui/app/kept_options.h"
#include "ui/ui.h"
#include "ui/widgets/language.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

/// The value of a string literal that begins at `at`, behind which `at` is then.
std::string literal_at(const std::string& code, std::size_t& at) {
    std::string text;
    for (++at; at < code.size() && code[at] != '"'; ++at) {
        if (code[at] == '\\') {
            ++at;
            text += code[at] == 'n' ? '\n' : code[at];
        } else {
            text += code[at];
        }
    }
    ++at;
    return text;
}

/// Adds the texts of a call of tr() whose arguments begin at `at`: the literals of its first
/// argument, or of the second if the first is the language.
void add_texts_of_call(const std::string& code, std::size_t at, std::set<std::string>& texts) {
    if (code.compare(at, 9, "language,") == 0) at += 9;
    int depth = 0;
    std::string text;
    bool has_text = false;
    const auto add = [&] {
        if (has_text) texts.insert(text);
        text.clear();
        has_text = false;
    };
    while (at < code.size()) {
        const char c = code[at];
        if (c == '"') {
            text += literal_at(code, at);
            has_text = true;
            continue;
        }
        if (c == '(' || c == '{') ++depth;
        if ((c == ')' || c == '}') && depth-- == 0) break;
        if (c == ',' && depth == 0) break;
        if (c == ':' || c == '?') add(); // literals next to each other are one
        ++at;
    }
    add();
}

/// The texts that the sources name where they ask for them.
void add_texts_of_sources(std::set<std::string>& texts) {
    for (const char* const folder : {"src", "ui"}) {
        for (const auto& entry : fs::recursive_directory_iterator(project_root() + "/" + folder)) {
            if (entry.path().extension() != ".cpp") continue;
            const std::string code = read_file(entry.path().string());
            for (std::size_t at = code.find("tr("); at != code.npos;
                 at = code.find("tr(", at + 1)) {
                const bool is_name =
                    at > 0 && (std::isalnum(static_cast<unsigned char>(code[at - 1])) != 0 ||
                               code[at - 1] == '_');
                if (!is_name) add_texts_of_call(code, at + 3, texts);
            }
        }
    }
}

/// The texts of tables, which are asked for by a variable.
void add_texts_of_tables(std::set<std::string>& texts) {
    for (const Action& action : action_table()) {
        texts.insert(action.title);
        texts.insert(action.help);
    }
    for (const StripEntry& entry : strip_list()) {
        for (const StripWords& words : {entry.words, entry.other_words}) {
            texts.emplace(words.title);
            texts.emplace(words.help);
        }
    }
    for (const PhaseInfo& phase : phase_list) {
        texts.emplace(phase.word);
        texts.emplace(phase.piece);
        texts.emplace(phase.step);
    }
    for (const DivergenceKind kind :
         {DivergenceKind::missing, DivergenceKind::extra, DivergenceKind::other})
        texts.insert(kind_text(kind));
    for (const ClipDepth kind : {ClipDepth::inv_z, ClipDepth::ndc, ClipDepth::reversed})
        texts.emplace(depth_words(kind).ends);
    for (std::size_t plane = 0; plane < clip_plane_count; ++plane)
        texts.insert(plane_name(static_cast<int>(plane)));
    texts.emplace(triangle_form);
    texts.erase("");
}

/// What the window asks for in a few situations: texts of constants near the place where they are
/// drawn.
void add_texts_of_window(std::set<std::string>& texts) {
    for (const Situation& situation :
         {Situation{"lab-room.toml", ""}, Situation{"lab-room.toml", "click:menu.File"},
          Situation{"lab-room.toml", "two_runs"}, Situation{"lab-room.toml", "set:shadows=map"},
          Situation{"lab-room.toml", "set:hidden=warnock"},
          Situation{"one-triangle.toml", "lesson:05-row-table/1"},
          Situation{"lab-room.toml", "key:F1"}, Situation{"lab-room.toml", "key:F5"}}) {
        Driver driver(situation.scene);
        driver.ui.language.asked = &texts;
        bring_about(driver, situation);
        driver.hand.frames(2);
    }
}

std::set<std::string> all_texts() {
    std::set<std::string> texts;
    add_texts_of_sources(texts);
    add_texts_of_tables(texts);
    add_texts_of_window(texts);
    return texts;
}

std::string as_toml(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c == '\n' ? std::string("\\n") : std::string(1, c);
    }
    return quoted + "\"";
}

std::string list_of(const std::set<std::string>& texts) {
    std::string list = "# The texts of the window that a translation can have. A language begins "
                       "with a copy of this "
                       "file,\n# languages/CODE/texts.toml, with its name and the translations. "
                       "What is left empty is shown "
                       "in English.\nname = \"English\"\n\n[texts]\n";
    for (const std::string& text : texts)
        list += as_toml(text) + " = \"\"\n";
    return list;
}

} // namespace

TEST_CASE("The list of texts to translate has all of the program, and no others") {
    const std::string path = project_root() + "/lessons/languages/texts.toml";
    const std::string list = list_of(all_texts());
    if (std::getenv("RASTERWALK_REWRITE_TEXTS") != nullptr) std::ofstream(path) << list;
    INFO("RASTERWALK_REWRITE_TEXTS=1 writes the list again");
    CHECK(read_file(path) == list);
}

TEST_CASE("The View menu changes the language of menus, strip, transport and lesson") {
    Driver driver;
    open_lesson(driver.ui, "05-row-table", 1);
    driver.hand.frames(1);
    const Lesson& lesson = *driver.ui.lesson.lessons.find("05-row-table");
    const std::string english_title = lesson.title, english_heading = heading_text(lesson.steps[1]);
    CHECK(speed_text({}, current_language()) == "frame in 15 s");

    driver.hand.click("menu.View");
    driver.hand.click("menu.view.language");
    driver.hand.frames(1);
    CHECK(driver.ui.options.language == "sv");
    CHECK(driver.ui.language.name == "Svenska");
    CHECK(driver.ui.session.notice.empty());
    const Lesson& translated = *driver.ui.lesson.lessons.find("05-row-table");
    CHECK(translated.title == "Radtabellen");
    CHECK(heading_text(translated.steps[1]) != english_heading);
    CHECK(driver.ui.session.lesson == "05-row-table");
    CHECK(driver.ui.session.step == 1);
    CHECK(words_of(driver.ui, find_action("walk.step")).title != "Step");
    CHECK(speed_text({}, current_language()) != "frame in 15 s");
    CHECK(driver.ui.widgets.at("walk.speed").text.find("steg") != std::string::npos);

    driver.hand.click("menu.View");
    driver.hand.click("menu.view.language");
    driver.hand.frames(1);
    CHECK(driver.ui.options.language.empty());
    CHECK(driver.ui.lesson.lessons.find("05-row-table")->title == english_title);
    CHECK(words_of(driver.ui, find_action("walk.step")).title == "Step");
}

TEST_CASE("A prediction answered in one language is answered in the other") {
    Driver driver;
    driver.ui.options.language = "sv";
    driver.hand.frames(1);
    open_lesson(driver.ui, "05-row-table", 1);
    driver.hand.frames(2);
    driver.hand.click("lesson.prediction.rows-of-it.number");
    driver.hand.type_text("31");
    driver.hand.click("lesson.prediction.rows-of-it.answer");
    driver.hand.frames(1);
    const auto& answers = driver.ui.lesson.progress.of("05-row-table").answers;
    REQUIRE(answers.count("rows-of-it") == 1);
    driver.ui.options.language.clear();
    driver.hand.frames(2);
    CHECK(driver.ui.widgets.count("lesson.prediction.rows-of-it.verdict") == 1);
}

TEST_CASE("A language that cannot be read leaves the window in English, and says why") {
    Driver driver;
    driver.ui.options.language = "xx";
    driver.hand.frames(1);
    CHECK(driver.ui.session.notice.find("languages/xx/texts.toml") != std::string::npos);
    CHECK(words_of(driver.ui, find_action("walk.step")).title == "Step");

    // The choice stays, and is not read again in each frame.
    CHECK(driver.ui.options.language == "xx");
    driver.ui.session.notice.clear();
    driver.hand.frames(2);
    CHECK(driver.ui.session.notice.empty());
    choose_language(driver.ui, "xx");
    driver.hand.frames(1);
    CHECK_FALSE(driver.ui.session.notice.empty());
    choose_language(driver.ui, "");
    driver.hand.frames(1);
    CHECK(words_of(driver.ui, find_action("walk.step")).title == "Step");
    choose_language(driver.ui, "sv");
    driver.hand.frames(1);
    CHECK(words_of(driver.ui, find_action("walk.step")).title != "Step");
}

TEST_CASE("The language is kept between two runs") {
    UiOptions options;
    options.language = "sv";
    CHECK(parse_options(options_text(options), "look.toml", {}).language == "sv");
    CHECK_THROWS_AS(parse_options("language = \"../x\"", "look.toml", {}), InputError);
}

TEST_CASE("Swedish has every text") {
    const TranslationGaps gaps = translation_gaps(project_root() + "/lessons", "sv");
    CHECK(gaps.texts.empty());
    CHECK(gaps.all_texts > 300);
}

} // namespace rasterwalk
