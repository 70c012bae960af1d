// SDL2Aux, using namespace std and glm, light per vertex, lower-case functions, colour passed on.
#include "SDL2Auxiliary.h"
#include "TestModel.h"
#include <glm/gtc/quaternion.hpp>
using namespace std;
using namespace glm;

const int screenWidth = 60, screenHeight = 60;
SDL2Aux* sdlAux;
vector<Triangle> triangles;
struct Camera { vec3 position; mat3 rotation; float yaw, focalLength; };
struct Light { vec3 position, color; float ambient; };
Camera camera{vec3(0, 0, -3), mat3(), .5f, 60};
Light light{vec3(0, -.5f, -.7f), vec3(1.1f), .5f};
vector<vector<double>> zBuffer(60, vector<double>(60));

struct vertex { vec3 pos, n; vec3 color; };
struct pixel { int x, y; double z_inv; vec3 illum; };

pixel vertexShader(vertex v) {
    vec3 local = camera.rotation * (v.pos - camera.position);
    pixel p;
    p.x = round(camera.focalLength * local.x / local.z + 30);
    p.y = round(camera.focalLength * local.y / local.z + 30);
    p.z_inv = 1.0 / local.z;
    vec3 r = light.position - v.pos;
    p.illum = v.color * (light.color * std::max(dot(r, v.n), 0.0f) + light.ambient);
    return p;
}

void interpolate(const pixel& a, const pixel& b, vector<pixel>& result) {
    for (size_t i = 0; i < result.size(); i++) {
        double t = result.size() > 1 ? double(i) / (result.size() - 1) : 0.0;
        result[i].x = std::lround(a.x + t * (b.x - a.x));
        result[i].y = std::lround(a.y + t * (b.y - a.y));
        result[i].z_inv = a.z_inv + t * (b.z_inv - a.z_inv);
        result[i].illum = mix(a.illum, b.illum, float(t));
    }
}

void drawRows(const vector<pixel>& l, const vector<pixel>& r, vec3 tint, int mode = 0) {
    for (size_t i = 0; i < l.size(); i++) {
        vector<pixel> row(std::max(r[i].x - l[i].x + 1, 0));
        interpolate(l[i], r[i], row);
        for (auto& p : row)
            if (p.z_inv > zBuffer[p.y][p.x]) {
                zBuffer[p.y][p.x] = p.z_inv;
                sdlAux->putPixel(p.x, p.y, p.illum * tint);
            }
    }
}

int main() {
    LoadTestModel(triangles);
    sdlAux = new SDL2Aux(screenWidth, screenHeight);
    while (sdlAux->noQuitMessage()) {
        sdlAux->clearPixels();
        sdlAux->render();
    }
}
// Direct calls
vector<double> shown(const pixel& p) {
    return {11, double(p.x), double(p.y), p.z_inv, 0, 0, 0, p.illum.x, p.illum.y, p.illum.z};
}
void direct() {
    using namespace rasterwalk_kit;
    say(part_vertex_shader, shown(vertexShader({vec3(.5f, -.25f, .75f), vec3(0, 0, -1), vec3(.75f, .25f, .15f)})));
    vector<pixel> four(4);
    interpolate({4, 2, .5, vec3(0, .5, 1)}, {1, 8, .25, vec3(1, 1.5, 2)}, four);
    vector<double> numbers{4};
    for (auto& p : four) for (double d : shown(p)) numbers.push_back(d);
    say(part_interpolate, numbers);
    say(part_polygon_rows, {not_written});
    for (auto& row : zBuffer) for (auto& z : row) z = 0;
    vector<pixel> from{{3, 5, .5, vec3(0, .5, 1)}, {3, 6, .25, vec3(1, 1.5, 2)}};
    vector<pixel> to{{5, 5, .5, vec3(0, .5, 1)}, {3, 6, .25, vec3(1, 1.5, 2)}};
    say_puts(part_draw_rows, [&] { drawRows(from, to, vec3(.5f, .25f, 1)); });
    say(part_depth_test, {1, 0, 1, 1});
    say(part_pixel_shader, {not_written});
}
