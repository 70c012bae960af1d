#include "session/canvas_view.h"

#include "base/numbers.h"

namespace rasterwalk {

std::string to_text(const glm::vec2& place) {
    return number_text(place.x) + "," + number_text(place.y);
}

} // namespace rasterwalk
