#pragma once

// Stands in for the model with homogeneous coordinates: see TestModel.h. Points are vec4 with w =
// 1, and so is the normal, whose w is 1 as well.
//
// A program chooses between TestModel.h and TestModelH.h by the name that it includes. Local copies
// of either that are included later find their guard taken.
//
// With RASTERWALK_OWN_HELPER the program's own file of this name is used instead.

#ifdef RASTERWALK_OWN_HELPER
#include_next <TestModelH.h>
#elif !defined(TEST_MODEL_CORNEL_BOX_H)
#define TEST_MODEL_CORNEL_BOX_H

#include <vector>

#include <glm/glm.hpp>

#include "inner/room.h"

class Triangle {
  public:
    glm::vec4 v0, v1, v2;
    glm::vec4 normal;
    glm::vec3 color;

    Triangle() = default;
    Triangle(glm::vec4 first, glm::vec4 second, glm::vec4 third, glm::vec3 colour)
        : v0(first), v1(second), v2(third), color(colour) {
        ComputeNormal();
    }

    /// Points into the room on walls, and outward on blocks.
    void ComputeNormal() {
        const glm::vec3 along_first(v1 - v0), along_second(v2 - v0);
        normal = glm::vec4(glm::normalize(glm::cross(along_second, along_first)), 1.0f);
    }
};

/// Replaces what is in `triangles` by the room, scaled to -1..1: x to the right, y down, z into the
/// picture.
inline void LoadTestModel(std::vector<Triangle>& triangles) {
    triangles.clear();
    for (const rasterwalk_kit::RoomTriangle& triangle : rasterwalk_kit::room()) {
        triangles.push_back(Triangle(glm::vec4(triangle.corners[0], 1.0f),
                                     glm::vec4(triangle.corners[1], 1.0f),
                                     glm::vec4(triangle.corners[2], 1.0f), triangle.colour));
    }
}

#endif
