#include <iostream>
#include <vector>
#include <stdint.h>
#include <glm/glm.hpp>
#include <SDL.h>
#include "SDLauxiliary.h"
#include "TestModelH.h"

using namespace std;
using glm::ivec2;
using glm::mat4;
using glm::vec3;
using glm::vec4;

SDL_Event event;

#define SCREEN_WIDTH 320
#define SCREEN_HEIGHT 320
#define FULLSCREEN_MODE false

struct Pixel {
  int x;
  int y;
  float zinv;
  vec3 pos3d;
};

struct Vertex {
  vec4 position;
};

/* state */
vector<Triangle> triangles;
float f = SCREEN_WIDTH;
vec4 cameraPos(0, 0, -3.001, 1);
mat4 R(1.0f);
float yaw = 0;

vec4 lightPos(0, -0.5, -0.7, 1);
vec3 lightColor = 14.0f * vec3(1, 1, 1);
vec3 indirectLight = 0.5f * vec3(1, 1, 1);

vec4 currentNormal;
vec3 currentReflectance;

float depthBuffer[SCREEN_HEIGHT][SCREEN_WIDTH];

bool Update();
void Draw(screen* screen);
void VertexShader(const Vertex& v, Pixel& p);
void PixelShader(screen* screen, const Pixel& p);
void Interpolate(Pixel a, Pixel b, vector<Pixel>& result);
void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels, vector<Pixel>& rightPixels);
void DrawPolygonRows(screen* screen, const vector<Pixel>& leftPixels, const vector<Pixel>& rightPixels);
void DrawPolygon(screen* screen, const vector<Vertex>& vertices);

int main(int argc, char* argv[]) {
  screen* screen = InitializeSDL(SCREEN_WIDTH, SCREEN_HEIGHT, FULLSCREEN_MODE);
  LoadTestModel(triangles);

  while (Update()) {
    Draw(screen);
    SDL_Renderframe(screen);
  }

  SDL_SaveImage(screen, "screenshot.bmp");
  KillSDL(screen);
  return 0;
}

void Draw(screen* screen) {
  memset(screen->buffer, 0, screen->height * screen->width * sizeof(uint32_t));
  for (int y = 0; y < SCREEN_HEIGHT; ++y)
    for (int x = 0; x < SCREEN_WIDTH; ++x)
      depthBuffer[y][x] = 0.0f;

  for (uint32_t i = 0; i < triangles.size(); ++i) {
    currentNormal = triangles[i].normal;
    currentReflectance = triangles[i].color;
    vector<Vertex> vertices(3);
    vertices[0].position = triangles[i].v0;
    vertices[1].position = triangles[i].v1;
    vertices[2].position = triangles[i].v2;
    DrawPolygon(screen, vertices);
  }
}

void VertexShader(const Vertex& v, Pixel& p) {
  vec4 local = (v.position - cameraPos) * R;
  p.zinv = 1.0f / local.z;
  p.x = int(f * local.x * p.zinv + SCREEN_WIDTH / 2);
  p.y = int(f * local.y * p.zinv + SCREEN_HEIGHT / 2);
  // divide by z, so that it can be interpolated linearly
  p.pos3d = vec3(v.position) * p.zinv;
}

void PixelShader(screen* screen, const Pixel& p) {
  if (p.x < 0 || p.x >= SCREEN_WIDTH || p.y < 0 || p.y >= SCREEN_HEIGHT)
    return;
  if (p.zinv <= depthBuffer[p.y][p.x])
    return;
  depthBuffer[p.y][p.x] = p.zinv;

  // multiply by z again to get the real position
  vec3 pos = p.pos3d / p.zinv;
  vec4 r = vec4(lightPos.x - pos.x, lightPos.y - pos.y, lightPos.z - pos.z, 1);
  float r2 = dot(r, r);
  vec4 rHat = normalize(r);
  float cosine = dot(vec3(rHat), vec3(currentNormal));

  vec3 D = lightColor * max(cosine, 0.0f) / float(4 * M_PI * r2);
  vec3 color = currentReflectance * (D + indirectLight);
  PutPixelSDL(screen, p.x, p.y, color);
}

void Interpolate(Pixel a, Pixel b, vector<Pixel>& result) {
  int N = result.size();
  float steps = max(N - 1, 1);
  for (int i = 0; i < N; ++i) {
    float k = i / steps;
    result[i].x = round((1 - k) * a.x + k * b.x);
    result[i].y = round((1 - k) * a.y + k * b.y);
    result[i].zinv = (1 - k) * a.zinv + k * b.zinv;
    result[i].pos3d = (1 - k) * a.pos3d + k * b.pos3d;
  }
}

void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels, vector<Pixel>& rightPixels) {
  int yMin = vertexPixels[0].y;
  int yMax = vertexPixels[0].y;
  for (const Pixel& p : vertexPixels) {
    yMin = min(yMin, p.y);
    yMax = max(yMax, p.y);
  }
  int rows = yMax - yMin + 1;

  leftPixels.resize(rows);
  rightPixels.resize(rows);
  for (int i = 0; i < rows; ++i) {
    leftPixels[i].x = +numeric_limits<int>::max();
    rightPixels[i].x = -numeric_limits<int>::max();
  }

  for (uint32_t i = 0; i < vertexPixels.size(); ++i) {
    Pixel a = vertexPixels[i];
    Pixel b = vertexPixels[(i + 1) % vertexPixels.size()];
    ivec2 delta = abs(ivec2(a.x - b.x, a.y - b.y));
    vector<Pixel> line(max(delta.x, delta.y) + 1);
    Interpolate(a, b, line);
    for (const Pixel& p : line) {
      int row = p.y - yMin;
      if (row < 0 || row >= rows) continue;
      if (p.x < leftPixels[row].x) leftPixels[row] = p;
      if (p.x > rightPixels[row].x) rightPixels[row] = p;
    }
  }
}

void DrawPolygonRows(screen* screen, const vector<Pixel>& leftPixels, const vector<Pixel>& rightPixels) {
  for (uint32_t i = 0; i < leftPixels.size(); ++i) {
    if (leftPixels[i].x > rightPixels[i].x) continue;
    vector<Pixel> line(rightPixels[i].x - leftPixels[i].x + 1);
    Interpolate(leftPixels[i], rightPixels[i], line);
    for (const Pixel& p : line) PixelShader(screen, p);
  }
}

void DrawPolygon(screen* screen, const vector<Vertex>& vertices) {
  for (const Vertex& v : vertices)
    if (((v.position - cameraPos) * R).z < 0.25f) return;

  vector<Pixel> vertexPixels(vertices.size());
  for (uint32_t i = 0; i < vertices.size(); ++i) VertexShader(vertices[i], vertexPixels[i]);

  vector<Pixel> leftPixels;
  vector<Pixel> rightPixels;
  ComputePolygonRows(vertexPixels, leftPixels, rightPixels);
  DrawPolygonRows(screen, leftPixels, rightPixels);
}

bool Update() {
  while (SDL_PollEvent(&event)) {
    if (event.type == SDL_QUIT) return false;
    if (event.type == SDL_KEYDOWN) {
      switch (event.key.keysym.sym) {
        case SDLK_UP: cameraPos += 0.1f * R[2]; break;
        case SDLK_DOWN: cameraPos -= 0.1f * R[2]; break;
        case SDLK_LEFT: yaw -= 0.1f; break;
        case SDLK_RIGHT: yaw += 0.1f; break;
        case SDLK_w: lightPos.z += 0.1f; break;
        case SDLK_s: lightPos.z -= 0.1f; break;
        case SDLK_a: lightPos.x -= 0.1f; break;
        case SDLK_d: lightPos.x += 0.1f; break;
        case SDLK_ESCAPE: return false;
      }
      R[0] = vec4(cos(yaw), 0, -sin(yaw), 0);
      R[2] = vec4(sin(yaw), 0, cos(yaw), 0);
    }
  }
  return true;
}
