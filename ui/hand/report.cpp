#include "ui/hand/report.h"

#include <initializer_list>
#include <map>

#include "base/numbers.h"
#include "base/quoted.h"
#include "settings/setting_table.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

std::string numbers(std::initializer_list<float> values) {
    std::string text;
    for (const float value : values)
        text.append(" ").append(number_text(value));
    return text;
}

} // namespace

std::string screen_report(const Ui& ui) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    std::string text = "window" + numbers({window.x, window.y}) + "\n";
    for (const Setting& setting : setting_table()) {
        text.append("setting ").append(setting.name).append(" ");
        text += value_text(setting, ui.session.a.settings) + "\n";
    }
    text += "cursor " + to_text(ui.session.cursor) + "\n";
    if (!ui.session.notice.empty()) text += "notice " + visible_line(ui.session.notice) + "\n";
    const PicturePlace& picture = ui.canvas.place;
    text += "picture" + numbers({picture.origin.x, picture.origin.y, picture.scale}) + "\n";
    const std::map<std::string, WidgetPlace> sorted(ui.widgets.begin(), ui.widgets.end());
    for (const auto& [name, place] : sorted) {
        if (!place.visible) continue;
        text += "widget" + numbers({place.top_left.x, place.top_left.y, place.bottom_right.x,
                                    place.bottom_right.y});
        text += " " + name + "\n";
    }
    return text;
}

} // namespace rasterwalk
