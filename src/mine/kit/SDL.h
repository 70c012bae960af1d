#pragma once

// Stands in for the headers of SDL 1.2 and of SDL 2 at once: the parts that programs of this lab
// use. There is no window; what a program shows is written down by the runtime. Where the versions
// use one name for different things, the types are such that programs for either compile.

#include "inner/sdl_events.h"
#include "inner/sdl_keys.h"
#include "inner/sdl_surfaces.h"
#include "inner/sdl_time.h"
#include "inner/sdl_types.h"
#include "inner/sdl_windows.h"
