// DH2323 Lab 3 (SDL2 version)
//
// Controls
//   up, down      forward, back         left, right   turn
//   W A S D       move the lamp         Q E           lamp up, down

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <vector>

#include <glm/glm.hpp>
#include "SDL2auxiliary.h"
#include "TestModel.h"

using namespace std;
using glm::vec2;
using glm::vec3;
using glm::ivec2;
using glm::mat3;

const int SCREEN_WIDTH = 500;
const int SCREEN_HEIGHT = 500;
const float NEAR = 0.25f;
const float PI = 3.14159265359f;

struct Pixel {
    ivec2 position;
    float z_inv;
    vec3 pos3D; // over z
};

struct Vertex {
    vec3 position;
};

struct Camera {
    vec3 position = vec3(0, 0, -3.001f);
    float yaw = 0;
    float focalLength = 500;
    mat3 rotation = mat3(1.0f);

    void turn(float angle) {
        yaw += angle;
        rotation = mat3(cos(yaw), 0, -sin(yaw), 0, 1, 0, sin(yaw), 0, cos(yaw));
    }

    vec3 see(vec3 point) const { return (point - position) * rotation; }
};

struct Light {
    vec3 position = vec3(0, -0.5f, -0.7f);
    vec3 power = vec3(14, 14, 14);
    vec3 indirect = vec3(0.5f, 0.5f, 0.5f);
};

SDL2Aux* sdlAux;
vector<Triangle> triangles;
vector<float> depthBuffer(SCREEN_WIDTH * SCREEN_HEIGHT);
Camera camera;
Light light;

void VertexShader(const Vertex& v, Pixel& p) {
    const vec3 c = camera.see(v.position);
    p.position.x = int(camera.focalLength * c.x / c.z + SCREEN_WIDTH / 2.0f);
    p.position.y = int(camera.focalLength * c.y / c.z + SCREEN_HEIGHT / 2.0f);
    p.z_inv = 1.0f / c.z;
    p.pos3D = v.position / c.z;
}

void Interpolate(const Pixel& a, const Pixel& b, vector<Pixel>& result) {
    const float last = max<float>(result.size() - 1.0f, 1.0f);
    const vec2 stepPosition = vec2(b.position - a.position) / last;
    const float stepZinv = (b.z_inv - a.z_inv) / last;
    const vec3 stepPos3D = (b.pos3D - a.pos3D) / last;

    vec2 position(a.position);
    float z_inv = a.z_inv;
    vec3 pos3D = a.pos3D;
    for (Pixel& pixel : result) {
        pixel.position = ivec2(glm::round(position));
        pixel.z_inv = z_inv;
        pixel.pos3D = pos3D;
        position += stepPosition;
        z_inv += stepZinv;
        pos3D += stepPos3D;
    }
}

void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels, vector<Pixel>& rightPixels) {
    auto byRow = [](const Pixel& a, const Pixel& b) { return a.position.y < b.position.y; };
    const auto ends = minmax_element(vertexPixels.begin(), vertexPixels.end(), byRow);
    const int top = ends.first->position.y;
    const int rows = ends.second->position.y - top + 1;

    Pixel unset;
    unset.position = ivec2(numeric_limits<int>::max(), 0);
    unset.z_inv = 0;
    unset.pos3D = vec3(0);
    leftPixels.assign(rows, unset);
    unset.position.x = -numeric_limits<int>::max();
    rightPixels.assign(rows, unset);

    for (size_t i = 0; i < vertexPixels.size(); ++i) {
        const Pixel& a = vertexPixels[i];
        const Pixel& b = vertexPixels[(i + 1) % vertexPixels.size()];
        const ivec2 delta = glm::abs(a.position - b.position);
        vector<Pixel> edge(max(delta.x, delta.y) + 1);
        Interpolate(a, b, edge);

        for (const Pixel& p : edge) {
            const int row = p.position.y - top;
            if (p.position.x < leftPixels[row].position.x) leftPixels[row] = p;
            if (p.position.x > rightPixels[row].position.x) rightPixels[row] = p;
        }
    }
}

void PixelShader(const Pixel& p, const Triangle& triangle) {
    const int x = p.position.x;
    const int y = p.position.y;
    if (x < 0 || y < 0 || x >= SCREEN_WIDTH || y >= SCREEN_HEIGHT) return;

    float& depth = depthBuffer[y * SCREEN_WIDTH + x];
    if (p.z_inv <= depth) return;
    depth = p.z_inv;

    const vec3 toLight = light.position - p.pos3D / p.z_inv;
    const float distance2 = glm::dot(toLight, toLight);
    const float slant = max(glm::dot(toLight, triangle.normal) / sqrt(distance2), 0.0f);
    const vec3 direct = light.power * slant / (4 * PI * distance2);
    sdlAux->putPixel(x, y, triangle.color * (direct + light.indirect));
}

void DrawPolygonRows(const vector<Pixel>& leftPixels, const vector<Pixel>& rightPixels, const Triangle& triangle) {
    for (size_t i = 0; i < leftPixels.size(); ++i) {
        const int width = rightPixels[i].position.x - leftPixels[i].position.x + 1;
        if (width <= 0) continue;
        vector<Pixel> row(width);
        Interpolate(leftPixels[i], rightPixels[i], row);
        for (const Pixel& p : row) PixelShader(p, triangle);
    }
}

void DrawPolygon(const Triangle& triangle) {
    const vector<Vertex> vertices = {{triangle.v0}, {triangle.v1}, {triangle.v2}};
    vector<Pixel> vertexPixels(3);
    for (int i = 0; i < 3; ++i) {
        if (camera.see(vertices[i].position).z < NEAR) return;
        VertexShader(vertices[i], vertexPixels[i]);
    }
    vector<Pixel> leftPixels, rightPixels;
    ComputePolygonRows(vertexPixels, leftPixels, rightPixels);
    DrawPolygonRows(leftPixels, rightPixels, triangle);
}

void Draw() {
    sdlAux->clearPixels();
    fill(depthBuffer.begin(), depthBuffer.end(), 0.0f);
    for (const Triangle& triangle : triangles) DrawPolygon(triangle);
    sdlAux->render();
}

void Update() {
    static int before = SDL_GetTicks();
    const int now = SDL_GetTicks();
    const float seconds = (now - before) / 1000.0f;
    before = now;

    const Uint8* keys = SDL_GetKeyboardState(NULL);
    const vec3 right = camera.rotation[0];
    const vec3 forward = camera.rotation[2];
    const float move = 2 * seconds;

    if (keys[SDL_SCANCODE_UP]) camera.position += move * forward;
    if (keys[SDL_SCANCODE_DOWN]) camera.position -= move * forward;
    if (keys[SDL_SCANCODE_RIGHT]) camera.turn(seconds);
    if (keys[SDL_SCANCODE_LEFT]) camera.turn(-seconds);
    if (keys[SDL_SCANCODE_W]) light.position += move * forward;
    if (keys[SDL_SCANCODE_S]) light.position -= move * forward;
    if (keys[SDL_SCANCODE_D]) light.position += move * right;
    if (keys[SDL_SCANCODE_A]) light.position -= move * right;
    if (keys[SDL_SCANCODE_E]) light.position.y += move;
    if (keys[SDL_SCANCODE_Q]) light.position.y -= move;
}

int main(int argc, char* argv[]) {
    sdlAux = new SDL2Aux(SCREEN_WIDTH, SCREEN_HEIGHT);
    LoadTestModel(triangles);
    while (!sdlAux->quitEvent()) {
        Update();
        Draw();
    }
    sdlAux->saveBMP("screenshot.bmp");
    return 0;
}
