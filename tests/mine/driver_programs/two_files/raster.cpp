#include "SDLauxiliary.h"
#include "TestModel.h"
#include "raster.h"
glm::vec3 camPos(0, 0, -2);
glm::mat3 rot;
std::array<std::array<float, WIDTH>, HEIGHT> depth_buffer;
void vertex_shader(const glm::vec3& v, ScreenPoint& p) {
    glm::vec3 l = (v - camPos) * rot;
    p = {24 * l.x / l.z + 16, 24 * l.y / l.z + 12, 1 / l.z};
}
void computePolygonRows(std::vector<ScreenPoint> polygon, std::vector<ScreenPoint>& l, std::vector<ScreenPoint>& r) {
    l.assign(1, polygon.front());
    r.assign(1, polygon.back());
}
void draw_rows(std::vector<ScreenPoint>& l, std::vector<ScreenPoint>& r, const Triangle& t, SDL_Surface* where) {
    int x = l[0].x, y = l[0].y;
    if (l[0].invDepth <= depth_buffer[y][x]) return;
    depth_buffer[y][x] = l[0].invDepth;
    PutPixelSDL(where, x, y, t.color);
}
