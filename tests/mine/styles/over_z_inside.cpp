// Computer graphics, lab 3
// The pixels carry real positions; all the multiplying by 1/z is done in Interpolate.
#include <iostream>
#include <vector>
#include <glm/glm.hpp>
#include <SDL.h>
#include "SDLauxiliary.h"
#include "TestModel.h"
using namespace std;
using namespace glm;

const int W = 500, H = 500;
SDL_Surface* screen;
vector<Triangle> triangles;

vec3 camera(0, 0, -3.001);
mat3 rotation(1.0f);
float yaw = 0;
float f = 500;

vec3 light(0, -0.5, -0.7);
vec3 power = vec3(14, 14, 14);
vec3 ambient = vec3(0.5, 0.5, 0.5);

struct Pixel
{
  int x, y;
  float zinv;
  vec3 pos;
};

struct Surface
{
  vec3 normal;
  vec3 reflectance;
};

typedef vector< vector<float> > Buffer;

void VertexShader(vec3 v, Pixel& p)
{
  vec3 local = (v - camera) * rotation;
  p.zinv = 1 / local.z;
  p.x = int(f * local.x / local.z) + W / 2;
  p.y = int(f * local.y / local.z) + H / 2;
  p.pos = v;
}

void Interpolate(Pixel a, Pixel b, vector<Pixel>& result)
{
  int N = result.size();
  int last = N > 1 ? N - 1 : 1;
  // positions are not linear on the screen, but position / z is
  vec3 qa = a.pos * a.zinv;
  vec3 qb = b.pos * b.zinv;
  for (int i = 0; i < N; i++)
  {
    result[i].x = int(a.x + float(b.x - a.x) * i / last);
    result[i].y = int(a.y + float(b.y - a.y) * i / last);
    float t = float(i) / last;
    result[i].zinv = (1 - t) * a.zinv + t * b.zinv;
    result[i].pos = ((1 - t) * qa + t * qb) / result[i].zinv;
  }
}

void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& left, vector<Pixel>& right)
{
  int ymin = vertexPixels[0].y;
  int ymax = vertexPixels[0].y;
  for (size_t i = 1; i < vertexPixels.size(); i++)
  {
    if (vertexPixels[i].y < ymin) ymin = vertexPixels[i].y;
    if (vertexPixels[i].y > ymax) ymax = vertexPixels[i].y;
  }

  left.clear();
  right.clear();
  for (int y = ymin; y <= ymax; y++)
  {
    Pixel p;
    p.y = y;
    p.zinv = 0;
    p.x = numeric_limits<int>::max();
    left.push_back(p);
    p.x = -numeric_limits<int>::max();
    right.push_back(p);
  }

  for (size_t i = 0; i < vertexPixels.size(); i++)
  {
    Pixel start = vertexPixels[i];
    Pixel end = vertexPixels[(i + 1) % vertexPixels.size()];
    ivec2 delta = abs(ivec2(start.x - end.x, start.y - end.y));
    vector<Pixel> edge(std::max(delta.x, delta.y) + 1);
    Interpolate(start, end, edge);
    for (size_t k = 0; k < edge.size(); k++)
    {
      int row = edge[k].y - ymin;
      if (row < 0 || row >= (int)left.size()) continue;
      if (edge[k].x < left[row].x) left[row] = edge[k];
      if (edge[k].x > right[row].x) right[row] = edge[k];
    }
  }
}

vec3 Shade(vec3 point, const Surface& surface)
{
  vec3 r = light - point;
  float rr = dot(r, r);
  float k = std::max(dot(normalize(r), surface.normal), 0.0f);
  vec3 direct = power * k / float(4 * 3.1415926 * rr);
  return surface.reflectance * (direct + ambient);
}

void PixelShader(const Pixel& p, const Surface& surface, Buffer& depth)
{
  bool visible = p.x >= 0 && p.x < W && p.y >= 0 && p.y < H;
  if (visible && p.zinv > depth[p.y][p.x])
  {
    depth[p.y][p.x] = p.zinv;
    PutPixelSDL(screen, p.x, p.y, Shade(p.pos, surface));
  }
}

void DrawPolygonRows(const vector<Pixel>& left, const vector<Pixel>& right, const Surface& surface, Buffer& depth)
{
  for (size_t i = 0; i < left.size(); i++)
  {
    if (left[i].x > right[i].x) continue;
    vector<Pixel> line(right[i].x - left[i].x + 1);
    Interpolate(left[i], right[i], line);
    for (size_t k = 0; k < line.size(); k++)
      PixelShader(line[k], surface, depth);
  }
}

void DrawPolygon(const vector<vec3>& vertices, const Surface& surface, Buffer& depth)
{
  vector<Pixel> vertexPixels(vertices.size());
  for (size_t i = 0; i < vertices.size(); i++)
  {
    VertexShader(vertices[i], vertexPixels[i]);
    // behind the camera, or so near that the triangle would be huge
    if (vertexPixels[i].zinv < 0 || vertexPixels[i].zinv > 4) return;
  }
  vector<Pixel> left, right;
  ComputePolygonRows(vertexPixels, left, right);
  DrawPolygonRows(left, right, surface, depth);
}

void Draw()
{
  SDL_FillRect(screen, 0, 0);
  if (SDL_MUSTLOCK(screen)) SDL_LockSurface(screen);

  Buffer depth(H, vector<float>(W, 0));
  for (size_t i = 0; i < triangles.size(); i++)
  {
    vector<vec3> vertices;
    vertices.push_back(triangles[i].v0);
    vertices.push_back(triangles[i].v1);
    vertices.push_back(triangles[i].v2);
    Surface surface = {triangles[i].normal, triangles[i].color};
    DrawPolygon(vertices, surface, depth);
  }

  if (SDL_MUSTLOCK(screen)) SDL_UnlockSurface(screen);
  SDL_UpdateRect(screen, 0, 0, 0, 0);
}

void Update()
{
  Uint8* keys = SDL_GetKeyState(0);
  vec3 right = rotation[0];
  vec3 forward = rotation[2];
  float d = 0.05;

  if (keys[SDLK_UP])    camera += d * forward;
  if (keys[SDLK_DOWN])  camera -= d * forward;
  if (keys[SDLK_a])     camera -= d * right;
  if (keys[SDLK_d])     camera += d * right;
  if (keys[SDLK_LEFT])  yaw -= d;
  if (keys[SDLK_RIGHT]) yaw += d;

  if (keys[SDLK_i]) light.z += d;
  if (keys[SDLK_k]) light.z -= d;
  if (keys[SDLK_j]) light.x -= d;
  if (keys[SDLK_l]) light.x += d;
  if (keys[SDLK_u]) light.y -= d;
  if (keys[SDLK_o]) light.y += d;

  rotation = mat3(cos(yaw), 0, -sin(yaw),
                  0,        1, 0,
                  sin(yaw), 0, cos(yaw));
}

int main(int argc, char* argv[])
{
  LoadTestModel(triangles);
  screen = InitializeSDL(W, H);
  while (NoQuitMessageSDL())
  {
    Update();
    Draw();
  }
  SDL_SaveBMP(screen, "screenshot.bmp");
  return 0;
}
