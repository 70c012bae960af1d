// What the kit records of a program that dies, or that asks for what it may not have, and what its
// driver needs.

#include <cstddef>
#include <string>

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include "mine/kit_runs.h"
#include "support/catch.h"

namespace rasterwalk::test {

namespace {

using namespace rasterwalk_kit;

/// The line of a text, from 1, where this first stands.
int line_of(const std::string& text, const std::string& part) {
    const std::size_t at = text.find(part);
    REQUIRE(at != std::string::npos);
    int line = 1;
    for (std::size_t i = 0; i < at; ++i)
        line += text[i] == '\n';
    return line;
}

std::string main_line(const std::string& text, const std::string& part) {
    return "main.cpp:" + std::to_string(line_of(text, part));
}

/// The first place of the stack that is in main.cpp; "" if there is none.
std::string place_in_main(const KitProgram& program, const Progress& progress) {
    for (std::size_t i = 0; i < progress.depth; ++i) {
        for (const SourcePlace& place : source_places(program, progress.stack[i])) {
            if (place.line.rfind("main.cpp:", 0) == 0) return place.line;
        }
    }
    return "";
}

const std::string faulty = R"(
#include <csignal>
#include "SDLauxiliary.h"
SDL_Surface* screen;
SDL_Surface* missing;
int* nowhere;
__attribute__((noinline)) void Store() {
    *nowhere = 3; // store
}
__attribute__((noinline)) int Deep(int depth) {
    volatile char local[4096]; local[depth % 4096] = 1; return Deep(depth + 1) + local[0]; // deeper
}
__attribute__((noinline)) void Throw() {
    throw std::runtime_error("not caught"); // throw
}
__attribute__((noinline)) void Jump() {
    void (*volatile function)() = nullptr;
    function(); // jump
    printf(" ");
}
__attribute__((noinline)) void Divide(volatile int* number) {
    *number = 5 / *number; // divide
}
__attribute__((noinline)) void PutNowhere() {
    PutPixelSDL(missing, 1, 1, glm::vec3(1, 1, 1)); // put
    printf(" ");
}
__attribute__((noinline)) void Send(int signal) {
    raise(signal); // send
    printf(" ");
}
int main(int, char** words) {
    screen = InitializeSDL(10, 10);
    PutPixelSDL(screen, 2, 3, glm::vec3(1, 0, 0));
    ((Uint32*)screen->pixels)[0] = 0xff00;
    int number = 0;
    switch (atoi(words[1])) {
    case 0: Store(); break;
    case 1: return Deep(0);
    case 2: Throw(); break;
    case 3: Jump(); break;
    case 4: Divide(&number); break;
    case 5: PutNowhere(); break;
    case 6: Send(SIGXCPU); break;
    case 7: Send(SIGTERM); break;
    }
    SDL_Flip(screen);
}
)";

/// A call of the kernel that the tests' filter refuses.
constexpr int refused_call = SYS_mkdir;

/// Refuses one call with a trap, as the guard does.
void refuse_mkdir() {
    sock_filter rules[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, refused_call, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const sock_fprog filter = {4, rules};
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
}

} // namespace

TEST_CASE("A death is recorded with its signal and its place", "[mine]") {
    struct Fault {
        int number, signal;
        std::string line;
    };
    const std::vector<Fault> faults = {{0, SIGSEGV, "// store"}, {1, SIGSEGV, "// deeper"},
                                       {2, SIGABRT, "// throw"}, {3, SIGSEGV, "// jump"},
                                       {4, SIGFPE, "// divide"}, {5, SIGSEGV, "// put"},
                                       {6, SIGXCPU, "// send"},  {7, SIGTERM, "// send"}};
    const KitProgram program = compile_with_kit(faulty);
    for (const Fault& fault : faults) {
        INFO(fault.line);
        const KitRun run = run_recorded(program, 1, 0, nullptr, std::to_string(fault.number));
        // It dies of it, too.
        CHECK(WIFSIGNALED(run.ended.status));
        CHECK(WTERMSIG(run.ended.status) == fault.signal);
        CHECK(run.progress().signal == fault.signal);
        CHECK(run.progress().moment == moment_put);
        CHECK(run.progress().frames == 0);
        REQUIRE(run.progress().depth > 0);
        CHECK(place_in_main(program, run.progress()) == main_line(faulty, fault.line));
        if (fault.number == 0) CHECK(run.progress().address == 0);
        // What was drawn until then is not lost.
        CHECK(run.progress().puts == 1);
        CHECK(run.progress().direct == 1);
        CHECK(run.pixel(2, 3) == std::vector<float>{1, 0, 0});
        CHECK(run.pixel(0, 0) == std::vector<float>{0, 1, 0});
    }
}

TEST_CASE("A call that the guard refuses fails, is recorded, and the program goes on", "[mine]") {
    const std::string main = R"(
#include <sys/stat.h>
int main() {
    for (int i = 0; i < 3; ++i) {
        errno = 0;
        int result = mkdir("folder-of-the-kit-test", 0700); // refused
        printf("%d %d ", result, errno == EPERM);
    }
    int result = mkdir("folder-of-the-kit-test", 0700);
    printf("%d", result);
}
)";
    const KitProgram program = compile_with_kit(main);
    const KitRun run = run_recorded(program, 1, 0, refuse_mkdir);
    CHECK(run.ended.is_well());
    CHECK(run.ended.output == "-1 1 -1 1 -1 1 -1");
    const Refused* refused = run.progress().refused;
    CHECK(refused[0].call == refused_call);
    CHECK(refused[0].count == 3);
    CHECK(source_places(program, refused[0].place)[0].line == main_line(main, "// refused"));
    CHECK(refused[1].count == 1);
    CHECK(refused[1].place != refused[0].place);
    CHECK(refused[2].count == 0);
    CHECK(run.progress().signal == 0);
}

TEST_CASE("Pixels that are captured leave the picture as it is", "[mine]") {
    const KitRun run = run_recorded(compile_with_kit(R"(
#include "runtime.h"
#include "SDLauxiliary.h"
screen* screen;
void DrawPolygonRows() {
    PutPixelSDL(screen, 1, 1, glm::vec3(1, 1, 1));
    PutPixelSDL(screen, -5, 1, glm::vec3(0, 1, 0));
    screen->buffer[2 * screen->width + 3] = 0x0000ff;
    SDL_Renderframe(screen);
}
void ask() {
    std::vector<rasterwalk_kit::Put> puts;
    for (int i = 0; i < 2; ++i) {
        rasterwalk_kit::set_part(rasterwalk_kit::part_draw_rows, i);
        rasterwalk_kit::capture_puts(&puts);
        DrawPolygonRows();
        rasterwalk_kit::capture_puts(nullptr);
        for (auto& put : puts) printf("%d,%d:%g%g%g ", put.x, put.y, put.red, put.green, put.blue);
        puts.clear();
        SDL_Renderframe(screen);
    }
    rasterwalk_kit::recorded()->answers[0] = 7;
}
struct Driver {
    Driver() { rasterwalk_kit::after_first_frame = ask; }
} driver;
int main() {
    screen = InitializeSDL(5, 5);
    while (NoQuitMessageSDL()) {
        PutPixelSDL(screen, 4, 4, glm::vec3(1, 0, 0));
        SDL_Renderframe(screen);
        printf("| ");
    }
}
)"),
                                    2);
    CHECK(run.ended.is_well());
    CHECK(run.ended.output == "1,1:111 -5,1:010 3,2:001 1,1:111 -5,1:010 3,2:001 | ");
    CHECK(run.progress().frames == 2);
    CHECK(run.progress().puts == 1);
    CHECK(run.progress().outside == 0);
    CHECK(run.progress().direct == 0);
    CHECK(run.progress().part == part_draw_rows);
    CHECK(run.progress().question == 1);
    CHECK(run.recorded->answers[0] == 7);
    CHECK(run.pixel(3, 2) == std::vector<float>{0, 0, 0});
}

TEST_CASE("Calls of the program's functions in the first frame are counted", "[mine]") {
    KitOptions options;
    options.flags = {"-finstrument-functions",
                     "-finstrument-functions-exclude-file-list=/usr/," + kit_folder()};
    options.has_fast_start = false;
    const KitProgram program = compile_with_kit(R"(
#include "SDL2Aux.h"
SDL2Aux* sdlAux;
__attribute__((noinline)) void PixelShader(int x) { sdlAux->putPixel(x, 0, glm::vec3(1, 1, 1)); }
__attribute__((noinline)) void Draw() {
    for (int x = 0; x < 40; ++x) PixelShader(x);
    sdlAux->render();
}
int main() {
    sdlAux = new SDL2Aux(50, 50);
    while (sdlAux->noQuitMessage()) Draw();
}
)",
                                                options);
    const KitRun run = run_recorded(program, 3);
    CHECK(run.ended.is_well());
    std::uint64_t shaded = 0, drawn = 0;
    for (const Calls& calls : run.progress().calls) {
        if (calls.place == 0) continue;
        const std::string function = source_places(program, calls.place)[0].function;
        if (function == "PixelShader(int)") shaded += calls.count;
        if (function == "Draw()") drawn += calls.count;
    }
    CHECK(shaded == 40);
    CHECK(drawn == 1);
}

TEST_CASE("Sanitizers find faults that show only while a key is held", "[mine]") {
    const std::string main = R"(
#include "SDLauxiliary.h"
SDL_Surface* screen;
float depth[10][10];
int main() {
    screen = InitializeSDL(10, 10);
    int x = 5;
    while (NoQuitMessageSDL()) {
        if (SDL_GetKeyState(0)[SDLK_RIGHT]) x += 3;
        depth[2][x] = 1; // fault
        PutPixelSDL(screen, x, 2, glm::vec3(1, 1, 1));
        SDL_UpdateRect(screen, 0, 0, 0, 0);
    }
}
)";
    KitOptions options;
    options.flags = {"-fsanitize=address,undefined", "-fno-sanitize-recover=undefined", "-O0"};
    options.has_fast_start = false;
    const KitProgram program = compile_with_kit(main, options);
    const int right = 0x4000004f;
    const KitRun quiet = run_recorded(program, 4);
    INFO(quiet.ended.output);
    CHECK(quiet.ended.is_well());
    CHECK(quiet.progress().frames == 4);
    const KitRun held = run_recorded(program, 4, right);
    CHECK(!held.ended.is_well());
    CHECK(held.progress().frames == 2);
    CHECK(held.ended.output.find(main_line(main, "// fault")) != std::string::npos);

    // A crash is recorded before the sanitizer reports it and ends the program.
    const KitProgram faulty_program = compile_with_kit(faulty, options);
    const KitRun crash = run_recorded(faulty_program, 1, 0, nullptr, "0");
    CHECK(!crash.ended.is_well());
    CHECK(crash.ended.output.find(main_line(faulty, "// store")) != std::string::npos);
    const KitRun null = run_recorded(faulty_program, 1, 0, nullptr, "5");
    CHECK(null.progress().signal == SIGSEGV);
    CHECK(place_in_main(faulty_program, null.progress()) == main_line(faulty, "// put"));
    const KitRun full = run_recorded(faulty_program, 1, 0, nullptr, "1");
    CHECK(full.progress().signal == SIGSEGV);
    CHECK(full.ended.output.find("stack-overflow") != std::string::npos);
}

TEST_CASE("Without the headers that were forgotten more names are free", "[mine]") {
    const std::string main = R"(
#include "SDL.h"
#include <glm/glm.hpp>
using namespace std;
int left = 1, map = 4;
int main() { return left + map; }
)";
    KitOptions options;
    options.flags = {"-DRASTERWALK_FEW_HEADERS"};
    options.has_fast_start = false;
    CHECK(WEXITSTATUS(run_command({compile_with_kit(main, options).path()}).status) == 5);
}

} // namespace rasterwalk::test
