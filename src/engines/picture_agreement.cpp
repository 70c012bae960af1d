#include "engines/picture_agreement.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "base/numbers.h"

namespace rasterwalk {

namespace {

/// The difference of the channel that differs most, in 255ths.
int largest_channel_difference(std::uint32_t a, std::uint32_t b) {
    int largest = 0;
    for (const int shift : {16, 8, 0}) {
        const auto channel = [shift](std::uint32_t colour) {
            return static_cast<int>(colour >> shift & 0xffU);
        };
        largest = std::max(largest, std::abs(channel(a) - channel(b)));
    }
    return largest;
}

} // namespace

PictureDifference difference_of(const EnginePicture& a, const EnginePicture& b) {
    if (!(a.size == b.size) || a.colour.size() != b.colour.size())
        throw std::invalid_argument("the pictures have different sizes");
    PictureDifference result;
    result.pixels = static_cast<std::int64_t>(a.colour.size());
    for (std::size_t i = 0; i < a.colour.size(); ++i) {
        const int difference = largest_channel_difference(a.colour[i], b.colour[i]);
        result.largest = std::max(result.largest, difference);
        if (difference <= 1) continue;
        if (result.different++ > 0) continue;
        const int place = static_cast<int>(i);
        result.first = {place % a.size.width, place / a.size.width};
    }
    return result;
}

bool do_agree(const PictureDifference& difference) {
    return difference.different * pixels_to_one_that_differs <= difference.pixels;
}

std::string difference_text(const PictureDifference& difference) {
    if (difference.different == 0) return "no pixel differs";
    const double share =
        100.0 * static_cast<double>(difference.different) / static_cast<double>(difference.pixels);
    return fmt::format("{} of {} pixels {} ({} %), by up to {}/255, the first at {},{}",
                       difference.different, difference.pixels,
                       difference.different == 1 ? "differs" : "differ", significant(share, 3),
                       difference.largest, difference.first.x, difference.first.y);
}

} // namespace rasterwalk
