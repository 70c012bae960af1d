#include <iostream>
#include <vector>
#include <stdint.h>
#include <glm/glm.hpp>
#include <SDL.h>
#include "SDLauxiliary.h"
#include "TestModelH.h"
#include "lines.h"

using namespace std;
using glm::vec3;
using glm::vec4;
using glm::mat4;
using glm::ivec2;

#define SCREEN_WIDTH 320
#define SCREEN_HEIGHT 256
#define FULLSCREEN_MODE false

/* GLOBAL VARIABLES */
vector<Triangle> triangles;
vec4 cameraPos(0, 0, -3.001, 1);
float focalLength = SCREEN_HEIGHT;
float yaw = 0;

/* FUNCTIONS */
bool Update();
void Draw(screen *screen);
void VertexShader(const vec4 &v, ivec2 &p);
void DrawPolygonEdges(screen *screen, const vector<vec4> &vertices, vec3 colour);
void TransformationMatrix(mat4 &M);

int main(int argc, char *argv[])
{
  screen *screen = InitializeSDL(SCREEN_WIDTH, SCREEN_HEIGHT, FULLSCREEN_MODE);
  LoadTestModel(triangles);

  while (Update()) {
    Draw(screen);
    SDL_Renderframe(screen);
  }

  SDL_SaveImage(screen, "screenshot.bmp");
  KillSDL(screen);
  return 0;
}

void Draw(screen *screen)
{
  memset(screen->buffer, 0, screen->height * screen->width * sizeof(uint32_t));

  for (uint32_t i = 0; i < triangles.size(); i++) {
    vector<vec4> vertices(3);
    vertices[0] = triangles[i].v0;
    vertices[1] = triangles[i].v1;
    vertices[2] = triangles[i].v2;
    DrawPolygonEdges(screen, vertices, triangles[i].color);
  }
}

/* From world to camera: first move, then turn. Columns are what the unit vectors become. */
void TransformationMatrix(mat4 &M)
{
  mat4 move(1.0f);
  move[3] = vec4(-cameraPos.x, -cameraPos.y, -cameraPos.z, 1);

  mat4 turn(1.0f);
  turn[0] = vec4(cos(yaw), 0, sin(yaw), 0);
  turn[1] = vec4(0, 1, 0, 0);
  turn[2] = vec4(-sin(yaw), 0, cos(yaw), 0);
  turn[3] = vec4(0, 0, 0, 1);

  M = turn * move;
}

void VertexShader(const vec4 &v, ivec2 &p)
{
  mat4 M;
  TransformationMatrix(M);
  vec4 c = M * v;
  p.x = focalLength * c.x / c.z + SCREEN_WIDTH / 2;
  p.y = focalLength * c.y / c.z + SCREEN_HEIGHT / 2;
}

void DrawPolygonEdges(screen *screen, const vector<vec4> &vertices, vec3 colour)
{
  int V = vertices.size();

  mat4 M;
  TransformationMatrix(M);
  for (int i = 0; i < V; i++)
    if ((M * vertices[i]).z < 0.1f)
      return;

  vector<ivec2> projected(V);
  for (int i = 0; i < V; i++)
    VertexShader(vertices[i], projected[i]);

  for (int i = 0; i < V; i++)
    DrawLine(screen, projected[i], projected[(i + 1) % V], colour);
}

bool Update()
{
  static int t = SDL_GetTicks();
  int t2 = SDL_GetTicks();
  float dt = float(t2 - t);
  t = t2;
  std::cout << "Render time: " << dt << " ms." << std::endl;

  SDL_Event e;
  while (SDL_PollEvent(&e)) {
    if (e.type == SDL_QUIT)
      return false;
    if (e.type == SDL_KEYDOWN) {
      switch (e.key.keysym.sym) {
      case SDLK_UP:
        cameraPos.x += 0.1f * sin(yaw);
        cameraPos.z += 0.1f * cos(yaw);
        break;
      case SDLK_DOWN:
        cameraPos.x -= 0.1f * sin(yaw);
        cameraPos.z -= 0.1f * cos(yaw);
        break;
      case SDLK_LEFT:
        yaw -= 0.1f;
        break;
      case SDLK_RIGHT:
        yaw += 0.1f;
        break;
      case SDLK_ESCAPE:
        return false;
      }
    }
  }
  return true;
}
