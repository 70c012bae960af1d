// Mistakes that the laboratory does not know. Each shows clearly, and none looks like a different
// lamp or camera.

#include "laboratory/student_pictures.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rasterwalk::test {

namespace {

using Program = StudentProgram;
using Room = std::vector<StudentTriangle>;

constexpr int short_block = 10, tall_block = 20; // the first triangle of each, of ten

std::size_t place(const Image& image, int x, int y) {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                static_cast<std::size_t>(x));
}

glm::vec3 colour_of(const Image& image, int x, int y) {
    const std::uint8_t* const p = image.rgba.data() + place(image, x, y);
    return glm::vec3(p[0], p[1], p[2]);
}

/// The colour at a place; black outside the picture.
glm::vec3 colour_or_black(const Image& image, int x, int y) {
    const bool is_inside = x >= 0 && y >= 0 && x < image.width && y < image.height;
    return is_inside ? colour_of(image, x, y) : glm::vec3(0.0f);
}

/// The direction from a point to the lamp, and the distance.
struct ToLamp {
    glm::vec3 unit;
    float length, cosine;
};
ToLamp to_lamp(const Program& program, const StudentPoint& point) {
    const glm::vec3 r = program.lamp - point.position;
    const float length = glm::length(r);
    return {r / length, length, glm::dot(r / length, point.normal)};
}

/// A pseudo-random number for each pixel.
std::uint_fast32_t scattered(int x, int y) {
    return std::mt19937(static_cast<std::uint32_t>(x + 4096 * y))();
}

constexpr float four_pi = 12.5663706f;

void move_towards(StudentTriangle& triangle, glm::vec3 middle, float factor) {
    for (glm::vec3& corner : triangle.corners)
        corner = middle + factor * (corner - middle);
}

struct Unknown {
    const char* name;
    const char* words;
    void (*change)(Program&);
};

void change_room(Program& p, void (*change)(Room&)) {
    p.change_room = change;
}
using Lit = glm::vec3(const Program&, glm::vec3, const StudentPoint&);
void change_light(Program& p, Lit* change) {
    p.change_light = change;
}
/// The new colour of a pixel, from the old picture; it is clamped to 0..255.
using Repainted = glm::vec3(const Image& old, int x, int y);
void change_picture(Program& p, Repainted* change) {
    p.change_picture = [change](Image& image) {
        const Image old = image;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const glm::vec3 colour = glm::clamp(change(old, x, y), 0.0f, 255.0f);
                for (int i = 0; i < 3; ++i)
                    image.rgba[place(image, x, y) + static_cast<std::size_t>(i)] =
                        static_cast<std::uint8_t>(colour[i]);
            }
        }
    };
}

// What is drawn.
const Unknown of_the_room[] = {
    {"a triangle is missing", "depth",
     [](Program& p) { change_room(p, [](Room& room) { room.erase(room.begin() + 8); }); }},
    {"the tall block is missing", "pixel power_14",
     [](Program& p) { change_room(p, [](Room& room) { room.resize(tall_block); }); }},
    {"the back wall is pink", "pixel",
     [](Program& p) {
         change_room(p, [](Room& room) { room[8].colour = room[9].colour = {0.9f, 0.4f, 0.6f}; });
     }},
    {"a corner of a block has moved", "depth",
     [](Program& p) {
         change_room(p, [](Room& room) {
             const glm::vec3 corner = room[short_block].corners[0];
             for (StudentTriangle& triangle : room) {
                 for (glm::vec3& v : triangle.corners)
                     v += v == corner ? glm::vec3(0.25f, -0.3f, 0.0f) : glm::vec3(0.0f);
             }
         });
     }},
    {"the right wall's normal is flipped", "pixel power_14",
     [](Program& p) {
         change_room(p, [](Room& room) {
             for (const std::size_t i : {4u, 5u})
                 room[i].normal = -room[i].normal;
         });
     }},
    {"triangles are shrunk", "depth",
     [](Program& p) {
         change_room(p, [](Room& room) {
             for (StudentTriangle& t : room)
                 move_towards(t, (t.corners[0] + t.corners[1] + t.corners[2]) / 3.0f, 0.96f);
         });
     }},
    {"a block is too large", "fill",
     [](Program& p) {
         change_room(p, [](Room& room) {
             for (std::size_t i = short_block; i < tall_block; ++i)
                 move_towards(room[i], {0.33f, 1.0f, -0.4f}, 1.3f);
         });
     }},
    {"the blocks have exchanged their colours", "depth sum_cut",
     [](Program& p) {
         change_room(p, [](Room& room) {
             for (std::size_t i = short_block; i < tall_block; ++i)
                 std::swap(room[i].colour, room[i + 10].colour);
         });
     }},
    {"the room is too narrow", "pixel",
     [](Program& p) {
         change_room(p, [](Room& room) {
             for (StudentTriangle& triangle : room) {
                 for (glm::vec3& v : triangle.corners)
                     v.x *= 0.8f;
             }
         });
     }},
    {"the floor is drawn last, over everything", "depth",
     [](Program& p) {
         change_room(p,
                     [](Room& room) { std::rotate(room.begin(), room.begin() + 2, room.end()); });
         p.change_depth = [](float zinv, int triangle) { return triangle < 2 ? 10.0f : zinv; };
     }},
    {"depth is a whole number of tenths", "depth",
     [](Program& p) { p.change_depth = [](float zinv, int) { return std::floor(zinv * 10.0f); }; }},
    {"half of each colour is mixed in", "depth",
     [](Program& p) {
         p.change_mix = [](glm::vec3 fresh, glm::vec3 old) { return 0.5f * (fresh + old); };
     }},
};

// How it is lit.
const Unknown of_the_light[] = {
    {"fog", "pixel power_14",
     [](Program& p) {
         change_light(p, [](const Program&, glm::vec3 lit, const StudentPoint& point) {
             const float clear = std::exp(-0.6f * (1.0f / point.zinv - 2.0f));
             return glm::mix(glm::vec3(0.6f), lit, clear);
         });
     }},
    {"both sides are lit", "pixel power_14",
     [](Program& p) {
         change_light(p, [](const Program& of, glm::vec3 lit, const StudentPoint& point) {
             const glm::vec3 back = student_lamp_light(of, point.position, -point.normal);
             return lit + point.colour * back;
         });
     }},
    {"no max on red", "pixel power_14",
     [](Program& p) {
         change_light(p, [](const Program& of, glm::vec3 lit, const StudentPoint& point) {
             const glm::vec3 back = student_lamp_light(of, point.position, -point.normal);
             return lit - glm::vec3(4.0f * back.r, 0.0f, 0.0f);
         });
     }},
    {"a highlight on everything", "pixel",
     [](Program& p) {
         change_light(p, [](const Program& of, glm::vec3 lit, const StudentPoint& point) {
             const glm::vec3 eye = glm::normalize(of.camera - point.position);
             const glm::vec3 half = glm::normalize(eye + to_lamp(of, point).unit);
             return lit + std::pow(std::max(glm::dot(half, point.normal), 0.0f), 20.0f);
         });
     }},
    {"light falls off like fog", "pixel power_30",
     [](Program& p) {
         change_light(p, [](const Program& of, glm::vec3, const StudentPoint& point) {
             const ToLamp lamp = to_lamp(of, point);
             const float r = lamp.length;
             return point.colour *
                    (of.power * std::max(lamp.cosine, 0.0f) * std::exp(-2.0f * r) / (1.0f + r * r) +
                     of.indirect);
         });
     }},
    {"the indirect light differs from face to face", "pixel power_14",
     [](Program& p) {
         change_light(p, [](const Program&, glm::vec3 lit, const StudentPoint& point) {
             return lit + point.colour * (0.1f * static_cast<float>(point.triangle % 5) - 0.2f);
         });
     }},
    {"light of the first corner for the whole triangle", "pixel power_14",
     [](Program& p) {
         change_light(p, [](const Program& of, glm::vec3, const StudentPoint& point) {
             static const Room room = student_room();
             const auto& triangle = room[static_cast<std::size_t>(point.triangle)];
             return point.colour *
                    (student_lamp_light(of, triangle.corners[0], point.normal) + of.indirect);
         });
     }},
    {"light on a coarse grid", "pixel power_14",
     [](Program& p) {
         change_light(p, [](const Program& of, glm::vec3, const StudentPoint& point) {
             const glm::vec3 cell = glm::floor(point.position / 0.4f) * 0.4f + 0.2f;
             return point.colour * (student_lamp_light(of, cell, point.normal) + of.indirect);
         });
     }},
    {"the cosine to the fourth power", "pixel power_14",
     [](Program& p) {
         change_light(p, [](const Program& of, glm::vec3, const StudentPoint& point) {
             const float c = std::max(to_lamp(of, point).cosine, 0.0f);
             return point.colour *
                    (student_lamp_light(of, point.position, point.normal) * c * c * c +
                     of.indirect);
         });
     }},
    {"the cosine is halved and lifted", "pixel power_14",
     [](Program& p) {
         change_light(p, [](const Program& of, glm::vec3, const StudentPoint& point) {
             const ToLamp lamp = to_lamp(of, point);
             const float c = 0.5f * lamp.cosine + 0.5f;
             return point.colour *
                    (of.power * c * c / (four_pi * lamp.length * lamp.length) + of.indirect);
         });
     }},
    {"a second lamp", "pixel power_14",
     [](Program& p) {
         change_light(p, [](const Program& of, glm::vec3 lit, const StudentPoint& point) {
             Program other = of;
             other.lamp = {0.7f, 0.6f, 0.2f};
             return lit + point.colour * student_lamp_light(other, point.position, point.normal);
         });
     }},
    {"the left half lies in the dark", "pixel power_14",
     [](Program& p) {
         change_light(p, [](const Program& of, glm::vec3 lit, const StudentPoint& point) {
             return point.position.x < 0.0f ? point.colour * of.indirect : lit;
         });
     }},
    {"a pattern on the floor", "pixel",
     [](Program& p) {
         change_light(p, [](const Program&, glm::vec3 lit, const StudentPoint& point) {
             const glm::ivec3 cell(glm::floor(point.position * 4.0f));
             return point.triangle < 2 && (cell.x + cell.z) % 2 == 0 ? 0.3f * lit : lit;
         });
     }},
};

// Changes to the finished picture.
const Unknown of_the_picture[] = {
    {"a checkerboard of pixels is dropped", "depth",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             return (x + y) % 2 == 0 ? glm::vec3(0.0f) : colour_of(old, x, y);
         });
     }},
    {"every seventh row is missing", "depth",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             return y % 7 == 3 ? glm::vec3(0.0f) : colour_of(old, x, y);
         });
     }},
    {"blurred", "pixel power_14",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             glm::vec3 sum(0.0f);
             for (int i = 0; i < 9; ++i)
                 sum += colour_or_black(old, x + i % 3 - 1, y + i / 3 - 1);
             return sum / 9.0f;
         });
     }},
    {"noise", "pixel power_14",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             return colour_of(old, x, y) + (static_cast<float>(scattered(x, y) % 41) - 20.0f);
         });
     }},
    {"contrast stretched", "pixel power_14",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             return 1.8f * (colour_of(old, x, y) - 60.0f);
         });
     }},
    {"eight levels", "pixel power_14",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             return glm::floor(colour_of(old, x, y) / 32.0f) * 32.0f;
         });
     }},
    {"green and blue swapped", "depth",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             const glm::vec3 c = colour_of(old, x, y);
             return glm::vec3(c.r, c.b, c.g);
         });
     }},
    {"the hue is turned", "pixel power_14",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             const glm::vec3 c = colour_of(old, x, y);
             return glm::vec3(c.g, c.b, c.r);
         });
     }},
    {"grey", "pixel power_14",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             const glm::vec3 c = colour_of(old, x, y);
             return glm::vec3((c.r + c.g + c.b) / 3.0f);
         });
     }},
    {"a negative", "depth",
     [](Program& p) {
         change_picture(
             p, [](const Image& old, int x, int y) { return 255.0f - colour_of(old, x, y); });
     }},
    {"the lower half is mirrored", "depth",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             return colour_of(old, 2 * y < old.height ? x : old.width - 1 - x, y);
         });
     }},
    {"tiles are shuffled", "pixel",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             const int tile = 3 * (x / 50) + 5 * (y / 50);
             return colour_of(old, (x + 50 * tile) % old.width, y);
         });
     }},
    {"rows are shifted more and more", "depth",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             return colour_of(old, (x + y / 8) % old.width, y);
         });
     }},
    {"a frame is painted over", "pixel power_14",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             const int border = std::min({x, y, old.width - 1 - x, old.height - 1 - y});
             return border < 6 ? glm::vec3(255.0f) : colour_of(old, x, y);
         });
     }},
    {"a block of noise, like text", "depth",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             const bool is_block = x > 20 && x < 120 && y > 30 && y < 55;
             return is_block && scattered(x, y) % 2 == 0 ? glm::vec3(255.0f) : colour_of(old, x, y);
         });
     }},
    {"a ghost of the last frame", "pixel power_14",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             return 0.6f * colour_of(old, x, y) + 0.4f * colour_or_black(old, x + 12, y + 3);
         });
     }},
    {"darker to the corners", "depth",
     [](Program& p) {
         change_picture(p, [](const Image& old, int x, int y) {
             const float across = 2.0f * static_cast<float>(x) / 200.0f - 1.0f;
             const float down = 2.0f * static_cast<float>(y) / 200.0f - 1.0f;
             return colour_of(old, x, y) * (1.0f - 0.35f * (across * across + down * down));
         });
     }},
};

} // namespace

std::vector<BroughtPicture> pictures_of_unknown_mistakes() {
    std::vector<BroughtPicture> pictures;
    const auto add = [&](const Unknown& unknown) {
        BroughtPicture picture;
        picture.name = unknown.name;
        picture.kind = StudentKind::unknown;
        apply_words(unknown.words, picture.program);
        unknown.change(picture.program);
        pictures.push_back(std::move(picture));
    };
    std::for_each(std::begin(of_the_room), std::end(of_the_room), add);
    std::for_each(std::begin(of_the_light), std::end(of_the_light), add);
    std::for_each(std::begin(of_the_picture), std::end(of_the_picture), add);
    return pictures;
}

} // namespace rasterwalk::test
