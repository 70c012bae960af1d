#pragma once

// The room of the lab: 30 triangles in the order in which they are drawn. x points to the right,
// y down and z into the picture; all points are in -1..1.

#include <vector>

#include <glm/glm.hpp>

class Triangle {
  public:
    glm::vec3 v0, v1, v2;
    glm::vec3 normal; // of length 1: into the room on walls, outward on blocks
    glm::vec3 color;  // red, green, blue, 0..1

    Triangle(glm::vec3 first, glm::vec3 second, glm::vec3 third, glm::vec3 its_color)
        : v0(first), v1(second), v2(third), color(its_color) {
        ComputeNormal();
    }

    void ComputeNormal() { normal = glm::normalize(glm::cross(v2 - v0, v1 - v0)); }
};

// A point of the room, which is 555 wide, high and deep, in -1..1.
inline glm::vec3 ScaledPoint(const glm::vec3& point) {
    const glm::vec3 scaled = 2.0f * point / 555.0f - 1.0f;
    return glm::vec3(-scaled.x, -scaled.y, scaled.z);
}

// Corners are numbered: 0 to 3 are on the floor, and 4 to 7 are above them.
inline void AddTriangles(std::vector<Triangle>& triangles, const glm::vec3 (&floor)[4],
                         float height, const int (*corners)[3], int count, const glm::vec3& color) {
    glm::vec3 points[8];
    for (int i = 0; i < 4; ++i) {
        points[i] = ScaledPoint(floor[i]);
        points[i + 4] = ScaledPoint(floor[i] + glm::vec3(0, height, 0));
    }
    for (int i = 0; i < count; ++i) {
        const int* corner = corners[i];
        triangles.push_back(
            Triangle(points[corner[0]], points[corner[1]], points[corner[2]], color));
    }
}

// Replaces what is in `triangles` by the room.
inline void LoadTestModel(std::vector<Triangle>& triangles) {
    using glm::vec3;
    triangles.clear();

    const vec3 room[4] = {vec3(555, 0, 0), vec3(0, 0, 0), vec3(555, 0, 555), vec3(0, 0, 555)};
    const int floor[2][3] = {{2, 1, 0}, {2, 3, 1}};
    const int leftWall[2][3] = {{0, 4, 2}, {2, 4, 6}};
    const int rightWall[2][3] = {{5, 1, 3}, {7, 5, 3}};
    const int ceiling[2][3] = {{4, 5, 6}, {5, 7, 6}};
    const int backWall[2][3] = {{6, 3, 2}, {6, 7, 3}};
    AddTriangles(triangles, room, 555, floor, 2, vec3(0.15f, 0.75f, 0.15f));
    AddTriangles(triangles, room, 555, leftWall, 2, vec3(0.75f, 0.15f, 0.75f));
    AddTriangles(triangles, room, 555, rightWall, 2, vec3(0.75f, 0.75f, 0.15f));
    AddTriangles(triangles, room, 555, ceiling, 2, vec3(0.15f, 0.75f, 0.75f));
    AddTriangles(triangles, room, 555, backWall, 2, vec3(0.75f, 0.75f, 0.75f));

    const int block[10][3] = {{4, 1, 0}, {4, 5, 1}, {5, 3, 1}, {5, 7, 3}, {7, 2, 3},
                              {7, 6, 2}, {6, 4, 2}, {4, 0, 2}, {6, 5, 4}, {6, 7, 5}};
    const vec3 shortBlock[4] = {vec3(290, 0, 114), vec3(130, 0, 65), vec3(240, 0, 272),
                                vec3(82, 0, 225)};
    AddTriangles(triangles, shortBlock, 165, block, 10, vec3(0.75f, 0.15f, 0.15f));
    const vec3 tallBlock[4] = {vec3(423, 0, 247), vec3(265, 0, 296), vec3(472, 0, 406),
                               vec3(314, 0, 456)};
    AddTriangles(triangles, tallBlock, 330, block, 10, vec3(0.15f, 0.15f, 0.75f));
}
