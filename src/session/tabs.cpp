#include "session/tabs.h"

#include <array>

namespace rasterwalk {

std::span<const std::string_view> tab_names() {
    static constexpr std::array<std::string_view, 9> names{"vertices",   "rows",    "fragment",
                                                           "history",    "graph",   "settings",
                                                           "microscope", "compare", "lab"};
    return names;
}

} // namespace rasterwalk
