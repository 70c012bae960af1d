// The room, from the numbers of the handout.

#include "laboratory/second_rasterizer.h"

#include <glm/geometric.hpp>

namespace rasterwalk::test {

namespace {

/// A point of the handout, scaled into the cube -1..1.
glm::vec3 scaled(glm::vec3 handout) {
    constexpr float edge = 555.0f;
    return {1.0f - 2.0f * handout.x / edge, 1.0f - 2.0f * handout.y / edge,
            2.0f * handout.z / edge - 1.0f};
}

/// The eight corners A to H; E to H are above A to D.
std::array<glm::vec3, 8> corners_of(const std::array<glm::vec3, 4>& floor, float height) {
    std::array<glm::vec3, 8> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        corners[i] = scaled(floor[i]);
        corners[i + 4] = scaled(floor[i] + glm::vec3(0.0f, height, 0.0f));
    }
    return corners;
}

} // namespace

std::vector<StudentTriangle> student_room() {
    std::vector<StudentTriangle> room;
    const auto add = [&](const std::array<glm::vec3, 8>& corners, const char* names,
                         glm::vec3 colour) {
        StudentTriangle triangle;
        for (std::size_t i = 0; i < 3; ++i)
            triangle.corners[i] = corners[static_cast<std::size_t>(names[i] - 'A')];
        const auto& [v0, v1, v2] = triangle.corners;
        triangle.normal = glm::normalize(glm::cross(v2 - v0, v1 - v0));
        triangle.colour = colour;
        triangle.number = static_cast<int>(room.size());
        room.push_back(triangle);
    };
    const glm::vec3 red(0.75f, 0.15f, 0.15f), yellow(0.75f, 0.75f, 0.15f);
    const glm::vec3 green(0.15f, 0.75f, 0.15f), cyan(0.15f, 0.75f, 0.75f);
    const glm::vec3 blue(0.15f, 0.15f, 0.75f), purple(0.75f, 0.15f, 0.75f), white(0.75f);
    constexpr float l = 555.0f;
    const auto walls = corners_of({{{l, 0, 0}, {0, 0, 0}, {l, 0, l}, {0, 0, l}}}, l);
    for (const char* names : {"CBA", "CDB"})
        add(walls, names, green);
    for (const char* names : {"AEC", "CEG"})
        add(walls, names, purple);
    for (const char* names : {"FBD", "HFD"})
        add(walls, names, yellow);
    for (const char* names : {"EFG", "FHG"})
        add(walls, names, cyan);
    for (const char* names : {"GDC", "GHD"})
        add(walls, names, white);
    const auto add_block = [&](const std::array<glm::vec3, 8>& block, glm::vec3 colour) {
        for (const char* names :
             {"EBA", "EFB", "FDB", "FHD", "HCD", "HGC", "GEC", "EAC", "GFE", "GHF"})
            add(block, names, colour);
    };
    add_block(corners_of({{{290, 0, 114}, {130, 0, 65}, {240, 0, 272}, {82, 0, 225}}}, 165.0f),
              red);
    add_block(corners_of({{{423, 0, 247}, {265, 0, 296}, {472, 0, 406}, {314, 0, 456}}}, 330.0f),
              blue);
    return room;
}

} // namespace rasterwalk::test
