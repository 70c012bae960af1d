#include <iostream>
#include <glm/glm.hpp>
#include <SDL.h>
#include "SDLauxiliary.h"
#include "TestModelH.h"
#include <stdint.h>
#include <limits>

using namespace std;
using glm::vec3;
using glm::vec4;
using glm::mat4;

#define SCREEN_WIDTH 500
#define SCREEN_HEIGHT 500
#define FULLSCREEN_MODE false

struct Pixel {
  int x, y;
  float zinv;
  vec4 pos3d;
};

struct Vertex {
  vec4 position;
};

/* ----------------------------------------------------------------------------*/
/* GLOBALS                                                                     */
const float focal_length = SCREEN_WIDTH;
vec4 camera_position(0.0, 0.0, -3.001, 1.0);
mat4 R(1.0f);
float yaw = 0;

vec4 light_position(0.0, -0.5, -0.7, 1.0);
vec3 light_power = vec3(14.0f);
vec3 indirect_light = vec3(0.5f);

vector<Triangle> triangles;
float depth_buffer[SCREEN_HEIGHT][SCREEN_WIDTH];

/* ----------------------------------------------------------------------------*/
/* FUNCTIONS                                                                   */
bool Update();
void Draw(screen* screen);
void DrawPolygon(screen* screen, const vector<Vertex>& vertices, vec4 normal, vec3 reflectance);

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
  /* Clear buffers */
  memset(screen->buffer, 0, screen->height * screen->width * sizeof(uint32_t));
  memset(depth_buffer, 0, sizeof(depth_buffer));

  for (const Triangle& triangle : triangles) {
    vector<Vertex> vertices(3);
    vertices[0].position = triangle.v0;
    vertices[1].position = triangle.v1;
    vertices[2].position = triangle.v2;
    DrawPolygon(screen, vertices, triangle.normal, triangle.color);
  }
}

/* World space to camera space. Points have w = 1, so the difference is a direction. */
vec4 ToCamera(vec4 world) {
  return (world - camera_position) * R;
}

void VertexShader(const Vertex& v, Pixel& p) {
  vec4 c = ToCamera(v.position);
  p.zinv = 1 / c.z;
  p.x = int(focal_length * c.x / c.z + SCREEN_WIDTH / 2);
  p.y = int(focal_length * c.y / c.z + SCREEN_HEIGHT / 2);
  p.pos3d = v.position / c.z;
}

void Interpolate(Pixel a, Pixel b, vector<Pixel>& result) {
  int N = result.size();
  float steps = max(N - 1, 1);
  for (int i = 0; i < N; i++) {
    float t = i / steps;
    result[i].x = round(a.x + t * (b.x - a.x));
    result[i].y = round(a.y + t * (b.y - a.y));
    result[i].zinv = a.zinv + t * (b.zinv - a.zinv);
    result[i].pos3d = a.pos3d + t * (b.pos3d - a.pos3d);
  }
}

void ComputePolygonRows(const vector<Pixel>& vertex_pixels,
                        vector<Pixel>& left_pixels, vector<Pixel>& right_pixels) {
  int lowest = numeric_limits<int>::max();
  int highest = numeric_limits<int>::min();
  for (const Pixel& p : vertex_pixels) {
    lowest = min(lowest, p.y);
    highest = max(highest, p.y);
  }
  int rows = highest - lowest + 1;
  left_pixels.resize(rows);
  right_pixels.resize(rows);
  for (int i = 0; i < rows; i++) {
    left_pixels[i].x = numeric_limits<int>::max();
    right_pixels[i].x = numeric_limits<int>::min();
  }

  for (size_t i = 0; i < vertex_pixels.size(); i++) {
    size_t j = (i + 1) % vertex_pixels.size();
    const Pixel& a = vertex_pixels[i];
    const Pixel& b = vertex_pixels[j];
    int dx = abs(a.x - b.x);
    int dy = abs(a.y - b.y);
    vector<Pixel> edge(max(dx, dy) + 1);
    Interpolate(a, b, edge);
    for (const Pixel& p : edge) {
      int row = p.y - lowest;
      if (p.x < left_pixels[row].x) left_pixels[row] = p;
      if (p.x > right_pixels[row].x) right_pixels[row] = p;
    }
  }
}

vec3 DirectLight(vec4 position, vec4 normal) {
  vec3 r = vec3(light_position - position);
  vec3 n = vec3(normal);
  float distance = length(r);
  float cos_angle = dot(r / distance, n);
  if (cos_angle < 0) cos_angle = 0;
  float area = 4 * M_PI * distance * distance;
  return light_power * cos_angle / area;
}

void PixelShader(screen* screen, const Pixel& p, vec4 normal, vec3 reflectance) {
  if (p.x < 0 || p.y < 0 || p.x >= SCREEN_WIDTH || p.y >= SCREEN_HEIGHT) return;
  if (p.zinv <= depth_buffer[p.y][p.x]) return;
  depth_buffer[p.y][p.x] = p.zinv;

  vec4 position = p.pos3d / p.zinv;
  vec3 light = DirectLight(position, normal) + indirect_light;
  PutPixelSDL(screen, p.x, p.y, reflectance * light);
}

void DrawRows(screen* screen, const vector<Pixel>& left_pixels, const vector<Pixel>& right_pixels,
              vec4 normal, vec3 reflectance) {
  for (size_t i = 0; i < left_pixels.size(); i++) {
    int width = right_pixels[i].x - left_pixels[i].x + 1;
    vector<Pixel> row(width);
    Interpolate(left_pixels[i], right_pixels[i], row);
    for (const Pixel& p : row) PixelShader(screen, p, normal, reflectance);
  }
}

void DrawPolygon(screen* screen, const vector<Vertex>& vertices, vec4 normal, vec3 reflectance) {
  // leave out what is behind us
  for (const Vertex& v : vertices)
    if (ToCamera(v.position).z < 0.3f) return;

  vector<Pixel> vertex_pixels(vertices.size());
  for (size_t i = 0; i < vertices.size(); i++)
    VertexShader(vertices[i], vertex_pixels[i]);

  vector<Pixel> left_pixels, right_pixels;
  ComputePolygonRows(vertex_pixels, left_pixels, right_pixels);
  DrawRows(screen, left_pixels, right_pixels, normal, reflectance);
}

/* Keys move the camera (arrows) and the light (wasd qe) */
bool Update() {
  static int t = SDL_GetTicks();
  int t2 = SDL_GetTicks();
  float dt = float(t2 - t);
  t = t2;
  cout << "Render time: " << dt << " ms." << endl;

  vec4 right(R[0][0], R[0][1], R[0][2], 0);
  vec4 forward(R[2][0], R[2][1], R[2][2], 0);

  SDL_Event e;
  while (SDL_PollEvent(&e)) {
    if (e.type == SDL_QUIT) return false;
    if (e.type == SDL_KEYDOWN) {
      int key_code = e.key.keysym.sym;
      switch (key_code) {
        case SDLK_UP:    camera_position += 0.1f * forward; break;
        case SDLK_DOWN:  camera_position -= 0.1f * forward; break;
        case SDLK_LEFT:  yaw -= 0.1f; break;
        case SDLK_RIGHT: yaw += 0.1f; break;
        case SDLK_w:     light_position += 0.1f * forward; break;
        case SDLK_s:     light_position -= 0.1f * forward; break;
        case SDLK_a:     light_position -= 0.1f * right; break;
        case SDLK_d:     light_position += 0.1f * right; break;
        case SDLK_q:     light_position.y -= 0.1f; break;
        case SDLK_e:     light_position.y += 0.1f; break;
        case SDLK_ESCAPE: return false;
      }
    }
  }
  R[0] = vec4(cos(yaw), 0, -sin(yaw), 0);
  R[2] = vec4(sin(yaw), 0, cos(yaw), 0);
  return true;
}
