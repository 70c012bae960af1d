#include "camera.h"
#include <cmath>

using glm::vec3;

vec3 cameraPos(0, 0, -3.001f);
glm::mat3 cameraRot(1.0f);
float yaw = 0;
float focalLength = SCREEN_HEIGHT;

void SetYaw(float angle)
{
    yaw = angle;
    vec3 right(std::cos(yaw), 0, -std::sin(yaw));
    vec3 down(0, 1, 0);
    vec3 forward(std::sin(yaw), 0, std::cos(yaw));
    cameraRot = glm::mat3(right, down, forward);
}

vec3 ToCameraSpace(const vec3& world)
{
    vec3 d = world - cameraPos;
    return vec3(glm::dot(d, cameraRot[0]), glm::dot(d, cameraRot[1]), glm::dot(d, cameraRot[2]));
}

// round to the nearest pixel
void VertexShader(const vec3& v, Pixel& p)
{
    vec3 c = ToCameraSpace(v);
    p.zinv = 1.0f / c.z;
    p.x = std::floor(focalLength * c.x * p.zinv + SCREEN_WIDTH / 2 + 0.5f);
    p.y = std::floor(focalLength * c.y * p.zinv + SCREEN_HEIGHT / 2 + 0.5f);
    p.pos = v * p.zinv;
}
