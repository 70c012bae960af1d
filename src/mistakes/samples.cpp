#include "mistakes/samples.h"

namespace rasterwalk {

glm::vec3 mean_clamped_late(const SampleColours& colours) {
    glm::vec3 sum(0.0f);
    for (const glm::vec3& colour : colours)
        sum = sum + colour;
    glm::vec3 mean = sum / static_cast<float>(sample_count);
    for (int i = 0; i < 3; ++i)
        mean[i] = visible_channel(mean[i]);
    return mean;
}

} // namespace rasterwalk
