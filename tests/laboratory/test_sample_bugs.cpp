// The mistakes of pixels with several samples.

#include <algorithm>
#include <map>
#include <utility>

#include "support/bug_runs.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {
namespace sample_bugs {

float clamped(float channel) {
    return std::min(std::max(channel, 0.0f), 1.0f);
}

/// A mean of one channel of the samples.
float mean_of(const SampleColours& samples, int channel, bool is_late) {
    float sum = 0.0f;
    for (const glm::vec3& sample : samples)
        sum += is_late ? sample[channel] : clamped(sample[channel]);
    return is_late ? clamped(sum / 4.0f) : sum / 4.0f;
}

} // namespace sample_bugs
} // namespace

TEST_CASE("B100: one sample far above 1 makes a whole pixel white") {
    using namespace sample_bugs;
    const BugRuns runs("B100");
    REQUIRE(runs.wrong.picture.sample_colour == runs.right.picture.sample_colour);
    int whitened = 0;
    for (std::size_t i = 0; i < runs.right.picture.colour.size(); ++i) {
        const SampleColours& samples = runs.right.picture.sample_colour[i];
        for (int c = 0; c < 3; ++c) {
            const float right = runs.right.picture.colour[i][c];
            const float wrong = runs.wrong.picture.colour[i][c];
            REQUIRE(right == Approx(mean_of(samples, c, false)).margin(1e-6));
            REQUIRE(wrong == Approx(mean_of(samples, c, true)).margin(1e-6));
            REQUIRE(wrong >= right - 1e-6f);
            const bool is_dim = std::all_of(samples.begin(), samples.end(),
                                            [&](const auto& sample) { return sample[c] <= 1.0f; });
            if (is_dim) REQUIRE(wrong == Approx(right).margin(1e-6));
            // An edge pixel that three samples of four leave below full brightness.
            whitened += wrong == 1.0f && right < 0.8f ? 1 : 0;
        }
    }
    CHECK(whitened > 100);
}

TEST_CASE("B101: where surfaces cross, the nearer one takes all samples of a pixel or none") {
    const BugRuns runs("B101");
    // The fragments of each pixel that cover all of its samples, before any that does not.
    const auto split = [](const DrawnRun& run) {
        std::map<std::pair<int, int>, bool> is_whole;
        int count = 0;
        for (const FragmentEvent& event : run.reported.fragments) {
            const auto pixel = std::pair(event.fragment.column, event.fragment.row);
            const auto [found, is_new] = is_whole.try_emplace(pixel, true);
            if (event.covered != 15) found->second = false;
            if (found->second && event.passed != 0 && event.passed != 15) ++count;
        }
        return count;
    };
    CHECK(split(runs.wrong) == 0);
    CHECK(split(runs.right) > 300);
    // Outlines against the background are the same in both.
    REQUIRE(runs.wrong.stats.fragments == runs.right.stats.fragments);
    const int different = different_pixels(runs.wrong.picture, runs.right.picture);
    CHECK(different > 200);
    CHECK(different < 10'000);
}
