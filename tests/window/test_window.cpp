#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"
#include "tests/window/virtual_display.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// How long a step may take on a machine that is busy with other things, seconds.
constexpr double patience = 60.0;

/// The program in a window on a separate display, watched through the report that it writes.
struct OpenProgram {
    TemporaryFolder display_folder, folder;
    VirtualDisplay display{display_folder.file("")};
    Program program;

    /// @param state where it keeps what it knows from earlier starts; empty: it knows nothing
    explicit OpenProgram(const std::vector<std::string>& arguments = {},
                         const std::string& state = "")
        : program(words(arguments),
                  {{"DISPLAY", display.name()},
                   {"WAYLAND_DISPLAY", ""},
                   {"LIBGL_ALWAYS_SOFTWARE", "1"},
                   {"XDG_STATE_HOME", state.empty() ? folder.file("state") : state},
                   {"RASTERWALK_WIDGET_REPORT", folder.file("report")}},
                  folder.file("")) {}

    static std::vector<std::string> words(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), RASTERWALK_PROGRAM);
        return arguments;
    }

    std::string report() const { return bytes_of(folder.file("report")); }
    std::string errors() const { return bytes_of(folder.file("stderr")); }

    /// True as soon as the report has this line.
    bool says(const std::string& line, double seconds = patience) const {
        return becomes_true(seconds, [&] {
            return ("\n" + report()).find("\n" + line + "\n") != std::string::npos;
        });
    }

    /// True as soon as the report has this widget.
    bool shows(const std::string& widget) const {
        return becomes_true(
            patience, [&] { return report().find(" " + widget + "\n") != std::string::npos; });
    }

    /// Moves the mouse onto a widget.
    void point_at(const std::string& name) {
        std::istringstream lines(report());
        std::string line;
        while (std::getline(lines, line)) {
            float left = 0, top = 0, right = 0, bottom = 0;
            char found[128] = "";
            if (std::sscanf(line.c_str(), "widget %f %f %f %f %127[^\n]", &left, &top, &right,
                            &bottom, found) != 5 ||
                name != found) {
                continue;
            }
            int x = 0, y = 0, width = 0, height = 0;
            display.window_place("Rasterwalk", x, y, width, height);
            display.move_mouse(x + static_cast<int>(0.5f * (left + right)),
                               y + static_cast<int>(0.5f * (top + bottom)));
            return;
        }
        throw std::runtime_error("the report has no widget '" + name + "':\n" + report());
    }
    void click(const std::string& name) {
        point_at(name);
        display.click();
    }
};

int count_differences(const Image& a, const Image& b) {
    REQUIRE(a.rgba.size() == b.rgba.size());
    int count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        count += std::equal(a.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                            a.rgba.begin() + static_cast<std::ptrdiff_t>(i + 4),
                            b.rgba.begin() + static_cast<std::ptrdiff_t>(i))
                     ? 0
                     : 1;
    return count;
}

} // namespace

TEST_CASE("A stage is clicked with the mouse in a real window, which is then closed") {
    OpenProgram open({"--stage", "depth"});
    INFO("errors: " << open.errors());
    REQUIRE(open.says("setting stage depth"));
    REQUIRE(open.display.has_window("Rasterwalk"));
    int x = 0, y = 0, width = 0, height = 0;
    open.display.window_place("Rasterwalk", x, y, width, height);
    CHECK(open.says("window " + std::to_string(width) + " " + std::to_string(height)));

    open.point_at("stage.points");
    sleep_seconds(0.5);
    const Image before = open.display.picture();
    open.display.click();
    REQUIRE(open.says("setting stage points"));
    sleep_seconds(0.5);
    const Image after = open.display.picture();
    // The room's walls fill a quarter of a million pixels; as points they are gone.
    CHECK(count_differences(before, after) > 100000);

    open.click("stage.depth");
    REQUIRE(open.says("setting stage depth"));
    REQUIRE(open.shows("switch.perspective"));
    open.click("switch.perspective");
    CHECK(open.says("setting interpolation affine"));

    open.display.ask_to_close("Rasterwalk");
    CHECK(open.program.wait(patience) == 0);
    CHECK(open.errors().empty());
}

TEST_CASE("The window takes keys however briefly they are pressed, and saves a picture of itself") {
    OpenProgram open({"--stage", "depth"});
    REQUIRE(open.says("setting stage depth"));
    open.point_at("canvas");
    for (const auto& [key, stage] : {std::pair{"2", "edges"}, std::pair{"7", "pixel_light"},
                                     std::pair{"1", "points"}, std::pair{"5", "depth"}}) {
        open.display.press_key(key);
        INFO("key " << key << "\n" << open.report());
        REQUIRE(open.says(std::string("setting stage ") + stage));
    }

    open.display.press_key("F12");
    std::string saved;
    REQUIRE(becomes_true(patience, [&] {
        for (const auto& entry : std::filesystem::directory_iterator(open.folder.file(""))) {
            const std::string name = entry.path().filename().string();
            if (name.starts_with("rasterwalk-") && name.ends_with(".png")) saved = entry.path();
        }
        return !saved.empty();
    }));
    const Image picture = read_image(saved);
    const Image shown = open.display.picture();
    int x = 0, y = 0, width = 0, height = 0;
    open.display.window_place("Rasterwalk", x, y, width, height);
    CHECK(picture.width == width);
    CHECK(picture.height == height);
    // The right way up: the line of menus is lighter than what is under the last line.
    const auto at = [&](const Image& image, int column, int row) {
        return image.rgba[4 * static_cast<std::size_t>(row * image.width + column)];
    };
    CHECK(int{at(picture, width / 2, 2)} == int{at(shown, x + width / 2, y + 2)});
    CHECK(int{at(picture, width / 2, height / 2)} == int{at(shown, x + width / 2, y + height / 2)});

    open.display.hold_key("Control_L", true);
    open.display.press_key("q");
    open.display.hold_key("Control_L", false);
    CHECK(open.program.wait(patience) == 0);
    CHECK(open.errors().empty());
}

TEST_CASE("The first start offers its ways, and the next one goes on in the lesson") {
    const TemporaryFolder state;
    {
        OpenProgram open({}, state.file(""));
        REQUIRE(open.shows("start.lessons"));
        open.display.press_key("Return");
        CHECK(open.shows("lesson.open"));
        CHECK(open.shows("walk.play"));
        open.display.ask_to_close("Rasterwalk");
        CHECK(open.program.wait(patience) == 0);
    }
    OpenProgram open({}, state.file(""));
    CHECK(open.shows("lesson.open"));
    CHECK(open.report().find("start.lessons") == std::string::npos);
    open.display.ask_to_close("Rasterwalk");
    CHECK(open.program.wait(patience) == 0);
}

TEST_CASE("The window follows its size and sleeps while nothing happens") {
    OpenProgram open;
    REQUIRE(open.says("cursor end"));
    open.display.resize("Rasterwalk", 900, 700);
    CHECK(open.says("window 900 700"));
    open.display.move_mouse(1690, 1090);
    sleep_seconds(1.0);
    const double before = open.program.cpu_seconds();
    sleep_seconds(2.0);
    const double spent = open.program.cpu_seconds() - before;
    INFO("processor time in two seconds of rest: " << spent << " s");
    CHECK(spent < 0.1);
    open.display.ask_to_close("Rasterwalk");
    CHECK(open.program.wait(patience) == 0);
}

TEST_CASE("While the window is minimized the walk rests, and goes on when it is back") {
    OpenProgram open({"--stage", "depth", "--to", "t0/v0"});
    INFO("errors: " << open.errors());
    REQUIRE(open.says("cursor t0/v0"));
    const unsigned long number = open.display.window_number("Rasterwalk");
    open.point_at("canvas");
    open.display.press_key("space");
    REQUIRE(becomes_true(patience, [&] { return !open.says("cursor t0/v0", 0.0); }));
    open.display.show(number, false);
    sleep_seconds(0.5);
    const std::string moment = open.report();
    const double before = open.program.cpu_seconds();
    sleep_seconds(2.0);
    const double spent = open.program.cpu_seconds() - before;
    INFO("processor time in two seconds out of sight: " << spent << " s");
    CHECK(spent < 0.1);
    CHECK(open.report() == moment);
    open.display.show(number, true);
    CHECK(becomes_true(patience, [&] { return open.report() != moment; }));
    open.display.ask_to_close("Rasterwalk");
    CHECK(open.program.wait(patience) == 0);
}

TEST_CASE("OpenGL draws in a context of its own next to a window") {
    const TemporaryFolder display_folder, folder;
    const VirtualDisplay display(display_folder.file(""));
    Program program(
        {RASTERWALK_OPENGL_IN_WINDOW},
        {{"DISPLAY", display.name()}, {"WAYLAND_DISPLAY", ""}, {"LIBGL_ALWAYS_SOFTWARE", "1"}},
        folder.file(""));
    const int exit_code = program.wait(patience);
    std::ifstream messages(folder.file("stderr"));
    std::string message;
    std::getline(messages, message);
    CAPTURE(message);
    CHECK(exit_code == 0);
}

TEST_CASE("Without a display the program says so in one sentence and ends with 5") {
    for (const char* const display : {"", ":9999"}) {
        const TemporaryFolder folder;
        Program program({RASTERWALK_PROGRAM}, {{"DISPLAY", display}, {"WAYLAND_DISPLAY", ""}},
                        folder.file(""));
        INFO("DISPLAY=" << display);
        CHECK(program.wait(patience) == 5);
        const std::string errors = bytes_of(folder.file("stderr"));
        CHECK(errors.starts_with("rasterwalk: there is no display to open the window on"));
        CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
        CHECK(bytes_of(folder.file("stdout")).empty());
    }
}
