// Rasterizer with classes: Camera, Lamp, DepthBuffer, Painter
#include <algorithm>
#include <climits>
#include <cmath>
#include <vector>
#include <glm/glm.hpp>
#include "SDL2auxiliary.h"
#include "TestModel.h"

using glm::vec3;
using std::vector;

static const int WIDTH = 400;
static const int HEIGHT = 400;

struct Pixel {
    int x, y;
    float zinv;
    vec3 light;
};

class Camera {
public:
    Camera() : m_position(0, 0, -3.001f), m_yaw(0), m_focal(HEIGHT) {}

    vec3 toLocal(const vec3& p) const {
        vec3 d = p - m_position;
        return vec3(glm::dot(d, right()), d.y, glm::dot(d, forward()));
    }

    Pixel project(const vec3& p) const {
        vec3 c = toLocal(p);
        Pixel pixel;
        pixel.x = int(m_focal * c.x / c.z + WIDTH / 2);
        pixel.y = int(m_focal * c.y / c.z + HEIGHT / 2);
        pixel.zinv = 1.0f / c.z;
        return pixel;
    }

    void walk(float distance) { m_position += distance * forward(); }
    void turn(float angle) { m_yaw += angle; }

private:
    vec3 right() const { return vec3(std::cos(m_yaw), 0, -std::sin(m_yaw)); }
    vec3 forward() const { return vec3(std::sin(m_yaw), 0, std::cos(m_yaw)); }

    vec3 m_position;
    float m_yaw;
    float m_focal;
};

class Lamp {
public:
    Lamp() : m_position(0, -0.5f, -0.7f), m_power(14, 14, 14) {}

    vec3 illuminate(const vec3& point, const vec3& normal, const vec3& reflectance) const {
        vec3 r = m_position - point;
        float rr = glm::dot(r, r);
        float angle = std::max(glm::dot(glm::normalize(r), normal), 0.0f);
        vec3 direct = m_power * angle / float(4 * M_PI * rr);
        return direct + reflectance;
    }

    void move(const vec3& by) { m_position += by; }

private:
    vec3 m_position;
    vec3 m_power;
};

class DepthBuffer {
public:
    DepthBuffer() : m_values(WIDTH * HEIGHT, 0.0f) {}

    void clear() { std::fill(m_values.begin(), m_values.end(), 0.0f); }

    // true if the pixel is the nearest so far
    bool test(const Pixel& p) {
        float& stored = m_values[p.y * WIDTH + p.x];
        if (p.zinv > stored) {
            stored = p.zinv;
            return true;
        }
        return false;
    }

private:
    vector<float> m_values;
};

class Painter {
public:
    explicit Painter(SDL2Aux* window) : m_window(window) {}

    void begin() {
        m_window->clearPixels();
        m_depth.clear();
    }

    void end() { m_window->render(); }

    void paint(const vector<Pixel>& corners) {
        vector<Pixel> left, right;
        computeRows(corners, left, right);
        for (size_t i = 0; i < left.size(); ++i) {
            if (left[i].x > right[i].x)
                continue;
            vector<Pixel> row(right[i].x - left[i].x + 1);
            interpolate(left[i], right[i], row);
            for (const Pixel& p : row)
                paintPixel(p);
        }
    }

private:
    static void interpolate(const Pixel& a, const Pixel& b, vector<Pixel>& result) {
        int n = result.size();
        float divisor = std::max(n - 1, 1);
        for (int i = 0; i < n; ++i) {
            float s = i / divisor;
            result[i].x = std::lround(a.x + s * (b.x - a.x));
            result[i].y = std::lround(a.y + s * (b.y - a.y));
            result[i].zinv = a.zinv + s * (b.zinv - a.zinv);
            result[i].light = a.light + s * (b.light - a.light);
        }
    }

    static void computeRows(const vector<Pixel>& corners, vector<Pixel>& left, vector<Pixel>& right) {
        int top = INT_MAX, bottom = INT_MIN;
        for (const Pixel& p : corners) {
            top = std::min(top, p.y);
            bottom = std::max(bottom, p.y);
        }
        left.resize(bottom - top + 1);
        right.resize(bottom - top + 1);
        for (size_t i = 0; i < left.size(); ++i) {
            left[i].x = INT_MAX;
            right[i].x = INT_MIN;
        }
        for (size_t i = 0; i < corners.size(); ++i) {
            const Pixel& a = corners[i];
            const Pixel& b = corners[(i + 1) % corners.size()];
            int samples = std::max(std::abs(a.x - b.x + 1), std::abs(a.y - b.y + 1));
            vector<Pixel> edge(samples);
            interpolate(a, b, edge);
            for (const Pixel& p : edge) {
                if (p.x < left[p.y - top].x) left[p.y - top] = p;
                if (p.x > right[p.y - top].x) right[p.y - top] = p;
            }
        }
    }

    void paintPixel(const Pixel& p) {
        if (p.x < 0 || p.x >= WIDTH || p.y < 0 || p.y >= HEIGHT)
            return;
        if (m_depth.test(p))
            m_window->putPixel(p.x, p.y, p.light);
    }

    SDL2Aux* m_window;
    DepthBuffer m_depth;
};

class Program {
public:
    Program() : m_window(WIDTH, HEIGHT), m_painter(&m_window) { LoadTestModel(m_triangles); }

    void run() {
        while (m_window.noQuitMessage()) {
            keys();
            draw();
        }
        m_window.saveBMP("screenshot.bmp");
    }

private:
    void keys() {
        const Uint8* k = SDL_GetKeyboardState(nullptr);
        if (k[SDL_SCANCODE_UP]) m_camera.walk(0.05f);
        if (k[SDL_SCANCODE_DOWN]) m_camera.walk(-0.05f);
        if (k[SDL_SCANCODE_LEFT]) m_camera.turn(-0.05f);
        if (k[SDL_SCANCODE_RIGHT]) m_camera.turn(0.05f);
        if (k[SDL_SCANCODE_W]) m_lamp.move(vec3(0, 0, 0.05f));
        if (k[SDL_SCANCODE_S]) m_lamp.move(vec3(0, 0, -0.05f));
        if (k[SDL_SCANCODE_A]) m_lamp.move(vec3(-0.05f, 0, 0));
        if (k[SDL_SCANCODE_D]) m_lamp.move(vec3(0.05f, 0, 0));
    }

    void draw() {
        m_painter.begin();
        for (const Triangle& t : m_triangles)
            drawTriangle(t);
        m_painter.end();
    }

    void drawTriangle(const Triangle& t) {
        vector<Pixel> corners;
        for (const vec3& v : {t.v0, t.v1, t.v2}) {
            if (m_camera.toLocal(v).z < 0.25f)
                return;
            Pixel p = m_camera.project(v);
            p.light = m_lamp.illuminate(v, t.normal, t.color);
            corners.push_back(p);
        }
        m_painter.paint(corners);
    }

    SDL2Aux m_window;
    Painter m_painter;
    Camera m_camera;
    Lamp m_lamp;
    vector<Triangle> m_triangles;
};

int main(int argc, char* argv[]) {
    Program program;
    program.run();
    return 0;
}
