#include <iostream>
#include "globals.h"
#include "SDLauxiliary.h"

using namespace std;
using glm::vec3;

SDL_Surface* screen;
vector<Triangle> triangles;
int t;

vec3 lightPos(0, -0.5f, -0.7f);
vec3 lightPower = 11.0f * vec3(1, 1, 1);
vec3 indirectLightPowerPerArea = 0.5f * vec3(1, 1, 1);

void Update()
{
    int t2 = SDL_GetTicks();
    cout << "Render time: " << t2 - t << " ms." << endl;
    t = t2;

    Uint8* keys = SDL_GetKeyState(0);
    MoveCamera(keys);
    if (keys[SDLK_w]) lightPos.z += 0.1f;
    if (keys[SDLK_s]) lightPos.z -= 0.1f;
    if (keys[SDLK_a]) lightPos.x -= 0.1f;
    if (keys[SDLK_d]) lightPos.x += 0.1f;
    if (keys[SDLK_q]) lightPos.y -= 0.1f;
    if (keys[SDLK_e]) lightPos.y += 0.1f;
}

void Draw()
{
    SDL_FillRect(screen, 0, 0);
    ClearDepthBuffer();
    for (size_t i = 0; i < triangles.size(); i++)
    {
        vector<Vertex> vertices(3);
        vertices[0].position = triangles[i].v0;
        vertices[1].position = triangles[i].v1;
        vertices[2].position = triangles[i].v2;
        DrawPolygon(vertices, triangles[i].normal, triangles[i].color);
    }
    SDL_UpdateRect(screen, 0, 0, 0, 0);
}

int main(int argc, char* argv[])
{
    LoadTestModel(triangles);
    screen = InitializeSDL(SCREEN_WIDTH, SCREEN_HEIGHT);
    t = SDL_GetTicks();
    while (NoQuitMessageSDL())
    {
        Update();
        Draw();
    }
    SDL_SaveBMP(screen, "screenshot.bmp");
    return 0;
}
