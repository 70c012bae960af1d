#pragma once

// Included by the compiler before each source of the program. It makes programs compile that were
// written for other compilers, for an older glm, or with headers forgotten, and it claims the
// include guards that local copies of the course's helper have, so that the kit takes their place
// wherever the program keeps them.
//
// The model is not claimed: whether it has vec3 or vec4 depends on which of TestModel.h and
// TestModelH.h is included, and a local copy of it needs nothing but glm.
//
// With RASTERWALK_OWN_HELPER nothing is claimed: the program's own helper draws through SDL.h.
//
// With RASTERWALK_FEW_HEADERS the headers that the program may have forgotten are left out. With
// `using namespace std`, each name in them is one that the program cannot use for a variable.

#ifndef RASTERWALK_FEW_HEADERS
#include <algorithm>
#include <array>
#include <cassert>
#include <cfloat>
#include <chrono>
#include <climits>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>
#endif

// Vectors of the glm that the lab was written for begin as 0. Later ones do so only if told.
// No more of glm is included: with `using namespace glm` its `yaw` would hide the program's.
#define GLM_FORCE_CTOR_INIT
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/glm.hpp>

#include "SDL.h"
#include "inner/mixed_numbers.h"
#include "inner/windows_names.h"

#ifndef RASTERWALK_OWN_HELPER
#include "SDLauxiliary.h"
#define SDL_AUXILIARY_H
#define SDL_AUXILIARY_H_
#define SDL_Auxiliary_h
#define SDLAUXILIARY_H
#define SDLAUXILIARY_H_
#define SDLAuxiliary_h
#define SDLauxiliary_h
#define SDL_AUX_H
#define SDLAUX_H
#define SDL2_AUXILIARY_H
#define SDL2_AUXILIARY_H_
#define SDL2_Auxiliary_h
#define SDL2AUXILIARY_H
#define SDL2AUXILIARY_H_
#define SDL2Auxiliary_h
#define SDL2auxiliary_h
#define SDL2_AUX_H
#define SDL2AUX_H
#define SDL2AUX_H_
#define SDL2Aux_h
#endif
