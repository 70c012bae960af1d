#ifndef LINES_H
#define LINES_H

#include <vector>
#include <glm/glm.hpp>
#include "SDLauxiliary.h"

// All pixels from a to b, both included. The size of result says how many.
void Interpolate(glm::ivec2 a, glm::ivec2 b, std::vector<glm::ivec2> &result);

void DrawLine(screen *screen, glm::ivec2 a, glm::ivec2 b, glm::vec3 colour);

#endif
