// A rasterizer, to be written in small steps. This is the first one: the corners of the room as
// points. The functions that are marked "Step" are yours.

#include <vector>

#include <glm/glm.hpp>

#include "SDLauxiliary.h"
#include "TestModel.h"

using glm::ivec2;
using glm::vec3;
using std::vector;

const int SCREEN_WIDTH = 500;
const int SCREEN_HEIGHT = 500;
float focalLength = 500; // pixels

SDL_Surface* screen;
vector<Triangle> triangles;
vec3 cameraPos(0, 0, -3.001f);

void Update();
void Draw();
void VertexShader(const vec3& v, ivec2& p);

int main(int, char*[]) {
    LoadTestModel(triangles);
    screen = InitializeSDL(SCREEN_WIDTH, SCREEN_HEIGHT);
    while (NoQuitMessageSDL()) {
        Update();
        Draw();
    }
    return 0;
}

// What changes from one frame to the next.
void Update() {
    // Later: move the camera with the keys. SDL_GetKeyboardState(nullptr)[SDL_SCANCODE_UP] is not 0
    // while the key is held.
}

// Draws one frame.
void Draw() {
    ClearSDL(screen);

    for (const Triangle& triangle : triangles) {
        const vec3 vertices[3] = {triangle.v0, triangle.v1, triangle.v2};
        (void)vertices; // to be removed with the first line of yours

        // Step 2. For each of the three vertices: ask VertexShader() which pixel it falls on, and
        // put a white point there with PutPixelSDL(screen, x, y, vec3(1, 1, 1)).
    }

    ShowSDL(screen);
}

// Step 1. Computes the pixel `p` that the point `v` of the room falls on.
//
// First subtract the camera's position: this gives the point as the camera sees it, with z as its
// distance in depth. A point that is twice as far away is drawn half as far from the middle of the
// picture, so divide x and y by z, and multiply them by the focal length. The result is 0 in the
// middle of the picture, but pixel (0, 0) is at the top left: add half of the picture's width to x,
// and half of its height to y.
void VertexShader(const vec3& v, ivec2& p) {
    (void)v; // to be removed with the first line of yours
    p = ivec2(0, 0);
}
