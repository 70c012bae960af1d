#ifndef PIXEL_H
#define PIXEL_H

#include <glm/glm.hpp>

// What is interpolated. x and y are floats here so that a Pixel can be added
// and scaled as a whole; they are whole numbers wherever a Pixel is stored.
struct Pixel
{
    float x = 0;
    float y = 0;
    float zinv = 0;
    glm::vec3 pos;          // world position * zinv
};

inline Pixel operator+(Pixel a, const Pixel& b)
{
    a.x += b.x;
    a.y += b.y;
    a.zinv += b.zinv;
    a.pos += b.pos;
    return a;
}

inline Pixel operator*(Pixel a, float s)
{
    a.x *= s;
    a.y *= s;
    a.zinv *= s;
    a.pos *= s;
    return a;
}

#endif
