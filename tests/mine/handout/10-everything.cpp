// Rasterizer lab. Finished: points, edges, triangles, depth, light per pixel, perspective.
//
// Keys: W A S D walk, left/right turn, I J K L U O move the lamp, space resets.
#include "SDL2auxiliary.h"
#include "TestModel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>
#include <glm/glm.hpp>

using namespace std;
using glm::dvec2;
using glm::dvec3;
using glm::vec3;

const int W = 500;
const int H = 500;

// one sample of a surface; everything after invZ is linear on the screen because it has been divided by z
struct Sample {
  int col;
  int row;
  double invZ;
  dvec3 worldByZ;
};

struct State {
  dvec3 eye = dvec3(0, 0, -3.001);
  double yaw = 0;
  dvec3 lamp = dvec3(0, -0.5, -0.7);
};

const double focal = H;
const double lampPower = 13;
const double ambient = 0.5;
const double nearest = 0.2;

State state;
SDL2Aux* aux;
auto model = vector<Triangle>();
auto depth = vector<double>(W * H);

dvec3 right() { return dvec3(cos(state.yaw), 0, -sin(state.yaw)); }
dvec3 ahead() { return dvec3(sin(state.yaw), 0, cos(state.yaw)); }

dvec3 view(const dvec3& world) {
  auto d = world - state.eye;
  return dvec3(dot(d, right()), d.y, dot(d, ahead()));
}

Sample project(const dvec3& world) {
  auto v = view(world);
  auto s = Sample();
  s.col = int(floor(focal * v.x / v.z + W / 2 + 0.5));
  s.row = int(floor(focal * v.y / v.z + H / 2 + 0.5));
  s.invZ = 1 / v.z;
  s.worldByZ = world / v.z;
  return s;
}

// Line of `count` samples. Both ends are hit exactly.
vector<Sample> line(const Sample& a, const Sample& b, int count) {
  auto samples = vector<Sample>(count);
  for (auto i = 0; i < count; ++i) {
    auto t = count > 1 ? double(i) / (count - 1) : 0.0;
    auto u = 1 - t;
    samples[i].col = int(round(u * a.col + t * b.col));
    samples[i].row = int(round(u * a.row + t * b.row));
    samples[i].invZ = u * a.invZ + t * b.invZ;
    samples[i].worldByZ = u * a.worldByZ + t * b.worldByZ;
  }
  return samples;
}

vec3 lit(const dvec3& place, const Triangle& triangle) {
  auto toLamp = state.lamp - place;
  auto squared = dot(toLamp, toLamp);
  auto slant = dot(toLamp, dvec3(triangle.normal)) / sqrt(squared);
  auto direct = lampPower * max(slant, 0.0) / (4 * acos(-1.0) * squared);
  return triangle.color * float(direct + ambient);
}

void shade(const Sample& s, const Triangle& triangle) {
  if (s.col < 0 || s.col >= W || s.row < 0 || s.row >= H) return;
  auto& stored = depth[s.row * W + s.col];
  if (stored >= s.invZ) return;
  stored = s.invZ;
  aux->putPixel(s.col, s.row, lit(s.worldByZ / s.invZ, triangle));
}

void fill(const vector<Sample>& corners, const Triangle& triangle) {
  auto top = H, bottom = -1;
  for (auto& c : corners) {
    top = min(top, c.row);
    bottom = max(bottom, c.row);
  }

  auto unset = Sample();
  unset.col = numeric_limits<int>::max();
  auto lefts = vector<Sample>(max(bottom - top + 1, 0), unset);
  unset.col = numeric_limits<int>::min();
  auto rights = vector<Sample>(lefts.size(), unset);

  for (auto i = 0; i < 3; ++i) {
    auto& a = corners[i];
    auto& b = corners[(i + 1) % 3];
    auto count = max(abs(a.col - b.col), abs(a.row - b.row)) + 1;
    for (auto& s : line(a, b, count)) {
      if (s.row < top || s.row > bottom) continue;
      auto& l = lefts[s.row - top];
      auto& r = rights[s.row - top];
      if (s.col < l.col) l = s;
      if (s.col > r.col) r = s;
    }
  }

  for (size_t i = 0; i < lefts.size(); ++i) {
    if (lefts[i].col > rights[i].col) continue;
    for (auto& s : line(lefts[i], rights[i], rights[i].col - lefts[i].col + 1))
      shade(s, triangle);
  }
}

void draw() {
  aux->clearPixels();
  fill(depth.begin(), depth.end(), 0.0);
  for (auto& triangle : model) {
    auto corners = vector<Sample>();
    for (auto& v : {triangle.v0, triangle.v1, triangle.v2})
      if (view(dvec3(v)).z > nearest) corners.push_back(project(dvec3(v)));
    if (corners.size() == 3) fill(corners, triangle);
  }
  aux->render();
}

void update() {
  auto keys = SDL_GetKeyboardState(nullptr);
  const auto step = 0.04;
  if (keys[SDL_SCANCODE_W]) state.eye += step * ahead();
  if (keys[SDL_SCANCODE_S]) state.eye -= step * ahead();
  if (keys[SDL_SCANCODE_A]) state.eye -= step * right();
  if (keys[SDL_SCANCODE_D]) state.eye += step * right();
  if (keys[SDL_SCANCODE_LEFT]) state.yaw -= step;
  if (keys[SDL_SCANCODE_RIGHT]) state.yaw += step;
  if (keys[SDL_SCANCODE_I]) state.lamp.z += step;
  if (keys[SDL_SCANCODE_K]) state.lamp.z -= step;
  if (keys[SDL_SCANCODE_J]) state.lamp.x -= step;
  if (keys[SDL_SCANCODE_L]) state.lamp.x += step;
  if (keys[SDL_SCANCODE_U]) state.lamp.y -= step;
  if (keys[SDL_SCANCODE_O]) state.lamp.y += step;
  if (keys[SDL_SCANCODE_SPACE]) state = State();
}

int main(int argc, char* argv[]) {
  LoadTestModel(model);
  aux = new SDL2Aux(W, H);
  while (!aux->quitEvent()) {
    update();
    draw();
  }
  aux->saveBMP("screenshot.bmp");
  return 0;
}
