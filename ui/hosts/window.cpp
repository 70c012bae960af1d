#include "ui/hosts/window.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>

#include "base/error.h"
#include "base/files.h"
#include "ui/actions/actions.h"
#include "ui/actions/compare.h"
#include "ui/actions/lab.h"
#include "ui/actions/mine.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/reading.h"
#include "ui/actions/view_files.h"
#include "ui/app/app.h"
#include "ui/app/guard.h"
#include "ui/hand/report.h"
#include "ui/hosts/gl2.h"
#include "ui/hosts/host_opengl.h"
#include "ui/hosts/life.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/style.h"

namespace rasterwalk {

namespace {

/// Longest sleep while nothing happens, seconds.
constexpr double idle_wait = 0.5;
/// The same while the student's own program is watched: what is saved shows soon.
constexpr double watching_wait = 0.15;
/// If the display does not pace the frames, this does, seconds.
constexpr double shortest_frame = 1.0 / 250.0;

/// Size of a window, screen coordinates.
struct Size {
    int width, height;
};
constexpr Size smallest_size{800, 600};

struct Window {
    GLFWwindow* handle = nullptr;
    Ui ui;
    Gl2Textures textures;
    int frames_due = frames_after_event;
    float meant_sleep = 0.0f; ///< before this frame, seconds
    float content_scale = 1.0f;
    /// Keys that are pressed and released between two frames count as held for one frame: after a
    /// press, all releases wait for the next frame.
    bool was_key_pressed = false;
    std::vector<int> late_releases;
    std::string report_path;
    std::string last_report;
};

Window& window_of(GLFWwindow* handle) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(handle));
}

void wake(GLFWwindow* handle) {
    window_of(handle).frames_due = frames_after_event;
}

/// The last complaint from GLFW.
std::string glfw_complaint;

void record_error(int, const char* text) {
    glfw_complaint = text;
}

Error no_display() {
    const std::string reason = glfw_complaint.empty() ? "" : " (" + glfw_complaint + ")";
    return {ExitCode::no_display,
            "there is no display to open the window on" + reason +
                "; 'rasterwalk render' and 'rasterwalk-offscreen' draw pictures without one."};
}

void on_key(GLFWwindow* handle, int key, int scancode, int action, int modifiers) {
    Window& window = window_of(handle);
    wake(handle);
    if (action == GLFW_PRESS) {
        window.was_key_pressed = true;
        std::erase(window.late_releases, key);
    } else if (action == GLFW_RELEASE && window.was_key_pressed) {
        window.late_releases.push_back(key);
        return;
    }
    ImGui_ImplGlfw_KeyCallback(handle, key, scancode, action, modifiers);
}

void on_drop(GLFWwindow* handle, int count, const char** paths) {
    wake(handle);
    Ui& ui = window_of(handle).ui;
    // No exception may pass through GLFW.
    guarded(ui, [&] {
        if (count > 0) open_dropped(ui, paths[0]);
    });
}

void on_content_scale(GLFWwindow* handle, float scale, float) {
    Window& window = window_of(handle);
    wake(handle);
    if (!(scale > 0.0f)) return;
    UiOptions& options = window.ui.options;
    options.wished_text_scale = std::clamp(options.wished_text_scale * scale / window.content_scale,
                                           smallest_text_scale, largest_text_scale);
    window.content_scale = scale;
}

/// Makes every event wake the window. To be called before ImGui installs its own callbacks, which
/// call these.
void install_callbacks(GLFWwindow* handle) {
    glfwSetDropCallback(handle, on_drop);
    glfwSetWindowContentScaleCallback(handle, on_content_scale);
    glfwSetCharCallback(handle, [](GLFWwindow* w, unsigned int) { wake(w); });
    glfwSetMouseButtonCallback(handle, [](GLFWwindow* w, int, int, int) { wake(w); });
    glfwSetScrollCallback(handle, [](GLFWwindow* w, double, double) { wake(w); });
    glfwSetCursorEnterCallback(handle, [](GLFWwindow* w, int) { wake(w); });
    glfwSetWindowFocusCallback(handle, [](GLFWwindow* w, int) { wake(w); });
    glfwSetCursorPosCallback(handle, [](GLFWwindow* w, double, double) { wake(w); });
    glfwSetFramebufferSizeCallback(handle, [](GLFWwindow* w, int, int) { wake(w); });
    glfwSetWindowRefreshCallback(handle, [](GLFWwindow* w) { wake(w); });
    glfwSetWindowIconifyCallback(handle, [](GLFWwindow* w, int) { wake(w); });
    glfwSetWindowCloseCallback(handle, [](GLFWwindow* w) { wake(w); });
}

/// 1600 x 1000, enlarged by the display's scale, as far as the display has room for it.
Size first_size() {
    Size size{1600, 1000};
    GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
    if (monitor == nullptr) return size;
    float scale = 1.0f, ignored_scale = 1.0f;
    glfwGetMonitorContentScale(monitor, &scale, &ignored_scale);
    int x = 0, y = 0;
    Size room{0, 0};
    glfwGetMonitorWorkarea(monitor, &x, &y, &room.width, &room.height);
    const auto fitted = [&](int wished, int available, int smallest) {
        const int enlarged =
            static_cast<int>(static_cast<float>(wished) * std::clamp(scale, 1.0f, 4.0f));
        return available > 0 ? std::max(std::min(enlarged, available), smallest) : wished;
    };
    return {fitted(size.width, room.width, smallest_size.width),
            fitted(size.height, room.height, smallest_size.height)};
}

/// How much the display wants text enlarged. If the display itself enlarges everything, as
/// framebuffers larger than the window show, that part is not counted again.
float text_enlargement(GLFWwindow* handle) {
    float scale = 1.0f, ignored = 1.0f;
    glfwGetWindowContentScale(handle, &scale, &ignored);
    int window_width = 0, framebuffer_width = 0, height = 0;
    glfwGetWindowSize(handle, &window_width, &height);
    glfwGetFramebufferSize(handle, &framebuffer_width, &height);
    if (window_width > 0 && framebuffer_width > 0) {
        scale *= static_cast<float>(window_width) / static_cast<float>(framebuffer_width);
    }
    return scale > 0.0f ? scale : 1.0f;
}

void write_report(Window& window) {
    if (window.report_path.empty()) return;
    std::string report = screen_report(window.ui);
    if (report == window.last_report) return;
    write_file(window.report_path, report);
    window.last_report = std::move(report);
}

/// Keys whose release waited until a frame was drawn with them held.
void release_late_keys(Window& window) {
    window.was_key_pressed = false;
    for (const int key : window.late_releases) {
        ImGui_ImplGlfw_KeyCallback(window.handle, key, glfwGetKeyScancode(key), GLFW_RELEASE, 0);
        window.frames_due = frames_after_event;
    }
    window.late_releases.clear();
}

/// Is no part of the window on the display? Some systems then report that it has no pixels.
bool is_out_of_sight(GLFWwindow* handle) {
    int width = 0, height = 0;
    glfwGetFramebufferSize(handle, &width, &height);
    return width <= 0 || height <= 0 || glfwGetWindowAttrib(handle, GLFW_ICONIFIED) == GLFW_TRUE ||
           glfwGetWindowAttrib(handle, GLFW_VISIBLE) == GLFW_FALSE;
}

bool draw_frame(Window& window) {
    if (is_out_of_sight(window.handle)) return false;
    int width = 0, height = 0;
    glfwGetFramebufferSize(window.handle, &width, &height);
    begin_gl2_frame();
    ImGui_ImplGlfw_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = frame_step(io.DeltaTime, window.meant_sleep);
    build_ui(window.ui);
    draw_gl2(window.ui, width, height);
    if (window.ui.host.wants_picture) {
        save_window_picture(window.ui, width, height);
        window.frames_due = frames_after_event;
    }
    glfwSwapBuffers(window.handle);
    release_late_keys(window);
    write_report(window);
    return true;
}

void run(Window& window) {
    double last_frame = 0.0;
    while (glfwWindowShouldClose(window.handle) == GLFW_FALSE && !window.ui.host.wants_quit) {
        const double rest = seconds_to_next_frame(window.ui, window.frames_due);
        const double due = last_frame + rest;
        const double still = seconds_to_blink(window.ui);
        window.meant_sleep = std::isfinite(still) ? static_cast<float>(still) : 0.0f;
        if (rest > 0.0) {
            const double longest = window.ui.mine.watched.empty() ? idle_wait : watching_wait;
            glfwWaitEventsTimeout(std::clamp(due - glfwGetTime(), shortest_frame, longest));
        } else if (const double early = last_frame + shortest_frame - glfwGetTime(); early > 0.0) {
            glfwWaitEventsTimeout(early);
        } else {
            glfwPollEvents();
        }
        const bool is_due = glfwGetTime() >= due;
        guarded(window.ui, [&] {
            if (lesson_was_edited(window.ui) || result_was_edited(window.ui) ||
                program_was_edited(window.ui))
                window.frames_due = frames_after_event;
        });
        if (window.frames_due <= 0 && !is_due) continue;
        // Waiting input comes in the next frame, and needs as many frames after it.
        if (!is_input_waiting()) --window.frames_due;
        last_frame = glfwGetTime();
        // While minimized, the whole program rests: what the walk would pass could not be seen.
        bool is_drawn = false;
        guarded(window.ui, [&] { is_drawn = draw_frame(window); });
        if (!is_drawn) glfwWaitEventsTimeout(idle_wait);
    }
    keep_everything(window.ui);
}

/// GLFW, begun and ended.
struct Glfw {
    Glfw() {
        glfwSetErrorCallback(record_error);
#ifdef GLFW_PLATFORM
        // Without it there can be no Wayland, and its library would complain on standard error.
        if (std::getenv("XDG_RUNTIME_DIR") == nullptr)
            glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
        if (glfwInit() != GLFW_TRUE) throw no_display();
    }
    ~Glfw() {
        glfwTerminate();
    }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

/// The window with ImGui in it, begun and ended.
struct OpenWindow {
    Window window;

    OpenWindow(Session session, bool is_plain) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 2);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
#ifdef GLFW_WAYLAND_APP_ID
        // GLFW 3.4: Wayland finds the icon by the name of the desktop entry.
        glfwWindowHintString(GLFW_WAYLAND_APP_ID, "rasterwalk");
#endif
        const Size size = first_size();
        window.handle = glfwCreateWindow(size.width, size.height, "Rasterwalk", nullptr, nullptr);
        if (window.handle == nullptr) throw no_display();
        glfwSetWindowSizeLimits(window.handle, smallest_size.width, smallest_size.height,
                                GLFW_DONT_CARE, GLFW_DONT_CARE);
        glfwSetWindowUserPointer(window.handle, &window);
        glfwMakeContextCurrent(window.handle);
        glfwSwapInterval(1);

        Ui& ui = window.ui;
        ui.session = std::move(session);
        window.content_scale = text_enlargement(window.handle);
        ui.options.wished_text_scale =
            std::clamp(window.content_scale, smallest_text_scale, largest_text_scale);
        open_ui(ui, window.textures);
        install_callbacks(window.handle);
        ImGui_ImplGlfw_InitForOpenGL(window.handle, true);
        glfwSetKeyCallback(window.handle, on_key);
        open_gl2();
        take_up(ui, is_plain);
        if (const char* path = std::getenv("RASTERWALK_WIDGET_REPORT")) window.report_path = path;
        if (const char* page = std::getenv("RASTERWALK_PAGE")) {
            const std::string address = page;
            ui.host.page = address.substr(0, address.find('#'));
        }
    }
    ~OpenWindow() {
        window.textures.release();
        close_gl2();
        ImGui_ImplGlfw_Shutdown();
        close_ui(window.ui);
        glfwDestroyWindow(window.handle);
    }
    OpenWindow(const OpenWindow&) = delete;
    OpenWindow& operator=(const OpenWindow&) = delete;
};

} // namespace

void show_window(Session session, bool is_plain, std::unique_ptr<FileReading> reading,
                 const std::string& code) {
    const Glfw glfw;
    HostOpenGl opengl;
    const UsedOpenGl used(opengl);
    OpenWindow open(std::move(session), is_plain);
    if (reading) begin_reading(open.window.ui, std::move(reading));
    if (!code.empty()) check_my_program(open.window.ui, code);
    run(open.window);
}

} // namespace rasterwalk
