// Software rasteriser in C++17
#include <array>
#include <cmath>
#include <vector>
#include <glm/glm.hpp>
#include "SDL2Auxiliary.h"
#include "TestModel.h"
#include "interpolation.h"
#include "rows.h"

using glm::vec3;

constexpr int SCREEN_WIDTH = 600;
constexpr int SCREEN_HEIGHT = 600;
constexpr float pi = 3.14159265f;

namespace {

SDL2Aux* sdlAux = nullptr;
std::vector<Triangle> triangles;
std::array<std::array<float, SCREEN_WIDTH>, SCREEN_HEIGHT> depthBuffer;

vec3 cameraPos{0, 0, -3.001f};
float yaw = 0;
const float focalLength = SCREEN_WIDTH;

vec3 lightPos{0, -0.5f, -0.7f};
const vec3 lightPower{14.1f, 14.1f, 14.1f};
const vec3 indirectLight{0.5f, 0.5f, 0.5f};

vec3 right() { return {std::cos(yaw), 0, -std::sin(yaw)}; }
vec3 forward() { return {std::sin(yaw), 0, std::cos(yaw)}; }

vec3 toCamera(const vec3& v) {
    const vec3 d = v - cameraPos;
    return {glm::dot(d, right()), d.y, glm::dot(d, forward())};
}

void VertexShader(const vec3& v, Pixel& p) {
    const vec3 c = toCamera(v);
    const glm::vec2 centre{SCREEN_WIDTH / 2, SCREEN_HEIGHT / 2};
    p.pos = glm::ivec2(glm::floor(focalLength * glm::vec2(c) / c.z + centre));
    p.zinv = 1 / c.z;
    p.worldOverZ = v / c.z;
}

// shade: from the pixel to its colour
template <typename Shade>
void DrawPolygon(const std::vector<vec3>& vertices, Shade shade) {
    std::vector<Pixel> vertexPixels(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (toCamera(vertices[i]).z < 0.3f) return;
        VertexShader(vertices[i], vertexPixels[i]);
    }

    std::vector<Pixel> leftPixels, rightPixels;
    ComputePolygonRows(vertexPixels, leftPixels, rightPixels);

    for (std::size_t row = 0; row < leftPixels.size(); ++row) {
        const auto& a = leftPixels[row];
        const auto& b = rightPixels[row];
        std::vector<Pixel> line(b.pos.x - a.pos.x + 1);
        Interpolate(a, b, line);
        for (const auto& p : line) {
            const auto [x, y] = std::array{p.pos.x, p.pos.y};
            if (x < 0 || x >= SCREEN_WIDTH || y < 0 || y >= SCREEN_HEIGHT) continue;
            if (p.zinv > depthBuffer[y][x]) {
                depthBuffer[y][x] = p.zinv;
                sdlAux->putPixel(x, y, shade(p));
            }
        }
    }
}

void Draw() {
    sdlAux->clearPixels();
    for (auto& row : depthBuffer) row.fill(0);

    for (const auto& triangle : triangles) {
        auto phong = [&](const Pixel& p) {
            const vec3 r = lightPos - p.worldOverZ / p.zinv;
            const float r2 = glm::dot(r, r);
            const float cosine = std::max(0.0f, glm::dot(glm::normalize(r), triangle.normal));
            const vec3 direct = lightPower * cosine / (4 * pi * r2);
            return triangle.color * (direct + indirectLight);
        };
        DrawPolygon({triangle.v0, triangle.v1, triangle.v2}, phong);
    }
    sdlAux->render();
}

void Update() {
    const Uint8* keys = SDL_GetKeyboardState(nullptr);
    auto held = [&](int key) { return keys[key] != 0; };
    const float step = 0.04f;

    if (held(SDL_SCANCODE_W)) cameraPos += step * forward();
    if (held(SDL_SCANCODE_S)) cameraPos -= step * forward();
    if (held(SDL_SCANCODE_A)) cameraPos -= step * right();
    if (held(SDL_SCANCODE_D)) cameraPos += step * right();
    if (held(SDL_SCANCODE_Q)) yaw -= step;
    if (held(SDL_SCANCODE_E)) yaw += step;

    if (held(SDL_SCANCODE_UP)) lightPos += step * forward();
    if (held(SDL_SCANCODE_DOWN)) lightPos -= step * forward();
    if (held(SDL_SCANCODE_LEFT)) lightPos -= step * right();
    if (held(SDL_SCANCODE_RIGHT)) lightPos += step * right();
}

} // namespace

int main(int, char**) {
    LoadTestModel(triangles);
    sdlAux = new SDL2Aux(SCREEN_WIDTH, SCREEN_HEIGHT);
    while (sdlAux->noQuitMessage()) {
        Update();
        Draw();
    }
    delete sdlAux;
}
