#include <stdint.h>
#include <math.h>
#include <string.h>
#include <limits.h>
#include <stdlib.h>
#include <vector>
#include <SDL.h>
#include <glm/glm.hpp>
#include "SDLauxiliary.h"
#include "TestModelH.h"

using glm::vec3;
using glm::vec4;

#define SCREEN_WIDTH  512
#define SCREEN_HEIGHT 512
#define FULLSCREEN_MODE false
#define NEAR_PLANE 0.2
#define MAX_LINE 6000           /* f * 2 / NEAR_PLANE, and a bit */

typedef struct {
    int x, y;
    double zinv;
    double pos[3];              /* world position * zinv */
} pixel_t;

std::vector<Triangle> triangles;

double camera[3] = {0, 0, -3.001};
double camera_yaw = 0;
double focal = SCREEN_WIDTH;

double lamp[3] = {0, -0.5, -0.7};
double lamp_power = 14;
double indirect = 0.5;

static double depth_buffer[SCREEN_HEIGHT][SCREEN_WIDTH];
static pixel_t edge[MAX_LINE];
static pixel_t line[SCREEN_WIDTH];
static pixel_t left[SCREEN_HEIGHT], right[SCREEN_HEIGHT];

void to_camera(const vec4 &v, double out[3])
{
    double x = v.x - camera[0];
    double y = v.y - camera[1];
    double z = v.z - camera[2];
    out[0] = cos(camera_yaw) * x - sin(camera_yaw) * z;
    out[1] = y;
    out[2] = sin(camera_yaw) * x + cos(camera_yaw) * z;
}

/* returns 0 if the vertex cannot be projected */
int vertex_shader(const vec4 &v, pixel_t *p)
{
    double c[3];
    to_camera(v, c);
    if (c[2] < NEAR_PLANE)
        return 0;
    p->zinv = 1.0 / c[2];
    p->x = (int)lrint(focal * c[0] * p->zinv + SCREEN_WIDTH / 2);
    p->y = (int)lrint(focal * c[1] * p->zinv + SCREEN_HEIGHT / 2);
    p->pos[0] = v.x * p->zinv;
    p->pos[1] = v.y * p->zinv;
    p->pos[2] = v.z * p->zinv;
    return 1;
}

void mix_pixels(const pixel_t *a, const pixel_t *b, double t, pixel_t *out)
{
    out->x = (int)lrint(a->x + t * (b->x - a->x));
    out->y = (int)lrint(a->y + t * (b->y - a->y));
    out->zinv = a->zinv + t * (b->zinv - a->zinv);
    for (int k = 0; k < 3; k++)
        out->pos[k] = a->pos[k] + t * (b->pos[k] - a->pos[k]);
}

void interpolate(const pixel_t *a, const pixel_t *b, pixel_t *result, int n)
{
    for (int i = 0; i < n; i++) {
        double t = n > 1 ? (double)i / (n - 1) : 0.0;
        mix_pixels(a, b, t, &result[i]);
    }
}

/* Fills left and right for the rows on the screen. Rows above and below are skipped. */
void compute_polygon_rows(const pixel_t corner[3], int *first, int *last)
{
    *first = SCREEN_HEIGHT;
    *last = -1;
    for (int i = 0; i < 3; i++) {
        if (corner[i].y < *first) *first = corner[i].y;
        if (corner[i].y > *last) *last = corner[i].y;
    }
    if (*first < 0) *first = 0;
    if (*last > SCREEN_HEIGHT - 1) *last = SCREEN_HEIGHT - 1;

    for (int y = *first; y <= *last; y++) {
        left[y].x = INT_MAX;
        right[y].x = INT_MIN;
    }
    for (int i = 0; i < 3; i++) {
        const pixel_t *a = &corner[i];
        const pixel_t *b = &corner[(i + 1) % 3];
        int dx = abs(a->x - b->x);
        int dy = abs(a->y - b->y);
        int n = (dx > dy ? dx : dy) + 1;
        if (n > MAX_LINE) n = MAX_LINE;
        interpolate(a, b, edge, n);
        for (int k = 0; k < n; k++) {
            int y = edge[k].y;
            if (y < *first || y > *last) continue;
            if (edge[k].x < left[y].x) left[y] = edge[k];
            if (edge[k].x > right[y].x) right[y] = edge[k];
        }
    }
}

/* one channel, as the screen will show it */
int to_byte(double value)
{
    int byte = (int)(255 * value);
    if (byte > 255) byte = 255;
    if (byte < 0) byte = 0;
    return byte;
}

void pixel_shader(screen *screen, const pixel_t *p, const Triangle &triangle)
{
    if (p->zinv <= depth_buffer[p->y][p->x])
        return;
    depth_buffer[p->y][p->x] = p->zinv;

    double r[3], r2 = 0, rn = 0;
    for (int k = 0; k < 3; k++) {
        r[k] = lamp[k] - p->pos[k] / p->zinv;
        r2 += r[k] * r[k];
        rn += r[k] * triangle.normal[k];
    }
    double cosine = rn / sqrt(r2);
    if (cosine < 0) cosine = 0;
    double received = lamp_power * cosine / (4 * M_PI * r2) + indirect;

    vec3 color;
    for (int k = 0; k < 3; k++)
        color[k] = to_byte(triangle.color[k] * received) / 255.0f;
    PutPixelSDL(screen, p->x, p->y, color);
}

void draw_row(screen *screen, const pixel_t *a, const pixel_t *b, const Triangle &triangle)
{
    /* only the part on the screen */
    int from = a->x < 0 ? 0 : a->x;
    int to = b->x >= SCREEN_WIDTH ? SCREEN_WIDTH - 1 : b->x;
    for (int x = from; x <= to; x++) {
        double t = b->x > a->x ? (double)(x - a->x) / (b->x - a->x) : 0.0;
        mix_pixels(a, b, t, &line[x]);
        line[x].x = x;
    }
    for (int x = from; x <= to; x++)
        pixel_shader(screen, &line[x], triangle);
}

void draw_triangle(screen *screen, const Triangle &triangle)
{
    pixel_t corner[3];
    if (!vertex_shader(triangle.v0, &corner[0])) return;
    if (!vertex_shader(triangle.v1, &corner[1])) return;
    if (!vertex_shader(triangle.v2, &corner[2])) return;

    int first, last;
    compute_polygon_rows(corner, &first, &last);
    for (int y = first; y <= last; y++)
        draw_row(screen, &left[y], &right[y], triangle);
}

void Draw(screen *screen)
{
    memset(screen->buffer, 0, screen->height * screen->width * sizeof(uint32_t));
    for (int y = 0; y < SCREEN_HEIGHT; y++)
        for (int x = 0; x < SCREEN_WIDTH; x++)
            depth_buffer[y][x] = 0;

    for (size_t i = 0; i < triangles.size(); i++)
        draw_triangle(screen, triangles[i]);
}

void Update()
{
    const Uint8 *keys = SDL_GetKeyboardState(NULL);
    double s = 0.05;

    if (keys[SDL_SCANCODE_UP]) {
        camera[0] += s * sin(camera_yaw);
        camera[2] += s * cos(camera_yaw);
    }
    if (keys[SDL_SCANCODE_DOWN]) {
        camera[0] -= s * sin(camera_yaw);
        camera[2] -= s * cos(camera_yaw);
    }
    if (keys[SDL_SCANCODE_LEFT])  camera_yaw -= s;
    if (keys[SDL_SCANCODE_RIGHT]) camera_yaw += s;

    if (keys[SDL_SCANCODE_W]) lamp[2] += s;
    if (keys[SDL_SCANCODE_S]) lamp[2] -= s;
    if (keys[SDL_SCANCODE_A]) lamp[0] -= s;
    if (keys[SDL_SCANCODE_D]) lamp[0] += s;
    if (keys[SDL_SCANCODE_Q]) lamp[1] -= s;
    if (keys[SDL_SCANCODE_E]) lamp[1] += s;
}

int main(int argc, char *argv[])
{
    screen *screen = InitializeSDL(SCREEN_WIDTH, SCREEN_HEIGHT, FULLSCREEN_MODE);
    LoadTestModel(triangles);

    while (NoQuitMessageSDL()) {
        Update();
        Draw(screen);
        SDL_Renderframe(screen);
    }

    SDL_SaveImage(screen, "screenshot.bmp");
    KillSDL(screen);
    return 0;
}
