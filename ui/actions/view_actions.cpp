#include <algorithm>
#include <limits>
#include <utility>

#include "picture/view_image.h"
#include "session/strip.h"
#include "session/walk.h"
#include "settings/setting_table.h"
#include "ui/actions/action_menus.h"
#include "ui/actions/compare.h"
#include "ui/actions/language.h"
#include "ui/actions/lecture.h"
#include "ui/actions/open_tab.h"
#include "ui/actions/outside.h"
#include "ui/actions/picture_fit.h"
#include "ui/actions/strip_doors.h"
#include "ui/ui.h"
#include "ui/widgets/keys.h"
#include "ui/widgets/language.h"
#include "ui/widgets/style.h"
#include "view/view_state.h"

namespace rasterwalk {

namespace {

/// Around the triangle, pixels of the picture.
constexpr float room_around = 0.5f;

/// Enlarges the triangle that the inspector shows, as far as it fits.
void zoom_to_triangle(Ui& ui) {
    const auto& widget = ui.widgets.find("canvas");
    if (!ui.results.a.triangle || widget == ui.widgets.end()) return;
    if (!ui.results.a.frame.is_drawn(*ui.results.a.triangle)) return;
    constexpr float infinite = std::numeric_limits<float>::infinity();
    PicturePart part{infinite, infinite, -infinite, -infinite};
    for (const ScreenVertex& vertex :
         ui.results.a.frame.triangle_vertices(*ui.results.a.triangle)) {
        const auto column = static_cast<float>(vertex.column), row = static_cast<float>(vertex.row);
        part = {std::min(part.left, column - room_around), std::min(part.top, row - room_around),
                std::max(part.right, column + 1.0f + room_around),
                std::max(part.bottom, row + 1.0f + room_around)};
    }
    const ImVec2 low = widget->second.top_left, high = widget->second.bottom_right;
    const PicturePlace place = fit_part(ui, part, low, high).place;
    // The middle of the triangle stays in its place, however the zoom is limited.
    const float zoom = std::clamp(place.scale, smallest_zoom, largest_zoom);
    const auto centre = [&](float middle, float origin, float from, float to) {
        const float at = origin + place.scale * middle;
        return middle + (0.5f * (from + to) - at) / zoom;
    };
    ui.session.canvas.zoom = zoom;
    ui.session.canvas.centre = {
        centre(0.5f * (part.left + part.right), place.origin.x, low.x, high.x),
        centre(0.5f * (part.top + part.bottom), place.origin.y, low.y, high.y)};
}

void set_text_scale(Ui& ui, float scale) {
    ui.options.wished_text_scale = std::clamp(scale, smallest_text_scale, largest_text_scale);
}

/// A row for each view.
std::vector<Action> view_choices() {
    std::vector<Action> actions;
    for (const ViewInfo& info : view_list()) {
        const View view = info.view;
        actions.push_back({std::string("view.").append(word_of(view)),
                           "View",
                           std::string(info.menu_title),
                           std::string(info.menu_help),
                           {},
                           [view](Ui& ui) { ui.session.view = view; },
                           [view](const Ui& ui) { return ui.session.view == view; }});
    }
    return actions;
}

/// A row for each thing that the canvas can show, and one for looking through the camera.
std::vector<Action> canvas_choices() {
    std::vector<Action> actions;
    for (const CanvasShowsInfo& info : canvas_shows_list()) {
        const CanvasShows shows = info.shows;
        const Chord chord{shows == CanvasShows::outside ? key::digit_0 + 8
                          : shows == CanvasShows::both  ? key::digit_0 + 9
                                                        : 0};
        actions.push_back({std::string("view.show_").append(info.name), "View",
                           std::string(info.menu_title), std::string(info.help), chord,
                           [shows](Ui& ui) { switch_canvas(ui, shows); },
                           [shows](const Ui& ui) { return shown_on_canvas(ui) == shows; }});
    }
    actions.push_back({"view.through_camera",
                       "View",
                       "Look through the camera",
                       "Moves the outside view to where the camera is; repeat to move it back.",
                       {},
                       switch_camera_view,
                       [](const Ui& ui) {
                           return shown_on_canvas(ui) != CanvasShows::picture &&
                                  ui.session.canvas.outside.is_camera;
                       }});
    return actions;
}

/// Turning the view from outside by keys; the pointer does it on the canvas.
std::vector<Action> turning_actions() {
    struct Turn {
        const char *name, *title;
        int key;
        float yaw, pitch;
    };
    constexpr float step = 0.1f; // radians
    std::vector<Action> actions;
    for (const Turn turn : {Turn{"left", "Turn the outside view left", key::left, -step, 0.0f},
                            Turn{"right", "Turn the outside view right", key::right, step, 0.0f},
                            Turn{"up", "Turn the outside view up", key::up, 0.0f, step},
                            Turn{"down", "Turn the outside view down", key::down, 0.0f, -step}}) {
        actions.push_back({std::string("view.outside_").append(turn.name),
                           "",
                           turn.title,
                           "Turns the scene in the outside view.",
                           {turn.key, false, true},
                           [turn](Ui& ui) {
                               if (shown_on_canvas(ui) == CanvasShows::picture) return;
                               turn_outside(ui, turn.yaw, turn.pitch);
                           }});
    }
    return actions;
}

/// A row for each entry of the strip; the stages have the digits as keys.
std::vector<Action> strip_actions() {
    std::vector<Action> actions;
    for (const StripEntry& entry : strip_list()) {
        const StageInfo* const stage = find_stage(entry.name);
        Action action{std::string("stage.").append(entry.name),
                      "Stage",
                      std::string(entry.words.title),
                      std::string(entry.words.help),
                      Chord{stage != nullptr ? '1' + strip_place(stage->step) : 0},
                      [&entry](Ui& ui) {
                          if (entry.set != nullptr) {
                              take_step(ui.session, entry);
                          } else {
                              open_door(ui, entry.name);
                          }
                      }};
        // Light and depth have no line between them where flat shading is of no use.
        action.begins_group =
            entry.name == "points" || entry.name == "flat" || entry.name == "texture";
        action.is_of_use = [&entry](const Ui& ui) {
            const StripRow usable = usable_entries(ui.session);
            return std::find(usable.begin(), usable.end(), &entry) != usable.end();
        };
        action.words_now = [&entry](const Ui& ui) {
            return ActionWords{title_of(entry, ui.session, current_language()),
                               help_of(entry, ui.session, current_language())};
        };
        actions.push_back(std::move(action));
    }
    return actions;
}

} // namespace

std::vector<Action> view_actions() {
    std::vector<Action> actions = canvas_choices();
    for (const auto more : {view_choices, turning_actions}) {
        std::vector<Action> group = more();
        group.front().begins_group = true;
        for (Action& action : group)
            actions.push_back(std::move(action));
    }
    const std::vector<Action> others{
        {"view.grid",
         "View",
         "Pixel grid",
         "Draws lines between the pixels at 8x and above.",
         {'G'},
         [](Ui& ui) { ui.session.canvas.grid = !ui.session.canvas.grid; },
         [](const Ui& ui) { return ui.session.canvas.grid; },
         true},
        {"view.fit",
         "View",
         "Fit the picture",
         "Shows the whole picture (of a very small one, its triangles); in the outside view, the "
         "whole scene.",
         {'F'},
         [](Ui& ui) {
             ui.session.canvas.zoom = 0.0f;
             ui.session.canvas.outside.distance = 0.0f;
             ui.session.canvas.outside.is_camera = false;
         }},
        {"view.zoom_selection",
         "View",
         "Zoom to the triangle",
         "Enlarges the triangle that the inspector shows.",
         {'X'},
         zoom_to_triangle},
        {"view.settings",
         "View",
         "Settings",
         "Every choice that changes the picture, on a sheet over the inspector.",
         {key::comma, true},
         toggle_settings,
         is_settings_open,
         true},
        {"view.lecture",
         "View",
         "Lecture mode",
         "Makes everything large for a projector; Page down walks. Escape ends it.",
         {key::f5},
         toggle_lecture,
         [](const Ui& ui) { return ui.options.is_lecture; }},
        {"view.larger_text",
         "View",
         "Larger text",
         "Makes all text larger.",
         {key::equal, true},
         [](Ui& ui) { set_text_scale(ui, ui.options.wished_text_scale + text_scale_step); },
         nullptr,
         true,
         true},
        {"view.smaller_text",
         "View",
         "Smaller text",
         "Makes all text smaller.",
         {key::minus, true},
         [](Ui& ui) { set_text_scale(ui, ui.options.wished_text_scale - text_scale_step); },
         nullptr,
         false,
         true},
        {"view.normal_text",
         "View",
         "Normal text",
         "Sets the text back to 16 pixels.",
         {key::digit_0, true},
         [](Ui& ui) { set_text_scale(ui, 1.0f); }},
        {"view.theme",
         "View",
         "Light theme",
         "Switches between the dark and the light theme.",
         {},
         [](Ui& ui) {
             ui.options.theme = ui.options.theme == Theme::dark ? Theme::light : Theme::dark;
             ui.style_is_stale = true;
         },
         [](const Ui& ui) { return ui.options.theme == Theme::light; }},
        {.name = "view.language",
         .menu = "View",
         .title = "Language",
         .help = "Goes on to the next language of menus, strip, transport and lessons.",
         .chord = {},
         .run = [](Ui& ui) { choose_language(ui, next_language(ui).code); },
         .is_of_use = [](const Ui& ui) { return ui.language_choices.size() > 1; },
         .words_now =
             [](const Ui& ui) {
                 return ActionWords{tr("Language: {}", ui.language.name),
                                    tr("Goes on to {}: menus, strip, transport and lessons, as far "
                                       "as they are translated.",
                                       next_language(ui).name)};
             }},
    };
    actions.insert(actions.end(), others.begin(), others.end());
    return actions;
}

std::vector<Action> stage_actions() {
    std::vector<Action> actions = strip_actions();
    const std::vector<Action> switches{
        {"switch.perspective",
         "Stage",
         "Perspective-correct interpolation",
         "Interpolates q/z, or q/w where w is not z, and recovers q at the pixel; when it is off, "
         "q itself is interpolated and the light is skewed.",
         {'P'},
         [](Ui& ui) {
             if (refuses_settings(ui.session)) return;
             Interpolation& i = ui.session.a.settings.interpolation;
             i = i == Interpolation::perspective ? Interpolation::affine
                                                 : Interpolation::perspective;
         },
         [](const Ui& ui) {
             return ui.session.a.settings.interpolation == Interpolation::perspective;
         },
         true},
        {"switch.depth_test",
         "Stage",
         "Depth test",
         "Draws a fragment only if it is nearer; when it is off, the last one drawn wins. If "
         "something else removes hidden surfaces, brings the depth buffer back.",
         {'Z'},
         [](Ui& ui) {
             if (refuses_settings(ui.session)) return;
             Settings& settings = ui.session.a.settings;
             DepthTest& d = settings.depth_test;
             if (std::exchange(settings.hidden, Hidden::depth_buffer) == Hidden::depth_buffer)
                 d = d == DepthTest::off ? DepthTest::inverse_z : DepthTest::off;
         },
         [](const Ui& ui) {
             const Settings& settings = ui.session.a.settings;
             return settings.hidden == Hidden::depth_buffer &&
                    settings.depth_test != DepthTest::off;
         }},
    };
    actions.insert(actions.end(), switches.begin(), switches.end());
    return actions;
}

} // namespace rasterwalk
