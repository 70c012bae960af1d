#pragma once
#include <array>
constexpr int WIDTH = 32, HEIGHT = 24;
struct ScreenPoint { float x, y, invDepth; };
extern glm::vec3 camPos;
extern glm::mat3 rot;
extern std::array<std::array<float, WIDTH>, HEIGHT> depth_buffer;
void vertex_shader(const glm::vec3& v, ScreenPoint& p);
void computePolygonRows(std::vector<ScreenPoint> polygon, std::vector<ScreenPoint>& l, std::vector<ScreenPoint>& r);
void draw_rows(std::vector<ScreenPoint>& l, std::vector<ScreenPoint>& r, const Triangle& t, SDL_Surface* where);
