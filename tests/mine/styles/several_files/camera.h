#ifndef CAMERA_H
#define CAMERA_H

#include <glm/glm.hpp>
#include "pixel.h"

const int SCREEN_WIDTH = 400;
const int SCREEN_HEIGHT = 400;

extern glm::vec3 cameraPos;
extern glm::mat3 cameraRot;
extern float yaw;
extern float focalLength;

void SetYaw(float angle);
glm::vec3 ToCameraSpace(const glm::vec3& world);
void VertexShader(const glm::vec3& v, Pixel& p);

#endif
