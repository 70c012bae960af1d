// opengl_in_window: draws a scene by a context of its own while a window's is current, as the
// program does. Exit code 0 if the picture is the fast engine's, but for few pixels, and if the
// window's context is as it was; otherwise it prints what is wrong.

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include <GLFW/glfw3.h>

#include "engines/fast/fast_engine.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "settings/settings.h"
#include "ui/hosts/host_opengl.h"

using namespace rasterwalk;

namespace {

/// The colour of a pixel of the window, as three numbers.
std::string window_colour() {
    unsigned char rgb[4] = {};
    glReadPixels(5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgb);
    return std::to_string(rgb[0]) + ' ' + std::to_string(rgb[1]) + ' ' + std::to_string(rgb[2]);
}

/// What is wrong with a picture; empty: nothing.
std::string fault_of(const Scene& scene) {
    Settings settings = default_settings(scene);
    settings.stage = Stage::shade;
    FastPicture fast, drawn;
    FastEngine(scene).draw(settings, fast);
    HostOpenGl opengl;
    opengl.draw(scene, settings, drawn);
    if (drawn.size != fast.size) return "the size is wrong";
    std::size_t other = 0, pixels = 0;
    for (int row = 0; row < fast.size.height; ++row) {
        for (int column = 0; column < fast.size.width; ++column) {
            const std::size_t a = fast.at(column, row), b = drawn.at(column, row);
            ++pixels;
            bool is_other = fast.owner[a] != drawn.owner[b];
            for (const int shift : {0, 8, 16})
                is_other |= std::abs(static_cast<int>(fast.colour[a] >> shift & 255U) -
                                     static_cast<int>(drawn.colour[b] >> shift & 255U)) > 2;
            other += is_other ? 1 : 0;
        }
    }
    if (other > pixels / 1000) return std::to_string(other) + " pixels are different";
    std::cout << opengl.name() << ", " << other << " of " << pixels << " pixels are different\n";
    return {};
}

std::string fault() {
    if (glfwInit() != GLFW_TRUE) return "GLFW cannot be started";
    GLFWwindow* const window = glfwCreateWindow(100, 80, "window", nullptr, nullptr);
    if (window == nullptr) return "there is no window";
    glfwMakeContextCurrent(window);
    glClearColor(0.2f, 0.4f, 0.6f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    const std::string before = window_colour();
    const std::string found =
        fault_of(read_scene(lessons_folder() + '/' + std::string(usual_scene)));
    if (!found.empty()) return found;
    if (glfwGetCurrentContext() != window) return "the context of the window is not current";
    if (before != "51 102 153" || window_colour() != before)
        return "the window was " + before + " and is " + window_colour();
    glfwTerminate();
    return {};
}

} // namespace

int main() {
    try {
        const std::string found = fault();
        if (found.empty()) return 0;
        std::cerr << found << '\n';
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
    }
    return 1;
}
