#include "engines/program_drawing.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.h"
#include "pipeline/draw.h"

namespace rasterwalk {

std::size_t ProgramDrawing::bytes() const {
    return puts.capacity() * sizeof(ProgramPut) + ours.capacity() * sizeof(Cursor);
}

std::size_t puts_at(const ProgramDrawing& drawing, const Cursor& cursor) {
    if (cursor == cursor_end) return drawing.puts.size();
    const auto next = std::lower_bound(drawing.ours.begin(), drawing.ours.end(), cursor);
    return std::min(static_cast<std::size_t>(next - drawing.ours.begin()), drawing.puts.size());
}

std::optional<Cursor> moment_of_parting(const ProgramDrawing& drawing) {
    if (!drawing.parting) return std::nullopt;
    return drawing.parting->ours ? drawing.parting->ours->cursor : cursor_end;
}

std::string parting_text(const SequenceParting& parting) {
    const auto pixel_words = [](glm::ivec2 pixel) {
        return fmt::format("pixel ({}, {})", pixel.x, pixel.y);
    };
    const std::string count = counted(parting.index, "pixel", "pixels");
    if (!parting.theirs && parting.ours)
        return fmt::format("Your program ends after {}, and we go on with {}.", count,
                           pixel_words(parting.ours->pixel));
    if (parting.theirs && !parting.ours)
        return fmt::format("We end after {}, and your program goes on with {}.", count,
                           pixel_words(*parting.theirs));
    const std::string before = parting.index == 0
                                   ? "They part at the first pixel"
                                   : fmt::format("They part after {} in the same order", count);
    return fmt::format("{}: your program puts {}, and we put {}.", before,
                       pixel_words(*parting.theirs), pixel_words(parting.ours->pixel));
}

std::vector<ProgramWrite> writes_on(const ProgramDrawing& drawing, glm::ivec2 pixel) {
    std::vector<ProgramWrite> writes;
    for (std::size_t i = 0; i < drawing.puts.size(); ++i) {
        if (drawing.puts[i].pixel == pixel) writes.push_back({i, drawing.puts[i].colour});
    }
    return writes;
}

void ProgramPlanes::begin(std::shared_ptr<const ProgramDrawing> drawing, const Frame& frame) {
    drawing_ = std::move(drawing);
    clear(planes_, frame);
    puts_ = 0;
    is_new_ = true;
}

void ProgramPlanes::put(std::size_t index) {
    const ProgramPut& put = drawing_->puts[index];
    const glm::ivec2 pixel = put.pixel;
    const Rectangle picture{0, 0, planes_.size.width, planes_.size.height};
    if (!contains(picture, pixel.x, pixel.y)) return;
    const std::size_t at = planes_.at(pixel.x, pixel.y);
    const bool is_ours =
        !drawing_->parting || index < static_cast<std::size_t>(drawing_->parting->index);
    planes_.colour[at] = put.colour;
    planes_.owner[at] =
        is_ours && index < drawing_->ours.size() ? drawing_->ours[index].triangle : -1;
    ++planes_.overdraw[at];
    changed_ = around(changed_, {pixel.x, pixel.y, pixel.x + 1, pixel.y + 1});
}

void ProgramPlanes::go_to(std::size_t puts) {
    const std::size_t wanted = std::min(puts, drawing_->puts.size());
    changed_ = {};
    if (wanted < puts_) {
        clear(planes_, planes_.size, {0, 0}, PictureRules(planes_.rules));
        puts_ = 0;
        is_new_ = true;
    }
    if (std::exchange(is_new_, false)) changed_ = {0, 0, planes_.size.width, planes_.size.height};
    for (; puts_ < wanted; ++puts_)
        put(puts_);
}

} // namespace rasterwalk
