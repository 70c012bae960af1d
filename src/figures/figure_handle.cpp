#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/nearest_name.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "base/text_parts.h"
#include "facts/facts.h"
#include "figures/figure_words.h"

namespace rasterwalk {

FigureHandle figure_handle(std::string_view text) {
    FigureHandle handle;
    text = trimmed(text);
    handle.setting = std::string(take_part(text, ' '));
    const SettingName found = find_setting_name(handle.setting);
    if (found.setting == nullptr || !is_slider(*found.setting)) {
        const std::vector<std::string> known = all_setting_names();
        const std::vector<std::string_view> views(known.begin(), known.end());
        throw UsageError("there is no setting " + in_quotes(handle.setting) +
                         " whose value is one number." + did_you_mean(handle.setting, views));
    }
    const std::vector<float> numbers = figure_numbers(text);
    if (numbers.size() != 3) throw UsageError("write \"SETTING FROM TO STEP\".");
    const NumberBounds bounds = bounds_of(*found.setting);
    if (numbers[0] < bounds.smallest || numbers[1] > bounds.largest) {
        throw UsageError(fmt::format("{} takes numbers from {} to {}.", handle.setting,
                                     number_text(bounds.smallest), number_text(bounds.largest)));
    }
    const float length = numbers[1] - numbers[0];
    if (!(length > 0.0f && numbers[2] > 0.0f && numbers[2] <= length &&
          length / numbers[2] <= static_cast<float>(most_handle_stops))) {
        throw UsageError(fmt::format("from the first number to the second there are 1 to {} "
                                     "steps.",
                                     most_handle_stops));
    }
    handle.set = found.setting;
    handle.range.part = found.part;
    handle.range.smallest = static_cast<double>(numbers[0]);
    handle.range.largest = static_cast<double>(numbers[1]);
    handle.range.step = static_cast<double>(numbers[2]);
    return handle;
}

} // namespace rasterwalk
