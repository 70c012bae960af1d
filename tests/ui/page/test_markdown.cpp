#include "ui/page/markdown.h"

#include <algorithm>
#include <cctype>
#include <functional>

#include "lessons/stage_note.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "text/markdown_text.h"
#include "ui/page/markdown_layout.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

using Kind = MarkdownBlock::Kind;

std::string repeated(std::string_view text, std::size_t size) {
    std::string result;
    while (result.size() < size)
        result += text;
    return result;
}

/// All text of blocks, without blanks.
void append_letters(const std::vector<MarkdownBlock>& blocks, std::string& letters) {
    for (const MarkdownBlock& block : blocks) {
        for (const MarkdownRun& run : block.runs) {
            for (const char c : run.text) {
                if (c != ' ' && c != '\n') letters += c;
            }
        }
        append_letters(block.children, letters);
    }
}

std::string letters_of(const MarkdownDocument& document) {
    std::string letters;
    append_letters(document.blocks, letters);
    return letters;
}

std::string letters_of(const PageLayout& page) {
    std::string letters;
    for (const PagePiece& piece : page.pieces) {
        for (const char c : piece.text) {
            if (c != ' ') letters += c;
        }
    }
    return letters;
}

int depth_of(const std::vector<MarkdownBlock>& blocks) {
    int deepest = 0;
    for (const MarkdownBlock& block : blocks)
        deepest = std::max(deepest, 1 + depth_of(block.children));
    return deepest;
}

std::vector<std::string> note_names() {
    std::vector<std::string> names{"bench", "pixels"};
    for (const StageInfo& info : stage_list())
        names.emplace_back(info.name);
    return names;
}

/// No piece leaves the column, and no two lie over each other.
void check_places(const PageLayout& page, const Fonts& fonts, float width) {
    for (std::size_t i = 0; i < page.pieces.size(); ++i) {
        const PagePiece& a = page.pieces[i];
        const float a_height = font_of(fonts, a.font)->FontSize;
        INFO("piece '" << a.text << "' at " << a.at.x << ", " << a.at.y);
        CHECK(a.at.x >= 0.0f);
        CHECK(a.at.x + a.width <= width + 0.01f);
        CHECK(a.at.y >= -0.01f);
        CHECK(a.at.y + a_height <= page.height + 1.0f);
        for (std::size_t j = i + 1; j < page.pieces.size(); ++j) {
            const PagePiece& b = page.pieces[j];
            const float b_height = font_of(fonts, b.font)->FontSize;
            // Letters do not fill their font's whole height.
            const float overlap_y =
                std::min(a.at.y + a_height, b.at.y + b_height) - std::max(a.at.y, b.at.y);
            const float overlap_x =
                std::min(a.at.x + a.width, b.at.x + b.width) - std::max(a.at.x, b.at.x);
            if (overlap_x > 0.1f && overlap_y > 0.1f * a_height) FAIL_CHECK("lies on " << b.text);
        }
    }
}

} // namespace

TEST_CASE("Paragraphs are read as runs in one style each") {
    const MarkdownDocument page = parse_markdown(
        "plain *slanted* **strong `both`** `code` [a *link*](set:stage=rows)  \nend");
    REQUIRE(page.fault.empty());
    REQUIRE(page.blocks.size() == 1);
    const std::vector<MarkdownRun>& runs = page.blocks[0].runs;
    REQUIRE(runs.size() == 11);
    CHECK(runs[0].text == "plain ");
    CHECK(runs[1].text == "slanted");
    CHECK(runs[1].emphasis);
    CHECK(runs[3].text == "strong ");
    CHECK(runs[3].strong);
    CHECK(runs[4].text == "both");
    CHECK((runs[4].strong && runs[4].code));
    CHECK(runs[6].code);
    CHECK(runs[8].text == "a ");
    CHECK(runs[8].link == 0);
    CHECK((runs[9].link == 0 && runs[9].emphasis));
    CHECK(runs[10].text == "\nend");
    CHECK(runs[10].link == -1);
    CHECK(page.links == std::vector<std::string>{"set:stage=rows"});
}

TEST_CASE("Headings, nested lists, code, tables, boxes and rules are read as blocks") {
    const MarkdownDocument page = parse_markdown("# Title\n\n"
                                                 "3. three\n4. four\n   - inner\n\n"
                                                 "```\na\n\tb\n```\n\n"
                                                 "| l | c | r |\n|---|:-:|--:|\n| 1 | 2 | 3 |\n\n"
                                                 "> **Try**\n>\n> this\n\n"
                                                 "***\n");
    REQUIRE(page.fault.empty());
    REQUIRE(page.blocks.size() == 6);
    CHECK(page.blocks[0].kind == Kind::heading);
    CHECK(page.blocks[0].level == 1);
    const MarkdownBlock& list = page.blocks[1];
    CHECK((list.kind == Kind::list && list.is_numbered && list.is_tight));
    CHECK(list.start == 3);
    REQUIRE(list.children.size() == 2);
    REQUIRE(list.children[1].children.size() == 2);
    CHECK(list.children[1].children[0].runs[0].text == "four");
    CHECK(list.children[1].children[1].kind == Kind::list);
    CHECK_FALSE(list.children[1].children[1].is_numbered);
    CHECK(page.blocks[2].runs[0].text == "a\n    b");
    const MarkdownBlock& table = page.blocks[3];
    REQUIRE(table.kind == Kind::table);
    REQUIRE(table.children.size() == 2);
    REQUIRE(table.children[0].children.size() == 3);
    CHECK(table.children[0].children[0].is_header);
    CHECK(table.children[1].children[1].align == MarkdownBlock::Align::centre);
    CHECK(table.children[1].children[2].align == MarkdownBlock::Align::right);
    CHECK(page.blocks[4].kind == Kind::quote);
    CHECK(page.blocks[4].label == "Try");
    CHECK(page.blocks[4].children.size() == 1);
    CHECK(page.blocks[5].kind == Kind::rule);
}

TEST_CASE("Entities become characters, HTML stays text, pictures become their words") {
    CHECK(letters_of(parse_markdown("&lt;&#960;&#x2192;&unknown;")) == "<π→&unknown;");
    CHECK(letters_of(parse_markdown("&#0;&#xD800;&#x110000;")).find('\0') == std::string::npos);
    CHECK(letters_of(parse_markdown("<b onclick=\"x\">bold</b>")) == "<bonclick=\"x\">bold</b>");
    CHECK(letters_of(parse_markdown("![a view](room.png)")) == "aview");
}

TEST_CASE("Odd bytes, control characters and a byte order mark do not reach the page") {
    CHECK(clean_text("\xEF\xBB\xBFok") == "ok");
    CHECK(clean_text("a\r\nb\rc\n") == "a\nb\nc\n");
    CHECK(clean_text(std::string_view("a\0b", 3)) == "a\uFFFDb");
    CHECK(clean_text("\x1b[31m\x7f") == "\uFFFD[31m\uFFFD");
    CHECK(clean_text("\xC3\xA9 \xF0\x9D\x9B\xBC") == "é \U0001D6FC");
    CHECK(clean_text("\xC0\xAF") == "\uFFFD\uFFFD");
    CHECK(clean_text("\xED\xA0\x80") == "\uFFFD\uFFFD\uFFFD");
    CHECK(clean_text("\xF5\x80\x80\x80") == "\uFFFD\uFFFD\uFFFD\uFFFD");
    CHECK(clean_text("end\xE2\x82") == "end\uFFFD\uFFFD");
}

TEST_CASE("A text that is too long, too deep or made to be slow is refused with a sentence") {
    const std::pair<std::string, std::string> cases[] = {
        {std::string(largest_markdown + 1, 'a'), "longer than 1 MB"},
        {repeated("> ", 2 * 33) + "a", "nested deeper than 32"},
        {repeated("> ", 1'000'000), "nested deeper than 32"},
        {repeated("1. ", 100'000) + "a", "nested deeper than 32"},
        {repeated("[a](\n", 1'000'000), "too many lines and brackets"},
        {repeated("[a]\n", 1'000'000), "too many lines and brackets"},
        {"[a]: /" + std::string(400'000, 'u') + "\n\n" + repeated("[a] ", 400'000),
         "targets of the links"},
    };
    for (const auto& [text, answer] : cases) {
        INFO(text.substr(0, 40));
        const MarkdownDocument page = parse_markdown(text);
        CHECK_THAT(page.fault, Catch::Matchers::ContainsSubstring(answer));
        CHECK(page.blocks.empty());
        CHECK(page.links.empty());
    }
    CHECK(parse_markdown(std::string(largest_markdown, 'a')).fault.empty());
    CHECK(parse_markdown(repeated("> ", 2 * 30) + "a").fault.empty());
}

TEST_CASE("Hostile text is laid out without loss, inside the column") {
    Driver driver;
    const Fonts& fonts = driver.ui.fonts;
    constexpr std::size_t size = 50'000;
    const std::string cases[] = {
        repeated("[", size),
        repeated("![", size),
        repeated("*a_ ", size),
        repeated("a**b", size),
        repeated("<a ", size),
        repeated("a\n=\n", size),
        repeated("---\n", size),
        repeated("* \n\n", size),
        repeated("|a|b|\n", 100) + "|---|---|\n" + repeated("|x|y|\n", size / 10),
        std::string("|")
            .append(repeated("a|", 200))
            .append("\n|")
            .append(repeated("-|", 200))
            .append("\n")
            .append(repeated("|x\n", 300)),
        repeated(">", 30) + repeated("word ", size),
        std::string(size, 'w'),
        "    " + std::string(size, 'c'),
        "`" + std::string(size, 'c') + "`",
        repeated("\xF0\x9D\x9B\xBC", size),
        repeated(std::string_view("\0\n", 2), size),
        std::string(size, '\n'),
    };
    for (const std::string& text : cases) {
        for (const float width : {1.0f, 60.0f, 300.0f}) {
            INFO("'" << text.substr(0, 20) << "' at width " << width);
            const MarkdownDocument document = parse_markdown(text);
            REQUIRE(document.fault.empty());
            const PageLayout page = lay_out(document, fonts, 1.0f, width);
            CHECK(page.height >= 0.0f);
            const std::string letters = letters_of(page);
            const std::string wanted = letters_of(document);
            // Cells are set one after the other, so that order is kept everywhere.
            CHECK(letters.size() == wanted.size());
            CHECK(letters == wanted);
            for (const PageShape& shape : page.shapes)
                REQUIRE(shape.low.x <= width);
        }
    }
}

TEST_CASE("Random bytes neither crash nor leave anything but valid text") {
    Driver driver;
    test::Random random(7);
    const std::string_view signs[] = {
        "*",   "_",    "`", "[", "](", ")",     "|",     "\n", "\n\n",  "> ",   "- ",
        "1. ", "    ", "#", "&", "\\", "---\n", "```\n", "x",  "word ", "\xC3", "\xE2\x86\x92"};
    for (int round = 0; round < 300; ++round) {
        std::string text;
        const int count = random.integer(0, 200);
        for (int i = 0; i < count; ++i) {
            if (random.integer(0, 9) == 0) {
                text += static_cast<char>(random.integer(0, 255));
            } else {
                text += signs[static_cast<std::size_t>(
                    random.integer(0, static_cast<int>(std::size(signs)) - 1))];
            }
        }
        INFO("round " << round);
        const MarkdownDocument document = parse_markdown(text);
        CHECK(depth_of(document.blocks) <= deepest_markdown);
        const PageLayout page = lay_out(document, driver.ui.fonts, 1.0f, 200.0f);
        for (const PagePiece& piece : page.pieces) {
            REQUIRE(clean_text(piece.text) == piece.text);
            REQUIRE(piece.link < static_cast<int>(document.links.size()));
        }
    }
}

TEST_CASE("Every note is set inside its column, nothing over anything else, at all text sizes") {
    for (const float scale : {1.0f, 1.5f, 2.0f}) {
        Driver driver("lab-room.toml", {3200, 2000}, scale);
        for (const std::string& name : note_names()) {
            const StageNote note = read_stage_note(lessons_folder(), name);
            const MarkdownDocument document = parse_markdown(note.text);
            for (const float width : {200.0f, 302.0f, 480.0f}) {
                INFO(name << ", text size " << scale << ", width " << width);
                check_places(lay_out(document, driver.ui.fonts, scale, scale * width),
                             driver.ui.fonts, scale * width);
            }
        }
    }
}

TEST_CASE("Words wrap between styles, and a word in two styles stays together") {
    Driver driver;
    const Fonts& fonts = driver.ui.fonts;
    const MarkdownDocument document = parse_markdown("aaaa bbbb**cccc** dddd");
    const float whole = fonts.text->CalcTextSizeA(16.0f, FLT_MAX, 0.0f, "aaaa bbbb").x;
    // "cccc" does not fit on the first line, so "bbbb" goes with it to the second.
    const PageLayout page = lay_out(document, fonts, 1.0f, whole + 5.0f);
    REQUIRE(page.pieces.size() >= 3);
    CHECK(page.pieces[0].text == "aaaa");
    CHECK(page.pieces[1].text == "bbbb");
    CHECK(page.pieces[2].text == "cccc");
    CHECK(page.pieces[1].at.y > page.pieces[0].at.y);
    CHECK(page.pieces[2].at.y == page.pieces[1].at.y);
    CHECK(page.pieces[2].at.x == Approx(page.pieces[1].at.x + page.pieces[1].width));
}

TEST_CASE("Lines of plain text are 1.4 times the font's size apart") {
    Driver driver;
    const MarkdownDocument document = parse_markdown("one  \ntwo  \nthree");
    const PageLayout page = lay_out(document, driver.ui.fonts, 1.0f, 300.0f);
    REQUIRE(page.pieces.size() == 3);
    CHECK(page.pieces[1].at.y - page.pieces[0].at.y == 22.0f);
    CHECK(page.pieces[2].at.y - page.pieces[1].at.y == 22.0f);
}

TEST_CASE("Each letter lies in a line, on the page, and a fraction is one line") {
    for (const float scale : {1.0f, 1.28f, 1.5f}) {
        Driver driver("lab-room.toml", {1600, 1000}, scale);
        const Fonts& fonts = driver.ui.fonts;
        const MarkdownDocument document =
            parse_markdown("of area $4\\pi r^2$, here\n\n$$\\frac{P}{4 \\pi r^2}$$\n\n- one\n-\n- "
                           "three\n\n```\na\n\nb\n```\n"
                           "\n| a | b |\n|---|---|\n| one and two | c |\n\n> **Task.** Do it.");
        const PageLayout page = lay_out(document, fonts, scale, 150.0f * scale);
        for (const PagePiece& piece : page.pieces) {
            INFO("'" << piece.text << "' at " << piece.at.y);
            const ImFont* const font = font_of(fonts, piece.font);
            // Where there is ink: nothing is drawn in the room for accents.
            const float low = piece.at.y + 0.15f * font->FontSize;
            const float high = piece.at.y + font->FontSize;
            CHECK(std::any_of(page.lines.begin(), page.lines.end(), [&](const PageLine& line) {
                return low >= line.top && high <= line.bottom + 0.5f;
            }));
        }
        for (const PageLine& line : page.lines) {
            CHECK(line.top >= 0.0f);
            CHECK(line.bottom > line.top);
            CHECK(line.bottom <= page.height);
        }
        const auto stroke =
            std::find_if(page.shapes.begin(), page.shapes.end(), [](const PageShape& shape) {
                return shape.kind == PageShape::Kind::stroke;
            });
        REQUIRE(stroke != page.shapes.end());
        CHECK(std::any_of(page.lines.begin(), page.lines.end(), [&](const PageLine& line) {
            return line.top < stroke->low.y - 0.7f * fonts.text->FontSize &&
                   line.bottom > stroke->high.y + 0.7f * fonts.text->FontSize;
        }));
    }
}

TEST_CASE("A note has from 150 to 220 words, a mistake and things to try") {
    for (const std::string& name : note_names()) {
        INFO(name);
        const MarkdownDocument document =
            parse_markdown(read_stage_note(lessons_folder(), name).text);
        int words = 0;
        std::vector<std::string> labels;
        std::size_t tasks = 0;
        const std::function<void(const std::vector<MarkdownBlock>&)> count = [&](const auto& all) {
            for (const MarkdownBlock& block : all) {
                if (!block.label.empty()) labels.push_back(block.label);
                if (block.label == "Try") tasks = block.children[0].children.size();
                std::string text;
                for (const MarkdownRun& run : block.runs)
                    text += run.text;
                bool in_word = false;
                for (const char c : text) {
                    const bool blank = c == ' ' || c == '\n';
                    words += !blank && !in_word ? 1 : 0;
                    in_word = !blank;
                }
                count(block.children);
            }
        };
        count(document.blocks);
        CHECK(words >= 150);
        CHECK(words <= 220);
        CHECK(labels == std::vector<std::string>{"The classic mistake", "Try"});
        CHECK((tasks == 2 || tasks == 3));
    }
}

} // namespace rasterwalk
