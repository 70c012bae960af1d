#include "support/project_root.h"

namespace rasterwalk {

std::string project_root() {
    return RASTERWALK_ROOT;
}

} // namespace rasterwalk
