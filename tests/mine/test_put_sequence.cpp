#include "mine/put_sequence.h"

#include <algorithm>
#include <utility>

#include "laboratory/bug.h"
#include "support/catch.h"
#include "support/samples.h"

using namespace rasterwalk;
using rasterwalk_kit::Put;

namespace {

/// The room, small, so that it is drawn quickly.
Settings small_settings(const Scene& room) {
    Settings settings = with_handout_rules(default_settings(room));
    settings.viewport = {64, 48};
    settings.camera.focal_length = 48.0f;
    return settings;
}

/// A program that puts exactly what we put.
std::vector<Put> puts_like(const std::vector<OurPut>& ours) {
    std::vector<Put> puts;
    for (const OurPut& put : ours)
        puts.push_back({put.pixel.x, put.pixel.y, 0.5f, 0.5f, 0.5f});
    return puts;
}

struct Sequences {
    Viewport picture{64, 48};
    std::vector<OurPut> ours;
    std::vector<Put> theirs;

    std::optional<SequenceParting> parting() const {
        return sequence_parting(theirs, ours, picture);
    }
};

const Sequences& room_sequences() {
    static const Sequences sequences = [] {
        const Scene room = test::lab_room();
        Sequences made;
        made.ours = our_puts(room, small_settings(room));
        made.theirs = puts_like(made.ours);
        return made;
    }();
    return sequences;
}

} // namespace

TEST_CASE("What we put is in the picture, and covers most of it") {
    const Sequences& same = room_sequences();
    REQUIRE(same.ours.size() > 2000);
    std::vector<bool> is_put(64 * 48, false);
    for (const OurPut& put : same.ours) {
        REQUIRE(put.pixel.x >= 0);
        REQUIRE(put.pixel.x < 64);
        REQUIRE(put.pixel.y >= 0);
        REQUIRE(put.pixel.y < 48);
        is_put[static_cast<std::size_t>(put.pixel.y * 64 + put.pixel.x)] = true;
    }
    CHECK(std::count(is_put.begin(), is_put.end(), true) > 48 * 40);
}

TEST_CASE("A program that puts the same pixels in the same order has our sequence") {
    CHECK_FALSE(room_sequences().parting().has_value());
}

TEST_CASE("The first pixel that is left out, swapped or put elsewhere is found") {
    Sequences changed = room_sequences();
    const std::size_t at = changed.theirs.size() / 2;
    const glm::ivec2 ours = changed.ours[at].pixel;
    glm::ivec2 theirs = changed.ours[at + 1].pixel;
    REQUIRE(ours != theirs);
    SECTION("left out") {
        changed.theirs.erase(changed.theirs.begin() + static_cast<std::ptrdiff_t>(at));
    }
    SECTION("swapped with the next") {
        std::swap(changed.theirs[at], changed.theirs[at + 1]);
    }
    SECTION("put elsewhere") {
        theirs = {63 - ours.x, 47 - ours.y};
        REQUIRE(ours != theirs);
        changed.theirs[at].x = theirs.x;
        changed.theirs[at].y = theirs.y;
    }
    const std::optional<SequenceParting> parting = changed.parting();
    REQUIRE(parting.has_value());
    CHECK(parting->index == static_cast<std::int64_t>(at));
    REQUIRE(parting->theirs.has_value());
    CHECK(*parting->theirs == theirs);
    REQUIRE(parting->ours.has_value());
    CHECK(parting->ours->pixel == ours);
    CHECK(parting->ours->cursor == changed.ours[at].cursor);
}

TEST_CASE("One pixel too many at the end has none of ours") {
    Sequences changed = room_sequences();
    changed.theirs.push_back({7, 9, 0.0f, 0.0f, 0.0f});
    const std::optional<SequenceParting> parting = changed.parting();
    REQUIRE(parting.has_value());
    CHECK(parting->index == static_cast<std::int64_t>(changed.ours.size()));
    CHECK(parting->theirs == glm::ivec2(7, 9));
    CHECK_FALSE(parting->ours.has_value());
}

TEST_CASE("One pixel too few at the end has none of theirs") {
    Sequences changed = room_sequences();
    changed.theirs.pop_back();
    const std::optional<SequenceParting> parting = changed.parting();
    REQUIRE(parting.has_value());
    CHECK(parting->index == static_cast<std::int64_t>(changed.theirs.size()));
    CHECK_FALSE(parting->theirs.has_value());
    REQUIRE(parting->ours.has_value());
    CHECK(parting->ours->pixel == changed.ours.back().pixel);
}

TEST_CASE("Puts outside the picture do not count") {
    Sequences changed = room_sequences();
    const std::vector<Put> outside{
        {-1, 3, 0, 0, 0}, {64, 3, 0, 0, 0}, {3, 48, 0, 0, 0}, {3, -1, 0, 0, 0}};
    changed.theirs.insert(changed.theirs.begin() + 10, outside.begin(), outside.end());
    changed.theirs.insert(changed.theirs.end(), outside.begin(), outside.end());
    CHECK_FALSE(changed.parting().has_value());
    // They do not move the index either.
    changed.theirs[20].x = (changed.theirs[20].x + 1) % 64;
    const std::optional<SequenceParting> parting = changed.parting();
    REQUIRE(parting.has_value());
    CHECK(parting->index == 16);
}

TEST_CASE("Nothing is the same as nothing") {
    CHECK_FALSE(sequence_parting({}, {}, {64, 48}).has_value());
    const Put put{1, 1, 0.0f, 0.0f, 0.0f};
    const std::optional<SequenceParting> parting = sequence_parting({&put, 1}, {}, {64, 48});
    REQUIRE(parting.has_value());
    CHECK(parting->index == 0);
}
