#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "pipeline/cursor.h"

namespace rasterwalk {

struct Session;

/// What is looked at: the same in every panel. Counts from 0.
struct Selection {
    std::optional<int> triangle;
    std::optional<int> vertex;       ///< of the triangle, 0..2
    std::optional<int> row;          ///< row of the picture
    std::optional<glm::ivec2> pixel; ///< column, row

    friend bool operator==(const Selection&, const Selection&) = default;
};

/// Where the student looks: a moment, and what is selected. Back and forward return to it.
struct Place {
    Cursor cursor = cursor_end;
    Selection selection;

    friend bool operator==(const Place&, const Place&) = default;
};

/// The places visited, as in a browser.
struct PlaceHistory {
    Place now;
    int jumps = 0; ///< Session::jumps when `now` was noted
    std::vector<Place> past;
    std::vector<Place> future; ///< the last is the next one forward
};

/// Call it when the input is at rest. A jump or a new selection begins a new place; stepping and
/// scrubbing only move the present one.
void record_visit(Session& session);

/// Goes to the previous or next place visited. False if there is none.
bool go_back(Session& session);
bool go_forward(Session& session);

/// The most places that are remembered; older ones are forgotten.
inline constexpr std::size_t most_places = 200;

} // namespace rasterwalk
