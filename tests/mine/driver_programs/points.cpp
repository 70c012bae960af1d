// The first step of the lab: only VertexShader is written, and the names of variables are short.
#include <SDL.h>
#include "SDLauxiliary.h"
#include "TestModel.h"
using std::vector;
using glm::vec3;
using glm::ivec2;
using glm::mat3;

#define W 60
#define H (W - 20)
#define FOCAL_LENGTH (W)
SDL_Surface* screen;
mat3 R;
vec3 C(0, 0, -3);
vec3 camera(0, 0, -3.001);
vec3& eye = camera;
int size = 3;
float left = 2, right = 5;
vector<Triangle> triangles;

void VertexShader(const vec3& v, ivec2& p) {
    vec3 q = (v - camera) * R;
    p.x = FOCAL_LENGTH * q.x / q.z + W / 2;
    p.y = FOCAL_LENGTH * q.y / q.z + H / 2;
}

int main() {
    LoadTestModel(triangles);
    screen = InitializeSDL(W, H);
    while (NoQuitMessageSDL()) {
        for (unsigned i = 0; i < triangles.size(); ++i) {
            ivec2 p;
            VertexShader(triangles[i].v0, p);
            PutPixelSDL(screen, p.x, p.y, vec3(size, left, right));
        }
        SDL_UpdateRect(screen, 0, 0, 0, 0);
    }
}
// Direct calls
void direct() {
    using namespace rasterwalk_kit;
    ivec2 p;
    VertexShader(vec3(.5f, -.25f, .75f), p);
    say(part_vertex_shader, {1, double(p.x), double(p.y), 0, 0, 0, 0, 0, 0, 0});
    VertexShader(vec3(-.5f, .5f, -.5f), p);
    say(part_vertex_shader, {1, double(p.x), double(p.y), 0, 0, 0, 0, 0, 0, 0});
    for (Part part : {part_interpolate, part_polygon_rows, part_draw_rows, part_depth_test, part_pixel_shader}) {
        say(part, {not_written});
    }
}
