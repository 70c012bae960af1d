// Functions whose parameters cannot be guessed, Interpolate that returns, for single numbers.
#include "SDL2Aux.h"
#include "TestModel.h"
#include <glm/gtx/matrix_interpolation.hpp>
using namespace glm;
SDL2Aux sdl(20, 20);
struct P { int x, y; float z; };
std::vector<float> interpolate(float a, float b, int n) {
    std::vector<float> result;
    for (int i = 0; i < n; i++) result.push_back(a + (b - a) * i / n);
    return result;
}
void ComputePolygonRows(P* polygon, int corners, P* left, P* right) {}
void DrawPolygonRows(const std::vector<P>& left, const std::vector<P>& right, int shift, vec3 a, vec3 b) {}
void VertexShader(vec3 v, float& x, float& y) {}
#define camera_yaw
int main() {
    while (sdl.noQuitMessage()) sdl.render();
}
// Direct calls
void direct() {
    using namespace rasterwalk_kit;
    say(part_vertex_shader, {not_askable});
    std::vector<float> x = interpolate(4, 1, 4), y = interpolate(2, 8, 4);
    std::vector<double> numbers{4};
    for (int i = 0; i < 4; i++) numbers.insert(numbers.end(), {1, x[i], y[i], 0, 0, 0, 0, 0, 0, 0});
    say(part_interpolate, numbers);
    say(part_polygon_rows, {not_askable});
    say(part_draw_rows, {not_askable});
    say(part_depth_test, {not_askable});
    say(part_pixel_shader, {not_written});
}
