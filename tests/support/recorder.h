#pragma once

#include <algorithm>
#include <vector>

#include "pipeline/draw.h"

namespace rasterwalk::test {

/// Keeps the events of a drawing by their kinds, in order; edge samples and tested pixels only if
/// requested.
struct Recorder {
    explicit Recorder(bool samples_too = false) : with_samples(samples_too) {}

    bool with_samples;
    std::vector<VertexEvent> vertices;
    std::vector<ClipEvent> clip_steps;
    std::vector<CullEvent> culls;
    std::vector<SampleEvent> samples;
    std::vector<TestEvent> tests;
    std::vector<FragmentEvent> fragments;

    /// Keeps what it hears here.
    Observer observer() {
        const auto into = [](auto& kept) {
            return [&kept](const auto& event) { kept.push_back(event); };
        };
        Observer all{into(vertices), into(clip_steps), into(culls),
                     into(samples),  into(tests),      into(fragments)};
        if (!with_samples) all.edge_sample = nullptr, all.pixel_test = nullptr;
        return all;
    }
};

inline DrawTally draw(const Frame& frame, const DrawWindow& window, Framebuffer& framebuffer,
                      Recorder* recorder) {
    const Observer observer = recorder->observer();
    return draw(frame, window, framebuffer, &observer);
}

/// The moments that a recorder got, sorted; one reported twice is there twice.
/// @param stage of the frame; before fragments are drawn, the ones reported are marks of other
///              moments
inline std::vector<Cursor> recorded_moments(const Recorder& reported, Stage stage) {
    std::vector<Cursor> moments;
    const auto add = [&](const auto& events) {
        for (const auto& event : events)
            moments.push_back(event.cursor);
    };
    add(reported.vertices);
    add(reported.clip_steps);
    add(reported.culls);
    add(reported.samples);
    add(reported.tests);
    if (has_fragments(stage)) add(reported.fragments);
    std::sort(moments.begin(), moments.end());
    return moments;
}

} // namespace rasterwalk::test
