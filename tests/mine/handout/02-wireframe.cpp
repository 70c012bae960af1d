// Rasterizer, wireframe so far
#include <cmath>
#include <iostream>
#include <vector>
#include <glm/glm.hpp>
#include "SDL2auxiliary.h"
#include "TestModel.h"

using namespace std;
using glm::vec3;
using glm::ivec2;
using glm::vec2;

const int SCREEN_WIDTH = 640;
const int SCREEN_HEIGHT = 480;

SDL2Aux* sdlAux;
vector<Triangle> triangles;
vec3 cameraPos(0, 0, -3.001f);
float focalLength = SCREEN_HEIGHT;
glm::mat3 R(1.0f);
float yaw = 0.0f;

void VertexShader(const vec3& v, ivec2& p) {
  vec3 q = (v - cameraPos) * R;
  p.x = int(focalLength * q.x / q.z) + SCREEN_WIDTH / 2;
  p.y = int(focalLength * q.y / q.z) + SCREEN_HEIGHT / 2;
}

void Interpolate(ivec2 a, ivec2 b, vector<ivec2>& result) {
  int N = result.size();
  ivec2 step = (b - a) / glm::max(N - 1, 1);
  ivec2 current = a;
  for (int i = 0; i < N; ++i) {
    result[i] = current;
    current += step;
  }
}

void DrawLine(ivec2 a, ivec2 b, vec3 color) {
  ivec2 delta = glm::abs(a - b);
  int pixels = glm::max(delta.x, delta.y) + 1;
  vector<ivec2> line(pixels);
  Interpolate(a, b, line);
  for (const ivec2& p : line) {
    if (p.x >= 0 && p.x < SCREEN_WIDTH && p.y >= 0 && p.y < SCREEN_HEIGHT)
      sdlAux->putPixel(p.x, p.y, color);
  }
}

void DrawPolygonEdges(const vector<vec3>& vertices) {
  int V = vertices.size();

  // not with anything behind the camera
  for (int i = 0; i < V; ++i)
    if (((vertices[i] - cameraPos) * R).z < 0.1f)
      return;

  vector<ivec2> projectedVertices(V);
  for (int i = 0; i < V; ++i)
    VertexShader(vertices[i], projectedVertices[i]);

  for (int i = 0; i < V; ++i) {
    int j = (i + 1) % V;
    DrawLine(projectedVertices[i], projectedVertices[j], vec3(1, 1, 1));
  }
}

void Update() {
  const Uint8* keys = SDL_GetKeyboardState(NULL);
  if (keys[SDL_SCANCODE_UP]) cameraPos += R[2] * 0.02f;
  if (keys[SDL_SCANCODE_DOWN]) cameraPos -= R[2] * 0.02f;
  if (keys[SDL_SCANCODE_LEFT]) yaw -= 0.02f;
  if (keys[SDL_SCANCODE_RIGHT]) yaw += 0.02f;
  R = glm::mat3(cos(yaw), 0, -sin(yaw), 0, 1, 0, sin(yaw), 0, cos(yaw));
}

void Draw() {
  sdlAux->clearPixels();
  for (size_t i = 0; i < triangles.size(); ++i) {
    vector<vec3> vertices(3);
    vertices[0] = triangles[i].v0;
    vertices[1] = triangles[i].v1;
    vertices[2] = triangles[i].v2;
    DrawPolygonEdges(vertices);
  }
  sdlAux->render();
}

int main(int argc, char* argv[]) {
  sdlAux = new SDL2Aux(SCREEN_WIDTH, SCREEN_HEIGHT);
  LoadTestModel(triangles);
  while (sdlAux->noQuitMessage()) {
    Update();
    Draw();
  }
  sdlAux->saveBMP("screenshot.bmp");
  return 0;
}
