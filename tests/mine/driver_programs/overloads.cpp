// Interpolate has three versions, ComputePolygonRows is a template, and there are two Draw.
#include "SDLauxiliary.h"
#include "TestModel.h"
using namespace std;
using namespace glm;
SDL_Surface* screen;
enum { WIDTH = 40, HEIGHT = 30 };
enum class Mode { camera, light };
struct Pixel { int x, y; float invZ; };
vec3 cameraPosition(1, 2, 3);

void Interpolate(float a, float b, vector<float>& result) {
    for (size_t i = 0; i < result.size(); i++) result[i] = a;
}
void Interpolate(ivec2 a, ivec2 b, vector<ivec2>& result) {
    for (auto& r : result) r = b;
}
void Interpolate(Pixel a, Pixel b, vector<Pixel>& result) {
    for (size_t i = 0; i < result.size(); i++) result[i] = {a.x + int(i), b.y, a.invZ};
}
template <class P> void ComputePolygonRows(const vector<P>& polygon, vector<P>& left, vector<P>& right) {
    left.assign(2, polygon[0]);
    right.assign(2, polygon[1]);
}
void DrawPolygonRows(const vector<Pixel>& left, const vector<Pixel>& right, vec3 color) {
    for (auto& p : left) PutPixelSDL(screen, p.x, p.y, color);
}
void DrawPolygonRows(vector<ivec2> left, vector<ivec2> right) { abort(); }

int main() {
    screen = InitializeSDL(WIDTH, HEIGHT);
    while (NoQuitMessageSDL()) SDL_Flip(screen);
}
// Direct calls
void direct() {
    using namespace rasterwalk_kit;
    say(part_vertex_shader, {not_written});
    say(part_interpolate, {4, 3, 4, 8, .5, 0, 0, 0, 0, 0, 0, 3, 5, 8, .5, 0, 0, 0, 0, 0, 0, 3, 6, 8, .5, 0, 0, 0, 0, 0, 0, 3, 7, 8, .5, 0, 0, 0, 0, 0, 0});
    say(part_polygon_rows, {2, 2, 3, 10, 5, .5, 0, 0, 0, 0, 0, 0, 3, 10, 5, .5, 0, 0, 0, 0, 0, 0, 3, 5, 10, .25, 0, 0, 0, 0, 0, 0, 3, 5, 10, .25, 0, 0, 0, 0, 0, 0});
    say(part_draw_rows, {2, 3, 5, .5f, .25f, 1, 3, 6, .5f, .25f, 1});
    say(part_depth_test, {1, 1, 1, 1});
    say(part_pixel_shader, {not_written});
}
