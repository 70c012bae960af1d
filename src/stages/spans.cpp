#include "stages/spans.h"

namespace rasterwalk {

Fragment span_end(const Fragment& end, Interpolation interpolation) {
    if (interpolation != Interpolation::zinv_twice) return end;
    Fragment again = end;
    again.varyings = end.varyings * end.zinv;
    return again;
}

} // namespace rasterwalk
