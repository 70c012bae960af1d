#pragma once

// Part of claims.h: names of Windows that programs of this lab use.

#include "../runtime.h"

typedef char _TCHAR;
typedef char TCHAR;
#define _tmain main
#define _T(text) text

inline void Sleep(unsigned long milliseconds) {
    rasterwalk_kit::delay(static_cast<std::uint32_t>(milliseconds));
}
