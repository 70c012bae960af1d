#pragma once

// Another place of SDL.h.

#include "../SDL.h"
