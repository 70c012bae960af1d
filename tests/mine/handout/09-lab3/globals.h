#ifndef GLOBALS_H
#define GLOBALS_H

#include <vector>
#include <glm/glm.hpp>
#include <SDL.h>
#include "TestModel.h"

const int SCREEN_WIDTH = 500;
const int SCREEN_HEIGHT = 500;

struct Pixel
{
    int x;
    int y;
    float zinv;
    glm::vec3 pos3d; // divided by z
};

struct Vertex
{
    glm::vec3 position;
};

// main.cpp
extern SDL_Surface* screen;
extern std::vector<Triangle> triangles;
extern glm::vec3 lightPos;
extern glm::vec3 lightPower;
extern glm::vec3 indirectLightPowerPerArea;

// camera.cpp
extern glm::vec3 cameraPos;
extern glm::mat3 R;
extern float yaw;
void MoveCamera(const Uint8* keys);
glm::vec3 CameraSpace(const glm::vec3& v);
void VertexShader(const Vertex& v, Pixel& p);

// polygon.cpp
void ClearDepthBuffer();
void DrawPolygon(const std::vector<Vertex>& vertices, glm::vec3 normal, glm::vec3 reflectance);

#endif
