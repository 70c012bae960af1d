#include "mine/put_sequence.h"

#include "pipeline/draw.h"
#include "pipeline/frame.h"
#include "pipeline/framebuffer.h"

namespace rasterwalk {

std::vector<OurPut> our_puts(const Scene& scene, const Settings& settings) {
    const Frame frame = prepare_frame(scene, settings);
    std::vector<OurPut> puts;
    const Viewport size = settings.viewport;
    Observer observer;
    observer.fragment = [&](const FragmentEvent& event) {
        const glm::ivec2 pixel{event.fragment.column, event.fragment.row};
        if (event.fate == Fate::written && pixel.x >= 0 && pixel.y >= 0 && pixel.x < size.width &&
            pixel.y < size.height)
            puts.push_back({event.cursor, pixel});
    };
    Framebuffer planes;
    clear(planes, frame);
    draw(frame, {}, planes, &observer);
    return puts;
}

std::optional<SequenceParting> sequence_parting(std::span<const rasterwalk_kit::Put> theirs,
                                                std::span<const OurPut> ours, Viewport picture) {
    std::size_t our_index = 0;
    for (const rasterwalk_kit::Put& put : theirs) {
        if (put.x < 0 || put.y < 0 || put.x >= picture.width || put.y >= picture.height) continue;
        const glm::ivec2 pixel{put.x, put.y};
        if (our_index == ours.size())
            return SequenceParting{static_cast<std::int64_t>(our_index), pixel, std::nullopt};
        if (ours[our_index].pixel != pixel)
            return SequenceParting{static_cast<std::int64_t>(our_index), pixel, ours[our_index]};
        ++our_index;
    }
    if (our_index == ours.size()) return std::nullopt;
    return SequenceParting{static_cast<std::int64_t>(our_index), std::nullopt, ours[our_index]};
}

} // namespace rasterwalk
