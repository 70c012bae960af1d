// The first frame never ends, so the program is asked before main(), without its window. It keeps
// z itself, and the nearer one wins.
#include "SDLauxiliary.h"
#include "TestModel.h"
using namespace std;
using namespace glm;
const int SCREEN_WIDTH = 30, SCREEN_HEIGHT = 20;
SDL_Surface* screen;
#define focalLength (SCREEN_HEIGHT / 2.0f)
#define indirectLight vec3(.25f, .5f, .75f)
#define main student_main
#undef main
float zbuffer[SCREEN_WIDTH * SCREEN_HEIGHT];
vec3 position(0, 0, -2);
struct Pixel { int x, y; float zinv; };
void VertexShader(const vec3& v, Pixel& p) {
    float z = v.z - position.z;
    p = {int(focalLength * v.x / z) + screen->w / 2, int(focalLength * v.y / z) + screen->h / 2, 1 / z};
}
void PixelShader(const Pixel& p) {
    float z = 1 / p.zinv;
    if (z >= zbuffer[p.y * SCREEN_WIDTH + p.x] && zbuffer[p.y * SCREEN_WIDTH + p.x] != 0) return;
    zbuffer[p.y * SCREEN_WIDTH + p.x] = z;
    ((Uint32*)screen->pixels)[p.y * screen->w + p.x] = 0xffffff;
}
void DrawPolygonRows(const vector<Pixel>& left, const vector<Pixel>& right) {
    for (auto& p : left) PixelShader(p);
}
int main() {
    screen = InitializeSDL(SCREEN_WIDTH, SCREEN_HEIGHT);
    while (NoQuitMessageSDL())
        for (;;) {
        }
}
// Direct calls
void direct() {}
