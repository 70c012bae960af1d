#include "mine/compile/student_files.h"

#include <filesystem>

#include "base/error.h"
#include "mine/compile/project_folder.h"
#include "mine/compile/source_text.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace rasterwalk;
using Catch::Matchers::ContainsSubstring;
using rasterwalk::test::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

constexpr const char* some_main = "int main() { return 0; }\n";

void write_below(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
    fs::create_directories(fs::path(folder.file(name)).parent_path());
    folder.write(name, text);
}

/// The names of the sources besides the main one.
std::string names_of(const StudentFiles& files) {
    std::string names;
    for (const std::string& source : files.sources) {
        names += (names.empty() ? "" : " ") + file_name(source);
    }
    return names;
}

} // namespace

TEST_CASE("A source with main() is distinguished from others") {
    CHECK(defines_main("int main() {}"));
    CHECK(defines_main("int main( int argc, char* argv[] )\r\n{\r\n}"));
    CHECK(defines_main("#include <x>\nint\nmain(void)\n{"));
    CHECK(defines_main("auto main() -> int { }"));
    CHECK(defines_main("int main() try { } catch (...) { }"));
    CHECK(defines_main("const char* text = \"/*\"; int main() { } // */"));
    CHECK(defines_main("char quote = '\"'; int main() { }"));
    CHECK(defines_main("int million = 1'000'000; int main() { }"));
    CHECK(defines_main("#if 0\nx\n#else\nint main() {}\n#endif"));
    CHECK_FALSE(defines_main("// int main() {}"));
    CHECK_FALSE(defines_main("/* int main() {} */"));
    CHECK_FALSE(defines_main("// goes on \\\nint main() {}"));
    CHECK_FALSE(defines_main("const char* text = \"int main() {}\";"));
    CHECK_FALSE(defines_main("auto text = R\"x( \" int main() {} )x\";"));
    CHECK_FALSE(defines_main("#if 0\nint main() {}\n#endif"));
    CHECK_FALSE(defines_main("#if 0\n#if 1\n#endif\nint main() {}\n#endif"));
    CHECK_FALSE(defines_main("int main();"));
    CHECK_FALSE(defines_main("int domain() {}"));
    CHECK_FALSE(defines_main("int main_loop() {}"));
    CHECK_FALSE(defines_main("void run() { return main(); }"));
    CHECK_FALSE(defines_main("int main"));
    CHECK_FALSE(defines_main("int main("));
    CHECK_FALSE(defines_main(""));
}

TEST_CASE("The functions of a source are found outside its classes") {
    const FunctionNames names = function_names(R"(
        #define TWICE(x) (2 * (x))
        void Draw(int a, int b = f(3));
        std::vector<int>& rows();
        namespace lab { float light(float r) { return helper(r); } }
        extern "C" { int in_c(); }
        struct Camera { void Update(); int x() { return 1; } };
        Camera::Camera() : x(3) { Draw(1, 2); }
        void Camera::Update() const { if (true) { later(); } }
        int number = compute(3);
    )");
    CHECK(names.declared == std::vector<std::string>{"Draw", "in_c", "rows"});
    CHECK(names.defined == std::vector<std::string>{"Camera::Camera", "Camera::Update", "light"});
}

TEST_CASE("A file alone is a program") {
    const TemporaryFolder folder;
    const std::string path = folder.write("skeleton.cpp", some_main);
    const StudentFiles files = find_student_files(path);
    CHECK(files.name == "skeleton.cpp");
    CHECK(files.main == fs::canonical(path));
    CHECK(files.folder == fs::canonical(folder.file("")).string());
    CHECK(files.sources.empty());
}

TEST_CASE("Sources are taken if the program needs them") {
    const TemporaryFolder folder;
    folder.write("main.cpp",
                 "#include \"draw.h\"\nvoid light();\nint main() { draw(); light(); }\n");
    folder.write("draw.h", "#include \"camera.hpp\"\nvoid draw();\n");
    folder.write("draw.cpp", "#include \"draw.h\"\nvoid draw() { }\n");
    folder.write("camera.hpp", "struct Camera { void move(); };\n");
    folder.write("camera.cc", "#include \"camera.hpp\"\nvoid Camera::move() { }\n");
    // Declared in main.cpp only, and it needs another one.
    folder.write("lamp.cpp", "int power();\nvoid light() { power(); }\n");
    folder.write("power.cpp", "int power() { return 14; }\n");
    // Not needed: an old copy, an exercise, another program.
    folder.write("draw_backup.cpp", "#include \"draw.h\"\nvoid draw() { }\n");
    folder.write("Copy of lamp.cpp", "void light() { }\n");
    folder.write("exercise.cpp", "int unused() { return 3; }\n");
    folder.write("old_main.cpp", some_main);
    const std::string expected = "camera.cc draw.cpp lamp.cpp power.cpp";
    CHECK(names_of(find_student_files(folder.file("main.cpp"))) == expected);
    CHECK(names_of(find_student_files(folder.file(""))) == expected);

    // Included sources are not compiled a second time.
    folder.write("main.cpp", "#include \"draw.cpp\"\nint main() { draw(); }\n");
    CHECK(names_of(find_student_files(folder.file("main.cpp"))) == "camera.cc");
}

TEST_CASE("The main source of a folder is found where students keep it") {
    const TemporaryFolder folder;
    write_below(folder, "Source/skeleton.cpp", "#include \"../include/draw.h\"\nint main() { }\n");
    write_below(folder, "include/draw.h", "void draw();\n");
    write_below(folder, "Source/draw.cpp", "void draw() { }\n");
    for (const char* left_out : {"build/main.cpp", "CMakeFiles/3.25/main.cpp", ".git/main.cpp",
                                 "glm/test/main.cpp", "SDL2-2.0.10/main.cpp"}) {
        write_below(folder, left_out, some_main);
    }
    folder.write("._skeleton.cpp", some_main);
    const StudentFiles files = find_student_files(folder.file(""));
    CHECK(file_name(files.main) == "skeleton.cpp");
    CHECK(files.folder == fs::canonical(folder.file("")).string());
    CHECK(names_of(files) == "draw.cpp");

    SECTION("A nearer one goes first") {
        folder.write("main.cxx", some_main);
        CHECK(file_name(find_student_files(folder.file("")).main) == "main.cxx");
    }
    SECTION("A copy does not count") {
        write_below(folder, "Source/skeleton_old.cpp", some_main);
        write_below(folder, "Source/skeleton (1).cpp", some_main);
        CHECK(file_name(find_student_files(folder.file("")).main) == "skeleton.cpp");
    }
    SECTION("Two are too many") {
        write_below(folder, "Source/raytracer.cpp", some_main);
        CHECK_THROWS_WITH(find_student_files(folder.file("")),
                          ContainsSubstring("raytracer.cpp, skeleton.cpp"));
        CHECK_THROWS_AS(find_student_files(folder.file("")), InputError);
    }
}

TEST_CASE("What is no program is refused with a reason") {
    const TemporaryFolder folder;
    CHECK_THROWS_AS(find_student_files(folder.file("nothing.cpp")), AccessError);
    CHECK_THROWS_WITH(find_student_files(folder.file("")), ContainsSubstring("no source in this"));
    CHECK_THROWS_WITH(find_student_files(folder.write("a.cpp", "int f();")),
                      ContainsSubstring("has no main()"));
    CHECK_THROWS_WITH(find_student_files(folder.write("a.txt", some_main)),
                      ContainsSubstring("no C++ source"));
    const std::string wide("\xff\xfei\0n\0t\0", 8);
    CHECK_THROWS_WITH(find_student_files(folder.write("b.cpp", wide)), ContainsSubstring("UTF-16"));
    const std::string zero("int a;\nint \0b;", 14);
    CHECK_THROWS_WITH(find_student_files(folder.write("c.cpp", zero)),
                      ContainsSubstring("c.cpp:2: "));
    folder.write("d.cpp", std::string(largest_source + 1, ' '));
    CHECK_THROWS_AS(find_student_files(folder.file("d.cpp")), InputError);
    CHECK(find_student_files(folder.write("e.cpp", "\xef\xbb\xbfint main() {}")).name == "e.cpp");
}

TEST_CASE("Links do not lead out of a student's folder") {
    const TemporaryFolder outside;
    outside.write("secret.cpp", "void draw() { }\n");
    outside.write("secret.h", "#pragma once\nvoid draw();\n");
    write_below(outside, "more/main.cpp", some_main);
    const TemporaryFolder folder;
    folder.write("main.cpp", "void draw();\n#include \"secret.h\"\nint main() { draw(); }\n");
    fs::create_symlink(outside.file("secret.cpp"), folder.file("draw.cpp"));
    fs::create_symlink(outside.file("secret.h"), folder.file("secret.h"));
    fs::create_directory_symlink(outside.file("more"), folder.file("more"));
    fs::create_directory_symlink(folder.file(""), folder.file("round"));
    CHECK(find_student_files(folder.file("")).sources.empty());

    fs::remove(folder.file("main.cpp"));
    CHECK_THROWS_AS(find_student_files(folder.file("")), InputError);
}

TEST_CASE("File names may hold any bytes") {
    const TemporaryFolder folder;
    const std::string odd = "m\xe5l \"1\"\\\n\xff.cpp";
    const StudentFiles files = find_student_files(folder.write(odd, some_main));
    CHECK(files.name == odd);
    CHECK(find_student_files(folder.file("")).main == files.main);
}

TEST_CASE("Hand-ins are the programs of a folder") {
    const TemporaryFolder folder;
    CHECK(find_hand_ins(folder.file("")).empty());
    write_below(folder, "cecilia/lab3/main.cpp", some_main);
    write_below(folder, "anna/skeleton.cpp", some_main);
    write_below(folder, "notes/readme.txt", "nothing");
    write_below(folder, "dan/a.cpp", some_main);
    write_below(folder, "dan/b.cpp", some_main);
    write_below(folder, "eva/lab.cpp", "int WinMain() { }\n");
    folder.write("bo.cpp", some_main);
    folder.write("helper.cpp", "void help() { }\n");
    folder.write("fia.ZIP", "PK");
    fs::create_directory(folder.file("gun"));
    std::string found;
    for (const StudentFiles& files : find_hand_ins(folder.file(""))) {
        CHECK(files.fault.empty() == !files.main.empty());
        found +=
            files.name + ": " + (files.fault.empty() ? file_name(files.main) : files.fault) + "\n";
    }
    // Nobody's is forgotten.
    CHECK(found == "anna: skeleton.cpp\n"
                   "bo.cpp: bo.cpp\n"
                   "cecilia: main.cpp\n"
                   "dan: several sources have a main(): a.cpp, b.cpp. Name one of them.\n"
                   "eva: no source in this folder has a main().\n"
                   "fia.ZIP: an archive must be unpacked first.\n"
                   "gun: the folder is empty.\n"
                   "notes: no C++ source is in this folder.\n");
}
