#pragma once

namespace rasterwalk {

/// Prints what models of 200,000 and of 1,000,000 triangles cost, milliseconds of the processor: to
/// open, a step, a seek, a pick, and the longest update of a window while they turn.
void print_model_times();

} // namespace rasterwalk
