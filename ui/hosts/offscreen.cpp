#include "ui/hosts/offscreen.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/quoted.h"
#include "ui/actions/lab.h"
#include "ui/actions/measure.h"
#include "ui/actions/mine.h"
#include "ui/actions/open_tab.h"
#include "ui/app/app.h"
#include "ui/canvas/outside_view.h"
#include "ui/hand/hand.h"
#include "ui/hand/key_names.h"
#include "ui/hand/report.h"
#include "ui/hosts/gl2.h"
#include "ui/hosts/host_opengl.h"
#include "ui/hosts/made_times.h"
#include "ui/hosts/memory_context.h"
#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// A context that is current, with a picture in memory. Throws AccessError.
std::unique_ptr<OpenGlContext> entered_memory(int width, int height) {
    auto context = make_memory_context({width, height}, 0);
    context->enter();
    if (largest_gl2_side() >= std::max(width, height)) return context;
    throw AccessError(fmt::format("a window of {} x {} pixels is more than OpenGL can draw here.",
                                  width, height));
}

/// The interface with everything around it.
class Screen {
  public:
    Screen(Session session, const OffscreenOptions& options)
        : context_(entered_memory(options.width, options.height)), width_(options.width),
          height_(options.height) {
        ui.session = std::move(session);
        ui.reading.patience = std::chrono::hours(1); // the picture shows what was opened
        ui.mine.search =
            std::chrono::hours(1); // the picture must not depend on the machine's speed
        ui.options = options.ui;
        open_ui(ui, textures_);
        if (!options.tab.empty()) open_tab(ui, options.tab);
        if (!options.ladder_times.empty()) show_made_times(options.ladder_times);
        open_gl2();
        ImGui::GetIO().DisplaySize = {static_cast<float>(width_), static_cast<float>(height_)};
    }
    ~Screen() {
        textures_.release();
        close_gl2();
        close_ui(ui);
    }
    Screen(const Screen&) = delete;
    Screen& operator=(const Screen&) = delete;

    void frame() {
        begin_gl2_frame();
        build_ui(ui);
    }
    /// The last frame: the only one that is drawn.
    Image picture() {
        draw_gl2(ui, width_, height_);
        return read_gl2(width_, height_);
    }

    Ui ui;

  private:
    void show_made_times(const std::string& path) {
        MadeTimes made = read_made_times(path);
        ui.ladder.of = ladder_subject(ui.session);
        ui.ladder.times = std::move(made.times);
        ui.ladder.processor = std::move(made.processor);
    }

    std::unique_ptr<OpenGlContext> context_;
    HostOpenGl opengl_;
    UsedOpenGl used_{opengl_};
    Gl2Textures textures_;
    int width_, height_;
};

void carry_out(const HandAction& action, Hand& hand) {
    switch (action.kind) {
    case HandAction::Kind::click:
        hand.click(action.what);
        break;
    case HandAction::Kind::hover:
        hand.hover(action.what);
        break;
    case HandAction::Kind::pick: {
        int column = 0, row = 0;
        char rest = 0;
        if (std::sscanf(action.what.c_str(), " %d , %d %c", &column, &row, &rest) != 2) {
            throw UsageError("--pick takes a pixel X,Y, not '" + action.what + "'.");
        }
        hand.click_picture(column, row);
        break;
    }
    case HandAction::Kind::press: {
        const KeyPress pressed = parse_key(action.what);
        hand.press(pressed.key, pressed.modifiers);
        break;
    }
    }
}

/// The view from outside is finished long before this.
constexpr int most_frames_of_work = 10'000;

} // namespace

Image draw_offscreen(Session session, const OffscreenOptions& options) {
    Screen screen(std::move(session), options);
    Hand hand(screen.ui, [&] { screen.frame(); });
    // Work that a window would spread over many frames is done in one go.
    const auto settle = [&] {
        if (is_diagnosing(screen.ui)) {
            while (is_diagnosing(screen.ui))
                poll_diagnosis(screen.ui, {});
            hand.rest();
        }
        if (is_checking_program(screen.ui)) {
            finish_program_check(screen.ui);
            // The hour and the machine's speed would make each picture another one.
            screen.ui.mine.checked_at.clear();
            hand.rest();
        }
        if (is_measuring(screen.ui) || is_racing(screen.ui)) {
            // Frames would take time from what is measured.
            while (is_measuring(screen.ui) || is_racing(screen.ui)) {
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
                poll_ladder(screen.ui);
            }
            hand.rest();
        }
        if (is_working(screen.ui.results)) {
            finish(screen.ui.session, screen.ui.results);
            hand.rest();
        }
        for (int i = 0; i < most_frames_of_work && is_outside_working(screen.ui); ++i)
            hand.frames(1);
    };
    hand.rest();
    settle();
    if (!options.code.empty()) {
        check_my_program(screen.ui, options.code);
        settle();
    }
    for (const HandAction& action : options.actions) {
        carry_out(action, hand);
        settle();
    }
    // There is a tooltip only if the last action asks for it.
    const bool is_resting =
        !options.actions.empty() && options.actions.back().kind == HandAction::Kind::hover;
    if (!is_resting) hand.leave();
    if (options.report_path == "-") {
        std::cout << visible(screen_report(screen.ui));
    } else if (!options.report_path.empty()) {
        write_file(options.report_path, screen_report(screen.ui));
    }
    return screen.picture();
}

} // namespace rasterwalk
