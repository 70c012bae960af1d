#pragma once

// Stands in for the helper that courses hand out with the lab, in its three dialects at once:
// functions for an SDL_Surface, the class SDL2Aux, and functions for a struct `screen`. A `screen`
// is an SDL_Surface here, so that one InitializeSDL() serves two of them.
//
// With RASTERWALK_OWN_HELPER the program's own helper of this name is used instead, on SDL.h.

#ifdef RASTERWALK_OWN_HELPER
#include_next <SDLauxiliary.h>
#else
#include "inner/helper.h"
#endif
