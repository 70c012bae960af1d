#if defined(RASTERWALK_X86_LOOPS)

#define RASTERWALK_LANES 4
#define RASTERWALK_NAMES_INSTRUCTIONS 1

#include "engines/fast/fast_loops.h"

namespace rasterwalk::fast {

const Loops& sse2_loops() {
    return loops;
}

} // namespace rasterwalk::fast

#endif
