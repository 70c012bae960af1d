// Rasteriser, lab 3. The program is in four parts:
//   camera      from the world to pixels
//   rasteriser  from corners to all pixels of a triangle
//   lighting    from a place to a colour
//   main        window and keys
#include <iostream>
#include <vector>
#include <SDL.h>
#include "SDLauxiliary.h"
#include "TestModel.h"
#include "camera.h"
#include "lighting.h"
#include "rasteriser.h"

SDL_Surface* screen;
std::vector<Triangle> triangles;

static void Update()
{
    static int before = SDL_GetTicks();
    int now = SDL_GetTicks();
    float dt = (now - before) * 0.001f;
    before = now;

    Uint8* key = SDL_GetKeyState(nullptr);
    const float speed = 1.5f * dt;

    if (key[SDLK_UP])    cameraPos += cameraRot[2] * speed;
    if (key[SDLK_DOWN])  cameraPos -= cameraRot[2] * speed;
    if (key[SDLK_LEFT])  SetYaw(yaw - dt);
    if (key[SDLK_RIGHT]) SetYaw(yaw + dt);

    if (key[SDLK_w]) lightPos += cameraRot[2] * speed;
    if (key[SDLK_s]) lightPos -= cameraRot[2] * speed;
    if (key[SDLK_a]) lightPos -= cameraRot[0] * speed;
    if (key[SDLK_d]) lightPos += cameraRot[0] * speed;
    if (key[SDLK_q]) lightPos -= cameraRot[1] * speed;
    if (key[SDLK_e]) lightPos += cameraRot[1] * speed;
}

static void Draw()
{
    SDL_FillRect(screen, 0, 0);
    ClearDepth();
    for (const Triangle& triangle : triangles)
        DrawTriangle(triangle);
    SDL_UpdateRect(screen, 0, 0, 0, 0);
}

int main(int argc, char** argv)
{
    screen = InitializeSDL(SCREEN_WIDTH, SCREEN_HEIGHT);
    LoadTestModel(triangles);
    while (NoQuitMessageSDL())
    {
        Update();
        Draw();
    }
    SDL_SaveBMP(screen, "screenshot.bmp");
    return 0;
}
