#pragma once

// Another name of SDLauxiliary.h.

#ifdef RASTERWALK_OWN_HELPER
#include_next <SDL2auxiliary.h>
#else
#include "inner/helper.h"
#endif
