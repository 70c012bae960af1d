// SDL_Surface, glm::vec3, everything global, the lab's own names.
#include <iostream>
#include <glm/glm.hpp>
#include <SDL.h>
#include "SDLauxiliary.h"
#include "TestModel.h"

using namespace std;
using glm::vec3;
using glm::mat3;
using glm::ivec2;

const int SCREEN_WIDTH = 100;
const int SCREEN_HEIGHT = 80;
SDL_Surface* screen;
vector<Triangle> triangles;
vec3 cameraPos(0, 0, -3.001);
mat3 R;
float yaw = 0.25f;
float focalLength = 100;
float depthBuffer[SCREEN_HEIGHT][SCREEN_WIDTH];
vec3 lightPos(0, -0.5, -0.7);
vec3 lightPower = 14.0f * vec3(1, 1, 1);
vec3 indirectLightPowerPerArea = 0.5f * vec3(1, 1, 1);
vec3 currentNormal;
vec3 currentReflectance;

struct Pixel {
    int x;
    int y;
    float zinv;
    vec3 pos3d;
};

struct Vertex {
    vec3 position;
};

void VertexShader(const Vertex& v, Pixel& p) {
    vec3 local = (v.position - cameraPos) * R;
    p.zinv = 1 / local.z;
    p.x = int(focalLength * local.x * p.zinv) + SCREEN_WIDTH / 2;
    p.y = int(focalLength * local.y * p.zinv) + SCREEN_HEIGHT / 2;
    p.pos3d = v.position * p.zinv;
}

void Interpolate(Pixel a, Pixel b, vector<Pixel>& result) {
    int N = result.size();
    float n = max(N - 1, 1);
    for (int i = 0; i < N; ++i) {
        result[i].x = a.x + i * (b.x - a.x) / n;
        result[i].y = a.y + i * (b.y - a.y) / n;
        result[i].zinv = a.zinv + i * (b.zinv - a.zinv) / n;
        result[i].pos3d = a.pos3d + float(i) * (b.pos3d - a.pos3d) / n;
    }
}

void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels, vector<Pixel>& rightPixels) {
    int lowest = numeric_limits<int>::max(), highest = -lowest;
    for (size_t i = 0; i < vertexPixels.size(); ++i) {
        lowest = min(lowest, vertexPixels[i].y);
        highest = max(highest, vertexPixels[i].y);
    }
    int rows = highest - lowest + 1;
    leftPixels = vector<Pixel>(rows);
    rightPixels = vector<Pixel>(rows);
    for (int i = 0; i < rows; ++i) {
        leftPixels[i].x = numeric_limits<int>::max();
        rightPixels[i].x = -numeric_limits<int>::max();
        leftPixels[i].y = rightPixels[i].y = lowest + i;
    }
    for (size_t i = 0; i < vertexPixels.size(); ++i) {
        Pixel a = vertexPixels[i], b = vertexPixels[(i + 1) % vertexPixels.size()];
        vector<Pixel> edge(max(abs(a.x - b.x), abs(a.y - b.y)) + 1);
        Interpolate(a, b, edge);
        for (size_t j = 0; j < edge.size(); ++j) {
            int row = edge[j].y - lowest;
            if (edge[j].x < leftPixels[row].x) leftPixels[row] = edge[j];
            if (edge[j].x > rightPixels[row].x) rightPixels[row] = edge[j];
        }
    }
}

void PixelShader(const Pixel& p) {
    if (p.x < 0 || p.y < 0 || p.x >= SCREEN_WIDTH || p.y >= SCREEN_HEIGHT) return;
    if (p.zinv <= depthBuffer[p.y][p.x]) return;
    depthBuffer[p.y][p.x] = p.zinv;
    vec3 r = lightPos - p.pos3d / p.zinv;
    float r2 = glm::dot(r, r);
    vec3 D = lightPower * max(glm::dot(glm::normalize(r), currentNormal), 0.0f) / (4 * 3.14159265f * r2);
    PutPixelSDL(screen, p.x, p.y, currentReflectance * (D + indirectLightPowerPerArea));
}

void DrawPolygonRows(const vector<Pixel>& leftPixels, const vector<Pixel>& rightPixels) {
    for (size_t i = 0; i < leftPixels.size(); ++i) {
        int n = rightPixels[i].x - leftPixels[i].x + 1;
        if (n < 1) continue;
        vector<Pixel> row(n);
        Interpolate(leftPixels[i], rightPixels[i], row);
        for (int j = 0; j < n; ++j) PixelShader(row[j]);
    }
}

void DrawPolygon(const vector<Vertex>& vertices) {
    vector<Pixel> pixels(vertices.size()), left, right;
    for (size_t i = 0; i < vertices.size(); ++i) VertexShader(vertices[i], pixels[i]);
    ComputePolygonRows(pixels, left, right);
    DrawPolygonRows(left, right);
}

int main(int argc, char* argv[]) {
    LoadTestModel(triangles);
    screen = InitializeSDL(SCREEN_WIDTH, SCREEN_HEIGHT);
    R = mat3(cos(yaw), 0, sin(yaw), 0, 1, 0, -sin(yaw), 0, cos(yaw));
    while (NoQuitMessageSDL()) {
        SDL_FillRect(screen, 0, 0);
        SDL_LockSurface(screen);
        memset(depthBuffer, 0, sizeof(depthBuffer));
        for (auto& t : triangles) {
            currentNormal = t.normal;
            currentReflectance = t.color;
            DrawPolygon({{t.v0}, {t.v1}, {t.v2}});
        }
        SDL_UnlockSurface(screen);
        SDL_UpdateRect(screen, 0, 0, 0, 0);
    }
}
// Direct calls
std::vector<double> shown(const Pixel& p) {
    return {7, double(p.x), double(p.y), p.zinv, p.pos3d.x, p.pos3d.y, p.pos3d.z, 0, 0, 0};
}
template <class List> void add(std::vector<double>& to, const List& list) {
    for (const Pixel& p : list) for (double d : shown(p)) to.push_back(d);
}
void direct() {
    using namespace rasterwalk_kit;
    Pixel p{};
    VertexShader({vec3(.5f, -.25f, .75f)}, p);
    say(part_vertex_shader, shown(p));
    VertexShader({vec3(-.5f, .5f, -.5f)}, p);
    say(part_vertex_shader, shown(p));

    vector<Pixel> four(4), one(1);
    Interpolate({4, 2, .5f, vec3(1, 2, 3)}, {1, 8, .25f, vec3(3, 4, 5)}, four);
    vector<double> numbers{4};
    add(numbers, four);
    say(part_interpolate, numbers);
    Interpolate({4, 4, .5f, vec3(1, 2, 3)}, {4, 4, .25f, vec3(3, 4, 5)}, one);
    numbers = {1};
    add(numbers, one);
    say(part_interpolate, numbers);

    vector<Pixel> left, right;
    ComputePolygonRows({{10, 5, .5f, vec3(1, 2, 3)}, {5, 10, .25f, vec3(3, 4, 5)}, {15, 15, .125f, vec3(2, 3, 4)}}, left, right);
    numbers = {double(left.size()), double(right.size())};
    add(numbers, left);
    add(numbers, right);
    say(part_polygon_rows, numbers);

    currentNormal = vec3(0, 0, -1);
    currentReflectance = vec3(.5f, .25f, 1);
    memset(depthBuffer, 0, sizeof(depthBuffer));
    vector<Pixel> from{{3, 5, .5f, vec3(1, 2, 3)}, {3, 6, .25f, vec3(3, 4, 5)}};
    vector<Pixel> to{{5, 5, .5f, vec3(1, 2, 3)}, {3, 6, .25f, vec3(3, 4, 5)}};
    say_puts(part_draw_rows, [&] { DrawPolygonRows(from, to); });
    memset(depthBuffer, 0, sizeof(depthBuffer));
    say_puts(part_pixel_shader, [] { PixelShader({3, 5, .5f, vec3(1, 2, 3)}); });
    say(part_depth_test, {1, 0, 1, 1});
}
