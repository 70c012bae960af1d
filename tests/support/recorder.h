#pragma once

#include <algorithm>
#include <vector>

#include "pipeline/observer.h"

namespace rasterwalk::test {

/// Keeps everything that an observer gets, in order; edge samples and tested pixels only if
/// requested.
struct Recorder : Observer {
    explicit Recorder(bool samples_too = false) : with_samples(samples_too) {}

    struct VertexEvent {
        Cursor cursor;
        ScreenVertex vertex;
        bool has_pixel;
    };
    bool with_samples;
    std::vector<VertexEvent> vertices;
    std::vector<ClipEvent> clip_steps;
    std::vector<CullEvent> culls;
    std::vector<SampleEvent> samples;
    std::vector<TestEvent> tests;
    std::vector<FragmentEvent> fragments;

    void vertex(const Cursor& cursor, const ProjectedVertex& vertex) override {
        vertices.push_back({cursor, vertex.pixel, vertex.has_pixel});
    }
    void clip_step(const ClipEvent& event) override { clip_steps.push_back(event); }
    void cull(const CullEvent& event) override { culls.push_back(event); }
    bool wants_clipping() const override { return true; }
    void edge_sample(const SampleEvent& event) override { samples.push_back(event); }
    void pixel_test(const TestEvent& event) override { tests.push_back(event); }
    bool wants_pixel_tests() const override { return with_samples; }
    void fragment(const FragmentEvent& event) override { fragments.push_back(event); }
    bool wants_edge_samples() const override { return with_samples; }
};

/// The moments that a recorder got, sorted; one reported twice is there twice.
/// @param stage of the frame; before fragments are drawn, the ones reported are marks of other
///              moments
inline std::vector<Cursor> told_moments(const Recorder& told, Stage stage) {
    std::vector<Cursor> moments;
    const auto add = [&](const auto& events) {
        for (const auto& event : events)
            moments.push_back(event.cursor);
    };
    add(told.vertices);
    add(told.clip_steps);
    add(told.culls);
    add(told.samples);
    add(told.tests);
    if (has_fragments(stage)) add(told.fragments);
    std::sort(moments.begin(), moments.end());
    return moments;
}

} // namespace rasterwalk::test
