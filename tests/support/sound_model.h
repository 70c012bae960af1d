#pragma once

#include <string>
#include <vector>

#include "scene/read_obj.h"

namespace rasterwalk::test {

/// Model files from which tests make others.
const std::vector<std::string>& model_seeds();

/// What is wrong with a model that was read, whatever its file held: counts that do not agree,
/// parts that do not follow each other, numbers that are no places, no colours and no directions.
/// Empty: nothing.
std::string trouble_of_model(const ObjModel& model);

/// Does a refusal begin with the model's file and a line?
bool has_line(const std::string& sentence, const std::string& path);

} // namespace rasterwalk::test
