#pragma once

#include <set>

#include <imgui.h>

#include "ui/widgets/widget_state.h"

namespace rasterwalk {

/// The colours that something begins or ends with within the widget in the frame that was drawn
/// last, as draw lists have them.
inline std::set<ImU32> shown_colours(const WidgetPlace& place) {
    std::set<ImU32> colours;
    const ImDrawData* const data = ImGui::GetDrawData();
    for (int i = 0; i < data->CmdListsCount; ++i) {
        for (const ImDrawVert& corner : data->CmdLists[i]->VtxBuffer) {
            const ImVec2& at = corner.pos;
            if (at.x >= place.top_left.x && at.x <= place.bottom_right.x &&
                at.y >= place.top_left.y && at.y <= place.bottom_right.y) {
                colours.insert(corner.col);
            }
        }
    }
    return colours;
}

} // namespace rasterwalk
