#pragma once

#include <array>

#include "scene/read_obj.h"
#include "scene/scene.h"

namespace rasterwalk {

/// Corner i of a scene's triangle is this corner of the model's.
inline constexpr std::array model_corners{0, 2, 1};

/// A model as a scene: moved and scaled so that its box has its middle at the origin and a longest
/// side of 2, like the lab's room, and turned by half a turn about x, since here y runs down and
/// z into the picture. Corners 1 and 2 change places, so that fronts stay fronts. The steps are in
/// each part's model. The camera looks from above and from the left, as near as the whole box
/// allows; the lamp is next to it.
Scene scene_of_model(const ObjModel& model);

} // namespace rasterwalk
