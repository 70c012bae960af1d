#pragma once

// Of Windows: what is needed of it is known without it.

#include "inner/windows_names.h"
