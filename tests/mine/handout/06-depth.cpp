// LAB 3 Rasterization, depth buffer and illumination
#include <iostream>
#include <vector>
#include <limits>
#include <cmath>
#include <glm/glm.hpp>
#include <SDL.h>
#include "SDLauxiliary.h"
#include "TestModel.h"

using namespace std;
using glm::vec3;
using glm::dvec3;
using glm::dmat3;

const int SCREEN_WIDTH = 500;
const int SCREEN_HEIGHT = 500;

// I use double everywhere, float gave me small errors in the edges.

struct Pixel
{
	int x;
	int y;
	double zinv;
	dvec3 illumination;
};

struct Vertex
{
	dvec3 position;
	dvec3 normal;
	dvec3 reflectance;
};

SDL_Surface* screen;
vector<Triangle> triangles;
double depthBuffer[SCREEN_HEIGHT][SCREEN_WIDTH];

dvec3 cameraPos(0, 0, -3.001);
double yaw = 0;
dmat3 R(1.0);
double focalLength = 500;

dvec3 lightPos(0, -0.5, -0.7);
dvec3 lightPower = 14.0 * dvec3(1, 1, 1);
dvec3 indirectLightPowerPerArea = 0.5 * dvec3(1, 1, 1);

dvec3 DirectLight(const Vertex& v)
{
	dvec3 r = lightPos - v.position;
	double distance = glm::length(r);
	dvec3 rHat = r / distance;
	double cosAlpha = max(glm::dot(rHat, v.normal), 0.0);
	double sphere = 4 * M_PI * distance * distance * distance;
	return lightPower * cosAlpha / sphere;
}

void VertexShader(const Vertex& v, Pixel& p)
{
	dvec3 local = (v.position - cameraPos) * R;
	p.zinv = 1.0 / local.z;
	p.x = int(focalLength * local.x * p.zinv) + SCREEN_WIDTH / 2;
	p.y = int(focalLength * local.y * p.zinv) + SCREEN_HEIGHT / 2;
	p.illumination = v.reflectance * (DirectLight(v) + indirectLightPowerPerArea);
}

void PixelShader(const Pixel& p)
{
	if (p.x < 0 || p.x >= SCREEN_WIDTH || p.y < 0 || p.y >= SCREEN_HEIGHT)
		return;
	if (p.zinv > depthBuffer[p.y][p.x])
	{
		depthBuffer[p.y][p.x] = p.zinv;
		PutPixelSDL(screen, p.x, p.y, vec3(p.illumination));
	}
}

void Interpolate(Pixel a, Pixel b, vector<Pixel>& result)
{
	int N = result.size();
	double div = double(max(N - 1, 1));
	for (int i = 0; i < N; ++i)
	{
		double part = i / div;
		result[i].x = int(lround(a.x + (b.x - a.x) * part));
		result[i].y = int(lround(a.y + (b.y - a.y) * part));
		result[i].zinv = a.zinv + (b.zinv - a.zinv) * part;
		result[i].illumination = a.illumination + (b.illumination - a.illumination) * part;
	}
}

void ComputePolygonRows(const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels, vector<Pixel>& rightPixels)
{
	int smallest = +numeric_limits<int>::max();
	int largest = -numeric_limits<int>::max();
	for (size_t i = 0; i < vertexPixels.size(); ++i)
	{
		smallest = min(smallest, vertexPixels[i].y);
		largest = max(largest, vertexPixels[i].y);
	}
	int ROWS = largest - smallest + 1;

	leftPixels = vector<Pixel>(ROWS);
	rightPixels = vector<Pixel>(ROWS);
	for (int i = 0; i < ROWS; ++i)
	{
		leftPixels[i].x = +numeric_limits<int>::max();
		rightPixels[i].x = -numeric_limits<int>::max();
	}

	for (size_t i = 0; i < vertexPixels.size(); ++i)
	{
		Pixel a = vertexPixels[i];
		Pixel b = vertexPixels[(i + 1) % vertexPixels.size()];
		int pixels = max(abs(a.x - b.x), abs(a.y - b.y)) + 1;
		vector<Pixel> line(pixels);
		Interpolate(a, b, line);
		for (int k = 0; k < pixels; ++k)
		{
			int row = line[k].y - smallest;
			if (line[k].x < leftPixels[row].x)
				leftPixels[row] = line[k];
			if (line[k].x > rightPixels[row].x)
				rightPixels[row] = line[k];
		}
	}
}

void DrawPolygonRows(const vector<Pixel>& leftPixels, const vector<Pixel>& rightPixels)
{
	for (size_t i = 0; i < leftPixels.size(); ++i)
	{
		vector<Pixel> pixels(rightPixels[i].x - leftPixels[i].x + 1);
		Interpolate(leftPixels[i], rightPixels[i], pixels);
		for (size_t k = 0; k < pixels.size(); ++k)
			PixelShader(pixels[k]);
	}
}

void DrawPolygon(const vector<Vertex>& vertices)
{
	vector<Pixel> vertexPixels(vertices.size());
	for (size_t i = 0; i < vertices.size(); ++i)
	{
		dvec3 local = (vertices[i].position - cameraPos) * R;
		if (local.z < 0.3)
			return;
		VertexShader(vertices[i], vertexPixels[i]);
	}
	vector<Pixel> leftPixels, rightPixels;
	ComputePolygonRows(vertexPixels, leftPixels, rightPixels);
	DrawPolygonRows(leftPixels, rightPixels);
}

void Draw()
{
	SDL_FillRect(screen, 0, 0);
	if (SDL_MUSTLOCK(screen))
		SDL_LockSurface(screen);

	for (int y = 0; y < SCREEN_HEIGHT; ++y)
		for (int x = 0; x < SCREEN_WIDTH; ++x)
			depthBuffer[y][x] = 0.0;

	for (size_t i = 0; i < triangles.size(); ++i)
	{
		vec3 corners[3] = { triangles[i].v0, triangles[i].v1, triangles[i].v2 };
		vector<Vertex> vertices(3);
		for (int k = 0; k < 3; ++k)
		{
			vertices[k].position = dvec3(corners[k]);
			vertices[k].normal = dvec3(triangles[i].normal);
			vertices[k].reflectance = dvec3(triangles[i].color);
		}
		DrawPolygon(vertices);
	}

	if (SDL_MUSTLOCK(screen))
		SDL_UnlockSurface(screen);
	SDL_UpdateRect(screen, 0, 0, 0, 0);
}

void Update()
{
	Uint8* keystate = SDL_GetKeyState(0);
	const double step = 0.1;

	if (keystate[SDLK_UP])
		cameraPos += step * R[2];
	if (keystate[SDLK_DOWN])
		cameraPos -= step * R[2];
	if (keystate[SDLK_LEFT])
		yaw -= step;
	if (keystate[SDLK_RIGHT])
		yaw += step;

	if (keystate[SDLK_w])
		lightPos.z += step;
	if (keystate[SDLK_s])
		lightPos.z -= step;
	if (keystate[SDLK_a])
		lightPos.x -= step;
	if (keystate[SDLK_d])
		lightPos.x += step;

	R[0] = dvec3(cos(yaw), 0, -sin(yaw));
	R[2] = dvec3(sin(yaw), 0, cos(yaw));
}

int main(int argc, char* argv[])
{
	LoadTestModel(triangles);
	screen = InitializeSDL(SCREEN_WIDTH, SCREEN_HEIGHT);
	while (NoQuitMessageSDL())
	{
		Update();
		Draw();
	}
	SDL_SaveBMP(screen, "screenshot.bmp");
	return 0;
}
