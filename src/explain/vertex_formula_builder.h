#pragma once

// Tools for the formulas of a vertex.

#include <string>

#include "explain/formula_writer.h"
#include "explain/vertex_report.h"
#include "pipeline/frame.h"

namespace rasterwalk {

/// The data that the formulas of a vertex are made from.
struct VertexFormulaBuilder {
    const Frame& frame;
    const Vertex& vertex;
    const glm::mat3& rotation; ///< the camera's
    VertexReport& report;
    FormulaWriter write{report.formulas};

    bool is_bench() const { return frame.scene->space == SceneSpace::pixels; }
    bool is_by_matrices() const {
        return !is_bench() && frame.settings.transform == Transform::matrices;
    }
    /// Is the projection different from perspective?
    bool is_mixed() const { return !is_bench() && frame.settings.projection_mix > 0.0f; }
    /// Does the depth buffer hold something different from 1/w?
    bool has_own_depth() const {
        return clip_depth_rule(frame.settings, frame.scene->space) != ClipDepth::inv_z;
    }
};

/// The result of a matrix in double is shown as it is; the vertex's spaces show how it was found.
inline FormulaInput by_matrix(const std::string& symbol, float value, const std::string& product) {
    return {symbol, {value}, from_words(product + ", in double: see the vertex's spaces")};
}

} // namespace rasterwalk
