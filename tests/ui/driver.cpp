#include "tests/ui/driver.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "session/content.h"
#include "ui/actions/open_tab.h"
#include "ui/app/app.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

ImTextureID KeptTextures::upload(ImTextureID old, const Image& image) {
    last = image;
    ++uploads;
    // Any name that is not null; every new texture has a different one.
    if (old != ImTextureID{}) return old;
    return ImTextureID(static_cast<std::intptr_t>(uploads));
}

namespace {

/// The lessons of the program, read once: thousands of windows are opened here.
const LessonList& read_lessons() {
    static const LessonList lessons = [] {
        LessonList list;
        list.all();
        return list;
    }();
    return lessons;
}

} // namespace

Driver::Driver(const std::string& scene, ImVec2 window, float text_scale)
    : Driver(open_session(lessons_folder() + "/scenes/" + scene), window, text_scale) {}

Driver::Driver(Session session, ImVec2 window, float text_scale)
    : hand(ui, [this] { build_ui(ui); }) {
    ui.session = std::move(session);
    ui.reading.patience = std::chrono::hours(1); // however busy the machine is
    ui.options.wished_text_scale = text_scale;
    const bool are_others = std::getenv("RASTERWALK_LESSONS") != nullptr;
    if (!are_others) ui.lesson.lessons = read_lessons();
    open_ui(ui, textures);
    resize(window);
}

Driver::~Driver() {
    close_ui(ui);
}

void Driver::resize(ImVec2 window) {
    ImGui::GetIO().DisplaySize = window;
    hand.rest();
}

void Driver::open(std::string_view tab) {
    const std::string name = std::string("tab.").append(tab);
    hand.leave();
    if (ui.widgets.count("settings.close") > 0) hand.click("settings.close");
    if (is_drawer_open(ui)) hand.click("lesson.whole");
    if (ui.widgets.count("tabs") > 0) {
        hand.click("tabs");
    } else if (const TabInfo* const info = find_tab(tab); ui.widgets.count(name) == 0 && info) {
        hand.click(std::string("group.").append(word_of(info->group)));
    }
    hand.click(name);
}

bool Driver::tab_to(std::string_view name, Modifiers modifiers) {
    constexpr int most_presses = 400;
    for (int i = 0; i < most_presses; ++i) {
        if (ui.focus.is_shown && ui.focus.name == name) return true;
        hand.press(key::tab, modifiers);
    }
    return false;
}

std::string fault_of_frame() {
    const ImDrawData* const data = ImGui::GetDrawData();
    if (data == nullptr || !data->Valid) return "no frame was drawn";
    for (int i = 0; i < data->CmdListsCount; ++i) {
        const ImDrawList& list = *data->CmdLists[i];
        for (const ImDrawVert& corner : list.VtxBuffer) {
            if (!std::isfinite(corner.pos.x) || !std::isfinite(corner.pos.y))
                return std::string("a corner that is not a number in ") + list._OwnerName;
        }
    }
    return {};
}

} // namespace rasterwalk
