// The kit that a student's program is compiled with: what is drawn is recorded, in the dialects of
// the course's helper and of SDL.

#include <string>
#include <vector>

#include "mine/kit_runs.h"
#include "scene/read_scene.h"
#include "support/catch.h"
#include "support/project_root.h"

namespace rasterwalk::test {

namespace {

using namespace rasterwalk_kit;
using Floats = std::vector<float>;

void check_put(const Put& put, int x, int y, const Floats& colour) {
    CHECK(put.x == x);
    CHECK(put.y == y);
    CHECK(Floats{put.red, put.green, put.blue} == colour);
}

void check_ended(const KitRun& run) {
    INFO(run.ended.output);
    CHECK(run.ended.is_well());
    CHECK(run.progress().moment == moment_ended);
    CHECK(run.progress().signal == 0);
}

} // namespace

TEST_CASE("Puts on a surface are recorded in order, with those outside", "[mine]") {
    // Headers are forgotten, the helper has a local copy, and text waits to be written.
    const std::vector<SourceFile> files = {{"MyHelper.h", R"(
#ifndef SDL_AUXILIARY_H
#define SDL_AUXILIARY_H
#error "This copy of the helper is claimed by the kit."
#endif
)"},
                                           {"main.cpp", R"(
#include "MyHelper.h"
#include <glm/glm.hpp>
using namespace std;
using namespace glm;
SDL_Surface* screen;
float yaw = 1;
int dots = 2 + yaw;
void Draw() {
    SDL_FillRect(screen, 0, SDL_MapRGB(screen->format, 0, 0, 255));
    if (SDL_MUSTLOCK(screen)) SDL_LockSurface(screen);
    vec3 half = 0.5 * vec3(1, 1, 1);
    PutPixelSDL(screen, 1, 2, half);
    PutPixelSDL(screen, -1, 2, vec3(1, 0, 0));
    PutPixelSDL(screen, 3, 4, vec3(2, 0, -1));
    PutPixelSDL(screen, 4, 0, vec3(1, 1, 1));
    if (SDL_MUSTLOCK(screen)) SDL_UnlockSurface(screen);
    SDL_UpdateRect(screen, 0, 0, 0, 0);
}
int main(int argc, char* argv[]) {
    screen = InitializeSDL(4, 5);
    PutPixelSDL(screen, 0, 0, vec3(1, 1, 1));
    cout << "waits";
    printf(" %d", dots);
    while (NoQuitMessageSDL()) Draw();
    SDL_SaveBMP(screen, "screenshot.bmp");
}
)"}};
    const KitRun run = run_recorded(compile_with_kit(files));
    check_ended(run);
    CHECK(run.ended.output == "waits 3");
    CHECK(run.progress().dialect == dialect_surface);
    CHECK(run.progress().width == 4);
    CHECK(run.progress().height == 5);
    CHECK(run.progress().frames == 1);
    REQUIRE(run.progress().puts == 4);
    CHECK(run.progress().outside == 2);
    CHECK(run.progress().direct == 0);
    check_put(run.put(0), 1, 2, {0.5f, 0.5f, 0.5f});
    check_put(run.put(1), -1, 2, {1, 0, 0});
    check_put(run.put(2), 3, 4, {2, 0, -1});
    check_put(run.put(3), 4, 0, {1, 1, 1});
    CHECK(run.pixel(1, 2) == Floats{0.5f, 0.5f, 0.5f});
    CHECK(run.pixel(3, 4) == Floats{2, 0, -1});
    CHECK(run.pixel(0, 0) == Floats{0, 0, 1});
    CHECK(run.pixel(0, 1) == Floats{0, 0, 1});
}

TEST_CASE("The class of the helper draws from several sources, for both compilers", "[mine]") {
    const std::vector<SourceFile> files = {{"draw.h", R"(
#pragma once
#include "SDL2Auxiliary.h"
#include "TestModel.h"
void draw(SDL2Aux& window, const std::vector<Triangle>& triangles);
)"},
                                           {"draw.cpp", R"(
#include "draw.h"
void draw(SDL2Aux& window, const std::vector<Triangle>& triangles) {
    window.clearPixels();
    for (int i = 0; i < int(triangles.size()); i += 2) window.putPixel(i, 1, triangles[i].color);
    window.render();
}
)"},
                                           {"main.cpp", R"(
#include "draw.h"
SDL2Aux* sdlAux;
int main() {
    sdlAux = new SDL2Aux(100, 50);
    std::vector<Triangle> triangles;
    LoadTestModel(triangles);
    sdlAux->putPixel(0, 0, glm::vec3(1, 1, 1));
    while (sdlAux->noQuitMessage()) draw(*sdlAux, triangles);
    sdlAux->saveBMP("screenshot.bmp");
    delete sdlAux;
}
)"}};
    for (const char* compiler : {"g++", "clang++"}) {
        INFO(compiler);
        KitOptions options;
        options.compiler = compiler;
        options.has_fast_start = options.compiler == "g++";
        const KitRun run = run_recorded(compile_with_kit(files, options));
        check_ended(run);
        CHECK(run.progress().dialect == dialect_class);
        CHECK(run.progress().width == 100);
        REQUIRE(run.progress().puts == 15);
        check_put(run.put(0), 0, 1, {0.15f, 0.75f, 0.15f});
        check_put(run.put(14), 28, 1, {0.15f, 0.15f, 0.75f});
        CHECK(run.pixel(0, 0) == Floats{0, 0, 0});
        CHECK(run.pixel(10, 1) == Floats{0.75f, 0.15f, 0.15f});
    }
}

TEST_CASE("A buffer that is written directly is compared when a frame is shown", "[mine]") {
    const KitRun run = run_recorded(compile_with_kit(R"(
#include "SDLauxiliary.h"
#include "TestModelH.h"
screen* screen;
int main() {
    screen = InitializeSDL(8, 6, false);
    for (int x = 0; x < 8; ++x) PutPixelSDL(screen, x, 0, glm::vec3(1, 1, 1));
    memset(screen->buffer, 0, screen->height * screen->width * sizeof(uint32_t));
    PutPixelSDL(screen, 2, 3, glm::vec3(0, 1, 0));
    screen->buffer[4 * screen->width + 5] = 0xff0000;
    ((Uint32*)screen->pixels)[4 * screen->pitch / 4 + 6] = 0x0000ff;
    Triangle triangle(glm::vec4(0, 0, 0, 1), glm::vec4(1, 0, 0, 1), glm::vec4(0, 1, 0, 1),
                      glm::vec3(1, 0, 0));
    std::cout << triangle.normal.z << ' ' << triangle.normal.w;
    SDL_Renderframe(screen);
    SDL_SaveImage(screen, "screenshot.bmp");
    KillSDL(screen);
}
)"));
    check_ended(run);
    CHECK(run.ended.output == "-1 1");
    CHECK(run.progress().dialect == dialect_screen);
    REQUIRE(run.progress().puts == 1);
    check_put(run.put(0), 2, 3, {0, 1, 0});
    CHECK(run.progress().direct == 2);
    CHECK(run.pixel(2, 3) == Floats{0, 1, 0});
    CHECK(run.pixel(5, 4) == Floats{1, 0, 0});
    CHECK(run.pixel(6, 4) == Floats{0, 0, 1});
    CHECK(run.pixel(0, 0) == Floats{0, 0, 0});
}

TEST_CASE("A texture of SDL 2 becomes the picture", "[mine]") {
    const KitRun run = run_recorded(compile_with_kit(R"(
#include <SDL2/SDL.h>
int main(int, char**) {
    SDL_Init(SDL_INIT_VIDEO);
    SDL_Window* window = SDL_CreateWindow("Lab", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED,
                                          20, 10, SDL_WINDOW_SHOWN);
    SDL_Renderer* renderer = SDL_CreateRenderer(window, -1, 0);
    SDL_Texture* texture = SDL_CreateTexture(renderer, SDL_PIXELFORMAT_RGBA8888,
                                             SDL_TEXTUREACCESS_STREAMING, 10, 5);
    std::vector<Uint32> pixels(50);
    pixels[3 * 10 + 7] = 0x00ff00ff;
    SDL_UpdateTexture(texture, NULL, pixels.data(), 10 * sizeof(Uint32));
    SDL_RenderClear(renderer);
    SDL_RenderCopy(renderer, texture, NULL, NULL);
    SDL_RenderPresent(renderer);
    SDL_DestroyWindow(window);
    SDL_Quit();
    return 0;
}
)"));
    check_ended(run);
    CHECK(run.progress().width == 10);
    CHECK(run.progress().height == 5);
    CHECK(run.progress().puts == 0);
    CHECK(run.progress().direct == 1);
    CHECK(run.pixel(7, 3) == Floats{0, 1, 0});
}

TEST_CASE("A program that never shows a frame is recorded too", "[mine]") {
    const std::string head = R"(
#include "SDLauxiliary.h"
int main() {
    SDL_Surface* surface = InitializeSDL(9, 9);
    SDL_Event event;
    int turn = 0;
)";
    SECTION("It ends the frame by asking again whether it shall go on") {
        const KitRun run = run_recorded(compile_with_kit(head + R"(
    while (NoQuitMessageSDL()) {
        SDL_PollEvent(&event);
        SDL_PollEvent(&event);
        PutPixelSDL(surface, turn++, 0, glm::vec3(1, 1, 1));
    }
}
)"));
        check_ended(run);
        CHECK(run.progress().frames == 1);
        CHECK(run.progress().puts == 1);
    }
    SECTION("It ends the frame by asking for events after it has drawn") {
        const KitRun run = run_recorded(compile_with_kit(head + R"(
    while (true) {
        while (SDL_PollEvent(&event)) {}
        while (SDL_PollEvent(&event)) {}
        PutPixelSDL(surface, turn++, 0, glm::vec3(1, 1, 1));
    }
}
)"));
        check_ended(run);
        CHECK(run.progress().puts == 1);
    }
    SECTION("It waits for ever") {
        const KitRun run = run_recorded(compile_with_kit(head + R"(
    while (SDL_GetTicks() < 1000) turn++;
    while (true) SDL_PollEvent(&event);
}
)"));
        check_ended(run);
        CHECK(run.progress().frames == 1);
    }
    SECTION("It leaves main() while its static objects live") {
        const KitRun run = run_recorded(compile_with_kit(R"(
#include "runtime.h"
)" + head + R"(
    static std::vector<int> numbers = {3};
    rasterwalk_kit::after_first_frame = [] { printf("%zu", numbers.size()); numbers[0] = 1; };
    PutPixelSDL(surface, 4, 4, glm::vec3(1, 1, 1));
    return 5;
}
)"));
        CHECK(WEXITSTATUS(run.ended.status) == 5);
        CHECK(run.ended.output == "1");
        CHECK(run.progress().moment == moment_ended);
        CHECK(run.progress().frames == 1);
        CHECK(run.pixel(4, 4) == Floats{1, 1, 1});
    }
}

TEST_CASE("A key is held from the second frame on, in both versions of SDL", "[mine]") {
    const KitProgram program = compile_with_kit(R"(
#include "SDL.h"
#include "SDLauxiliary.h"
int main() {
    SDL_Surface* surface = InitializeSDL(5, 5);
    const Uint8* scancodes = SDL_GetKeyboardState(NULL);
    while (NoQuitMessageSDL()) {
        SDL_Event event;
        int presses = 0;
        while (SDL_PollEvent(&event)) {
            if (event.type == SDL_QUIT) return 1;
            if (event.type == SDL_KEYDOWN && event.key.keysym.sym == SDLK_UP) ++presses;
            if (event.key.keysym.scancode != SDL_SCANCODE_UP) return 2;
        }
        Uint8* keys = SDL_GetKeyState(0);
        int x = 0, y = 0;
        SDL_GetRelativeMouseState(&x, &y);
        printf("%d%d%d%d%d ", keys[SDLK_UP], keys[SDLK_DOWN] + keys[SDLK_w],
               scancodes[SDL_SCANCODE_UP], presses, x + y);
        PutPixelSDL(surface, 1, keys[SDLK_UP] ? 7 : 1, glm::vec3(1, 0, 0));
        SDL_Flip(surface);
    }
}
)");
    const int up = 0x40000052;
    const KitRun run = run_recorded(program, 3, up);
    check_ended(run);
    CHECK(run.ended.output == "00000 10110 10110 ");
    CHECK(run.progress().frames == 3);
    CHECK(run.progress().puts == 1);
    CHECK(run.progress().outside == 0);
    CHECK(run.progress().later_outside == 2);
    CHECK(run.pixel(1, 1) == Floats{1, 0, 0});
    CHECK(run_recorded(program, 2).ended.output == "00000 00000 ");
    // Without the shared memory it draws one frame.
    const CommandResult alone = run_command({program.path()});
    CHECK(alone.is_well());
    CHECK(alone.output == "00000 ");
}

TEST_CASE("All models are the room of our scenes, bit for bit", "[mine]") {
    const Scene scene = read_scene(project_root() + "/lessons/scenes/lab-room.toml");
    const std::string main = R"(
int main() {
    std::vector<Triangle> triangles;
    LoadTestModel(triangles);
    LoadTestModel(triangles);
    for (auto& t : triangles) {
        for (auto v : {t.v0, t.v1, t.v2}) printf("%a %a %a ", v.x, v.y, v.z);
        printf("%a %a %a ", t.color.r, t.color.g, t.color.b);
        printf("%.4f %.4f %.4f\n", t.normal.x, t.normal.y, t.normal.z);
    }
}
)";
    std::string expected;
    for (int i = 0; i < scene.triangle_count(); ++i) {
        char text[512] = {};
        std::string line;
        for (int corner = 0; corner < 3; ++corner) {
            const glm::vec3 v = scene.corner(i, corner).position;
            std::snprintf(text, sizeof(text), "%a %a %a ", static_cast<double>(v.x),
                          static_cast<double>(v.y), static_cast<double>(v.z));
            line += text;
        }
        const glm::vec3 colour = scene.corner(i, 0).reflectance;
        const glm::vec3 normal = face_normal(
            scene.corner(i, 0).position, scene.corner(i, 1).position, scene.corner(i, 2).position);
        std::snprintf(text, sizeof(text), "%a %a %a %.4f %.4f %.4f\n",
                      static_cast<double>(colour.x), static_cast<double>(colour.y),
                      static_cast<double>(colour.z), static_cast<double>(normal.x),
                      static_cast<double>(normal.y), static_cast<double>(normal.z));
        expected += line + text;
    }
    for (const char* name : {"TestModel.h", "TestModelH.h", "new/TestModel.h"}) {
        const KitProgram program =
            compile_with_kit("#include \"" + std::string(name) + "\"\n" + main);
        CHECK(run_command({program.path()}).output == expected);
    }
}

TEST_CASE("The program's own helper draws through the stand-in of SDL", "[mine]") {
    const std::vector<SourceFile> files = {{"SDLauxiliary.h", R"(
#ifndef SDL_AUXILIARY_H
#define SDL_AUXILIARY_H
#include "SDL.h"
struct Canvas { SDL_Window* window; SDL_Renderer* renderer; };
inline Canvas* OpenCanvas(int size) {
    auto* canvas = new Canvas;
    SDL_CreateWindowAndRenderer(size, size, 0, &canvas->window, &canvas->renderer);
    return canvas;
}
inline void Dot(Canvas* canvas, int x, int y) {
    SDL_SetRenderDrawColor(canvas->renderer, 255, 0, 0, 255);
    SDL_RenderDrawPoint(canvas->renderer, x, y);
}
#endif
)"},
                                           {"main.cpp", R"(
#include "SDLauxiliary.h"
int main() {
    Canvas* canvas = OpenCanvas(6);
    SDL_SetRenderDrawColor(canvas->renderer, 0, 255, 0, 255);
    SDL_RenderClear(canvas->renderer);
    Dot(canvas, 2, 1);
    SDL_RenderPresent(canvas->renderer);
}
)"}};
    KitOptions options;
    options.flags = {"-DRASTERWALK_OWN_HELPER"};
    options.has_fast_start = false;
    const KitRun run = run_recorded(compile_with_kit(files, options));
    check_ended(run);
    CHECK(run.progress().puts == 1);
    CHECK(run.pixel(2, 1) == Floats{1, 0, 0});
    CHECK(run.pixel(1, 2) == Floats{0, 1, 0});
}

TEST_CASE("The skeleton compiles as it is, with the kit and with its own helper", "[mine]") {
    const std::string folder = kit_folder() + "/new/";
    std::string skeleton = bytes_of(folder + "skeleton.cpp");
    const KitRun empty = run_recorded(compile_with_kit(skeleton));
    check_ended(empty);
    CHECK(empty.progress().width == 500);
    CHECK(empty.progress().puts == 0);
    CHECK(empty.progress().frames == 1);

    // The two steps, as a student would write them.
    const std::string draw = "        (void)vertices;";
    const std::string shade = "    p = ivec2(0, 0);";
    REQUIRE(skeleton.find(draw) != std::string::npos);
    REQUIRE(skeleton.find(shade) != std::string::npos);
    skeleton.insert(skeleton.find(draw), R"(
        for (const vec3& v : vertices) {
            ivec2 p;
            VertexShader(v, p);
            PutPixelSDL(screen, p.x, p.y, vec3(1, 1, 1));
        }
)");
    skeleton.insert(skeleton.find(shade) + shade.size(), R"(
    const vec3 seen = v - cameraPos;
    p.x = int(focalLength * seen.x / seen.z + SCREEN_WIDTH / 2);
    p.y = int(focalLength * seen.y / seen.z + SCREEN_HEIGHT / 2);
)");
    const KitRun kit = run_recorded(compile_with_kit(skeleton));
    check_ended(kit);
    REQUIRE(kit.progress().puts == 90);
    // The first corner is C: (-1, 1, 1) - (0, 0, -3.001), so 500 / 4.001 to the left and down.
    check_put(kit.put(0), 125, 374, {1, 1, 1});

    KitOptions options;
    options.flags = {"-DRASTERWALK_OWN_HELPER"};
    options.has_fast_start = false;
    const KitRun own =
        run_recorded(compile_with_kit({{"SDLauxiliary.h", bytes_of(folder + "SDLauxiliary.h")},
                                       {"TestModel.h", bytes_of(folder + "TestModel.h")},
                                       {"main.cpp", skeleton}},
                                      options));
    check_ended(own);
    CHECK(own.progress().puts == 0);
    std::size_t white = 0, different = 0;
    for (int y = 0; y < 500; ++y) {
        for (int x = 0; x < 500; ++x) {
            different += own.pixel(x, y) != kit.pixel(x, y);
            white += own.pixel(x, y)[0] == 1.0f;
        }
    }
    CHECK(different == 0);
    CHECK(own.progress().direct == white);
}

} // namespace rasterwalk::test
