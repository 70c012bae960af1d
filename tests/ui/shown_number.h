#pragma once

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/ui/driver.h"
#include "ui/ui.h"

namespace rasterwalk {

/// What a widget that shows a number says.
inline std::string shown_text(Driver& driver, const std::string& name) {
    driver.hand.find(name);
    return driver.ui.widgets.at(name).text;
}

/// A number as the interface writes it, with a true minus sign.
inline double number_in(std::string text) {
    if (text.starts_with("−")) text.replace(0, std::string("−").size(), "-");
    return std::strtod(text.c_str(), nullptr);
}

/// The windows and text sizes at which every panel must be usable.
struct SmallWindow {
    ImVec2 size;
    float text_scale;
};
inline const std::array small_windows{SmallWindow{{1024, 640}, 1.0f},
                                      SmallWindow{{1024, 640}, 1.5f}, SmallWindow{{800, 600}, 1.0f},
                                      SmallWindow{{800, 600}, 1.5f}};

/// Those, and larger ones.
inline std::vector<SmallWindow> all_windows() {
    std::vector<SmallWindow> all(small_windows.begin(), small_windows.end());
    all.push_back({{1366, 768}, 1.0f});
    all.push_back({{1600, 1000}, 1.0f});
    all.push_back({{1600, 1000}, 1.5f});
    return all;
}

} // namespace rasterwalk
