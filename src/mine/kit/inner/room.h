#pragma once

// The room of the lab: for TestModel.h and TestModelH.h.

#include <vector>

#include <glm/glm.hpp>

namespace rasterwalk_kit {

struct RoomTriangle {
    glm::vec3 corners[3];
    glm::vec3 colour;
};

/// The room is 555 wide, high and deep, with y up: it becomes -1..1, with y down and x
/// the other way round. In this order the numbers are, to the last bit, those that Rasterwalk has.
inline glm::vec3 scaled_to_room(const glm::vec3& point) {
    const glm::vec3 scaled = 2.0f * point / 555.0f - 1.0f;
    return glm::vec3(-scaled.x, -scaled.y, scaled.z);
}

inline void add_triangle(std::vector<RoomTriangle>& triangles, const glm::vec3& a,
                         const glm::vec3& b, const glm::vec3& c, const glm::vec3& colour) {
    RoomTriangle added;
    added.corners[0] = scaled_to_room(a);
    added.corners[1] = scaled_to_room(b);
    added.corners[2] = scaled_to_room(c);
    added.colour = colour;
    triangles.push_back(added);
}

/// A block without its bottom.
/// @param floor its corners A to D on the floor; E to H are above them
inline void add_block(std::vector<RoomTriangle>& triangles, const glm::vec3 (&floor)[4],
                      float height, const glm::vec3& colour) {
    const glm::vec3 up(0.0f, height, 0.0f);
    const glm::vec3 corners[8] = {floor[0],      floor[1],      floor[2],      floor[3],
                                  floor[0] + up, floor[1] + up, floor[2] + up, floor[3] + up};
    const char sides[10][4] = {"EBA", "EFB", "FDB", "FHD", "HCD",
                               "HGC", "GEC", "EAC", "GFE", "GHF"};
    for (const char* side : sides) {
        add_triangle(triangles, corners[side[0] - 'A'], corners[side[1] - 'A'],
                     corners[side[2] - 'A'], colour);
    }
}

/// Its 30 triangles in drawing order: five walls, the short block, the tall one.
inline std::vector<RoomTriangle> room() {
    const float length = 555.0f;
    const glm::vec3 a(length, 0, 0), b(0, 0, 0), c(length, 0, length), d(0, 0, length);
    const glm::vec3 e(length, length, 0), f(0, length, 0), g(length, length, length),
        h(0, length, length);
    const glm::vec3 red(0.75f, 0.15f, 0.15f), yellow(0.75f, 0.75f, 0.15f),
        green(0.15f, 0.75f, 0.15f), cyan(0.15f, 0.75f, 0.75f), blue(0.15f, 0.15f, 0.75f),
        purple(0.75f, 0.15f, 0.75f), white(0.75f, 0.75f, 0.75f);

    std::vector<RoomTriangle> triangles;
    add_triangle(triangles, c, b, a, green); // floor
    add_triangle(triangles, c, d, b, green);
    add_triangle(triangles, a, e, c, purple); // left wall
    add_triangle(triangles, c, e, g, purple);
    add_triangle(triangles, f, b, d, yellow); // right wall
    add_triangle(triangles, h, f, d, yellow);
    add_triangle(triangles, e, f, g, cyan); // ceiling
    add_triangle(triangles, f, h, g, cyan);
    add_triangle(triangles, g, d, c, white); // back wall
    add_triangle(triangles, g, h, d, white);

    const glm::vec3 short_block[4] = {glm::vec3(290, 0, 114), glm::vec3(130, 0, 65),
                                      glm::vec3(240, 0, 272), glm::vec3(82, 0, 225)};
    add_block(triangles, short_block, 165.0f, red);
    const glm::vec3 tall_block[4] = {glm::vec3(423, 0, 247), glm::vec3(265, 0, 296),
                                     glm::vec3(472, 0, 406), glm::vec3(314, 0, 456)};
    add_block(triangles, tall_block, 330.0f, blue);
    return triangles;
}

} // namespace rasterwalk_kit
