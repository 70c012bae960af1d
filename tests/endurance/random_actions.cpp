#include "tests/endurance/random_actions.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "base/error.h"
#include "base/files.h"
#include "base/letter_case.h"
#include "session/content.h"
#include "session/tabs.h"
#include "settings/setting_table.h"
#include "tests/support/changed_files.h"
#include "tests/support/hostile_lessons.h"
#include "ui/actions/actions.h"
#include "ui/actions/lab.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/measure.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/view_files.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/style.h"

namespace rasterwalk::endurance {

namespace {

namespace fs = std::filesystem;

constexpr float moment = 1.0f / 60.0f; ///< between the parts of an action, seconds
const ImVec2 usual_size{1600.0f, 1000.0f};
const ImVec2 sizes[] = {usual_size,   {320, 200},   {800, 600},  {1280, 720},
                        {1920, 1080}, {2560, 1440}, {480, 1600}, {1600, 300},
                        {3840, 2160}, usual_size,   {1024, 768}, {1366, 768}};
constexpr std::string_view texts[] = {
    "0",      "1",           "-1",          "12.5",       "1e9",    "nan",
    "-inf",   "500x500",     "1,2,3",       "0.5 0.5",    "",       "view",
    "edge",   "triangle 7",  "ä€ß漢字",     "t12/e2/s14", "p3:end", "99999999999999999999",
    "%s%n%d", "a.walk.toml", "b.walk.toml", "..",         "\"",     "##",
    "auto"};
/// Values of settings; most do not suit most settings.
constexpr std::string_view values[] = {
    "0",   "1",       "-1",  "2",     "0.25",  "7",         "1e30",      "auto",     "on",
    "off", "500x500", "1x1", "64x48", "0,0,0", "1,0.5,0.2", "-1,1,-1,1", "truncate", "none"};
constexpr int named_keys[] = {key::escape,    key::enter, key::tab,  key::backspace, key::del,
                              key::right,     key::left,  key::down, key::up,        key::page_up,
                              key::page_down, key::home,  key::end,  key::space,     key::escape};

void sort_into(std::vector<std::string>& paths, const std::string& folder) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file()) paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
}

/// The targets of the links in a lesson.
void add_links(std::string_view text, std::vector<std::string>& links) {
    constexpr std::string_view before = "](";
    for (std::size_t at = 0; (at = text.find(before, at)) != text.npos;) {
        at += before.size();
        links.emplace_back(text.substr(at, text.find(')', at) - at));
    }
}

} // namespace

RandomActions::RandomActions(Driver& driver, std::uint32_t seed, std::string folder)
    : driver_(driver), ui_(driver.ui), seed_(seed), folder_(std::move(folder)) {
    const std::string lessons = lessons_folder();
    sort_into(scenes_, lessons + "/scenes");
    sort_into(scenes_, lessons + "/models");
    sort_into(dropped_, lessons + "/scenes/textures");
    sort_into(dropped_, lessons);
    int number = 0;
    const auto drop_later = [&](const std::string& name, const std::string& bytes) {
        dropped_.push_back(folder_ + "/" + name);
        write_file(dropped_.back(), bytes);
    };
    for (const auto& make : {test::hostile_lessons, test::tiring_lessons}) {
        for (const test::HostileLesson& lesson : make())
            drop_later("hostile" + std::to_string(++number) + ".md", lesson.text);
    }
    drop_later("endless.png", test::endless_picture());
    drop_later("program.cpp", "int main() {}\n");
    drop_later("empty.toml", "");
    for (const char* const name : {"a", "b", "view"})
        dropped_.push_back(folder_ + "/" + name + ".walk.toml");
    for (const char* const name : {"gone.obj", ".", "/dev/null", "/dev/zero"})
        dropped_.push_back(name[0] == '/' ? name : folder_ + "/" + name);
    for (const TabInfo& tab : tab_list())
        links_.push_back("tab:" + std::string(tab.name));
    for (const fs::directory_entry& entry : fs::directory_iterator(lessons)) {
        if (entry.path().extension() == ".md") add_links(read_file(entry.path().string()), links_);
    }
    for (const char* const link : {"cursor:t999/e1", "cursor:p2:t3", "cursor:w12", "cursor:end",
                                   "bug:B0", "show:nothing", "preset:lab", "javascript:alert", ""})
        links_.push_back(link);
    std::sort(links_.begin(), links_.end());
}

std::string RandomActions::act(int number) {
    // What was on the screen before must not decide which numbers come now.
    random_ = test::Random(seed_ * 1'000'003u + static_cast<std::uint32_t>(number));
    struct Share {
        int weight;
        Kind kind;
    };
    static constexpr Share shares[] = {{30, &RandomActions::click_widget},
                                       {8, &RandomActions::click_anywhere},
                                       {8, &RandomActions::drag},
                                       {16, &RandomActions::press_key},
                                       {4, &RandomActions::hold_key},
                                       {8, &RandomActions::type_text},
                                       {6, &RandomActions::turn_wheel},
                                       {4, &RandomActions::hover},
                                       {2, &RandomActions::change_size},
                                       {1, &RandomActions::change_look},
                                       {5, &RandomActions::run_action},
                                       {4, &RandomActions::follow_any_link},
                                       {2, &RandomActions::open_lesson_step},
                                       {1, &RandomActions::open_scene},
                                       {1, &RandomActions::drop_file}};
    constexpr int all = 100;
    int left = random_.integer(1, all);
    const Share* chosen = std::begin(shares);
    while ((left -= chosen->weight) > 0 && chosen + 1 != std::end(shares))
        ++chosen;
    stay_in_folder();
    const std::string what = (this->*chosen->kind)();
    frame(0.1f);
    give_up_long_work();
    return what;
}

void RandomActions::come_to_rest() {
    play_modifiers(false, false, false);
    for (int i = 0; i < 12; ++i)
        driver_.hand.press(key::escape);
    driver_.resize(usual_size);
    ui_.options.wished_text_scale = 1.0f;
    ui_.start.is_open = false;
    open_file(ui_, lessons_folder() + "/scenes/lab-room.toml");
    ui_.session.a.settings = default_settings(*ui_.session.scene);
    driver_.hand.leave();
    // Longer than what is not shown keeps its memory.
    driver_.hand.frames(20, 2.0f);
}

void RandomActions::frame(float seconds) {
    driver_.hand.frames(1, seconds);
    // What the host does.
    ui_.host.fonts_changed = ui_.host.wants_quit = ui_.host.wants_picture = false;
}

/// Presses a button of the mouse and releases it, now and then twice.
void RandomActions::press_mouse(ImVec2 place) {
    play_pointer(place);
    frame(moment);
    const int button = random_.integer(0, 9) == 0 ? random_.integer(1, 2) : 0;
    const int times = random_.integer(0, 9) == 0 ? 2 : 1;
    play_some_modifiers();
    for (int i = 0; i < times; ++i) {
        play_mouse_button(button, true);
        frame(moment);
        play_mouse_button(button, false);
        if (i + 1 < times) frame(moment);
    }
    frame(moment);
    play_modifiers(false, false, false);
}

void RandomActions::play_some_modifiers() {
    const auto rarely = [&] { return random_.integer(0, 7) == 0; };
    const bool ctrl = rarely(), shift = rarely(), alt = rarely() && rarely();
    play_modifiers(ctrl, shift, alt);
}

/// A widget that can be seen: first its kind, so that long tables do not take every turn.
std::string RandomActions::some_widget() {
    std::vector<std::string> all = driver_.hand.names();
    std::erase_if(all, [&](const std::string& name) { return !driver_.hand.is_visible(name); });
    if (all.empty()) return {};
    const auto kind_of = [](const std::string& name) { return name.substr(0, name.find('.')); };
    std::vector<std::string> kinds;
    for (const std::string& name : all)
        if (kinds.empty() || kinds.back() != kind_of(name)) kinds.push_back(kind_of(name));
    const std::string kind = one_of(kinds);
    std::erase_if(all, [&](const std::string& name) { return kind_of(name) != kind; });
    return one_of(all);
}

ImVec2 RandomActions::place_in(const std::string& widget) {
    const auto found = ui_.widgets.find(widget);
    if (found == ui_.widgets.end()) return any_place();
    const WidgetPlace& at = found->second;
    return {random_.number(at.top_left.x, at.bottom_right.x),
            random_.number(at.top_left.y, at.bottom_right.y)};
}

ImVec2 RandomActions::any_place() {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    return {random_.number(-5.0, size.x + 5.0), random_.number(-5.0, size.y + 5.0)};
}

std::string RandomActions::click_widget() {
    const std::string name = some_widget();
    press_mouse(place_in(name));
    return "click " + name;
}

std::string RandomActions::click_anywhere() {
    const ImVec2 place = any_place();
    press_mouse(place);
    return "click " + std::to_string(place.x) + "," + std::to_string(place.y);
}

std::string RandomActions::drag() {
    const std::string name = some_widget();
    const ImVec2 from = place_in(name), to = any_place();
    play_pointer(from);
    frame(moment);
    play_some_modifiers();
    const int button = random_.integer(0, 4) == 0 ? 1 : 0;
    play_mouse_button(button, true);
    frame(moment);
    play_pointer({0.5f * (from.x + to.x), 0.5f * (from.y + to.y)});
    frame(moment);
    play_pointer(to);
    frame(moment);
    play_mouse_button(button, false);
    play_modifiers(false, false, false);
    return "drag " + name;
}

int RandomActions::some_key() {
    switch (random_.integer(0, 4)) {
    case 0:
        return random_.integer('A', 'Z');
    case 1:
        return random_.integer('0', '9');
    case 2:
        return random_.integer(key::f1, key::f12);
    default:
        return one_of(named_keys);
    }
}

std::string RandomActions::press_key() {
    const int code = some_key();
    play_some_modifiers();
    play_key(code, true);
    frame(moment);
    play_key(code, false);
    play_modifiers(false, false, false);
    return "key " + std::to_string(code);
}

std::string RandomActions::hold_key() {
    const int code = some_key();
    play_key(code, true);
    for (int i = random_.integer(2, 8); i > 0; --i)
        frame(0.1f);
    play_key(code, false);
    return "hold " + std::to_string(code);
}

std::string RandomActions::type_text() {
    const std::string text(one_of(texts));
    if (random_.integer(0, 1) == 0) {
        // A field, if there is one.
        std::vector<std::string> fields;
        for (const std::string& name : driver_.hand.names())
            if (ui_.widgets.at(name).is_input && driver_.hand.is_visible(name))
                fields.push_back(name);
        if (!fields.empty()) press_mouse(place_in(one_of(fields)));
    }
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
    frame(moment);
    if (random_.integer(0, 1) == 0) {
        play_key(key::enter, true);
        frame(moment);
        play_key(key::enter, false);
    }
    return "type " + text;
}

std::string RandomActions::turn_wheel() {
    play_pointer(random_.integer(0, 1) == 0 ? place_in("canvas") : any_place());
    frame(moment);
    play_some_modifiers();
    play_wheel(random_.number(-4.0, 4.0), random_.number(-1.0, 1.0));
    frame(moment);
    play_modifiers(false, false, false);
    return "wheel";
}

std::string RandomActions::hover() {
    const std::string name = some_widget();
    play_pointer(place_in(name));
    frame(1.0f);
    return "hover " + name;
}

std::string RandomActions::change_size() {
    const ImVec2 size = one_of(sizes);
    ImGui::GetIO().DisplaySize = size;
    return "size " + std::to_string(static_cast<int>(size.x)) + "x" +
           std::to_string(static_cast<int>(size.y));
}

std::string RandomActions::change_look() {
    ui_.options.wished_text_scale = 0.25f * static_cast<float>(random_.integer(3, 8));
    ui_.options.theme = random_.integer(0, 1) == 0 ? Theme::light : Theme::dark;
    ui_.style_is_stale = true;
    return "look";
}

std::string RandomActions::run_action() {
    const Action& action = one_of(action_table());
    if (action.is_of_use && !action.is_of_use(ui_)) return "no use: " + action.name;
    action.run(ui_);
    return "action " + action.name;
}

std::string RandomActions::follow_any_link() {
    std::string link = one_of(links_);
    if (random_.integer(0, 1) == 0) {
        const Setting& setting = one_of(setting_table());
        std::string value(one_of(values));
        if (const auto* words = std::get_if<ChoiceSetting>(&setting.kind))
            value = one_of(words->words);
        link = "set:" + std::string(setting.name) + "=" + value;
    }
    follow_link(ui_, link);
    return "link " + link;
}

std::string RandomActions::open_lesson_step() {
    const std::vector<Lesson>& lessons = ui_.lesson.lessons.all();
    if (lessons.empty()) return "no lessons";
    const std::string id = one_of(lessons).id;
    const int step = random_.integer(0, 9);
    ui_.start.is_open = false;
    open_lesson(ui_, id, step);
    return "lesson " + id + "/" + std::to_string(step);
}

std::string RandomActions::open_scene() {
    const std::string& path = one_of(scenes_);
    open_dropped(ui_, path);
    return "scene " + path;
}

/// A sound file, changed.
std::string RandomActions::changed_file() {
    static const std::vector<test::ChangedFormat> formats = test::changed_formats();
    const test::ChangedFormat& format = one_of(formats);
    const std::string path =
        folder_ + "/changed." + (format.name == "scene" ? "toml" : in_small_letters(format.name));
    write_file(path,
               test::changed_file(format, static_cast<std::uint32_t>(random_.integer(1, 1 << 30))));
    return path;
}

std::string RandomActions::drop_file() {
    const std::string path = random_.integer(0, 1) == 0 ? one_of(dropped_) : changed_file();
    open_dropped(ui_, path);
    return "drop " + path;
}

/// Views are saved in the folder only, whatever was clicked and typed, and under few names.
void RandomActions::stay_in_folder() {
    FileSheet& sheet = ui_.sheets.files;
    if (sheet.kind != FileSheet::Kind::save) return;
    if (sheet.folder != folder_) enter_folder(sheet, folder_);
    constexpr std::size_t longest = 24;
    if (sheet.path.size() > longest || sheet.path.find('/') != std::string::npos)
        sheet.path = "view";
}

/// Explaining a picture or measuring may take a minute, which teaches nothing new here.
void RandomActions::give_up_long_work() {
    constexpr int patience = 20; // actions
    const bool is_long = is_diagnosing(ui_) || is_measuring(ui_) || is_racing(ui_);
    diagnosing_ = is_long ? diagnosing_ + 1 : 0;
    if (diagnosing_ < patience) return;
    give_up_diagnosis(ui_);
    stop_measuring(ui_);
}

} // namespace rasterwalk::endurance
