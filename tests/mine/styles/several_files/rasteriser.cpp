#include "rasteriser.h"
#include "camera.h"
#include "lighting.h"
#include "SDLauxiliary.h"
#include <algorithm>
#include <cmath>

using std::vector;
using glm::vec3;

static float depthBuffer[SCREEN_HEIGHT][SCREEN_WIDTH];

void ClearDepth()
{
    for (auto& row : depthBuffer)
        std::fill(std::begin(row), std::end(row), 0.0f);
}

void Interpolate(const Pixel& a, const Pixel& b, vector<Pixel>& result)
{
    int n = result.size();
    if (n == 1)
    {
        result[0] = a;
        return;
    }
    for (int i = 0; i < n; ++i)
    {
        float t = float(i) / float(n - 1);
        Pixel p = a * (1 - t) + b * t;
        p.x = std::round(p.x);
        p.y = std::round(p.y);
        result[i] = p;
    }
}

static int SamplesOf(const Pixel& a, const Pixel& b)
{
    return int(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y))) + 1;
}

void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels, vector<Pixel>& rightPixels)
{
    float top = vertexPixels[0].y;
    float bottom = vertexPixels[0].y;
    for (const Pixel& p : vertexPixels)
    {
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
    }

    int rows = int(bottom - top) + 1;
    leftPixels = vector<Pixel>(rows);
    rightPixels = vector<Pixel>(rows);
    for (int i = 0; i < rows; ++i)
    {
        leftPixels[i].x = 1e9f;
        rightPixels[i].x = -1e9f;
        leftPixels[i].y = rightPixels[i].y = top + i;
    }

    for (size_t i = 0; i < vertexPixels.size(); ++i)
    {
        const Pixel& from = vertexPixels[i];
        const Pixel& to = vertexPixels[(i + 1) % vertexPixels.size()];
        vector<Pixel> edge(SamplesOf(from, to));
        Interpolate(from, to, edge);
        for (const Pixel& p : edge)
        {
            int row = int(p.y - top);
            if (p.x < leftPixels[row].x)
                leftPixels[row] = p;
            if (p.x > rightPixels[row].x)
                rightPixels[row] = p;
        }
    }
}

static void PixelShader(const Pixel& p, const Triangle& triangle)
{
    int x = int(p.x);
    int y = int(p.y);
    if (p.zinv > depthBuffer[y][x])
    {
        depthBuffer[y][x] = p.zinv;
        PutPixelSDL(screen, x, y, Reflected(p.pos / p.zinv, triangle.normal, triangle.color));
    }
}

static bool OnScreen(const Pixel& p)
{
    return p.x >= 0 && p.x < SCREEN_WIDTH && p.y >= 0 && p.y < SCREEN_HEIGHT;
}

static void DrawPolygonRows(const vector<Pixel>& leftPixels, const vector<Pixel>& rightPixels,
                            const Triangle& triangle)
{
    for (size_t i = 0; i < leftPixels.size(); ++i)
    {
        int width = int(rightPixels[i].x - leftPixels[i].x) + 1;
        vector<Pixel> row(width);
        Interpolate(leftPixels[i], rightPixels[i], row);
        for (const Pixel& p : row)
            if (OnScreen(p))
                PixelShader(p, triangle);
    }
}

void DrawTriangle(const Triangle& triangle)
{
    const vec3 corners[3] = {triangle.v0, triangle.v1, triangle.v2};
    vector<Pixel> vertexPixels(3);
    for (int i = 0; i < 3; ++i)
    {
        if (ToCameraSpace(corners[i]).z <= 0.2f)
            return;
        VertexShader(corners[i], vertexPixels[i]);
    }

    vector<Pixel> leftPixels, rightPixels;
    ComputePolygonRows(vertexPixels, leftPixels, rightPixels);
    DrawPolygonRows(leftPixels, rightPixels, triangle);
}
