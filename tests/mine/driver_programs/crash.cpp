// Interpolate throws in the second question, which the program would catch; DrawRows is fine.
#include "SDLauxiliary.h"
#include "TestModel.h"
using namespace std;
SDL_Surface* screen;
struct Pixel { int x, y; float zinv; };
void Interpolate(Pixel a, Pixel b, vector<Pixel>& result) {
    result.at(0) = a;
    result.at(3) = b;
}
void DrawRows(const vector<Pixel>& left, const vector<Pixel>& right) {
    PutPixelSDL(screen, left.size(), right.size(), glm::vec3(1));
}
int main() {
    screen = InitializeSDL(20, 20);
    while (NoQuitMessageSDL()) {
        try {
            SDL_Flip(screen);
        } catch (...) {
        }
    }
}
// Direct calls
void direct() {
    using namespace rasterwalk_kit;
    say(part_vertex_shader, {not_written});
    say(part_interpolate, {4, 3, 4, 2, .5, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 1, 8, .25, 0, 0, 0, 0, 0, 0});
    say(part_draw_rows, {1, 2, 2, 1, 1, 1});
}
