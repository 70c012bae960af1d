#include "support/fast_pictures.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include <fmt/format.h>

#include "stages/put_pixel.h"
#include "support/bits.h"
#include "support/ray_picture.h"

namespace rasterwalk::test {

FastPicture fast_picture(const Scene& scene, const Settings& settings, const FastOptions& options) {
    FastPicture picture;
    FastEngine(scene, options).draw(settings, picture);
    return picture;
}

Settings by_fast_rules(Settings settings) {
    settings.coverage = Coverage::scan_conversion;
    settings.fill_rule = FillRule::top_left;
    settings.snap = Snap::subpixel;
    settings.clip = Clip::near;
    return settings;
}

bool FastDifference::is_small() const {
    constexpr std::size_t fewest = 3, one_of = 5000;
    const std::size_t allowed = std::max(fewest, pixels / one_of);
    return colours <= allowed && owners <= allowed;
}

std::string FastDifference::words() const {
    return fmt::format("of {} pixels {} have another colour ({}), {} another owner ({})", pixels,
                       colours, first_of_colour, owners, first_of_owner);
}

FastDifference difference(const FastPicture& fast, const Framebuffer& steps,
                          const std::vector<int>& met) {
    FastDifference difference;
    if (fast.size != steps.size) {
        difference.colours = difference.owners = SIZE_MAX;
        difference.first_of_colour = "another size";
        return difference;
    }
    for (int row = 0; row < fast.size.height; ++row) {
        for (int column = 0; column < fast.size.width; ++column) {
            const std::size_t f = fast.at(column, row), s = steps.at(column, row);
            if (!met.empty() && met[s] == ray_near_outline) continue;
            ++difference.pixels;
            if (fast.owner[f] != steps.owner[s] && difference.owners++ == 0)
                difference.first_of_owner = fmt::format("column {}, row {}: {}, steps {}", column,
                                                        row, fast.owner[f], steps.owner[s]);
            std::uint32_t expected = 0;
            bool is_other = fast.colour[f] > 0xffffff;
            for (const int channel : {0, 1, 2}) {
                const int byte = to_byte(steps.colour[s][channel]);
                const int shift = 16 - 8 * channel;
                expected |= static_cast<std::uint32_t>(byte) << shift;
                is_other |= std::abs(static_cast<int>(fast.colour[f] >> shift & 255) - byte) > 1;
            }
            if (is_other && difference.colours++ == 0)
                difference.first_of_colour = fmt::format("column {}, row {}: {:06x}, steps {:06x}",
                                                         column, row, fast.colour[f], expected);
        }
    }
    return difference;
}

std::string first_other_bits(const FastPicture& a, const FastPicture& b) {
    if (a.size != b.size) return "another size";
    for (int row = 0; row < a.size.height; ++row) {
        for (int column = 0; column < a.size.width; ++column) {
            const std::size_t p = a.at(column, row), q = b.at(column, row);
            if (a.colour[p] == b.colour[q] && same_bits(a.inv_z[p], b.inv_z[q]) &&
                a.owner[p] == b.owner[q])
                continue;
            return fmt::format("column {}, row {}: colour {:06x} and {:06x}, 1/z {} and {}, owner "
                               "{} and {}",
                               column, row, a.colour[p], b.colour[q], a.inv_z[p], b.inv_z[q],
                               a.owner[p], b.owner[q]);
        }
    }
    return {};
}

} // namespace rasterwalk::test
