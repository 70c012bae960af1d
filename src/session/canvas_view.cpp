#include "session/canvas_view.h"

#include "settings/setting_table.h"

namespace rasterwalk {

std::string to_text(const glm::vec2& place) {
    return number_text(place.x).append(",").append(number_text(place.y));
}

} // namespace rasterwalk
