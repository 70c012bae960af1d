// Lab 3: everything up to filled triangles, C++17
#include "SDL2auxiliary.h"
#include "TestModel.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

using std::vector;
using glm::vec2;
using glm::vec3;
using glm::ivec2;

constexpr auto screenWidth = 500;
constexpr auto screenHeight = 500;

struct View {
  vec3 eye{0.f, 0.f, -3.001f};
  float yaw = 0.f;
  float focal = 500.f;

  [[nodiscard]] auto right() const { return vec3{std::cos(yaw), 0.f, -std::sin(yaw)}; }
  [[nodiscard]] auto ahead() const { return vec3{std::sin(yaw), 0.f, std::cos(yaw)}; }

  // nothing if the point is not in front of the eye
  [[nodiscard]] std::optional<ivec2> project(const vec3& world) const {
    const auto d = world - eye;
    const auto c = vec3{glm::dot(d, right()), d.y, glm::dot(d, ahead())};
    if (c.z < 0.1f) return std::nullopt;
    const auto centre = vec2{screenWidth / 2, screenHeight / 2};
    return ivec2{glm::floor(vec2{c} * focal / c.z + centre)};
  }
};

auto interpolate(ivec2 a, ivec2 b) {
  const auto size = glm::abs(b - a);
  const auto last = std::max(size.x, size.y);
  vector<ivec2> line;
  line.reserve(last + 1);
  for (auto i = 0; i <= last; ++i) {
    const auto t = last == 0 ? 0.f : float(i) / last;
    line.push_back(ivec2{glm::round(vec2{a} + t * vec2{b - a})});
  }
  return line;
}

struct Span {
  int left = INT_MAX;
  int right = INT_MIN;

  void include(int x) {
    left = std::min(left, x);
    right = std::max(right, x);
  }
};

struct Rows {
  int top = 0;
  vector<Span> spans;
};

Rows polygonRows(const vector<ivec2>& corners) {
  const auto [lowest, highest] = std::minmax_element(
      corners.begin(), corners.end(), [](auto a, auto b) { return a.y < b.y; });

  Rows rows;
  rows.top = lowest->y;
  rows.spans.resize(highest->y - lowest->y + 1);

  for (auto i = 0u; i < corners.size(); ++i)
    for (const auto& p : interpolate(corners[i], corners[(i + 1) % corners.size()]))
      rows.spans[p.y - rows.top].include(p.x);
  return rows;
}

int main(int, char**) {
  auto window = std::make_unique<SDL2Aux>(screenWidth, screenHeight);
  vector<Triangle> triangles;
  LoadTestModel(triangles);
  View view;

  const auto drawTriangle = [&](const Triangle& triangle) {
    vector<ivec2> corners;
    for (const auto& v : {triangle.v0, triangle.v1, triangle.v2}) {
      const auto p = view.project(v);
      if (!p) return;
      corners.push_back(*p);
    }

    const auto rows = polygonRows(corners);
    auto y = rows.top;
    for (const auto& span : rows.spans) {
      if (y >= 0 && y < screenHeight)
        for (auto x = std::max(span.left, 0); x <= std::min(span.right, screenWidth - 1); ++x)
          window->putPixel(x, y, triangle.color);
      ++y;
    }
  };

  const auto update = [&] {
    const auto* held = SDL_GetKeyboardState(nullptr);
    const auto axis = [&](int minus, int plus) { return 0.05f * (held[plus] - held[minus]); };
    view.yaw += axis(SDL_SCANCODE_LEFT, SDL_SCANCODE_RIGHT);
    view.eye += axis(SDL_SCANCODE_S, SDL_SCANCODE_W) * view.ahead();
    view.eye += axis(SDL_SCANCODE_A, SDL_SCANCODE_D) * view.right();
  };

  while (!window->quitEvent()) {
    update();
    window->clearPixels();
    std::for_each(triangles.begin(), triangles.end(), drawTriangle);
    window->render();
  }
  window->saveBMP("screenshot.bmp");
}
