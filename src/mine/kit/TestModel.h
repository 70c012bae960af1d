#pragma once

// Stands in for the model that courses hand out with the lab: a room with two blocks, 30
// triangles, in the drawing order that the lab's pictures depend on. Points are vec3.
//
// A program chooses between TestModel.h and TestModelH.h by the name that it includes. Local copies
// of either that are included later find their guard taken.
//
// With RASTERWALK_OWN_HELPER the program's own file of this name is used instead.

#ifdef RASTERWALK_OWN_HELPER
#include_next <TestModel.h>
#elif !defined(TEST_MODEL_CORNEL_BOX_H)
#define TEST_MODEL_CORNEL_BOX_H

#include <vector>

#include <glm/glm.hpp>

#include "inner/room.h"

class Triangle {
  public:
    glm::vec3 v0, v1, v2;
    glm::vec3 normal;
    glm::vec3 color;

    Triangle() = default;
    Triangle(glm::vec3 first, glm::vec3 second, glm::vec3 third, glm::vec3 colour)
        : v0(first), v1(second), v2(third), color(colour) {
        ComputeNormal();
    }

    /// Points into the room on walls, and outward on blocks.
    void ComputeNormal() { normal = glm::normalize(glm::cross(v2 - v0, v1 - v0)); }
};

/// Replaces what is in `triangles` by the room, scaled to -1..1: x to the right, y down, z into the
/// picture.
inline void LoadTestModel(std::vector<Triangle>& triangles) {
    triangles.clear();
    for (const rasterwalk_kit::RoomTriangle& triangle : rasterwalk_kit::room()) {
        triangles.push_back(Triangle(triangle.corners[0], triangle.corners[1], triangle.corners[2],
                                     triangle.colour));
    }
}

#endif
