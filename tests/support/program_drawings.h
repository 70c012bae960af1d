#pragma once

// What a student's program has drawn, made from our own picture: no program is compiled for it.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "engines/program_drawing.h"
#include "laboratory/bug.h"
#include "pipeline/draw.h"
#include "support/samples.h"

namespace rasterwalk::test {

/// The room by the rules of the lab, small, so that it is drawn quickly.
inline Settings small_room_settings(const Scene& room, const StripStep& step) {
    Settings settings = with_handout_rules(default_settings(room));
    set_step(settings, step);
    settings.viewport = {64, 48};
    settings.camera.focal_length = 48.0f;
    return settings;
}

/// A program that puts exactly what we put: every pixel that is written, in order.
inline ProgramDrawing drawing_like_ours(const std::shared_ptr<const Scene>& scene,
                                        const Settings& settings) {
    ProgramDrawing drawing{"mine.cpp", scene, settings, {}, {}, std::nullopt};
    const Frame frame = prepare_frame(*scene, settings);
    Observer observer;
    observer.fragment = [&](const FragmentEvent& event) {
        if (event.fate != Fate::written) return;
        drawing.puts.push_back({{event.fragment.column, event.fragment.row}, event.after});
        drawing.ours.push_back(event.cursor);
    };
    Framebuffer planes;
    clear(planes, frame);
    rasterwalk::draw(frame, {}, planes, &observer);
    return drawing;
}

/// The same program with other puts: finds where they part from the right ones.
inline ProgramDrawing with_puts(const ProgramDrawing& right, std::vector<ProgramPut> puts) {
    ProgramDrawing changed = right;
    changed.puts = std::move(puts);
    const std::size_t common = std::min(changed.puts.size(), right.puts.size());
    std::size_t i = 0;
    while (i < common && changed.puts[i].pixel == right.puts[i].pixel)
        ++i;
    if (i == changed.puts.size() && i == right.puts.size()) return changed;
    SequenceParting parting;
    parting.index = static_cast<std::int64_t>(i);
    if (i < changed.puts.size()) parting.theirs = changed.puts[i].pixel;
    if (i < right.puts.size()) parting.ours = OurPut{right.ours[i], right.puts[i].pixel};
    changed.parting = parting;
    return changed;
}

/// The small room, drawn by a program that is right.
inline ProgramDrawing right_room_drawing(const StripStep& step = StripStep::pixel_light) {
    const auto room = std::make_shared<const Scene>(lab_room());
    return drawing_like_ours(room, small_room_settings(*room, step));
}

/// The room, drawn by a program that puts one pixel seven rows too low and in a colour of its own,
/// in the middle of the picture's time.
struct ProgramWithWrongPixel {
    ProgramDrawing right = right_room_drawing(StripStep{Stage::fill});
    std::size_t index = right.puts.size() / 2;
    glm::ivec2 meant = right.puts[index].pixel;
    glm::ivec2 hit{meant.x, (meant.y + 7) % 48};

    std::shared_ptr<const ProgramDrawing> drawing() const {
        std::vector<ProgramPut> puts = right.puts;
        puts[index] = {hit, glm::vec3(0.125f, 0.25f, 0.5f)};
        return std::make_shared<const ProgramDrawing>(with_puts(right, puts));
    }
};

} // namespace rasterwalk::test
