#if defined(RASTERWALK_X86_LOOPS)

#define RASTERWALK_LANES 8
#define RASTERWALK_NAMES_INSTRUCTIONS 0

#include "engines/fast/fast_loops.h"

namespace rasterwalk::fast {

const Loops& clones_loops() {
    return loops;
}

} // namespace rasterwalk::fast

#endif
