/*
 * Lab 3: Rasterization
 *
 * All functions take values and give values back, nothing is changed through
 * references. It is a bit slower, but much easier to think about.
 */
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
#include <vector>
#include <SDL.h>
#include <glm/glm.hpp>
#include "SDLauxiliary.h"
#include "TestModel.h"

using namespace std;
using glm::vec3;
using glm::mat3;
using glm::dot;

const int SCREEN_WIDTH = 300;
const int SCREEN_HEIGHT = 300;

struct Pixel {
    int x;
    int y;
    float z_inv;
    vec3 position;      // in the world, times z_inv
    vec3 normal;
    vec3 reflectance;
};

struct Vertex {
    vec3 position;
    vec3 normal;
    vec3 reflectance;
};

struct Rows {
    vector<Pixel> left;
    vector<Pixel> right;
};

struct Camera {
    vec3 position;
    float yaw;
    float focal;
};

struct Light {
    vec3 position;
    vec3 power;
    vec3 indirect;
};

SDL_Surface* screen;

mat3 rotationOf(float yaw) {
    return mat3(cos(yaw), 0, -sin(yaw),
                0, 1, 0,
                sin(yaw), 0, cos(yaw));
}

vec3 cameraSpace(vec3 v, Camera camera) {
    return (v - camera.position) * rotationOf(camera.yaw);
}

Pixel vertexShader(Vertex v, Camera camera) {
    vec3 p = cameraSpace(v.position, camera);
    Pixel result;
    result.x = (int)floor(camera.focal * p.x / p.z) + SCREEN_WIDTH / 2;
    result.y = (int)floor(camera.focal * p.y / p.z) + SCREEN_HEIGHT / 2;
    result.z_inv = 1 / p.z;
    result.position = v.position * result.z_inv;
    result.normal = v.normal;
    result.reflectance = v.reflectance;
    return result;
}

vector<Pixel> interpolate(Pixel a, Pixel b, int n) {
    vector<Pixel> result;
    float steps = n > 1 ? n - 1 : 1;
    float x = a.x, y = a.y, z = a.z_inv;
    vec3 position = a.position;
    for (int i = 0; i < n; i++) {
        Pixel p = a;    // normal and reflectance are the same everywhere
        p.x = (int)floor(x + 0.5f);
        p.y = (int)floor(y + 0.5f);
        p.z_inv = z;
        p.position = position;
        result.push_back(p);

        x += (b.x - a.x) / steps;
        y += (b.y - a.y) / steps;
        z += (b.z_inv - a.z_inv) / steps;
        position += (b.position - a.position) / steps;
    }
    return result;
}

vector<Pixel> lineBetween(Pixel a, Pixel b) {
    int dx = abs(b.x - a.x);
    int dy = abs(b.y - a.y);
    return interpolate(a, b, (dx > dy ? dx : dy) + 1);
}

Rows computePolygonRows(vector<Pixel> corners) {
    int lowest = corners[0].y;
    int highest = corners[0].y;
    for (Pixel p : corners) {
        if (p.y < lowest) lowest = p.y;
        if (p.y > highest) highest = p.y;
    }

    Pixel none = {};
    Rows rows;
    none.x = numeric_limits<int>::max();
    rows.left = vector<Pixel>(highest - lowest + 1, none);
    none.x = numeric_limits<int>::min();
    rows.right = vector<Pixel>(highest - lowest + 1, none);

    Pixel previous = corners.back();
    for (Pixel corner : corners) {
        for (Pixel p : lineBetween(previous, corner)) {
            int i = p.y - lowest;
            if (p.x < rows.left[i].x) rows.left[i] = p;
            if (p.x > rows.right[i].x) rows.right[i] = p;
        }
        previous = corner;
    }
    return rows;
}

vec3 directLight(vec3 position, vec3 normal, Light light) {
    vec3 r = light.position - position;
    float r2 = dot(r, r);
    float area = 4 * acos(-1.0f) * r2;
    float angle = dot(r, normal) / sqrt(r2);
    return light.power * max(angle, 0.0f) / area;
}

vec3 colorOf(Pixel p, Light light) {
    vec3 position = p.position / p.z_inv;
    vec3 D = directLight(position, p.normal, light);
    return p.reflectance * (D + light.indirect);
}

bool isVisible(Pixel p) {
    return p.x >= 0 && p.x < SCREEN_WIDTH && p.y >= 0 && p.y < SCREEN_HEIGHT;
}

void draw(vector<Triangle> triangles, Camera camera, Light light) {
    SDL_FillRect(screen, 0, 0);
    vector<float> depth(SCREEN_WIDTH * SCREEN_HEIGHT, 0.0f);

    for (Triangle t : triangles) {
        Vertex vertices[3] = {
            {t.v0, t.normal, t.color},
            {t.v1, t.normal, t.color},
            {t.v2, t.normal, t.color},
        };

        bool inFront = true;
        vector<Pixel> corners;
        for (Vertex v : vertices) {
            if (cameraSpace(v.position, camera).z < 0.2f) inFront = false;
            corners.push_back(vertexShader(v, camera));
        }
        if (!inFront) continue;

        Rows rows = computePolygonRows(corners);
        for (size_t i = 0; i < rows.left.size(); i++) {
            for (Pixel p : lineBetween(rows.left[i], rows.right[i])) {
                if (!isVisible(p)) continue;
                float& nearest = depth[p.y * SCREEN_WIDTH + p.x];
                if (p.z_inv > nearest) {
                    nearest = p.z_inv;
                    PutPixelSDL(screen, p.x, p.y, colorOf(p, light));
                }
            }
        }
    }
    SDL_UpdateRect(screen, 0, 0, 0, 0);
}

Camera moveCamera(Camera camera, Uint8* keys) {
    mat3 R = rotationOf(camera.yaw);
    if (keys[SDLK_UP]) camera.position += 0.1f * R[2];
    if (keys[SDLK_DOWN]) camera.position -= 0.1f * R[2];
    if (keys[SDLK_LEFT]) camera.yaw -= 0.1f;
    if (keys[SDLK_RIGHT]) camera.yaw += 0.1f;
    return camera;
}

Light moveLight(Light light, Uint8* keys) {
    if (keys[SDLK_w]) light.position.z += 0.1f;
    if (keys[SDLK_s]) light.position.z -= 0.1f;
    if (keys[SDLK_a]) light.position.x -= 0.1f;
    if (keys[SDLK_d]) light.position.x += 0.1f;
    if (keys[SDLK_q]) light.position.y -= 0.1f;
    if (keys[SDLK_e]) light.position.y += 0.1f;
    return light;
}

int main(int argc, char* argv[]) {
    vector<Triangle> triangles;
    LoadTestModel(triangles);
    screen = InitializeSDL(SCREEN_WIDTH, SCREEN_HEIGHT);

    Camera camera = {vec3(0, 0, -3.001f), 0, SCREEN_HEIGHT};
    Light light = {vec3(0, -0.5f, -0.7f), vec3(14, 14, 14), vec3(0.5f, 0.5f, 0.5f)};

    while (NoQuitMessageSDL()) {
        camera = moveCamera(camera, SDL_GetKeyState(NULL));
        light = moveLight(light, SDL_GetKeyState(NULL));
        draw(triangles, camera, light);
    }
    SDL_SaveBMP(screen, "screenshot.bmp");
    return 0;
}
