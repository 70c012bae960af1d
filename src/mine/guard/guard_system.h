#pragma once

// RASTERWALK_HAS_GUARD: this system can guard a program. The filter compares words of 64 bits as
// these two processors store them, and numbers of system calls as Linux gives them there.
#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__)) && defined(__LP64__)
#define RASTERWALK_HAS_GUARD
#endif
