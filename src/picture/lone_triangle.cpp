#include "picture/lone_triangle.h"

#include <algorithm>

#include "pipeline/draw.h"

namespace rasterwalk {

bool LoneTriangle::draw(const Frame& frame, const FrameWork& work, std::uint64_t number,
                        int triangle, const Cursor& cursor, const WorkLimit& limit) {
    const bool has_squares = frame.squares != nullptr;
    const Cursor from = has_squares ? cursor_begin : beginning_of(triangle);
    const Cursor to = has_squares ? cursor : std::clamp(cursor, from, beginning_of(triangle + 1));
    const bool is_same = number == number_ && triangle == triangle_;
    if (is_same && to == to_ && !is_drawing()) return false;
    if (!is_same || to < at_) {
        triangle_ = std::nullopt; // if memory runs out, it is drawn again next time
        clear(picture_, frame);
        at_ = from;
    }
    number_ = number;
    triangle_ = triangle;
    to_ = to;
    const double begun = work.before(at_), missing = work.before(to) - begun;
    Cursor end = to;
    if (missing > limit.at_once) {
        const Cursor part = work.at(begun + limit.slice);
        if (part > at_) end = std::min(part, to);
    }
    if (end > at_) rasterwalk::draw(frame, {at_, end, std::nullopt, triangle}, picture_);
    at_ = end;
    pixels_ = std::count_if(picture_.owner.begin(), picture_.owner.end(),
                            [](std::int32_t owner) { return owner >= 0; });
    return true;
}

} // namespace rasterwalk
