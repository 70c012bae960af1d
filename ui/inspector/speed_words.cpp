#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/numbers.h"
#include "ui/actions/compare.h"
#include "ui/inspector/speed_parts.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

std::string milliseconds_text(double milliseconds) {
    const int digits = milliseconds < 9.995 ? 2 : milliseconds < 99.95 ? 1 : 0;
    return decimals(milliseconds, digits) + " ms";
}

bool is_slower(double ratio) {
    constexpr double hardly_slower = 0.95;
    return ratio < hardly_slower;
}

std::string gain_text(double ratio) {
    const double factor = is_slower(ratio) ? 1.0 / ratio : ratio;
    return (is_slower(ratio) ? "÷ " : "× ") + decimals(factor, factor < 9.95 ? 1 : 0);
}

PictureWords picture_words(const LadderTimes& times, std::size_t index) {
    if (index >= times.rungs.size()) return {};
    const PictureDifference& difference = times.rungs[index].from_previous;
    const std::size_t before = rung_before(index);
    if (before == index || difference.pixels == 0) return {};
    const Rung& rung = rung_at(index);
    const std::string number = grouped(difference.different);
    const std::string pixels =
        difference.different == 1 ? "1 pixel differs" : number + " pixels differ";
    const std::string as = fmt::format(" as rung {}", before);
    if (difference.different == 0)
        return {passed_sign, index < ladder().size()
                                 ? std::vector<std::string>{"same picture"}
                                 : std::vector{"same picture" + as, std::string("same picture")}};
    if (rung.has_other_edges) return {"~", {pixels + ", by its new rule", pixels, number}};
    if (rung.is_random) return {failed_sign, {pixels + ", this time", pixels, number}, true};
    return {"~", {pixels, number}};
}

} // namespace rasterwalk
