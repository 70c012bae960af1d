#include "globals.h"

using glm::vec3;

vec3 cameraPos(0, 0, -3.001f);
glm::mat3 R(1.0f);
float yaw = 0;
float focalLength = 500;

void MoveCamera(const Uint8* keys)
{
    vec3 forward(R[2][0], R[2][1], R[2][2]);

    if (keys[SDLK_UP])
        cameraPos += 0.1f * forward;
    if (keys[SDLK_DOWN])
        cameraPos -= 0.1f * forward;
    if (keys[SDLK_LEFT])
        yaw -= 0.05f;
    if (keys[SDLK_RIGHT])
        yaw += 0.05f;

    R[0] = vec3(glm::cos(yaw), 0, -glm::sin(yaw));
    R[1] = vec3(0, 1, 0);
    R[2] = vec3(glm::sin(yaw), 0, glm::cos(yaw));
}

vec3 CameraSpace(const vec3& v)
{
    return R * (v - cameraPos);
}

void VertexShader(const Vertex& v, Pixel& p)
{
    vec3 pos = CameraSpace(v.position);
    p.zinv = 1 / pos.z;
    p.x = int(focalLength * pos.x / pos.z + SCREEN_WIDTH / 2);
    p.y = int(focalLength * pos.y / pos.z + SCREEN_HEIGHT / 2);
    p.pos3d = v.position / pos.z;
}
