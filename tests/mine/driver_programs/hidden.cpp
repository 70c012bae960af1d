// Everything in the unnamed namespace, and types and functions with names of usual variables.
#include "SDLauxiliary.h"
#include "TestModel.h"
using namespace std;
using namespace glm;
struct light { vec3 where; };
struct Scene { vector<Triangle> triangles; };
namespace {
SDL_Surface* window;
vec3 cameraPos(4, 5, 6);
float yaw = 2;
Scene scene;
double focal() { return 3; }
float depth(int x, int y) { return 0; }
float depth(ivec2 p) { return 0; }
void Interpolate(ivec2 a, ivec2 b, vector<ivec2>& result) {
    for (size_t i = 0; i < result.size(); i++) result[i] = a + ivec2(i, -int(i));
}
}
static vec3 lightPos = vec3(7, 8, 9);
static auto PixelShader = [](const ivec2& p) { PutPixelSDL(window, p.x, p.y, vec3(1, 0, 1)); };
int main() {
    LoadTestModel(scene.triangles);
    scene.triangles.resize(1);
    window = InitializeSDL(10, 10);
    while (NoQuitMessageSDL()) SDL_Flip(window);
}
// Direct calls
void direct() {
    using namespace rasterwalk_kit;
    say(part_vertex_shader, {not_written});
    say(part_interpolate, {4, 1, 4, 2, 0, 0, 0, 0, 0, 0, 0, 1, 5, 1, 0, 0, 0, 0, 0, 0, 0, 1, 6, 0, 0, 0, 0, 0, 0, 0, 0, 1, 7, -1, 0, 0, 0, 0, 0, 0, 0});
    say(part_polygon_rows, {not_written});
    say(part_draw_rows, {not_written});
    say(part_depth_test, {not_written});
    say(part_pixel_shader, {1, 3, 5, 1, 0, 1});
}
