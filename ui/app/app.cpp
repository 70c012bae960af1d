#include "ui/app/app.h"

#include <algorithm>

#include "picture/view_image.h"
#include "session/shown_pass.h"
#include "session/walk.h"
#include "ui/actions/actions.h"
#include "ui/actions/code.h"
#include "ui/actions/compare.h"
#include "ui/actions/focus_keys.h"
#include "ui/actions/held_keys.h"
#include "ui/actions/lab.h"
#include "ui/actions/language.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/measure.h"
#include "ui/actions/mine.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/open_tab.h"
#include "ui/actions/reading.h"
#include "ui/actions/row_table_layout.h"
#include "ui/app/guard.h"
#include "ui/app/kept_options.h"
#include "ui/bars/bars.h"
#include "ui/canvas/canvas.h"
#include "ui/canvas/large_frame.h"
#include "ui/canvas/outside_view.h"
#include "ui/canvas/side_row_table.h"
#include "ui/inspector/panels.h"
#include "ui/lesson/lesson_column.h"
#include "ui/lesson/lesson_strip.h"
#include "ui/sheets/sheets.h"
#include "ui/start/start_choice.h"
#include "ui/start/start_page.h"
#include "ui/ui.h"
#include "ui/widgets/focus.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/language.h"
#include "ui/widgets/layout.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace rasterwalk {

namespace {

/// ImGui divides by the time between two frames.
constexpr float shortest_frame = 1e-5f;

void renew_style(Ui& ui) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const UiOptions& options = ui.options;
    const float chosen =
        std::min(options.wished_text_scale * ui.host.pixel_ratio, largest_text_scale);
    const float wished = options.is_lecture ? lecture_text_scale(window, chosen) : chosen;
    const float scale = fitting_text_scale(window, wished);
    if (scale != ui.options.text_scale) {
        ui.options.text_scale = scale;
        ui.style_is_stale = true;
    }
    if (!ui.style_is_stale) return;
    apply_style(ui.options);
    ui.fonts =
        load_fonts(options.text_scale, options.is_lecture ? least_lecture_letters(window) : 0.0f);
    ui.host.fonts_changed = true;
    ui.style_is_stale = false;
}

void draw_column_border(const Ui& ui, float x, float top, float bottom) {
    ImGui::GetWindowDrawList()->AddLine({x, top}, {x, bottom},
                                        packed(palette(ui.options.theme).line));
}

/// A strip along a border that is dragged to make a column wider.
void draw_splitter(Ui& ui, const char* name, float x, const Area& middle, float& share,
                   bool grows_to_the_left) {
    const float width = 8.0f * ui.options.text_scale;
    ImGui::SetNextWindowPos({x - 0.5f * width, middle.position.y});
    ImGui::SetNextWindowSize({width, middle.size.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::Begin(name, nullptr,
                 (panel_flags & ~ImGuiWindowFlags_NoBringToFrontOnFocus) |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::InvisibleButton(name, {width, middle.size.y});
    const float window = ImGui::GetIO().DisplaySize.x;
    if (ImGui::IsItemActive()) {
        const float mouse = ImGui::GetIO().MousePos.x;
        share = std::clamp((grows_to_the_left ? window - mouse : mouse) / window, 0.05f, 0.9f);
    }
    if (ImGui::IsItemActive() || ImGui::IsItemHovered()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    }
    register_widget(ui, name);
    if (const int right = take_arrows(ui, name).right; right != 0) {
        share = std::clamp((grows_to_the_left ? window - x : x) / window +
                               0.01f * static_cast<float>(grows_to_the_left ? -right : right),
                           0.05f, 0.9f);
    }
    draw_column_border(ui, x, middle.position.y, middle.position.y + middle.size.y);
    ImGui::End();
    ImGui::PopStyleVar();
}

/// The window with a scene in it.
void draw_workplace(Ui& ui, const Layout& layout) {
    guarded(ui, [&] { draw_stage_strip(ui, layout); });
    const bool has_drawer = is_drawer_open(ui); // what is drawn may close it
    guarded(ui, [&] {
        if (!layout.lesson_is_strip) {
            draw_lesson_column(ui, layout.lesson);
        } else if (!has_drawer) {
            draw_lesson_strip(ui, layout.lesson);
        }
    });
    guarded(ui, [&] { draw_canvas(ui, layout.canvas); });
    guarded(ui, [&] {
        ui.code.pointed.clear();
        if (has_drawer) {
            draw_lesson_drawer(ui, layout.inspector);
        } else if (!draw_row_table_for_inspector(ui, layout.inspector)) {
            draw_inspector(ui, layout.inspector);
        }
    });
    guarded(ui, [&] { draw_transport(ui, layout.transport); });
    guarded(ui, [&] {
        if (layout.status.size.y > 0.0f) draw_status_line(ui, layout.status);
    });
    if (!layout.lesson_is_strip) {
        draw_splitter(ui, "splitter.lesson", layout.canvas.position.x, layout.canvas,
                      ui.options.lesson_width, false);
    }
    // The column widths that the student chose do not apply to a lecture.
    if (!ui.options.is_lecture) {
        draw_splitter(ui, "splitter.inspector", layout.inspector.position.x, layout.canvas,
                      ui.options.inspector_width, true);
    }
}

bool has_status_line(const Ui& ui) {
    return !spares_status_line(ui) || !ui.session.notice.empty() || !ui.fonts.notice.empty();
}

/// The layout, without the lesson's column if the canvas needs its width.
Layout layout_of(const Ui& ui, ImVec2 window) {
    LayoutNeeds needs{.transport = transport_height(ui, window.x),
                      .lesson_strip = lesson_strip_height(ui),
                      .has_drawer = ui.lesson.drawer_is_open,
                      .menu_end = menu_end_width(ui, window.x),
                      // A row table that continues the picture's rows is as high as they are.
                      .high_canvas = !is_lecture_of_rows(ui),
                      .has_stages = !ui.start.is_open,
                      .has_status = has_status_line(ui)};
    const Layout narrow = compute_layout(window, ui.options, needs);
    needs.wide_canvas = true;
    const Layout wide = compute_layout(window, ui.options, needs);
    return wants_wide_canvas(ui, narrow.canvas.size, wide.canvas.size) ? wide : narrow;
}

void draw_everything(Ui& ui) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const Layout layout = layout_of(ui, window);
    ui.lesson.is_strip = layout.lesson_is_strip;
    ui.lesson.strip.is_at_side = layout.lesson_is_at_side;
    ui.lesson.strip.most_height = layout.most_strip;
    // A part that fails leaves the others on the screen.
    guarded(ui, [&] { draw_menu_bar(ui, layout); });
    if (ui.start.is_open) {
        guarded(ui, [&] { draw_start_page(ui, {0.0f, layout.menu.size.y}, window); });
    } else {
        draw_workplace(ui, layout);
    }
    guarded(ui, [&] { draw_key_sheet(ui, window); });
    guarded(ui, [&] { draw_glossary_sheet(ui, window); });
    guarded(ui, [&] { draw_map_sheet(ui, window); });
    guarded(ui, [&] { draw_event_sheet(ui, window); });
    guarded(ui, [&] { draw_test_sheet(ui, window); });
    guarded(ui, [&] { draw_file_sheet(ui, window); });
    guarded(ui, [&] { draw_reading_bar(ui, window); });
    draw_ring(ui);
    release_pointed(ui);
}

/// True while nothing is held, so that a drag counts as one change.
bool is_at_rest() {
    const ImGuiIO& io = ImGui::GetIO();
    const bool button_is_down = std::any_of(std::begin(io.MouseDown), std::end(io.MouseDown),
                                            [](bool down) { return down; });
    return !button_is_down && !ImGui::IsAnyItemActive();
}

/// Has everything that the student does come to rest, and everything that follows from it?
bool is_still(const Ui& ui) {
    return is_at_rest() && !is_any_key_down() && !ui.session.play.running &&
           !is_moving_by_key(ui) && !is_moving_by_arrows(ui) && !is_working(ui.results);
}

/// Works out what follows from the session. If that fails, for example for lack of memory, the
/// session goes back to its last good state.
bool update_or_go_back(Ui& ui) {
    SessionInputs& inputs = ui.session;
    const auto work = [&] {
        update(ui.session, ui.results, work_limit(ui));
        ui.worked_out = inputs;
    };
    if (guarded(ui, work)) return true;
    if (!ui.worked_out) return false;
    inputs = *ui.worked_out;
    return guarded(ui, work);
}

/// For the worst case: nothing can be drawn except the sentence that says why.
void draw_notice_alone(const Ui& ui) {
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::Begin("notice", nullptr, panel_flags);
    wrapped_text(ui.session.notice);
    ImGui::End();
}

/// One pass: from the input to what is to be drawn. Returns true if a widget changed the inputs, so
/// that what was drawn is already out of date.
bool build_pass(Ui& ui, float seconds) {
    keep_tab();
    ImGui::NewFrame();
    guarded(ui, [&] { handle_keys(ui); }); // uses the widgets' places in the frame on screen
    ui.widgets.clear();
    guarded(ui, [&] {
        if (!play_code(ui, seconds))
            advance_play(ui.session, Timeline(ui.results.a.frame), ui.results.length, seconds);
        mirror_changes_to_b(ui.session);
        leave_missing_pass(ui.session);
        leave_compare_tab(ui.session);
        follow_stage(ui.session);
    });
    guarded(ui, [&] { follow_start_page(ui); });
    if (is_blinking(ui)) advance_blinking(ui, seconds);
    const Cursor before = ui.results.a.cursor;
    const bool is_known = update_or_go_back(ui);
    if (is_known) guarded(ui, [&] { follow_code(ui); });
    ui.follow_cursor = ui.results.a.cursor != before;
    if (is_known && !ui.start.is_open && is_still(ui)) guarded(ui, [&] { tick_off_tasks(ui); });
    const SessionInputs& inputs = ui.session;
    const SessionInputs drawn = inputs;
    if (is_known) {
        guarded(ui, [&] { draw_everything(ui); });
    } else {
        draw_notice_alone(ui);
    }
    if (is_at_rest() && !is_moving_by_key(ui) && !is_moving_by_arrows(ui)) {
        guarded(ui, [&] {
            record_undo_step(ui.session);
            record_visit(ui.session);
        });
        guarded(ui, [&] { save_progress(ui); });
        guarded(ui, [&] { save_options(ui); });
    }
    ImGui::Render();
    return !(drawn == inputs);
}

} // namespace

void open_ui(Ui& ui, TextureHost& textures) {
    ui.fonts.atlas = std::make_shared<ImFontAtlas>(); // until the first frame
    ImGui::CreateContext(ui.fonts.atlas.get());
    ImGui::GetIO().IniFilename = nullptr;
    open_keys();
    ui.host.textures = &textures;
    take_up_lesson(ui);
    update(ui.session, ui.results, work_limit(ui));
    const SessionInputs& inputs = ui.session;
    ui.worked_out = inputs;
    // In a small window the list of lessons is in the drawer.
    ui.lesson.drawer_is_open = ui.session.page == SidePage::list;
    ui.options.text_scale = ui.options.wished_text_scale;
    ImGui::GetIO().DisplaySize = {1600.0f, 1000.0f}; // until the host sets it
}

void close_ui(Ui& ui) {
    ImGui::GetIO().Fonts->Locked = false; // where a frame was not finished
    ImGui::DestroyContext();
    use_language(english());
    ui.host.textures = nullptr;
}

void build_ui(Ui& ui) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize.x = std::max(io.DisplaySize.x, 1.0f);
    io.DisplaySize.y = std::max(io.DisplaySize.y, 1.0f);
    io.DeltaTime = std::max(io.DeltaTime, shortest_frame);
    guarded(ui, [&] { renew_language(ui); });
    guarded(ui, [&] { renew_style(ui); });
    guarded(ui, [&] { poll_diagnosis(ui); });
    guarded(ui, [&] { poll_program_check(ui); });
    guarded(ui, [&] { poll_background_load(ui); });
    guarded(ui, [&] { poll_ladder(ui); });
    if (!build_pass(ui, io.DeltaTime)) return;
    // The same moment again, with the changed inputs; no input is used twice.
    const float seconds = io.DeltaTime;
    io.DeltaTime = shortest_frame;
    build_pass(ui, 0.0f);
    io.DeltaTime = seconds;
}

void keep_everything(Ui& ui) {
    ui.lesson.progress_file.next_try = ui.options_file.next_try = 0.0;
    guarded(ui, [&] { save_progress(ui); });
    guarded(ui, [&] { save_options(ui); });
}

bool is_animating(const Ui& ui) {
    return ui.session.play.running || is_moving_by_key(ui) || is_diagnosing(ui) ||
           is_working(ui.results) || is_outside_working(ui) || is_answer_waiting(ui) ||
           is_reading(ui) || is_measured_by_frames(ui) || is_code_running(ui);
}

} // namespace rasterwalk
