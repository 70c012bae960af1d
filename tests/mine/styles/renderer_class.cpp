#include "SDL2auxiliary.h"
#include "TestModel.h"
#include <glm/glm.hpp>
#include <algorithm>
#include <climits>
#include <cmath>
#include <memory>
#include <vector>

using glm::vec3;
using glm::mat3;

struct Pixel {
    int x;
    int y;
    double zinv;
    vec3 pos3d;
};

class Renderer {
public:
    Renderer(int width, int height)
        : width(width), height(height), focalLength(width), depth(width * height), sdl(new SDL2Aux(width, height)) {
        LoadTestModel(triangles);
        SetYaw(0);
    }

    void Run() {
        while (sdl->noQuitMessage()) {
            HandleKeys();
            Draw();
        }
        sdl->saveBMP("screenshot.bmp");
    }

private:
    // ----- window -----
    int width;
    int height;

    // ----- camera -----
    vec3 cameraPos = vec3(0, 0, -3.001f);
    mat3 R;
    float yaw = 0;
    float focalLength;

    // ----- light -----
    vec3 lightPos = vec3(0, -0.5f, -0.7f);
    vec3 lightPower = 10.0f * vec3(1, 1, 1);
    vec3 indirectLight = 0.5f * vec3(1, 1, 1);

    // ----- what is drawn -----
    std::vector<Triangle> triangles;
    std::vector<double> depth;
    vec3 currentNormal;
    vec3 currentColor;
    std::unique_ptr<SDL2Aux> sdl;

    void SetYaw(float angle) {
        yaw = angle;
        R[0] = vec3(std::cos(yaw), 0, -std::sin(yaw));
        R[1] = vec3(0, 1, 0);
        R[2] = vec3(std::sin(yaw), 0, std::cos(yaw));
    }

    void HandleKeys() {
        const Uint8* keys = SDL_GetKeyboardState(nullptr);
        if (keys[SDL_SCANCODE_UP]) cameraPos += 0.05f * R[2];
        if (keys[SDL_SCANCODE_DOWN]) cameraPos -= 0.05f * R[2];
        if (keys[SDL_SCANCODE_LEFT]) SetYaw(yaw - 0.05f);
        if (keys[SDL_SCANCODE_RIGHT]) SetYaw(yaw + 0.05f);
        if (keys[SDL_SCANCODE_W]) lightPos.z += 0.05f;
        if (keys[SDL_SCANCODE_S]) lightPos.z -= 0.05f;
        if (keys[SDL_SCANCODE_A]) lightPos.x -= 0.05f;
        if (keys[SDL_SCANCODE_D]) lightPos.x += 0.05f;
        if (keys[SDL_SCANCODE_Q]) lightPos.y -= 0.05f;
        if (keys[SDL_SCANCODE_E]) lightPos.y += 0.05f;
    }

    void Draw() {
        sdl->clearPixels();
        std::fill(depth.begin(), depth.end(), 0.0);
        for (const Triangle& t : triangles) {
            currentNormal = t.normal;
            currentColor = t.color;
            DrawPolygon({t.v0, t.v1, t.v2});
        }
        sdl->render();
    }

    void DrawPolygon(const std::vector<vec3>& vertices) {
        std::vector<Pixel> corners;
        for (const vec3& v : vertices) {
            const vec3 p = (v - cameraPos) * R;
            if (p.z < 0.2f) return;
            corners.push_back(Project(p, v));
        }
        std::vector<Pixel> left, right;
        ComputeRows(corners, left, right);
        DrawRows(left, right);
    }

    Pixel Project(const vec3& p, const vec3& world) const {
        Pixel pixel;
        pixel.x = std::floor(focalLength * p.x / p.z + width / 2);
        pixel.y = std::floor(focalLength * p.y / p.z + height / 2);
        pixel.zinv = 1.0 / p.z;
        pixel.pos3d = world / p.z;
        return pixel;
    }

    // Doubles are exact enough that adding up steps cannot end a pixel early; the
    // half makes int() round.
    static void Interpolate(const Pixel& a, const Pixel& b, std::vector<Pixel>& line) {
        const double steps = std::max<int>(line.size() - 1, 1);
        const double dx = (b.x - a.x) / steps;
        const double dy = (b.y - a.y) / steps;
        const double dz = (b.zinv - a.zinv) / steps;
        const vec3 dp = (b.pos3d - a.pos3d) / float(steps);
        double x = a.x, y = a.y, z = a.zinv;
        for (size_t i = 0; i < line.size(); i++) {
            line[i].x = std::floor(x + 0.5);
            line[i].y = std::floor(y + 0.5);
            line[i].zinv = z;
            line[i].pos3d = a.pos3d + float(i) * dp;
            x += dx;
            y += dy;
            z += dz;
        }
    }

    void ComputeRows(const std::vector<Pixel>& corners, std::vector<Pixel>& left, std::vector<Pixel>& right) const {
        int yMin = corners[0].y, yMax = corners[0].y;
        for (const Pixel& c : corners) {
            yMin = std::min(yMin, c.y);
            yMax = std::max(yMax, c.y);
        }
        left.resize(yMax - yMin + 1);
        right.resize(yMax - yMin + 1);
        for (size_t i = 0; i < left.size(); i++) {
            left[i].x = INT_MAX;
            right[i].x = INT_MIN;
        }
        for (size_t i = 0; i < corners.size(); i++) {
            const Pixel& from = corners[i];
            const Pixel& to = corners[i + 1 == corners.size() ? 0 : i + 1];
            std::vector<Pixel> edge(std::max(std::abs(from.x - to.x), std::abs(from.y - to.y)) + 1);
            Interpolate(from, to, edge);
            for (const Pixel& p : edge) {
                if (p.y < yMin || p.y > yMax) continue;
                Pixel& l = left[p.y - yMin];
                Pixel& r = right[p.y - yMin];
                if (p.x < l.x) l = p;
                if (p.x > r.x) r = p;
            }
        }
    }

    void DrawRows(const std::vector<Pixel>& left, const std::vector<Pixel>& right) {
        for (size_t i = 0; i < left.size(); i++) {
            if (left[i].y < 0 || left[i].y >= height) continue;
            std::vector<Pixel> row(right[i].x - left[i].x + 1);
            Interpolate(left[i], right[i], row);
            for (const Pixel& p : row) {
                if (p.x < 0 || p.x >= width) continue;
                if (p.zinv > depth[p.y * width + p.x]) {
                    depth[p.y * width + p.x] = p.zinv;
                    sdl->putPixel(p.x, p.y, Shade(p));
                }
            }
        }
    }

    vec3 Shade(const Pixel& p) const {
        const vec3 position = p.pos3d / float(p.zinv);
        const vec3 r = glm::normalize(lightPos - position);
        const float d = glm::distance(lightPos, position);
        const float facing = std::max(0.0f, glm::dot(r, currentNormal));
        const vec3 direct = lightPower * facing / float(4 * M_PI * d * d);
        return currentColor * (direct + indirectLight);
    }
};

int main(int argc, char* argv[]) {
    Renderer renderer(500, 500);
    renderer.Run();
    return 0;
}
