#include "mine/compile/compile.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <sys/wait.h>

#include "base/error.h"
#include "mine/compile/compile_copies.h"
#include "mine/compile/kit_files.h"
#include "mine/compile/project_folder.h"
#include "support/catch.h"
#include "support/project_root.h"
#include "support/temporary_folder.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;
using rasterwalk::test::bytes_of;
using rasterwalk::test::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

/// One cache for all tests of the file, so that the kit is compiled once.
void use_cache_of_test() {
    static const TemporaryFolder cache;
    setenv("RASTERWALK_CACHE", cache.file("cache").c_str(), 1);
}

Compiled compile_at(const std::string& path, const std::string& compiler = "g++",
                    Instrumented instrumented = Instrumented::no) {
    use_cache_of_test();
    return compile_student_program(find_student_files(path), find_compiler(compiler), instrumented);
}

/// What a program says, and its exit code in a last line.
std::string output_of_program(const std::string& program) {
    FILE* pipe = popen((program + " 2>&1 3>&-").c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string output;
    std::array<char, 4096> block{};
    while (const std::size_t size = fread(block.data(), 1, block.size(), pipe)) {
        output.append(block.data(), size);
    }
    const int status = pclose(pipe);
    return output + "exit " + std::to_string(WIFEXITED(status) ? WEXITSTATUS(status) : -1);
}

constexpr const char* with_model = R"(
#include <SDL.h>
#include "SDLauxiliary.h"
#include "TestModel.h"
using namespace std;
using glm::vec3;
SDL_Surface* screen;
int main(int argc, char* argv[]) {
    vector<Triangle> triangles;
    LoadTestModel(triangles);
    screen = InitializeSDL(100, 80);
    PutPixelSDL(screen, 3, 4, vec3(1, 1, 1));
    cout << triangles.size() << " triangles" << endl;
    return 7;
}
)";

} // namespace

TEST_CASE("The kit is a part of the program") {
    const fs::path kit = fs::path(project_root()) / "src/mine/kit";
    std::size_t count = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(kit)) {
        if (!entry.is_regular_file()) continue;
        ++count;
        const std::string name = fs::relative(entry.path(), kit).string();
        CAPTURE(name);
        const std::vector<KitFile>& files = kit_files();
        const auto found = std::find_if(files.begin(), files.end(),
                                        [&name](const KitFile& file) { return file.name == name; });
        REQUIRE(found != files.end());
        const bool is_same = found->text == bytes_of(entry.path().string());
        CHECK(is_same);
    }
    CHECK(kit_files().size() == count);
    CHECK(kit_version().size() == 16);

    const TemporaryFolder folder;
    for (int i = 0; i < 2; ++i)
        write_kit(folder.file("kit"));
    const bool is_written =
        bytes_of(folder.file("kit/recording.h")) == bytes_of((kit / "recording.h").string());
    CHECK(is_written);
    CHECK(folder.file_count() == 1);
}

TEST_CASE("A compiler is found by its name or path") {
    use_cache_of_test();
    const Compiler gcc = find_compiler("g++");
    CHECK_FALSE(gcc.is_clang);
    CHECK(gcc.path.front() == '/');
    CHECK_THAT(gcc.version, Catch::Matchers::StartsWith("g++ "));
    CHECK(find_compiler().version == gcc.version);
    CHECK(find_compiler(gcc.path).version == gcc.version);
    const Compiler clang = find_compiler("clang++");
    CHECK(clang.is_clang);
    CHECK_THAT(clang.version, Catch::Matchers::StartsWith("clang++ "));

    CHECK_THROWS_WITH(find_compiler("no-such-compiler"), ContainsSubstring("no-such-compiler"));
    CHECK_THROWS_AS(find_compiler("/bin/ls"), AccessError);
    const TemporaryFolder folder;
    CHECK_THROWS_AS(find_compiler(folder.write("g++", "no program")), AccessError);

    const std::string path = std::getenv("PATH");
    setenv("PATH", folder.file("").c_str(), 1);
    CHECK_THROWS_WITH(find_compiler(), ContainsSubstring("apt install g++"));
    setenv("PATH", path.c_str(), 1);
}

TEST_CASE("A student's program compiles unmodified") {
    const TemporaryFolder folder;
    const std::string path = folder.write("skeleton.cpp", with_model);
    for (const char* compiler : {"g++", "clang++"}) {
        CAPTURE(compiler);
        const Compiled compiled = compile_at(path, compiler);
        CAPTURE(compiled.messages.empty() ? "" : compiled.messages.front().text);
        REQUIRE_FALSE(compiled.program.empty());
        CHECK(compiled.kit == KitUse::with_driver);
        CHECK_THAT(output_of_program(compiled.program), ContainsSubstring("30 triangles\nexit 7"));
        CHECK_THAT(compiled.compiler, Catch::Matchers::StartsWith(compiler));
    }
    // Nothing is written into the student's folder.
    CHECK(folder.file_count() == 1);
    CHECK(bytes_of(path) == with_model);
}

TEST_CASE("Only what has changed is compiled again") {
    const TemporaryFolder folder;
    folder.write("main.cpp", "#include \"two.h\"\nint main() { return two(); }\n");
    folder.write("two.h", "int two();\n");
    folder.write("two.cpp", "#include \"two.h\"\nint two() { return 2; }\n");
    const std::string first = compile_at(folder.file("main.cpp")).program;
    REQUIRE(output_of_program(first) == "exit 2");
    const std::string objects = fs::path(first).parent_path().parent_path().string() + "/objects";
    const auto count = [&objects] { return files_in(objects, 0).size(); };
    const std::size_t before = count();
    CHECK(compile_at(folder.file("main.cpp")).program == first);
    CHECK(count() == before);
    folder.write("two.cpp", "#include \"two.h\"\nint two() { return 3; }\n");
    CHECK(output_of_program(compile_at(folder.file("main.cpp")).program) == "exit 3");
    CHECK(count() == before + 2); // an object, and its messages
    folder.write("two.h", "inline int one() { return 1; }\nint two();\n");
    CHECK(output_of_program(compile_at(folder.file("main.cpp")).program) == "exit 3");
    CHECK(count() == before + 6);
}

TEST_CASE("Messages name the student's file and line") {
    const TemporaryFolder folder;
    for (const char* compiler : {"g++", "clang++"}) {
        CAPTURE(compiler);
        // The byte order mark and the ends of Windows' lines change nothing.
        const std::string path = folder.write(
            "a \"b\"\\c.cpp", "\xef\xbb\xbf#include \"SDLauxiliary.h\"\r\n\r\nint main() {\r\n"
                              "    return focl;\r\n}\r\n");
        const Compiled compiled = compile_at(path, compiler);
        CHECK(compiled.program.empty());
        REQUIRE(compiled.messages.size() == 1);
        CHECK(compiled.messages[0].file == fs::canonical(path));
        CHECK(compiled.messages[0].line == 4);
        CHECK(compiled.messages[0].is_error);
        CHECK_THAT(compiled.messages[0].cause, ContainsSubstring("Nothing named focl"));
    }
    const auto messages_of = [&folder](const std::string& text) {
        const Compiled compiled = compile_at(folder.write("main.cpp", text));
        CHECK(compiled.program.empty());
        REQUIRE_FALSE(compiled.messages.empty());
        return compiled.messages.front();
    };
    SECTION("A function that is called but not defined") {
        const CompileMessage message =
            messages_of("void Draw(int);\nint main() {\n    Draw(3);\n}\n");
        CHECK(message.line == 3);
        CHECK_THAT(message.cause, ContainsSubstring("Draw is declared and called, but never"));
    }
    SECTION("A brace that is not closed is the student's, not the driver's") {
        const CompileMessage message = messages_of("int main() {\n    if (true) {\n}\n");
        CHECK(fs::path(message.file).filename() == "main.cpp");
        CHECK_THAT(message.cause, ContainsSubstring("never closed"));
    }
    SECTION("A missing header") {
        const CompileMessage message = messages_of("\n#include \"nothing.h\"\nint main() { }\n");
        CHECK(message.line == 2);
        CHECK_THAT(message.cause, ContainsSubstring("no file of this name"));
    }
    SECTION("A mistake in a template of the library") {
        const CompileMessage message =
            messages_of("struct Pixel { int x; };\nint main() {\n    std::vector<Pixel> p(3);\n"
                        "    std::sort(p.begin(), p.end());\n}\n");
        CHECK(fs::path(message.file).filename() == "main.cpp");
        CHECK(message.line == 4);
    }
}

TEST_CASE("Warnings about the student's code are kept") {
    const TemporaryFolder folder;
    const std::string path =
        folder.write("main.cpp", "int main() {\n    int a = 1;\n    if (a = 2) return 3;\n}\n");
    for (int i = 0; i < 2; ++i) { // the second time nothing is compiled
        const Compiled compiled = compile_at(path);
        CHECK_FALSE(compiled.program.empty());
        REQUIRE(compiled.messages.size() == 1);
        CHECK(compiled.messages[0].line == 3);
        CHECK_FALSE(compiled.messages[0].is_error);
    }
}

TEST_CASE("Includes lead to the kit, to GLM and to the student's headers") {
    CHECK(kit_file_for("../Source/SDLauxiliary.h") == kit_file_for("sdlauxiliary.H"));
    CHECK_FALSE(kit_file_for("C:\\libs\\SDL\\SDL.h").empty());
    CHECK_FALSE(kit_file_for("TestModelH.h").empty());
    CHECK(kit_file_for("driver.h").empty());
    CHECK(kit_file_for("recording.h").empty());
    CHECK(glm_file_for("..\\glm\\glm.hpp") == "glm/glm.hpp");
    CHECK(glm_file_for("/home/x/glm/glm/gtc/type_ptr.hpp") == "glm/gtc/type_ptr.hpp");
    CHECK(glm_file_for("myglm/glm.hpp").empty());
    CHECK(quoted_for_line("a\"b\\c\n") == "\"a\\\"b\\\\c?\"");

    const TemporaryFolder folder;
    fs::create_directories(folder.file("Source/maths"));
    folder.write("SDLauxiliary.h", "#error the kit's comes first\n");
    folder.write("Source/TestModel.h", "#error here as well\n");
    folder.write("Source/driver.h", "inline int speed() { return 5; }\n");
    folder.write("Source/maths/deep.h", "#include \"../driver.h\"\n#include \"../TestModel.h\"\n");
    const std::string path =
        folder.write("Source/main.cpp", "#include \"C:\\libs\\SDL\\SDL.h\"\n"
                                        "#include \"..\\SDLauxiliary.h\"\n"
                                        "#include </home/x/glm/glm.hpp>\n"
                                        "#include \"D:\\lab\\maths\\deep.h\" // mine\n"
                                        "#include \"deep.h\"\n"
                                        "int main() { LoadTestModel(*new std::vector<Triangle>);"
                                        " return speed() + __LINE__; }\n");
    const Compiled compiled = compile_at(folder.file(""));
    CAPTURE(compiled.messages.empty() ? "" : compiled.messages.front().text);
    // Line 6, and deep.h has no guard but defines nothing twice only if driver.h is read once.
    CHECK_FALSE(compiled.messages.empty());
    folder.write("Source/driver.h", "#pragma once\ninline int speed() { return 5; }\n");
    const Compiled guarded = compile_at(folder.file(""));
    REQUIRE_FALSE(guarded.program.empty());
    CHECK(output_of_program(guarded.program) == "exit 11");
}

TEST_CASE("The compiler reads nothing outside the student's folder") {
    const TemporaryFolder outside;
    outside.write("secret.h", "int secret = SECRET_WORD;\n");
    const TemporaryFolder folder;
    fs::create_symlink(outside.file("secret.h"), folder.file("linked.h"));
    for (const std::string& included :
         {outside.file("secret.h"), std::string("linked.h"), std::string("/etc/passwd")}) {
        CAPTURE(included);
        const Compiled compiled = compile_at(
            folder.write("main.cpp", "#include \"" + included + "\"\nint main() { return 0; }\n"));
        CHECK(compiled.program.empty());
        REQUIRE_FALSE(compiled.messages.empty());
        for (const CompileMessage& message : compiled.messages) {
            CHECK_THAT(message.text, !ContainsSubstring("SECRET_WORD"));
            CHECK_THAT(message.text, !ContainsSubstring("root"));
        }
    }
}

TEST_CASE("If the driver cannot be appended, the program is still compiled") {
    const TemporaryFolder folder;
    // The name that the driver is in is a macro here.
    const Compiled compiled =
        compile_at(folder.write("main.cpp", "#define namespace class\nint main() { return 4; }\n"));
    CAPTURE(compiled.messages.empty() ? "" : compiled.messages.front().text);
    REQUIRE_FALSE(compiled.program.empty());
    CHECK(compiled.kit == KitUse::kit_only);
    CHECK(output_of_program(compiled.program) == "exit 4");
}

TEST_CASE("What only an older standard allows is compiled as that") {
    const TemporaryFolder folder;
    const Compiled compiled = compile_at(folder.write(
        "main.cpp", "using namespace std;\nint data = 3;\nint main() { return data; }\n"));
    CAPTURE(compiled.messages.empty() ? "" : compiled.messages.front().text);
    REQUIRE_FALSE(compiled.program.empty());
    CHECK(output_of_program(compiled.program) == "exit 3");
}

TEST_CASE("A helper of the student's own is used if the kit's cannot replace it") {
    const TemporaryFolder folder;
    folder.write("SDLauxiliary.h", "#ifndef SDL_AUXILIARY_H\n#define SDL_AUXILIARY_H\n"
                                   "#include <SDL.h>\ninline int DrawMyWay(int a) { return a; }\n"
                                   "#endif\n");
    const std::string path = folder.write(
        "main.cpp", "#include \"SDLauxiliary.h\"\nint main() { return DrawMyWay(6); }\n");
    const Compiled compiled = compile_at(path);
    CAPTURE(compiled.messages.empty() ? "" : compiled.messages.front().text);
    REQUIRE_FALSE(compiled.program.empty());
    CHECK(compiled.kit == KitUse::own_helper);
    CHECK(output_of_program(compiled.program) == "exit 6");
}

TEST_CASE("A sanitized program names the line of its fault") {
    const TemporaryFolder folder;
    const std::string path =
        folder.write("main.cpp", "float depthBuffer[4][4];\nint main(int argc, char**) {\n"
                                 "    depthBuffer[argc + 3][0] = 1;\n    return 0;\n}\n");
    const Compiled plain = compile_at(path);
    const Compiled sanitized = compile_at(path, "g++", Instrumented::sanitized);
    REQUIRE_FALSE(sanitized.program.empty());
    CHECK(sanitized.program != plain.program);
    const std::string output = output_of_program(sanitized.program);
    CHECK_THAT(output, ContainsSubstring("main.cpp:3:"));
    CHECK_THAT(output, ContainsSubstring("index 4 out of bounds"));
    CHECK_THAT(output, !ContainsSubstring("exit 0"));
}

TEST_CASE("A compilation can be stopped") {
    use_cache_of_test();
    const TemporaryFolder folder;
    const StudentFiles files = find_student_files(folder.write("main.cpp", with_model));
    const Compiled compiled =
        compile_student_program(files, find_compiler("g++"), Instrumented::no, [] { return true; });
    CHECK(compiled.program.empty());
    CHECK(compiled.messages.empty());
    // Nothing unfinished stays, and the next time it compiles.
    CHECK_FALSE(compile_at(folder.file("main.cpp")).program.empty());
    for (const FoundFile& file : files_in(cache_folder(), 4)) {
        CHECK_FALSE(fs::path(file.path).extension() == ".part");
    }
}

TEST_CASE("A cache that cannot be made is an error") {
    const TemporaryFolder folder;
    const std::string before = std::getenv("RASTERWALK_CACHE");
    setenv("RASTERWALK_CACHE", (folder.write("file", "") + "/cache").c_str(), 1);
    CHECK_THROWS_AS(cache_folder(), AccessError);
    setenv("RASTERWALK_CACHE", before.c_str(), 1);
    CHECK(cache_folder() == before);
}
