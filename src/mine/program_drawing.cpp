#include "mine/program_drawing.h"

#include <algorithm>
#include <cmath>

#include "mine/put_sequence.h"
#include "stages/put_pixel.h"
#include "stages/rectangle.h"
#include "stages/stages.h"

namespace rasterwalk {

namespace {

/// A colour that can be drawn and compared.
glm::vec3 colour_of_put(const rasterwalk_kit::Put& put, bool is_outline) {
    glm::vec3 colour(put.red, put.green, put.blue);
    bool is_black = true;
    for (int channel = 0; channel < 3; ++channel) {
        float& value = colour[channel];
        value =
            std::isnan(value) ? 0.0f : std::clamp(value, -largest_put_channel, largest_put_channel);
        is_black = is_black && to_byte(value) == 0;
    }
    return is_outline && !is_black ? glm::vec3(1.0f) : colour;
}

} // namespace

std::shared_ptr<const ProgramDrawing> drawing_of(const CheckedProgram& checked,
                                                 const std::shared_ptr<const Scene>& room) {
    if (!checked.picture || !checked.run || !has_known_order(*checked.run)) return nullptr;
    const std::vector<rasterwalk_kit::Put>& puts = checked.run->recording.puts;
    const auto drawing = std::make_shared<ProgramDrawing>();
    drawing->name = checked.files.name;
    drawing->scene = room;
    drawing->settings = checked.picture->reference;
    const Viewport size = drawing->settings.viewport;
    const bool is_outline = !has_fragments(drawing->settings.stage);
    for (const rasterwalk_kit::Put& put : puts) {
        if (contains({0, 0, size.width, size.height}, put.x, put.y))
            drawing->puts.push_back({{put.x, put.y}, colour_of_put(put, is_outline)});
    }
    const std::vector<OurPut> ours = our_puts(*room, drawing->settings);
    for (const OurPut& put : ours)
        drawing->ours.push_back(put.cursor);
    drawing->parting = sequence_parting(puts, ours, size);
    return drawing;
}

} // namespace rasterwalk
