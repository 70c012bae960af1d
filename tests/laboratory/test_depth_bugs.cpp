// The mistakes of the depth buffer and of the weights for interpolation: each pixel is computed
// again from the fragments of the right run.

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>

#include "support/bits.h"
#include "support/bug_runs.h"
#include "support/walks.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// Who owns each pixel if a fragment passes where `passes(its depth, the stored one)`, in a buffer
/// that begins at 0.
template <class Passes>
std::vector<std::int32_t> owners(const DrawnRun& run, const Passes& passes) {
    std::vector<std::int32_t> owner(run.picture.owner.size(), -1);
    std::vector<float> stored(owner.size(), 0.0f);
    for (const FragmentEvent& event : run.reported.fragments) {
        const std::size_t at = run.picture.at(event.fragment.column, event.fragment.row);
        if (!passes(event.fragment.depth, stored[at])) continue;
        stored[at] = event.fragment.depth;
        owner[at] = event.cursor.triangle;
    }
    return owner;
}

/// The mistake's dice, written down a second time: is a fragment of the late thread late?
bool is_late(const FragmentEvent& event) {
    const std::uint32_t seed = static_cast<std::uint32_t>(event.fragment.column) * 2654435761u +
                               static_cast<std::uint32_t>(event.fragment.row) * 2246822519u +
                               static_cast<std::uint32_t>(event.cursor.triangle) * 3266489917u;
    std::uint64_t z = seed + 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return ((z ^ (z >> 31)) & 7) == 0;
}

std::string part_of(const DrawnRun& run, int triangle) {
    return part_name(*run.frame.scene, triangle);
}

/// Calls f with the two runs' fragments of the same moment and pixel.
template <class F>
void for_each_pair(const BugRuns& runs, const F& f) {
    REQUIRE(runs.wrong.reported.fragments.size() == runs.right.reported.fragments.size());
    for (std::size_t i = 0; i < runs.right.reported.fragments.size(); ++i) {
        const FragmentEvent &wrong = runs.wrong.reported.fragments[i],
                            &right = runs.right.reported.fragments[i];
        REQUIRE(wrong.cursor == right.cursor);
        REQUIRE(wrong.fragment.column == right.fragment.column);
        f(wrong, right);
    }
}

/// Checks that each place is `moved(right place, z)` and lit there, and counts the fragments that
/// became darker and those that became brighter.
template <class Moved>
std::array<int, 2> require_places(const BugRuns& runs, const Moved& moved) {
    int weaker = 0, stronger = 0;
    for_each_pair(runs, [&](const FragmentEvent& wrong, const FragmentEvent& right) {
        REQUIRE(same_bits(wrong.fragment.inv_w, right.fragment.inv_w));
        REQUIRE(wrong.fate == right.fate);
        const glm::vec3 place =
            recover_varyings(wrong.fragment, runs.wrong.frame.stages).position_world;
        const glm::vec3 true_place =
            recover_varyings(right.fragment, runs.right.frame.stages).position_world;
        const glm::dvec3 wanted =
            moved(glm::dvec3(true_place), 1.0 / static_cast<double>(right.fragment.inv_w));
        if (glm::distance(glm::dvec3(place), wanted) > 1e-4 * (1.0 + glm::length(wanted)))
            FAIL(to_text(wrong.cursor) << " is elsewhere");
        if (wrong.fate != Fate::written) return;
        const Vertex& corner = runs.right.frame.scene->corner(wrong.cursor.triangle, 0);
        const glm::dvec3 to_lamp = glm::dvec3(runs.wrong.frame.settings.light.position) - wanted;
        const double distance2 = glm::dot(to_lamp, to_lamp);
        const double cosine =
            std::max(0.0, glm::dot(to_lamp, glm::dvec3(corner.normal)) / std::sqrt(distance2));
        const Light& light = runs.wrong.frame.settings.light;
        const glm::dvec3 lit =
            glm::dvec3(corner.reflectance) *
            (glm::dvec3(light.power) * cosine / (4.0 * 3.14159265358979 * distance2) +
             glm::dvec3(light.indirect));
        if (glm::distance(glm::dvec3(wrong.after), lit) > 1e-3 * (1.0 + glm::length(lit)))
            FAIL(to_text(wrong.cursor) << " is lit differently");
        const float change = glm::length(wrong.after) - glm::length(right.after);
        weaker += change < -0.01f ? 1 : 0;
        stronger += change > 0.01f ? 1 : 0;
    });
    return {weaker, stronger};
}

} // namespace

TEST_CASE("B17e: the picture is the same to the last bit, and only empty cells differ") {
    const BugRuns runs("B17e");
    CHECK(runs.wrong.picture.colour == runs.right.picture.colour);
    CHECK(runs.wrong.picture.owner == runs.right.picture.owner);
    CHECK(runs.wrong.picture.overdraw == runs.right.picture.overdraw);
    int empty = 0;
    for (std::size_t at = 0; at < runs.right.picture.depth.size(); ++at) {
        const bool is_empty = runs.right.picture.overdraw[at] == 0;
        empty += is_empty ? 1 : 0;
        const float wanted = is_empty ? -std::ldexp(1.0f, 31) : runs.right.picture.depth[at];
        if (!same_bits(runs.wrong.picture.depth[at], wanted)) FAIL("cell " << at);
    }
    CHECK(empty == 998);
    // With z, where the smaller value wins, nothing would pass.
    for (const FragmentEvent& event : runs.right.reported.fragments)
        REQUIRE_FALSE(event.fragment.z < -static_cast<float>(INT_MAX));
}

TEST_CASE("B88a: the later of two equally near fragments stays, on shared edges only") {
    const BugRuns runs("B88a");
    CHECK(runs.wrong.picture.owner ==
          owners(runs.right, [](float depth, float stored) { return depth >= stored; }));
    CHECK(runs.right.picture.owner ==
          owners(runs.right, [](float depth, float stored) { return depth > stored; }));
    CHECK(same_bits(runs.wrong.picture.depth.front(), runs.right.picture.depth.front()));
    CHECK(runs.wrong.picture.depth == runs.right.picture.depth);
    CHECK(different_pixels(runs.wrong.picture, runs.right.picture) == 484);
    int shared = 0;
    for (std::size_t at = 0; at < runs.right.picture.owner.size(); ++at) {
        if (runs.wrong.picture.colour[at] == runs.right.picture.colour[at]) continue;
        const int later = runs.wrong.picture.owner[at], first = runs.right.picture.owner[at];
        int corners = 0;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j)
                corners += runs.right.frame.scene->corner(later, i).position ==
                                   runs.right.frame.scene->corner(first, j).position
                               ? 1
                               : 0;
        }
        CHECK(later > first);
        shared += corners >= 1 ? 1 : 0;
    }
    CHECK(shared == 484);
}

TEST_CASE("B88b: the poster is not nearer by 0.0001 of 1/z, and all of it is lost") {
    const BugRuns runs("B88b");
    CHECK(runs.wrong.picture.owner ==
          owners(runs.right, [](float depth, float stored) { return depth > stored + 0.0001f; }));
    int poster = 0, decal = 0;
    for (std::size_t at = 0; at < runs.right.picture.owner.size(); ++at) {
        const int right = runs.right.picture.owner[at], wrong = runs.wrong.picture.owner[at];
        if (right < 0) continue;
        const std::string part = part_of(runs.right, right);
        poster += part == "poster" ? 1 : 0;
        decal += part == "decal" ? 1 : 0;
        if (part == "poster") CHECK(part_of(runs.wrong, wrong) == "wall");
        if (part == "decal") CHECK(part_of(runs.wrong, wrong) == "decal");
    }
    CHECK(poster == different_pixels(runs.wrong.picture, runs.right.picture));
    CHECK(poster > 3000);
    CHECK(decal > 3000);
    for (const FragmentEvent& event : runs.right.reported.fragments) {
        if (part_of(runs.right, event.cursor.triangle) != "poster") continue;
        REQUIRE(event.fragment.inv_w < 1.0f / 3.2f);
        if (event.fate == Fate::written) REQUIRE(event.depth > event.stored);
    }
}

TEST_CASE("B89: 1/z changes by the right amount with the wrong sign, and blocks lose their feet") {
    const BugRuns runs("B89");
    float begun = 0.0f, most = 0.0f, block = 0.0f;
    for_each_pair(runs, [&](const FragmentEvent& wrong, const FragmentEvent& right) {
        // In this room column 0 is always in the picture, so each row is reported from its left
        // end.
        if (right.cursor.step == 0) begun = right.fragment.depth;
        const float wanted = begun - (right.fragment.depth - begun);
        if (right.cursor.step > 0 && std::abs(wrong.fragment.depth - wanted) > 1e-4f)
            FAIL(to_text(wrong.cursor) << " has a different 1/z");
        CHECK(same_bits(wrong.fragment.inv_w, wrong.fragment.depth));
        const std::string part = part_of(runs.right, right.cursor.triangle);
        if (part == "floor" || part == "ceiling" || part == "back wall")
            most = std::max(most, std::abs(wrong.fragment.depth - right.fragment.depth));
        else
            block = std::max(block, std::abs(wrong.fragment.depth - right.fragment.depth));
    });
    CHECK(most < 0.01f);
    CHECK(block > 0.1f);
    CHECK(different_pixels(runs.wrong.picture, runs.right.picture) > 1500);
    int blocks = 0;
    for (std::size_t at = 0; at < runs.right.picture.owner.size(); ++at) {
        if (runs.wrong.picture.colour[at] == runs.right.picture.colour[at]) continue;
        const std::string part = part_of(runs.right, runs.right.picture.owner[at]);
        blocks += part == "short block" || part == "tall block" ? 1 : 0;
    }
    CHECK(4 * blocks > 3 * different_pixels(runs.wrong.picture, runs.right.picture));
}

TEST_CASE("B102: now and then a hidden fragment of odd number covers one of even number") {
    const BugRuns runs("B102");
    const Framebuffer &wrong = runs.wrong.picture, &right = runs.right.picture;
    CHECK(wrong.overdraw == right.overdraw);
    std::vector<std::int32_t> owner(right.owner.size(), -1);
    std::vector<float> stored(owner.size(), 0.0f);
    int raced = 0, late = 0;
    for (const FragmentEvent& event : runs.right.reported.fragments) {
        const std::size_t at = right.at(event.fragment.column, event.fragment.row);
        const int triangle = event.cursor.triangle;
        if (event.fragment.depth <= stored[at]) {
            if (triangle % 2 == 0 || owner[at] % 2 == 1) continue;
            ++raced;
            if (!is_late(event)) continue;
            ++late;
        }
        stored[at] = event.fragment.depth;
        owner[at] = triangle;
    }
    CHECK(wrong.owner == owner);
    CHECK(wrong.depth == stored);
    CHECK(raced == 8466);
    CHECK(late == 1111);
    int different = 0, on_short = 0, on_tall = 0;
    for (std::size_t at = 0; at < owner.size(); ++at) {
        if (wrong.owner[at] == right.owner[at]) {
            CHECK(wrong.colour[at] == right.colour[at]);
            continue;
        }
        ++different;
        CHECK(wrong.depth[at] <= right.depth[at]);
        const std::string part = part_of(runs.right, right.owner[at]);
        on_short += part == "short block" ? 1 : 0;
        on_tall += part == "tall block" ? 1 : 0;
    }
    CHECK(on_short > 200);
    CHECK(on_tall > 200);
    CHECK(different == 1055);
    for (const FragmentEvent& event : runs.wrong.reported.fragments) {
        if (event.fate == Fate::written && event.depth <= event.stored)
            REQUIRE(event.cursor.triangle % 2 == 1);
    }
}

TEST_CASE("B102: the picture is the same every time, and in whatever parts it is drawn") {
    const BugRuns runs("B102");
    const Frame& frame = runs.wrong.frame;
    const Framebuffer again = draw_frame(frame);
    CHECK(again.owner == runs.wrong.picture.owner);
    CHECK(again.colour == runs.wrong.picture.colour);
    Framebuffer in_two;
    clear(in_two, frame);
    const Cursor middle{20, Phase::rows, 60, 7};
    draw(frame, {.from = cursor_begin, .to = middle, .scissor = {}}, in_two);
    draw(frame, {.from = middle, .to = cursor_end, .scissor = {}}, in_two);
    CHECK(in_two.owner == again.owner);
    CHECK(in_two.depth == again.depth);
    // A window of the picture, around the front of the tall block.
    Framebuffer part;
    const Viewport size{120, 150};
    clear(part, frame, size, {130, 200});
    draw(frame, {}, part);
    bool is_same = true;
    for (int row = 200; row < 200 + size.height; ++row) {
        for (int column = 130; column < 130 + size.width; ++column)
            is_same =
                is_same && part.owner[part.at(column, row)] == again.owner[again.at(column, row)];
    }
    CHECK(is_same);
}

TEST_CASE("B86: every place is 1/z of its way from the origin, and is lit there") {
    const BugRuns runs("B86");
    const auto [weaker, stronger] =
        require_places(runs, [](const glm::dvec3& place, double z) { return place / z; });
    CHECK(stronger > 100000);
    CHECK(weaker > 10000);
    const Light& light = runs.wrong.frame.settings.light;
    int ceiling = 0, wall = 0, white = 0;
    for_each_pair(runs, [&](const FragmentEvent& wrong, const FragmentEvent& right) {
        if (wrong.fate != Fate::written) return;
        const std::string part = part_of(runs.right, wrong.cursor.triangle);
        const Vertex& corner = runs.right.frame.scene->corner(wrong.cursor.triangle, 0);
        if (part == "ceiling") {
            ++ceiling;
            CHECK(wrong.after == corner.reflectance * light.indirect);
        }
        if (part == "back wall") {
            ++wall;
            CHECK(wrong.after.x > 1.2f * right.after.x);
            white += wrong.after.x > 1.0f ? 1 : 0;
        }
    });
    CHECK(ceiling > 10000);
    CHECK(wall > 10000);
    CHECK(5 * white > 2 * wall);
}

TEST_CASE("B87: every place is z of its way from the origin, and is lit there") {
    const BugRuns runs("B87");
    const auto [weaker, stronger] =
        require_places(runs, [](const glm::dvec3& place, double z) { return place * z; });
    CHECK(weaker > 200000);
    CHECK(stronger < weaker / 20);
}
