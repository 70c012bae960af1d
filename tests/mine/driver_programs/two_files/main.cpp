// Functions and variables in a second file, only declared here; the colour comes as a triangle.
#include "SDLauxiliary.h"
#include "TestModel.h"
#include "raster.h"
SDL_Surface* screen;
int main() {
    screen = InitializeSDL(WIDTH, HEIGHT);
    while (NoQuitMessageSDL()) SDL_UpdateRect(screen, 0, 0, 0, 0);
}
// Direct calls
void direct() {
    using namespace rasterwalk_kit;
    ScreenPoint p = {};
    vertex_shader(glm::vec3(.5f, -.25f, .75f), p);
    say(part_vertex_shader, {3, p.x, p.y, p.invDepth, 0, 0, 0, 0, 0, 0});
    say(part_interpolate, {not_written});
    say(part_polygon_rows, {1, 1, 3, 10, 5, .5, 0, 0, 0, 0, 0, 0, 3, 15, 15, .125, 0, 0, 0, 0, 0, 0});
    say(part_draw_rows, {1, 3, 5, .5, .25, 1});
    say(part_depth_test, {1, 0, 1, 1});
    say(part_pixel_shader, {not_written});
}
