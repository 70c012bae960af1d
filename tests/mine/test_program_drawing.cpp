#include "mine/program_drawing.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "mine/put_sequence.h"
#include "support/bits.h"
#include "support/moments.h"
#include "support/program_drawings.h"
#include "tests/support/catch.h"

using namespace rasterwalk;

namespace {

/// The colours of our picture before a moment.
Framebuffer ours_before(const Frame& frame, const Cursor& to) {
    Framebuffer planes;
    clear(planes, frame);
    rasterwalk::draw(frame, {.from = cursor_begin, .to = to, .scissor = {}}, planes);
    return planes;
}

/// The first pixel whose colour or owner differs, row by row from the top; "" if none does.
std::string first_wrong(const Framebuffer& ours, const Framebuffer& theirs) {
    if (!(ours.size == theirs.size)) return "another size";
    for (int row = 0; row < ours.size.height; ++row)
        for (int column = 0; column < ours.size.width; ++column) {
            const std::size_t at = ours.at(column, row);
            const glm::vec3 &a = ours.colour[at], &b = theirs.colour[at];
            if (test::same_bits(a, b) && ours.owner[at] == theirs.owner[at]) continue;
            return fmt::format("pixel ({}, {}): {} {} {} of {} in ours, {} {} {} of {} in theirs",
                               column, row, a.x, a.y, a.z, ours.owner[at], b.x, b.y, b.z,
                               theirs.owner[at]);
        }
    return "";
}

std::shared_ptr<const ProgramDrawing> shared(ProgramDrawing drawing) {
    return std::make_shared<const ProgramDrawing>(std::move(drawing));
}

/// A checked program that has put this.
CheckedProgram checked_with(const Settings& reference, std::vector<rasterwalk_kit::Put> puts) {
    CheckedProgram checked;
    checked.files.name = "mine.cpp";
    checked.run.emplace();
    checked.run->recording.progress.puts = puts.size();
    checked.run->recording.puts = std::move(puts);
    checked.picture.emplace();
    checked.picture->reference = reference;
    return checked;
}

std::vector<rasterwalk_kit::Put> kit_puts(const ProgramDrawing& drawing) {
    std::vector<rasterwalk_kit::Put> puts;
    for (const ProgramPut& put : drawing.puts)
        puts.push_back({put.pixel.x, put.pixel.y, put.colour.r, put.colour.g, put.colour.b});
    return puts;
}

} // namespace

TEST_CASE("A right program has our picture at every tenth moment, forward and back") {
    for (const StripStep& step :
         {StripStep::pixel_light, StripStep{Stage::depth}, StripStep{Stage::edges}}) {
        const auto drawing = shared(test::right_room_drawing(step));
        REQUIRE(drawing->puts.size() > 300);
        const Frame frame = prepare_frame(*drawing->scene, drawing->settings);
        ProgramPlanes theirs;
        theirs.begin(drawing, frame);
        const std::vector<Cursor> moments = test::all_moments(frame);
        const auto compare_at = [&](const Cursor& cursor) {
            INFO(to_text(cursor));
            theirs.go_to(puts_at(*drawing, cursor));
            const std::string wrong = first_wrong(ours_before(frame, cursor), theirs.planes());
            if (!wrong.empty()) FAIL(wrong);
        };
        for (std::size_t i = 0; i < moments.size(); i += 10)
            compare_at(moments[i]);
        compare_at(cursor_end);
        for (std::size_t i = moments.size(); i > 500; i -= 500)
            compare_at(moments[i - 1]);
        compare_at(cursor_begin);
    }
}

TEST_CASE("One wrong pixel parts the sequences, and only its two places differ from then on") {
    const ProgramDrawing right = test::right_room_drawing(StripStep{Stage::fill});
    const std::size_t wrong_index = right.puts.size() / 2;
    const glm::ivec2 meant = right.puts[wrong_index].pixel;
    const glm::ivec2 hit{meant.x, (meant.y + 7) % 48};
    std::vector<ProgramPut> puts = right.puts;
    puts[wrong_index] = {hit, glm::vec3(0.125f, 0.25f, 0.5f)};
    const auto drawing = shared(test::with_puts(right, puts));
    REQUIRE(drawing->parting);
    CHECK(drawing->parting->index == static_cast<std::int64_t>(wrong_index));
    CHECK(moment_of_parting(*drawing) == right.ours[wrong_index]);
    CHECK(parting_text(*drawing->parting) ==
          fmt::format("They part after {} pixels in the same order: your program puts pixel "
                      "({}, {}), and we put pixel ({}, {}).",
                      wrong_index, hit.x, hit.y, meant.x, meant.y));
    const Frame frame = prepare_frame(*drawing->scene, drawing->settings);
    ProgramPlanes theirs;
    theirs.begin(drawing, frame);
    const auto different = [&](const Cursor& cursor) {
        theirs.go_to(puts_at(*drawing, cursor));
        const Framebuffer ours = ours_before(frame, cursor);
        std::vector<glm::ivec2> places;
        for (int row = 0; row < 48; ++row)
            for (int column = 0; column < 64; ++column) {
                const std::size_t at = ours.at(column, row);
                if (!test::same_bits(ours.colour[at], theirs.planes().colour[at]))
                    places.emplace_back(column, row);
            }
        return places;
    };
    CHECK(different(right.ours[wrong_index]).empty());
    Cursor after = right.ours[wrong_index];
    ++after.step;
    const std::vector<glm::ivec2> places = different(after);
    REQUIRE_FALSE(places.empty());
    for (const glm::ivec2& place : places)
        CHECK((place == meant || place == hit));
    // The owners are ours only where the sequences are still the same.
    CHECK(theirs.planes().owner[theirs.planes().at(hit.x, hit.y)] == -1);
    for (std::size_t i = wrong_index + 1; i < right.ours.size(); i += 97)
        for (const glm::ivec2& place : different(right.ours[i]))
            CHECK((place == meant || place == hit));
}

TEST_CASE("A program that puts fewer or more pixels than we do is whole only at the end") {
    const ProgramDrawing right = test::right_room_drawing(StripStep{Stage::fill});
    const std::size_t count = right.puts.size();
    std::vector<ProgramPut> fewer = right.puts, more = right.puts;
    fewer.resize(count - 5);
    more.push_back({{3, 4}, glm::vec3(1.0f)});
    const ProgramDrawing short_one = test::with_puts(right, fewer);
    CHECK(puts_at(short_one, right.ours.back()) == count - 5);
    CHECK(puts_at(short_one, cursor_end) == count - 5);
    CHECK(moment_of_parting(short_one) == right.ours[count - 5]);
    CHECK(parting_text(*short_one.parting).starts_with("Your program ends after "));
    const ProgramDrawing long_one = test::with_puts(right, more);
    CHECK(puts_at(long_one, right.ours.back()) == count - 1);
    CHECK(puts_at(long_one, cursor_end) == count + 1);
    CHECK(moment_of_parting(long_one) == cursor_end);
    CHECK(parting_text(*long_one.parting).ends_with("goes on with pixel (3, 4)."));
    CHECK_FALSE(moment_of_parting(right));
    CHECK(puts_at(right, cursor_begin) == 0);
}

TEST_CASE("Puts anywhere and of any colour do no harm") {
    const ProgramDrawing right = test::right_room_drawing(StripStep{Stage::fill});
    constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const float nan = std::nanf("");
    std::vector<rasterwalk_kit::Put> puts{{least, 0, 1, 1, 1}, {most, most, 1, 1, 1},
                                          {0, least, 1, 1, 1}, {64, 0, 1, 1, 1},
                                          {0, 48, 1, 1, 1},    {5, 6, nan, infinite, -infinite}};
    for (const rasterwalk_kit::Put& put : kit_puts(right))
        puts.push_back(put);
    const auto drawing = drawing_of(checked_with(right.settings, puts), right.scene);
    REQUIRE(drawing != nullptr);
    CHECK(drawing->puts.size() == right.puts.size() + 1);
    const glm::vec3 kept = drawing->puts.front().colour;
    CHECK(kept == glm::vec3(0.0f, largest_put_channel, -largest_put_channel));
    // The planes themselves leave out what is outside, too.
    ProgramDrawing wild = *drawing;
    wild.puts.insert(wild.puts.begin(), {{{least, most}, {}}, {{-1, 0}, {}}, {{0, 48}, {}}});
    const Frame frame = prepare_frame(*right.scene, right.settings);
    ProgramPlanes theirs;
    theirs.begin(shared(wild), frame);
    theirs.go_to(most);
    CHECK(theirs.puts() == wild.puts.size());
    std::size_t drawn = 0;
    for (const std::uint32_t times : theirs.planes().overdraw)
        drawn += times;
    CHECK(drawn == right.puts.size() + 1);
}

TEST_CASE("What a checked program has drawn is its puts, next to ours") {
    const ProgramDrawing right = test::right_room_drawing(StripStep{Stage::fill});
    const auto drawing = drawing_of(checked_with(right.settings, kit_puts(right)), right.scene);
    REQUIRE(drawing != nullptr);
    CHECK(drawing->name == "mine.cpp");
    CHECK(*drawing->scene == *right.scene);
    CHECK(drawing->settings == right.settings);
    CHECK(drawing->ours == right.ours);
    CHECK_FALSE(drawing->parting);
    REQUIRE(drawing->puts.size() == right.puts.size());
    for (std::size_t i = 0; i < right.puts.size(); ++i) {
        REQUIRE(drawing->puts[i].pixel == right.puts[i].pixel);
        REQUIRE(test::same_bits(drawing->puts[i].colour, right.puts[i].colour));
    }
    CHECK(drawing_of(CheckedProgram(), right.scene) == nullptr);
    CHECK(drawing_of(checked_with(right.settings, {}), right.scene) == nullptr);
    // Pixels written without PutPixelSDL have no place in the order; nor have those not kept.
    CheckedProgram direct = checked_with(right.settings, kit_puts(right));
    direct.run->recording.progress.direct = 1;
    CHECK(drawing_of(direct, right.scene) == nullptr);
    CheckedProgram cut = checked_with(right.settings, kit_puts(right));
    cut.run->recording.puts.pop_back();
    CHECK(drawing_of(cut, right.scene) == nullptr);
}

TEST_CASE("Edges may have any colour but black, and are compared in white") {
    const ProgramDrawing right = test::right_room_drawing(StripStep{Stage::edges});
    const auto drawing = drawing_of(
        checked_with(right.settings, {{1, 2, 0.0f, 0.5f, 0.0f}, {3, 4, 0.0f, 0.0f, 0.0f}}),
        right.scene);
    REQUIRE(drawing != nullptr);
    CHECK(drawing->puts[0].colour == glm::vec3(1.0f));
    CHECK(drawing->puts[1].colour == glm::vec3(0.0f));
}

TEST_CASE("A parting at the very first pixel is said without a count") {
    const OurPut ours{cursor_begin, {5, 6}};
    CHECK(parting_text({0, glm::ivec2(1, 2), ours}) ==
          "They part at the first pixel: your program puts pixel (1, 2), and we put pixel (5, 6).");
    CHECK(parting_text({1, std::nullopt, ours}) ==
          "Your program ends after 1 pixel, and we go on with pixel (5, 6).");
    CHECK(parting_text({0, glm::ivec2(1, 2), std::nullopt}) ==
          "We end after 0 pixels, and your program goes on with pixel (1, 2).");
}

TEST_CASE("All that a program puts on a pixel is found, in order") {
    ProgramDrawing drawing;
    drawing.puts = {
        {{1, 2}, glm::vec3(0.5f)}, {{2, 1}, glm::vec3(0.1f)}, {{1, 2}, glm::vec3(1.0f)}};
    const std::vector<ProgramWrite> expected{{0, glm::vec3(0.5f)}, {2, glm::vec3(1.0f)}};
    CHECK(writes_on(drawing, {1, 2}) == expected);
    CHECK(writes_on(drawing, {0, 0}).empty());
}
