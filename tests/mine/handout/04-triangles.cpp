// graphics lab 3
#include <stdio.h>
#include <stdlib.h>
#include <math.h>
#include <vector>
#include "SDL.h"
#include "SDLauxiliary.h"
#include "TestModel.h"

#define WIDTH 500
#define HEIGHT 500
#define MAXROWS 4000

struct point { int x, y; };

SDL_Surface *win;
std::vector<Triangle> room;

/* camera */
float camx = 0, camy = 0, camz = -3.001f;
float angle = 0;
float focal = 500;

/* the table of rows of the triangle that is being drawn */
int rowCount, firstRow;
int leftX[MAXROWS], rightX[MAXROWS];

/* 0 if it is behind us */
int project(glm::vec3 v, point *p)
{
    float dx = v.x - camx;
    float dy = v.y - camy;
    float dz = v.z - camz;
    float x = cosf(angle) * dx - sinf(angle) * dz;
    float z = sinf(angle) * dx + cosf(angle) * dz;
    if (z < 0.3f)
        return 0;
    p->x = (int)(focal * x / z + WIDTH / 2);
    p->y = (int)(focal * dy / z + HEIGHT / 2);
    return 1;
}

void interpolate(point a, point b, point *out, int n)
{
    float stepx = (float)(b.x - a.x) / (n > 1 ? n - 1 : 1);
    float stepy = (float)(b.y - a.y) / (n > 1 ? n - 1 : 1);
    for (int i = 0; i < n; i++) {
        out[i].x = (int)floorf(a.x + i * stepx + 0.5f);
        out[i].y = (int)floorf(a.y + i * stepy + 0.5f);
    }
}

void addEdge(point a, point b)
{
    int w = abs(a.x - b.x), h = abs(a.y - b.y);
    int n = (w > h ? w : h) + 1;
    point *line = (point *)malloc(n * sizeof(point));
    interpolate(a, b, line, n);
    for (int i = 0; i < n; i++) {
        int row = line[i].y - firstRow;
        if (row < 0 || row >= rowCount)
            continue;
        if (line[i].x < leftX[row])
            leftX[row] = line[i].x;
        if (line[i].x > rightX[row])
            rightX[row] = line[i].x;
    }
    free(line);
}

void computeRows(point p[3])
{
    int lo = p[0].y, hi = p[0].y;
    for (int i = 1; i < 3; i++) {
        if (p[i].y < lo) lo = p[i].y;
        if (p[i].y > hi) hi = p[i].y;
    }
    firstRow = lo;
    rowCount = hi - lo + 1;
    if (rowCount > MAXROWS)
        rowCount = MAXROWS;
    for (int i = 0; i < rowCount; i++) {
        leftX[i] = 1000000;
        rightX[i] = -1000000;
    }
    addEdge(p[0], p[1]);
    addEdge(p[1], p[2]);
    addEdge(p[2], p[0]);
}

void drawRows(glm::vec3 color)
{
    for (int i = 0; i < rowCount; i++) {
        int y = firstRow + i;
        if (y < 0 || y >= HEIGHT)
            continue;
        for (int x = leftX[i]; x < rightX[i]; x++)
            if (x >= 0 && x < WIDTH)
                PutPixelSDL(win, x, y, color);
    }
}

void drawTriangle(const Triangle &t)
{
    point p[3];
    if (!project(t.v0, &p[0]) || !project(t.v1, &p[1]) || !project(t.v2, &p[2]))
        return;
    computeRows(p);
    drawRows(t.color);
}

void draw()
{
    SDL_FillRect(win, 0, 0);
    for (int i = 0; i < (int)room.size(); i++)
        drawTriangle(room[i]);
    SDL_UpdateRect(win, 0, 0, 0, 0);
}

void keys()
{
    Uint8 *k = SDL_GetKeyState(0);
    if (k[SDLK_UP])    { camx += 0.1f * sinf(angle); camz += 0.1f * cosf(angle); }
    if (k[SDLK_DOWN])  { camx -= 0.1f * sinf(angle); camz -= 0.1f * cosf(angle); }
    if (k[SDLK_LEFT])  angle -= 0.1f;
    if (k[SDLK_RIGHT]) angle += 0.1f;
}

int main(int argc, char **argv)
{
    LoadTestModel(room);
    win = InitializeSDL(WIDTH, HEIGHT);
    while (NoQuitMessageSDL()) {
        keys();
        draw();
    }
    return 0;
}
