// A struct screen that is local to main and handed on, vec4, macros, a float depth buffer.
#include <SDL.h>
#include "SDLauxiliary.h"
#include "TestModelH.h"
using namespace std;
using glm::vec3;
using glm::vec4;
using glm::mat4;
using glm::ivec2;

#define SCREEN_WIDTH 64
#define SCREEN_HEIGHT 48
#define FULLSCREEN_MODE false
#define FOCAL_LENGTH SCREEN_HEIGHT

struct Pixel { ivec2 position; float zinv; vec4 pos3D; };
struct Vertex { vec4 position; };

vec4 cameraPos(0, 0, -3.001, 1);
mat4 R(1);
float depth[SCREEN_HEIGHT][SCREEN_WIDTH];

void VertexShader(Vertex& v, Pixel& p) {
    vec4 l = R * (v.position - cameraPos);
    p.zinv = 1.0f / l.z;
    p.position = ivec2(FOCAL_LENGTH * l.x / l.z + SCREEN_WIDTH / 2, FOCAL_LENGTH * l.y / l.z + SCREEN_HEIGHT / 2);
    p.pos3D = v.position;
}

void PixelShader(screen* screen, const Pixel& p, vec3 color) {
    if (p.zinv > depth[p.position.y][p.position.x]) {
        depth[p.position.y][p.position.x] = p.zinv;
        PutPixelSDL(screen, p.position.x, p.position.y, color);
    }
}

void DrawPolygonRows(screen* screen, const vector<Pixel>& left, const vector<Pixel>& right, vec3 color) {
    for (int i = 0; i < int(left.size()); i++)
        for (Pixel p = left[i]; p.position.x <= right[i].position.x; p.position.x++)
            PixelShader(screen, p, color);
}

void Draw(screen* screen) {
    memset(screen->buffer, 0, screen->height * screen->width * sizeof(uint32_t));
    vector<Triangle> triangles;
    LoadTestModel(triangles);
    for (auto& t : triangles) {
        Vertex v{t.v0};
        Pixel p;
        VertexShader(v, p);
        if (p.position.x >= 0 && p.position.x < SCREEN_WIDTH && p.position.y >= 0 && p.position.y < SCREEN_HEIGHT)
            PixelShader(screen, p, t.color);
    }
}

int main(int argc, char* argv[]) {
    screen* screen = InitializeSDL(SCREEN_WIDTH, SCREEN_HEIGHT, FULLSCREEN_MODE);
    while (NoQuitMessageSDL()) {
        Draw(screen);
        SDL_Renderframe(screen);
    }
    KillSDL(screen);
    return 0;
}
// Direct calls
void direct() {
    using namespace rasterwalk_kit;
    Vertex v{vec4(.5f, -.25f, .75f, 1)};
    Pixel p;
    VertexShader(v, p);
    say(part_vertex_shader, {7, double(p.position.x), double(p.position.y), p.zinv, .5, -.25, .75, 0, 0, 0});
    say(part_interpolate, {not_written});
    say(part_polygon_rows, {not_written});
    say(part_draw_rows, {4, 3, 5, .5f, .25f, 1, 4, 5, .5f, .25f, 1, 5, 5, .5f, .25f, 1, 3, 6, .5f, .25f, 1});
    say(part_depth_test, {1, 0, 1, 1});
    say(part_pixel_shader, {1, 3, 5, .5f, .25f, 1});
}
