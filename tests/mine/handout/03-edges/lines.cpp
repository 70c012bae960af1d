#include "lines.h"
#include <algorithm>
#include <cmath>

using namespace std;
using glm::ivec2;
using glm::vec3;

void Interpolate(ivec2 a, ivec2 b, vector<ivec2> &result)
{
  int N = result.size();
  float divisor = max(N - 1, 1);
  for (int i = 0; i < N; i++) {
    result[i].x = (int)round(a.x + (b.x - a.x) * i / divisor);
    result[i].y = (int)round(a.y + (b.y - a.y) * i / divisor);
  }
}

void DrawLine(screen *screen, ivec2 a, ivec2 b, vec3 colour)
{
  int n = max(abs(a.x - b.x), abs(a.y - b.y)) + 1;
  vector<ivec2> pixels(n);
  Interpolate(a, b, pixels);
  for (int i = 0; i < n; i++) {
    ivec2 p = pixels[i];
    bool inside = p.x >= 0 && p.y >= 0 && p.x < screen->width && p.y < screen->height;
    if (inside)
      PutPixelSDL(screen, p.x, p.y, colour);
  }
}
