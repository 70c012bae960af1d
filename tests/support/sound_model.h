#pragma once

#include <string>
#include <vector>

#include "scene/read_obj.h"
#include "scene/scene.h"

namespace rasterwalk::test {

/// Model files from which tests make others.
const std::vector<std::string>& model_seeds();

/// What is wrong with a model that was read, whatever its file held: counts that do not agree,
/// parts that do not follow each other, numbers that are no places, no colours and no directions.
/// Empty: nothing.
std::string problem_of_model(const ObjModel& model);

/// The same of a scene that was read, whose places are in the world: no triangle, and numbers that
/// are no places, no colours and no directions.
std::string problem_of_scene(const Scene& scene);

/// Does a refusal begin with the model's file and a line?
bool has_line(const std::string& sentence, const std::string& path);

} // namespace rasterwalk::test
