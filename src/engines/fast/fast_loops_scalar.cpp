#define RASTERWALK_LANES 4
#define RASTERWALK_NAMES_INSTRUCTIONS 0

#include "engines/fast/fast_loops.h"

namespace rasterwalk::fast {

const Loops& scalar_loops() {
    return loops;
}

} // namespace rasterwalk::fast
