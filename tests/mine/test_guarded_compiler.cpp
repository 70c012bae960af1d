#include <csignal>
#include <cstring>
#include <string>

#include <fmt/format.h>
#include <sys/stat.h>

#include "mine/guard/guard.h"
#include "tests/support/catch.h"
#include "tests/support/guard_runs.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using namespace std::chrono_literals;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A folder in which a compiler works, of the user who runs it.
struct Workplace {
    Workplace(User user, const std::string& source) {
        folder.write("program.cpp", source);
        path = folder.file("");
        give_to(user, path);
    }

    TemporaryFolder folder;
    std::string path;
};

/// Compiles program.cpp of the folder under guard, and checks that nothing of it is left.
GuardedRun compiled(const GuardWay& way, const std::string& compiler, const Workplace& place,
                    std::chrono::milliseconds time = 60s,
                    const std::vector<std::string>& options = {}, const std::string& result = {}) {
    GuardedCommand command;
    command.words = {compiler, place.folder.file("program.cpp"), "-o",
                     result.empty() ? place.folder.file("program") : result};
    command.words.insert(command.words.end(), options.begin(), options.end());
    command.environment = {"PATH=/usr/local/bin:/usr/bin:/bin", "TMPDIR=" + place.path,
                           "CCACHE_DISABLE=1"};
    command.folder = place.path;
    command.writable = {place.path};
    command.limits.time = time;
    command.limits.may_start_programs = true;
    CAPTURE(compiler, way.use_landlock, way.user == User::ordinary);
    const GuardSeen seen = seen_run(way, command);
    CHECK(seen.children == 0);
    CHECK(seen.descriptors == 0);
    CHECK(count_processes(place.path) == 0);
    return seen.run;
}

GuardedRun run_program(const GuardWay& way, const Workplace& place) {
    GuardedCommand command;
    command.words = {place.folder.file("program")};
    command.folder = place.path;
    command.environment = {"ASAN_OPTIONS=detect_leaks=0:symbolize=0"};
    command.limits.time = 60s;
    command.limits.memory = 0;
    return seen_run(way, command).run;
}

GuardWay any_compiler_way() {
    return GENERATE(GuardWay{User::ordinary, true}, GuardWay{User::ordinary, false},
                    GuardWay{User::same, true});
}

} // namespace

TEST_CASE("A compiler works under guard, and what it makes runs") {
    const GuardWay way = any_compiler_way();
    for (const std::string& compiler : compilers()) {
        const Workplace place(way.user, "#include <cstdio>\n"
                                        "int main() { std::puts(\"hello\"); return 5; }\n");
        const GuardedRun run = compiled(way, compiler, place);
        INFO(run.output);
        CHECK(run.end == GuardedEnd::exited);
        CHECK(run.exit_code == 0);
        CHECK(place.folder.file_count() == 2);
        const GuardedRun made = run_program(way, place);
        CHECK(made.end == GuardedEnd::exited);
        CHECK(made.exit_code == 5);
        CHECK(made.output == "hello\n");
    }
}

TEST_CASE("A guarded compiler says what is wrong, and leaves with its exit code") {
    const Workplace place(User::ordinary, "int main() { return x; }\n");
    const GuardedRun run = compiled({}, compilers().front(), place);
    CHECK(run.end == GuardedEnd::exited);
    CHECK(run.exit_code == 1);
    CHECK_THAT(run.output, ContainsSubstring("program.cpp:1:21: error:"));
}

TEST_CASE("A guarded compiler includes no files from elsewhere") {
    const GuardWay way{GENERATE(User::ordinary, User::same), true};
    const TemporaryFolder outside;
    const std::string secret = outside.write("secret", "#error precious\n");
    give_to(way.user, outside.file(""));
    for (const std::string& compiler : compilers()) {
        const Workplace place(way.user, fmt::format("#include \"{}\"\nint main() {{}}\n", secret));
        const GuardedRun run = compiled(way, compiler, place);
        CHECK(run.end == GuardedEnd::exited);
        CHECK(run.exit_code == 1);
        if (run.has_landlock) CHECK(run.output.find("precious") == std::string::npos);
    }
}

TEST_CASE("A guarded compiler writes nothing elsewhere") {
    const GuardWay way{GENERATE(User::ordinary, User::same), true};
    const TemporaryFolder outside;
    outside.write("file", "precious");
    give_to(way.user, outside.file(""));
    const Workplace place(way.user, "int main() {}\n");
    for (const std::string& compiler : compilers()) {
        const GuardedRun run = compiled(way, compiler, place, 60s, {}, outside.file("file"));
        INFO(run.output);
        if (!run.has_landlock) return;
        CHECK_THAT(run.output, ContainsSubstring("ermission denied"));
        CHECK(run.exit_code == 1);
        CHECK(bytes_of(outside.file("file")) == "precious");
        CHECK(outside.file_count() == 1);
    }
}

TEST_CASE("A guarded compiler that never ends is killed with all its processes") {
    std::string bomb = "#define A0 x x x x x x x x x x\n";
    for (int i = 1; i < 10; ++i)
        bomb += fmt::format("#define A{0} A{1} A{1} A{1} A{1} A{1} A{1} A{1} A{1} A{1} A{1}\n", i,
                            i - 1);
    bomb += "int A9;\n";
    const GuardWay way = any_compiler_way();
    for (const std::string& compiler : compilers()) {
        const Workplace macros(way.user, bomb);
        const GuardedRun run = compiled(way, compiler, macros, 300ms);
        INFO(run.output);
        CHECK(run.end != GuardedEnd::signalled);
        CHECK(run.end != GuardedEnd::exited);
        const Workplace zeros(way.user, "#include \"/dev/zero\"\n");
        const GuardedRun endless = compiled(way, compiler, zeros, 300ms);
        INFO(endless.output);
        CHECK((endless.end != GuardedEnd::exited || endless.exit_code != 0));
        CHECK(endless.end != GuardedEnd::signalled);
    }
}

TEST_CASE("Sanitizers work under guard, without a limit of address space") {
    const GuardWay way = any_compiler_way();
    const Workplace place(way.user, "#include <cstdio>\n"
                                    "int main(int count, char**) {\n"
                                    "    int* numbers = new int[3];\n"
                                    "    std::puts(\"begins\");\n"
                                    "    return numbers[count + 2];\n"
                                    "}\n");
    const GuardedRun run =
        compiled(way, compilers().front(), place, 60s, {"-g", "-fsanitize=address,undefined"});
    INFO(run.output);
    REQUIRE(run.exit_code == 0);
    const GuardedRun made = run_program(way, place);
    INFO(made.output);
    CHECK(made.end == GuardedEnd::exited);
    CHECK_THAT(made.output, ContainsSubstring("heap-buffer-overflow"));
}
