#pragma once

// The mesh of a model, built from the faces that its statements name.

#include "scene/obj_statements.h"
#include "scene/read_obj.h"

namespace rasterwalk {

/// Builds mesh and parts of a model, and counts them: looks up the material of each part, leaves
/// out the faces that name a point that does not exist, computes missing normals, cuts the faces
/// into triangles. Faults go into the report.
/// @param model has its path and its materials
/// @param origins gets what each triangle was made of
/// Throws ReadingStopped if the watch stops it.
void build_model(ObjStatements& file, const ObjOptions& options, WatchedSteps& watched,
                 ObjReporter& reporter, ObjModel& model, std::vector<TriangleOrigin>& origins);

} // namespace rasterwalk
