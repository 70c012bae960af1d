#include <string>
#include <vector>

#include "pipeline/cursor.h"
#include "support/random.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using test::Random;

namespace {

Cursor random_cursor(Random& random) {
    Cursor cursor;
    cursor.triangle = random.integer(0, random.integer(0, 3) == 0 ? INT_MAX - 1 : 50);
    cursor.pass = random.integer(0, 3) == 0 ? -random.integer(1, 6) : 0;
    cursor.phase = static_cast<Phase>(random.integer(0, phase_count - 1));
    const PhaseInfo& phase = phase_info(cursor.phase);
    cursor.index = phase.is_numbered ? random.integer(0, 400) : 0;
    cursor.step = phase.step_letter == 0 ? 0 : random.integer(0, 40000);
    if (cursor.phase == Phase::resolve) cursor.triangle = resolve_triangle;
    return cursor;
}

} // namespace

TEST_CASE("Moments have the text form of the command line") {
    CHECK(to_text({12, Phase::vertices, 1, 0}) == "t12/v1");
    CHECK(to_text({12, Phase::edges, 2, 14}) == "t12/e2/s14");
    CHECK(to_text({12, Phase::rows, 37, 5}) == "t12/r37/c5");
    CHECK(to_text({12, Phase::clip, 0, 2}) == "t12/p0/s2");
    CHECK(to_text({12, Phase::cull, 0, 0}) == "t12/k");
    CHECK(to_text({12, Phase::vertices, 1, 0, -6}) == "p1:t12/v1");
    CHECK(to_text({12, Phase::vertices, 1, 0, -1}) == "p6:t12/v1");
    CHECK(to_text(in_pass(cursor_end, -4)) == "p3:end");
    CHECK(to_text(cursor_begin) == "t0/v0");
    CHECK(to_text(cursor_end) == "end");
}

TEST_CASE("Parts omitted from the text of a moment are 0") {
    CHECK(parse_cursor("t12") == Cursor{12, Phase::vertices, 0, 0});
    CHECK(parse_cursor("t12/v2") == Cursor{12, Phase::vertices, 2, 0});
    CHECK(parse_cursor("t12/e2") == Cursor{12, Phase::edges, 2, 0});
    CHECK(parse_cursor("t12/r37") == Cursor{12, Phase::rows, 37, 0});
    CHECK(parse_cursor("t12/p3") == Cursor{12, Phase::clip, 3, 0});
    CHECK(parse_cursor("t12/p0/s2") == Cursor{12, Phase::clip, 0, 2});
    CHECK(parse_cursor("t12/k") == Cursor{12, Phase::cull, 0, 0});
    CHECK(parse_cursor("p1:t12") == Cursor{12, Phase::vertices, 0, 0, -6});
    CHECK(parse_cursor("p6:t12/e2/s14") == Cursor{12, Phase::edges, 2, 14, -1});
    CHECK(parse_cursor("p3:end") == in_pass(cursor_end, -4));
    CHECK(parse_cursor("end") == cursor_end);
    CHECK(parse_cursor("t0") == cursor_begin);
}

TEST_CASE("The passes come before the picture, and each has a moment at its end") {
    std::vector<Cursor> in_order;
    for (int pass = -early_pass_count; pass <= 0; ++pass) {
        in_order.push_back(in_pass(cursor_begin, pass));
        in_order.push_back(in_pass({1 << 30, Phase::rows, 7, 7}, pass));
        in_order.push_back(in_pass(cursor_end, pass));
    }
    CHECK(in_order.back() == cursor_end);
    for (std::size_t i = 1; i < in_order.size(); ++i)
        CHECK(in_order[i - 1] < in_order[i]);
    for (int pass = -early_pass_count; pass <= 0; ++pass) {
        for (std::size_t i = 0; i < in_order.size(); ++i) {
            const int of_cursor = static_cast<int>(i / 3) - early_pass_count;
            const Cursor found = in_frame(in_order[i], pass);
            if (of_cursor < pass) CHECK(found == cursor_begin);
            if (of_cursor > pass) CHECK(found == cursor_end);
            if (of_cursor == pass) CHECK(in_pass(found, pass) == in_order[i]);
        }
    }
}

TEST_CASE("Every moment is read back from its text") {
    Random random(20);
    for (int i = 0; i < 20000; ++i) {
        const Cursor cursor = random_cursor(random);
        const std::string text = to_text(cursor);
        if (parse_cursor(text) == cursor) continue;
        CAPTURE(text);
        FAIL("is not read back as it was");
    }
}

TEST_CASE("In tight spaces a place cannot be mistaken for a decimal") {
    CHECK(short_place({12, Phase::vertices, 1, 0}) == "v1");
    CHECK(short_place({12, Phase::edges, 2, 14}) == "e2 [14]");
    CHECK(short_place({12, Phase::rows, 37, 5}) == "r37 [5]");
    CHECK(short_place({12, Phase::cull, 0, 0}) == "k");
}

TEST_CASE("Text that is not a moment is refused") {
    for (const char* text : {"",
                             " ",
                             "t",
                             "12",
                             "t-1",
                             "t-0",
                             "t+1",
                             "t 1",
                             "t1 ",
                             " t1",
                             "t1.5",
                             "t1e3",
                             "T1",
                             "t1/",
                             "t1/v",
                             "t1/v-1",
                             "t1/v1/",
                             "t1/v1/s0",
                             "t1/v1/c0",
                             "t1/e",
                             "t1/e1/",
                             "t1/e1/s",
                             "t1/e1/c0",
                             "t1/e1/s0/",
                             "t1/e1/s0/s0",
                             "t1/e1/s-1",
                             "t1/r1/s0",
                             "t12/s5",
                             "t12/s5/c6",
                             "w1/t12/s5/c6",
                             "t1/r1/c",
                             "t1/r1c2",
                             "t1//r1",
                             "t1/x1",
                             "t1/1",
                             "/t1",
                             "t99999999999",
                             "t1/e99999999999/s0",
                             "End",
                             "end ",
                             "ende",
                             "t1,v1",
                             "v1",
                             "e1/s1",
                             "t1/\xff",
                             "t1/e1/s1\n",
                             "t1/p",
                             "t1/p0/c0",
                             "t1/k0",
                             "t1/k/",
                             "t1/k/s0",
                             "p",
                             "p1",
                             "p1:",
                             "p0:t1",
                             "p7:t1",
                             "p1:end/v0",
                             "p-1:t1",
                             "p1t1",
                             "p:t1",
                             "p1:p1:t1",
                             "p1/t1"}) {
        CAPTURE(text);
        CHECK_FALSE(parse_cursor(text).has_value());
    }
    CHECK_FALSE(parse_cursor(std::string_view("t1\0", 3)).has_value());
    CHECK_FALSE(parse_cursor(std::string_view("t1/e1/s1\0", 9)).has_value());
}

TEST_CASE("A text cut short or garbled is refused or read as some moment, never worse") {
    Random random(21);
    const std::string letters = "tverpksc/:0123456789-+ end\n";
    for (int i = 0; i < 50000; ++i) {
        std::string text = to_text(random_cursor(random));
        text.resize(static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()))));
        const int edits = random.integer(0, 3);
        for (int e = 0; e < edits && !text.empty(); ++e) {
            const int place = random.integer(0, static_cast<int>(text.size()) - 1);
            text[static_cast<std::size_t>(place)] = letters[static_cast<std::size_t>(
                random.integer(0, static_cast<int>(letters.size()) - 1))];
        }
        const std::optional<Cursor> cursor = parse_cursor(text);
        if (!cursor) continue;
        const bool counts_from_0 = cursor->triangle >= 0 && cursor->index >= 0 && cursor->step >= 0;
        if (counts_from_0 && parse_cursor(to_text(*cursor)) == cursor) continue;
        CAPTURE(text);
        FAIL("was read as a moment that has no text of its own");
    }
}

TEST_CASE("Moments are ordered as triangles are drawn") {
    const Cursor order[] = {cursor_begin,
                            {0, Phase::vertices, 2, 0},
                            {0, Phase::clip, 0, 0},
                            {0, Phase::clip, 0, 2},
                            {0, Phase::clip, 5, 0},
                            {0, Phase::cull, 0, 0},
                            {0, Phase::edges, 0, 0},
                            {0, Phase::edges, 0, 9},
                            {0, Phase::edges, 1, 0},
                            {0, Phase::rows, 0, 0},
                            {0, Phase::rows, 0, 7},
                            {0, Phase::rows, 3, 0},
                            {1, Phase::vertices, 0, 0},
                            {900, Phase::rows, 900, 900},
                            {0, Phase::vertices, 0, 0, 1},
                            {0, Phase::cull, 0, 0, 1},
                            {5, Phase::vertices, 0, 0, 2},
                            cursor_end};
    for (std::size_t a = 0; a < std::size(order); ++a) {
        for (std::size_t b = 0; b < std::size(order); ++b) {
            CAPTURE(to_text(order[a]), to_text(order[b]));
            CHECK((order[a] < order[b]) == (a < b));
        }
    }
}
