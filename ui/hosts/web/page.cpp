// The interface in a browser. page.js, which runs first, is the other half: it listens to the
// browser and calls the functions at the end of this file; those that it provides are listed at the
// top.

#include <algorithm>
#include <cmath>
#include <exception>

#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include <GLES3/gl3.h>
#include <emscripten.h>
#include <emscripten/html5.h>

#include "base/error.h"
#include "engines/engine_planes.h"

#include "opening/opened_view.h"
#include "opening/view_link.h"
#include "picture/view_image.h"
#include "session/shown_pass.h"
#include "ui/actions/compare.h"
#include "ui/actions/reading.h"
#include "ui/actions/view_files.h"
#include "ui/app/app.h"
#include "ui/app/guard.h"
#include "ui/hand/report.h"
#include "ui/hosts/gl2.h"
#include "ui/hosts/life.h"
#include "ui/hosts/web/input.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/style.h"

// clang-format off
EM_JS(void, page_copy, (const char* text), { page.copy(UTF8ToString(text)); })
EM_JS(void, page_choose_file, (bool is_result), { page.chooseFile(is_result); })
EM_JS(void, page_hand_out, (const char* path), { page.handOut(UTF8ToString(path)); })
EM_JS(bool, page_keep, (const char* path), { return page.keep(UTF8ToString(path)); })
EM_JS(void, page_set_cursor, (const char* name), { page.setCursor(UTF8ToString(name)); })
EM_JS(void, page_set_typing, (bool is_typing), { page.setTyping(is_typing); })
EM_JS(void, page_set_address, (const char* fragment), { page.setAddress(UTF8ToString(fragment)); })
EM_JS(void, page_say, (const char* sentence), { page.say(UTF8ToString(sentence)); })
// A context that was lost and is back has none of its objects: new textures under the old names,
// and nothing else that could be deleted.
EM_JS(void, page_make_textures_anew, (), {
    for (const table of [GL.buffers, GL.programs, GL.shaders, GL.vaos]) table.fill(null);
    GL.textures.forEach((old, name) => {
        if (!old) return;
        GL.textures[name] = GLctx.createTexture();
        GL.textures[name].name = name;
    });
})
// clang-format on

namespace rasterwalk {

namespace {

constexpr const char* canvas_name = "#canvas";

/// The textures and their contents, for when the browser takes the context away and gives it back.
class PageTextures : public TextureHost {
  public:
    ImTextureID upload(ImTextureID old, const Image& image) override {
        const ImTextureID id = textures_.upload(old, image);
        images_[id] = image;
        return id;
    }
    void renew() {
        textures_.forget_contents();
        for (const auto& [id, image] : images_)
            textures_.upload(id, image);
    }

  private:
    Gl2Textures textures_;
    std::map<ImTextureID, Image> images_;
};

/// The size of the canvas, pixels.
struct CanvasSize {
    int width = 1, height = 1;

    friend bool operator==(const CanvasSize&, const CanvasSize&) = default;
};

struct Page {
    Ui ui;
    PageTextures textures;
    PageEvents events;
    CanvasSize size;
    double last_frame = 0.0;  ///< milliseconds
    double meant_sleep = 0.0; ///< seconds
    int frames_due = frames_after_event;
    bool is_context_lost = false;
    std::string pasted;
    std::string notice_when_open; ///< a notice for when the dropped file is open, unless there is
                                  ///< another one
    int kept_options = 0, kept_progress = 0; ///< writes that the browser's storage has
    bool has_storage_notice = false;         ///< the student knows that it keeps nothing
    std::string shown_lesson;                ///< as in the address, with its step
    int shown_step = 0;
};
std::unique_ptr<Page> the_page; ///< until the student leaves it

void record_event(PageEvent event) {
    the_page->frames_due = frames_after_event;
    the_page->events.push_back(std::move(event));
}

/// Gives the browser's storage a file that has been written since it last received it.
void keep_file(Page& page, const KeptFile& file, int& kept_writes) {
    if (file.path.empty() || file.writes == kept_writes) return;
    kept_writes = file.writes;
    if (page_keep(file.path.c_str()) || page.has_storage_notice) return;
    page.has_storage_notice = true;
    page.ui.session.notice =
        "This browser keeps nothing for this page, so what you do here is lost when you leave.";
}

void keep_state(Page& page) {
    keep_file(page, page.ui.options_file, page.kept_options);
    keep_file(page, page.ui.lesson.progress_file, page.kept_progress);
}

/// The address names this step from now on.
void record_step(Page& page) {
    page.shown_lesson = page.ui.session.lesson;
    page.shown_step = page.ui.session.step;
}

/// Changes the address to that of the current step, so that it can be shared. Until the step
/// changes, it stays the link that was opened.
void update_address(Page& page) {
    const Session& session = page.ui.session;
    if (session.lesson == page.shown_lesson && session.step == page.shown_step) return;
    record_step(page);
    page_set_address(step_link(session).c_str());
}

void show_cursor() {
    static ImGuiMouseCursor shown = ImGuiMouseCursor_Arrow;
    const ImGuiMouseCursor wished = ImGui::GetMouseCursor();
    if (wished == shown) return;
    shown = wished;
    constexpr const char* names[] = {"default",     "text",      "move",
                                     "ns-resize",   "ew-resize", "nesw-resize",
                                     "nwse-resize", "pointer",   "not-allowed"};
    const bool is_known = wished >= 0 && wished < static_cast<int>(std::size(names));
    page_set_cursor(is_known ? names[wished] : "none");
}

/// A device without a keyboard shows one where something can be typed.
void show_typing() {
    static bool shown = false;
    if (ImGui::GetIO().WantTextInput == shown) return;
    shown = !shown;
    page_set_typing(shown);
}

void draw_frame(Page& page, double now) {
    Ui& ui = page.ui;
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(page.size.width), static_cast<float>(page.size.height)};
    io.DeltaTime = frame_step(static_cast<float>((now - page.last_frame) / 1000.0),
                              static_cast<float>(page.meant_sleep));
    page.last_frame = now;
    play_events(page.events);
    begin_gl2_frame();
    build_ui(ui);
    draw_gl2(ui, page.size.width, page.size.height);
    if (ui.host.wants_picture) {
        save_window_picture(ui, page.size.width, page.size.height);
        page.frames_due = frames_after_event;
    }
    if (!page.notice_when_open.empty() && !is_reading(ui)) {
        if (ui.session.notice.empty()) ui.session.notice = page.notice_when_open;
        page.notice_when_open.clear();
        page.frames_due = frames_after_event;
    }
    keep_state(page);
    update_address(page);
    show_cursor();
    show_typing();
}

void open_context() {
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    attributes.alpha = attributes.depth = attributes.stencil = attributes.antialias = false;
    const auto context = emscripten_webgl_create_context(canvas_name, &attributes);
    if (context <= 0) {
        throw Error(ExitCode::no_display,
                    "Rasterwalk needs WebGL 2, which this browser does not have or has turned "
                    "off.");
    }
    emscripten_webgl_make_context_current(context);
}

/// The view that a link names. A faulty link opens its lesson, or if that fails the program, and
/// says what is wrong.
Session open_link(const std::string& link, bool& is_plain) {
    ViewOptions view;
    std::string fault;
    is_plain = false;
    try {
        view = parse_view_link(link);
        is_plain = view == ViewOptions{};
        return open_view(view);
    } catch (const Error& error) {
        fault = std::string("This link does not work: ") + error.what();
    }
    Session session = open_view({});
    try {
        ViewOptions opening;
        opening.lesson = view.lesson;
        session = open_view(opening);
    } catch (const Error&) {
        // The lesson itself is the fault.
    }
    session.notice = fault;
    return session;
}

/// @param address of the page, on which links are opened
void open_page(const std::string& address, const std::string& link) {
    open_context();
    bool is_plain = false;
    Session session = open_link(link, is_plain);
    the_page = std::make_unique<Page>();
    Ui& ui = the_page->ui;
    ui.session = std::move(session);
    ui.host.is_browser = true;
    ui.host.choose_file = [](bool is_result) { page_choose_file(is_result); };
    ui.host.hand_out = [](const std::string& path) { page_hand_out(path.c_str()); };
    ui.host.page = address;
    open_ui(ui, the_page->textures);
    open_gl2();
    ImGuiIO& io = ImGui::GetIO();
    io.SetClipboardTextFn = [](void*, const char* text) { page_copy(text); };
    io.GetClipboardTextFn = [](void*) { return the_page->pasted.c_str(); };
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    record_step(*the_page);
    take_up(ui, is_plain);
}

} // namespace

} // namespace rasterwalk

extern "C" {

/// glGetIntegerv for ImGui's renderer, which asks in each frame for the state that it restores
/// afterward: nothing else draws on this page. A browser would answer only when everything before
/// it is drawn.
void known_gl_integer(GLenum name, GLint* value) {
    switch (name) {
    case GL_MAJOR_VERSION:
        *value = 3;
        break;
    case GL_ACTIVE_TEXTURE:
        *value = GL_TEXTURE0;
        break;
    case GL_BLEND_EQUATION_RGB:
    case GL_BLEND_EQUATION_ALPHA:
        *value = GL_FUNC_ADD;
        break;
    case GL_VIEWPORT:
    case GL_SCISSOR_BOX:
        std::fill_n(value, 4, 0);
        break;
    default:
        *value = 0;
    }
}
}

// The functions that page.js calls. It must know when a frame is due; it requests one after each
// event.

extern "C" {

/// Draws a frame if one is due.
/// @param now milliseconds
/// @param width,height of the canvas, pixels
/// @param ratio of these to the pixels of CSS
/// @return how long until the next is due, milliseconds; infinite: when something happens
EMSCRIPTEN_KEEPALIVE double web_frame(double now, int width, int height, double ratio) {
    using namespace rasterwalk;
    Page& page = *the_page;
    if (page.is_context_lost) return std::numeric_limits<double>::infinity();
    const CanvasSize size{width, height};
    if (size != page.size || static_cast<float>(ratio) != page.ui.host.pixel_ratio) {
        page.size = size;
        page.ui.host.pixel_ratio = static_cast<float>(ratio);
        page.frames_due = frames_after_event;
    }
    const auto wait = [&] {
        const double passed = (now - page.last_frame) / 1000.0;
        const double rest = seconds_to_next_frame(page.ui, page.frames_due);
        return page.events.empty() ? std::max(1000.0 * (rest - passed), 0.0) : 0.0;
    };
    if (const double early = wait(); early > 0.0) return early;
    const double still = seconds_to_blink(page.ui);
    page.meant_sleep = std::isfinite(still) ? still : 0.0;
    guarded(page.ui, [&] { draw_frame(page, now); });
    // Waiting input comes in the next frame, and needs as many frames after it.
    if (page.events.empty() && !is_input_waiting()) --page.frames_due;
    return wait();
}

EMSCRIPTEN_KEEPALIVE void web_pointer(float x, float y) {
    rasterwalk::record_event({.kind = rasterwalk::PageEvent::Kind::pointer, .x = x, .y = y});
}

/// @param button 0 left, 1 right, 2 middle
EMSCRIPTEN_KEEPALIVE void web_button(int button, bool is_down) {
    if (button < 0 || button > 2) return;
    rasterwalk::record_event(
        {.kind = rasterwalk::PageEvent::Kind::button, .code = button, .is_down = is_down});
}

/// Steps of a wheel, to the left and up.
EMSCRIPTEN_KEEPALIVE void web_wheel(float left, float up) {
    rasterwalk::record_event({.kind = rasterwalk::PageEvent::Kind::wheel, .x = left, .y = up});
}

/// @param key as in ui/widgets/keys.h; 0: only the modifiers have changed
EMSCRIPTEN_KEEPALIVE void web_key(int key, bool is_down, bool ctrl, bool shift, bool alt) {
    rasterwalk::record_event({.kind = rasterwalk::PageEvent::Kind::key,
                              .code = key,
                              .is_down = is_down,
                              .has_ctrl = ctrl,
                              .has_shift = shift,
                              .has_alt = alt});
}

EMSCRIPTEN_KEEPALIVE void web_letters(const char* letters) {
    rasterwalk::record_event({.kind = rasterwalk::PageEvent::Kind::letters, .letters = letters});
}

/// The page is no longer in front.
EMSCRIPTEN_KEEPALIVE void web_leave() {
    rasterwalk::the_page->frames_due = rasterwalk::frames_after_event;
    rasterwalk::release_everything(rasterwalk::the_page->events);
}

/// The student leaves the page.
EMSCRIPTEN_KEEPALIVE void web_keep() {
    rasterwalk::keep_everything(rasterwalk::the_page->ui);
    rasterwalk::keep_state(*rasterwalk::the_page);
}

/// The text that Ctrl+V pastes.
EMSCRIPTEN_KEEPALIVE void web_paste(const char* text) {
    rasterwalk::the_page->pasted = text;
}

/// Opens a file that the page has put into the file system.
/// @param is_result of the student's program: it is checked
EMSCRIPTEN_KEEPALIVE void web_open(const char* path, bool is_result) {
    using namespace rasterwalk;
    Ui& ui = the_page->ui;
    the_page->frames_due = frames_after_event;
    guarded(ui, [&] {
        if (is_result) {
            check_result(ui, path);
        } else {
            open_dropped(ui, path);
            if (std::string_view(path).ends_with(".md")) {
                the_page->notice_when_open =
                    "A page cannot watch files. Drop the lesson again when you have changed it.";
            }
        }
    });
}

/// Says something in the line at the bottom.
EMSCRIPTEN_KEEPALIVE void web_say(const char* sentence) {
    rasterwalk::the_page->ui.session.notice = sentence;
    rasterwalk::the_page->frames_due = rasterwalk::frames_after_event;
}

/// The address was changed: the part after its #.
EMSCRIPTEN_KEEPALIVE void web_go(const char* link) {
    using namespace rasterwalk;
    Ui& ui = the_page->ui;
    the_page->frames_due = frames_after_event;
    guarded(ui, [&] {
        try {
            show_view(ui, open_view(parse_view_link(link)));
            record_step(*the_page);
        } catch (const Error& fault) {
            ui.session.notice = std::string("This link does not work: ") + fault.what();
        }
    });
}

/// The browser has taken the graphics away, or given them back.
EMSCRIPTEN_KEEPALIVE void web_context(bool is_lost) {
    using namespace rasterwalk;
    Page& page = *the_page;
    page.is_context_lost = is_lost;
    if (is_lost) return;
    page_make_textures_anew();
    close_gl2();
    open_gl2();
    page.textures.renew();
    page.ui.host.fonts_changed = true;
    page.frames_due = frames_after_event;
}

/// For tests: writes the picture shown into a file, as PNG.
EMSCRIPTEN_KEEPALIVE void web_picture(const char* path) {
    using namespace rasterwalk;
    const Session& session = the_page->ui.session;
    const Frame frame = shown_frame(session);
    const Cursor to = in_frame(session.cursor, frame.pass);
    Framebuffer framebuffer;
    draw_by_engine(frame, to, framebuffer);
    write_png(view_image(framebuffer, session.view, session.depth_range), path);
}

/// For tests: what is on the screen.
EMSCRIPTEN_KEEPALIVE const char* web_report() {
    static std::string text;
    text = rasterwalk::screen_report(rasterwalk::the_page->ui);
    return text.c_str();
}
}

/// @param argv the address of the page, and the part after its #
int main(int argc, char** argv) {
    try {
        rasterwalk::open_page(argc > 1 ? argv[1] : "", argc > 2 ? argv[2] : "");
        return 0;
    } catch (const std::exception& fault) {
        page_say(fault.what());
        return 1;
    }
}
