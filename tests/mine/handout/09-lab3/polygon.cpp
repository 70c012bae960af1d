#include "globals.h"
#include "SDLauxiliary.h"
#include <cstdlib>
#include <limits>

using namespace std;
using glm::vec3;

float depthBuffer[SCREEN_HEIGHT][SCREEN_WIDTH];
vec3 currentNormal;
vec3 currentReflectance;

void ClearDepthBuffer()
{
    for (int y = 0; y < SCREEN_HEIGHT; y++)
        for (int x = 0; x < SCREEN_WIDTH; x++)
            depthBuffer[y][x] = 0;
}

void Interpolate(Pixel a, Pixel b, vector<Pixel>& result)
{
    int N = result.size();
    float div = N > 1 ? float(N - 1) : 1.0f;
    float dx = (b.x - a.x) / div;
    float dy = (b.y - a.y) / div;
    float dz = (b.zinv - a.zinv) / div;
    vec3 dp = (b.pos3d - a.pos3d) / div;
    float x = a.x;
    float y = a.y;
    for (int i = 0; i < N; i++)
    {
        result[i].x = round(x);
        result[i].y = round(y);
        result[i].zinv = a.zinv;
        result[i].pos3d = a.pos3d;
        x += dx;
        y += dy;
        a.zinv += dz;
        a.pos3d += dp;
    }
}

void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels, vector<Pixel>& rightPixels)
{
    int minY = vertexPixels[0].y;
    int maxY = vertexPixels[0].y;
    for (size_t i = 1; i < vertexPixels.size(); i++)
    {
        minY = min(minY, vertexPixels[i].y);
        maxY = max(maxY, vertexPixels[i].y);
    }
    int rows = maxY - minY + 1;
    leftPixels.resize(rows);
    rightPixels.resize(rows);
    for (int i = 0; i < rows; i++)
    {
        leftPixels[i].x = numeric_limits<int>::max();
        rightPixels[i].x = -numeric_limits<int>::max();
    }

    for (size_t i = 0; i < vertexPixels.size(); i++)
    {
        Pixel a = vertexPixels[i];
        Pixel b = vertexPixels[(i + 1) % vertexPixels.size()];
        int pixels = max(abs(a.x - b.x), abs(a.y - b.y)) + 1;
        vector<Pixel> line(pixels);
        Interpolate(a, b, line);
        for (int k = 0; k < pixels; k++)
        {
            int row = line[k].y - minY;
            if (row < 0 || row >= rows)
                continue;
            if (line[k].x < leftPixels[row].x)
                leftPixels[row] = line[k];
            if (line[k].x > rightPixels[row].x)
                rightPixels[row] = line[k];
        }
    }
}

void PixelShader(const Pixel& p)
{
    if (p.x < 0 || p.y < 0 || p.x >= SCREEN_WIDTH || p.y >= SCREEN_HEIGHT)
        return;
    if (p.zinv > depthBuffer[p.y][p.x])
    {
        depthBuffer[p.y][p.x] = p.zinv;
        vec3 r = lightPos - p.pos3d / p.zinv;
        float r2 = glm::dot(r, r);
        float cosine = max(glm::dot(glm::normalize(r), currentNormal), 0.0f);
        vec3 D = lightPower * cosine / (4.0f * float(M_PI) * r2);
        PutPixelSDL(screen, p.x, p.y, currentReflectance * (D + indirectLightPowerPerArea));
    }
}

void DrawPolygonRows(const vector<Pixel>& leftPixels, const vector<Pixel>& rightPixels)
{
    for (size_t i = 0; i < leftPixels.size(); i++)
    {
        if (leftPixels[i].x > rightPixels[i].x)
            continue;
        vector<Pixel> line(rightPixels[i].x - leftPixels[i].x + 1);
        Interpolate(leftPixels[i], rightPixels[i], line);
        for (size_t k = 0; k < line.size(); k++)
            PixelShader(line[k]);
    }
}

void DrawPolygon(const vector<Vertex>& vertices, vec3 normal, vec3 reflectance)
{
    currentNormal = normal;
    currentReflectance = reflectance;

    vector<Pixel> vertexPixels(vertices.size());
    for (size_t i = 0; i < vertices.size(); i++)
    {
        if (CameraSpace(vertices[i].position).z < 0.25f)
            return;
        VertexShader(vertices[i], vertexPixels[i]);
    }
    vector<Pixel> leftPixels;
    vector<Pixel> rightPixels;
    ComputePolygonRows(vertexPixels, leftPixels, rightPixels);
    DrawPolygonRows(leftPixels, rightPixels);
}
