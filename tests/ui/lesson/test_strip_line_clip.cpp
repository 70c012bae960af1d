// The strip of the lesson shows whole lines of a text: no letter is cut, and every one can be
// reached.

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include <imgui_internal.h>

#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/ui/driver.h"
#include "tests/ui/screen_text.h"
#include "ui/actions/open_lesson.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

struct LetterWindow {
    ImVec2 size;
    float text;
    bool is_lecture;
};

const std::vector<LetterWindow> letter_windows{
    {{1024, 640}, 1.5f, true}, {{800, 600}, 1.0f, false},  {{1024, 640}, 1.5f, false},
    {{640, 480}, 1.0f, false}, {{1024, 640}, 1.0f, false}, {{800, 600}, 1.5f, true}};

/// A letter by its place in the text, screen pixels from the text's beginning.
using LetterPlace = std::pair<int, int>;

/// The letters of the strip's text, by how much of them is seen.
struct StripLetters {
    std::set<LetterPlace> whole, absent, cut;
    float scrolled = 0.0f, most = 0.0f; ///< of the text, screen pixels
};

const ImGuiWindow* window_with(std::string_view name) {
    for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows) {
        if (window->Active && std::string_view(window->Name).find(name) != std::string_view::npos)
            return window;
    }
    return nullptr;
}

/// Read back from the triangles that were drawn and from what clips them.
StripLetters strip_letters() {
    const ImGuiWindow* const window = window_with("lesson.strip.text");
    REQUIRE(window != nullptr);
    StripLetters letters;
    letters.scrolled = window->Scroll.y;
    letters.most = window->ScrollMax.y;
    const ImDrawList& list = *window->DrawList;
    const ImVec2 plain = ImGui::GetFontTexUvWhitePixel();
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (command.TextureId != ImGui::GetIO().Fonts->TexID) continue;
        for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
            float low = 1e9f, high = -1e9f, left = 1e9f;
            bool is_letter = true;
            for (unsigned k = 0; k < 3; ++k) {
                const auto index = list.IdxBuffer[static_cast<int>(command.IdxOffset + i + k)];
                const ImDrawVert& corner =
                    list.VtxBuffer[static_cast<int>(command.VtxOffset) + static_cast<int>(index)];
                is_letter = is_letter && (corner.uv.x != plain.x || corner.uv.y != plain.y);
                low = std::min(low, corner.pos.y);
                high = std::max(high, corner.pos.y);
                left = std::min(left, corner.pos.x);
            }
            if (!is_letter) continue;
            const float begin = command.ClipRect.y, end = command.ClipRect.w;
            const LetterPlace place{static_cast<int>(std::round(left)),
                                    static_cast<int>(std::round(low + window->Scroll.y))};
            const bool is_absent = high <= begin + 1.0f || low >= end - 1.0f;
            const bool is_whole = low >= begin - 1.0f && high <= end + 1.0f;
            (is_absent ? letters.absent : is_whole ? letters.whole : letters.cut).insert(place);
        }
    }
    return letters;
}

/// Pages through the current card and looks at what is seen of it.
void check_card(Driver& driver) {
    const LessonStrip& strip = driver.ui.lesson.strip;
    const int card = strip.card, step = driver.ui.session.step;
    std::set<LetterPlace> known, seen;
    for (int page = 0; page < 30; ++page) {
        const StripLetters letters = strip_letters();
        CHECK(letters.cut.empty());
        known.insert(letters.absent.begin(), letters.absent.end());
        seen.insert(letters.whole.begin(), letters.whole.end());
        CHECK_FALSE(letters.whole.empty());
        if (!driver.ui.lesson.has_more_below) break;
        driver.hand.press(key::page_down);
        driver.hand.rest();
        REQUIRE(strip.card == card);
        REQUIRE(driver.ui.session.step == step);
        CHECK(strip_letters().scrolled > letters.scrolled);
    }
    CHECK_FALSE(driver.ui.lesson.has_more_below);
    for (const LetterPlace& place : known) {
        // Whole pixels may differ by one where the text was scrolled.
        bool is_seen = false;
        for (const int off : {-1, 0, 1})
            is_seen = is_seen || seen.count({place.first, place.second + off}) > 0;
        INFO("a letter " << place.second << " below the upper edge");
        CHECK(is_seen);
    }
}

/// All cards of a step.
void check_step(Driver& driver, const std::string& lesson, int step) {
    open_lesson(driver.ui, lesson, step);
    driver.hand.leave();
    const std::size_t count = driver.ui.lesson.strip.cards.size();
    for (std::size_t card = 0; card < count; ++card) {
        INFO(lesson << ", step " << step << ", card " << card);
        driver.ui.lesson.strip.card = static_cast<int>(card);
        driver.hand.frames(2 * frames_to_rest);
        REQUIRE(driver.ui.lesson.strip.cards.size() == count);
        check_card(driver);
    }
}

/// Does the strip's text say this on one line, where it can be seen?
bool strip_says(std::string_view words) {
    const ImGuiWindow* const window = window_with("lesson.strip.text");
    REQUIRE(window != nullptr);
    const std::vector<ScreenText> texts = screen_text();
    return std::any_of(texts.begin(), texts.end(), [&](const ScreenText& text) {
        return text.window == window->Name && text.words.find(words) != std::string::npos &&
               text.low.y >= window->Pos.y - 2.0f &&
               text.high.y <= window->Pos.y + window->Size.y + 2.0f;
    });
}

} // namespace

TEST_CASE("No letter of a formula or of a raised number is cut in a strip") {
    for (const LetterWindow& window : letter_windows) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text
                           << (window.is_lecture ? ", lecture" : ""));
        Driver driver("lab-room.toml", window.size, window.text);
        if (window.is_lecture) driver.hand.press(key::f5);
        const std::pair<const char*, int> steps[] = {
            {"04-edges", 1}, {"11-perspective", 3}, {"03-points", 2}, {"09-light-per-vertex", 1}};
        for (const auto& [lesson, step] : steps)
            check_step(driver, lesson, step);
    }
}

TEST_CASE("No letter of any lesson is cut in a strip, and each is reached by paging") {
    for (const LetterWindow& window : test::some_of(letter_windows, 1)) {
        INFO(window.size.x << " x " << window.size.y << ", text " << window.text
                           << (window.is_lecture ? ", lecture" : ""));
        Driver driver("lab-room.toml", window.size, window.text);
        if (window.is_lecture) driver.hand.press(key::f5);
        const std::vector<Lesson> lessons = driver.ui.lesson.lessons.all();
        for (const Lesson& lesson : test::some_of(lessons, 2)) {
            for (int step = 0; step < static_cast<int>(lesson.steps.size()); ++step)
                check_step(driver, lesson.id, step);
        }
    }
}

TEST_CASE("A table that has no room in the strip begins a card of its own, its head on each") {
    Driver driver("lab-room.toml", {1024, 640}, 1.5f);
    open_lesson(driver.ui, "08-depth-buffer", 2);
    driver.hand.leave();
    const std::vector<const char*> parts{"back wall", "red block, side", "red block, top",
                                         "blue block, front", "blue block, side"};
    std::vector<std::string> read;
    int tables = 0;
    for (int i = 0; i < 12 && driver.ui.session.step == 2; ++i) {
        const std::size_t before = read.size();
        for (const char* part : parts) {
            if (strip_says(part)) read.emplace_back(part);
        }
        if (read.size() > before) {
            ++tables;
            CHECK(strip_says("part"));
            CHECK(strip_says("1/z"));
            CHECK_FALSE(strip_says("Five fragments"));
            CHECK(read.size() - before > 1); // no row is alone
            CHECK_FALSE(driver.ui.lesson.has_more_below);
        }
        driver.hand.press(key::page_down);
        driver.hand.frames(2 * frames_to_rest);
    }
    CHECK(tables == 2);
    CHECK(read == std::vector<std::string>(parts.begin(), parts.end()));
}

} // namespace rasterwalk
