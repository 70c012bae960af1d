#ifndef RASTERISER_H
#define RASTERISER_H

#include <vector>
#include <SDL.h>
#include "pixel.h"
#include "TestModel.h"

extern SDL_Surface* screen;

void ClearDepth();
void Interpolate(const Pixel& a, const Pixel& b, std::vector<Pixel>& result);
void ComputePolygonRows(const std::vector<Pixel>& vertexPixels,
                        std::vector<Pixel>& leftPixels, std::vector<Pixel>& rightPixels);
void DrawTriangle(const Triangle& triangle);

#endif
