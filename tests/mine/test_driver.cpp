// The driver asks programs of many styles, and writes what their own direct calls give.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <csignal>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "mine/kit/recording.h"
#include "support/catch.h"
#include "support/project_root.h"

using namespace rasterwalk_kit;

namespace {

const std::string root = rasterwalk::project_root();
const std::string kit = root + "/src/mine/kit";
const std::string programs = root + "/tests/mine/driver_programs";

/// A folder that goes with the test, and the parts of the kit that are compiled once.
struct Workshop {
    std::string folder;

    Workshop() {
        std::string name = (std::filesystem::temp_directory_path() / "driver-XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        folder = name;
        write("all.h", "#include \"claims.h\"\n#include \"asking.h\"\n");
        run("-x c++-header " + folder + "/all.h -o " + folder + "/all.h.gch");
        run("-c " + kit + "/runtime.cpp -o " + folder + "/runtime.o");
        run("-c " + kit + "/asking.cpp -o " + folder + "/asking.o");
    }
    ~Workshop() { std::filesystem::remove_all(folder); }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder + "/" + name) << text;
    }

    void run(const std::string& arguments) const {
        const std::string command = "g++ -std=gnu++20 -O1 -w -I" + kit + " " + arguments + " > " +
                                    folder + "/messages 2>&1";
        const int status = std::system(command.c_str());
        std::ifstream messages(folder + "/messages");
        std::stringstream text;
        text << messages.rdbuf();
        INFO(text.str());
        REQUIRE(status == 0);
    }

    /// Compiles a program with the driver, and direct() if there is one.
    std::string compile(const std::string& name, bool is_direct = true) const {
        const bool is_folder = std::filesystem::is_directory(programs + "/" + name);
        std::ifstream file(programs + "/" + name + (is_folder ? "/main.cpp" : ".cpp"));
        REQUIRE(file);
        std::string students;
        std::string direct;
        bool is_in_direct = false;
        for (std::string line; std::getline(file, line);) {
            is_in_direct = is_in_direct || line == "// Direct calls";
            (is_in_direct ? direct : students) += line + "\n";
        }
        if (is_direct) students += "#include \"direct.h\"\n" + direct;
        students += "#include \"driver.h\"\n";
        if (is_direct) students += "#include \"direct_hook.h\"\n";
        write("program.cpp", students);
        std::string arguments = "-include " + folder + "/all.h -I" + programs + " -I" + programs +
                                "/" + name + " " + folder + "/program.cpp";
        if (is_folder) arguments += " " + programs + "/" + name + "/raster.cpp";
        arguments += " " + folder + "/runtime.o " + folder + "/asking.o -o " + folder + "/program";
        run(arguments);
        return folder + "/program";
    }
};

const Workshop& workshop() {
    static const Workshop one;
    return one;
}

/// The memory that is shared with a program.
struct Memory {
    int descriptor;
    Recorded* recorded;
    std::size_t asked = 0;

    Memory() : descriptor(memfd_create("recording", 0)) {
        REQUIRE(ftruncate(descriptor, sizeof(Recorded)) == 0);
        void* place =
            mmap(nullptr, sizeof(Recorded), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
        REQUIRE(place != MAP_FAILED);
        recorded = static_cast<Recorded*>(place);
        recorded->task.magic = recording_magic;
        recorded->task.frames = 1;
        recorded->task.parts = (1U << part_count) - 1;
    }
    ~Memory() {
        munmap(recorded, sizeof(Recorded));
        close(descriptor);
    }
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;

    void ask(const std::vector<double>& numbers) {
        for (const double number : numbers)
            recorded->questions[asked++] = number;
    }

    void ask_pixel(double x, double y, double zinv, double place, double light) {
        ask({15, x, y, zinv, place, place + 1, place + 2, light, light + 0.5, light + 1});
    }

    void end(rasterwalk_kit::Part part) { recorded->task.question_end[part] = asked; }
};

void ask_questions(Memory& memory) {
    memory.ask({0.5, -0.25, 0.75, 0, 0, -1, 0.75, 0.25, 0.15});
    memory.ask({-0.5, 0.5, -0.5, 0, 1, 0, 0.25, 0.75, 0.5});
    memory.end(part_vertex_shader);
    memory.ask_pixel(4, 2, 0.5, 1, 0);
    memory.ask_pixel(1, 8, 0.25, 3, 1);
    memory.ask({4});
    memory.ask_pixel(4, 4, 0.5, 1, 0);
    memory.ask_pixel(4, 4, 0.25, 3, 1);
    memory.ask({1});
    memory.end(part_interpolate);
    memory.ask({3});
    memory.ask_pixel(10, 5, 0.5, 1, 0);
    memory.ask_pixel(5, 10, 0.25, 3, 1);
    memory.ask_pixel(15, 15, 0.125, 2, 1);
    memory.end(part_polygon_rows);
    memory.ask({2});
    memory.ask_pixel(3, 5, 0.5, 1, 0);
    memory.ask_pixel(3, 6, 0.25, 3, 1);
    memory.ask_pixel(5, 5, 0.5, 1, 0);
    memory.ask_pixel(3, 6, 0.25, 3, 1);
    memory.ask({0.5, 0.25, 1});
    memory.end(part_draw_rows);
    memory.ask({4});
    memory.ask_pixel(3, 5, 0.5, 1, 0);
    memory.ask({1, 1, 1});
    memory.ask_pixel(3, 5, 0.25, 1, 0);
    memory.ask({1, 1, 1});
    memory.ask_pixel(3, 5, 0.75, 1, 0);
    memory.ask({1, 1, 1});
    memory.ask_pixel(3, 6, 0.25, 1, 0);
    memory.ask({1, 1, 1});
    memory.end(part_depth_test);
    memory.ask_pixel(3, 5, 0.5, 1, 0);
    memory.ask({0, 0, -1, 0.5, 0.25, 1});
    memory.end(part_pixel_shader);
}

struct Outcome {
    int status = 0;
    std::string output;
};

/// Runs a program with this memory. It is killed after some seconds.
Outcome run(const std::string& program, Memory& memory) {
    std::array<int, 2> pipe_ends{};
    REQUIRE(pipe(pipe_ends.data()) == 0);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        dup2(pipe_ends[1], STDOUT_FILENO);
        dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
        dup2(memory.descriptor, recording_descriptor);
        alarm(20);
        execl(program.c_str(), program.c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }
    close(pipe_ends[1]);
    Outcome outcome;
    std::array<char, 4096> buffer{};
    for (ssize_t got = 0; (got = ::read(pipe_ends[0], buffer.data(), buffer.size())) > 0;) {
        outcome.output.append(buffer.data(), static_cast<std::size_t>(got));
    }
    close(pipe_ends[0]);
    waitpid(child, &outcome.status, 0);
    return outcome;
}

using Numbers = std::vector<double>;

/// What the stream of answers says: by part, its answers without their numbers.
struct AnswersOfParts {
    std::array<std::vector<Numbers>, part_count> parts;
    std::array<Numbers, global_count> globals;
};

/// Reads numbers from the front of a stream, and fails at its end.
class Stream {
  public:
    explicit Stream(const Recorded& recorded)
        : m_at(recorded.answers), m_end(recorded.answers + recorded.progress.answers) {}

    bool has_more() const { return m_at < m_end; }
    double next() {
        REQUIRE(has_more());
        return *m_at++;
    }
    double peek() const {
        REQUIRE(has_more());
        return *m_at;
    }
    void take(Numbers& into, double count) {
        for (double i = 0; i < count; ++i)
            into.push_back(next());
    }

  private:
    const double* m_at;
    const double* m_end;
};

/// @param asked numbers in the answers to the depth test
Numbers read_answer(Stream& stream, rasterwalk_kit::Part part, std::size_t asked) {
    Numbers answer;
    if (part == part_vertex_shader) {
        stream.take(answer, doubles_in_pixel);
    } else if (part == part_interpolate) {
        stream.take(answer, 1);
        stream.take(answer, answer[0] * doubles_in_pixel);
    } else if (part == part_polygon_rows) {
        stream.take(answer, 2);
        stream.take(answer, (answer[0] + answer[1]) * doubles_in_pixel);
    } else if (part == part_draw_rows || part == part_pixel_shader) {
        stream.take(answer, 1);
        stream.take(answer, answer[0] * 5);
    } else {
        stream.take(answer, static_cast<double>(asked));
    }
    return answer;
}

AnswersOfParts read_answers(const Recorded& recorded) {
    AnswersOfParts answers;
    Stream stream(recorded);
    while (stream.has_more()) {
        const auto part = static_cast<rasterwalk_kit::Part>(stream.next());
        REQUIRE(part < part_count);
        if (stream.has_more() && stream.peek() < end_of_part) {
            answers.parts[part].push_back({stream.next()});
        }
        for (double index = 0; stream.has_more() && stream.peek() != end_of_part; ++index) {
            REQUIRE(stream.next() == index);
            if (part != part_globals) {
                answers.parts[part].push_back(read_answer(stream, part, 4));
                continue;
            }
            while (stream.peek() != end_of_part) {
                Numbers& global = answers.globals[static_cast<std::size_t>(stream.next())];
                stream.take(global, stream.next());
            }
        }
        if (stream.has_more()) REQUIRE(stream.next() == end_of_part);
    }
    return answers;
}

/// What direct() said: lines of a part and numbers. They are the first answers of each part.
void check_against_direct(const AnswersOfParts& answers, const std::string& output) {
    std::array<std::size_t, part_count> checked{};
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::size_t part = 0;
        REQUIRE(words >> part);
        Numbers expected;
        for (std::string word; words >> word;)
            expected.push_back(std::stod(word));
        INFO("part " << part << ", answer " << checked[part]);
        REQUIRE(checked[part] < answers.parts[part].size());
        CHECK(answers.parts[part][checked[part]++] == expected);
    }
    for (std::size_t part = part_vertex_shader; part < part_count; ++part) {
        INFO("part " << part);
        CHECK(checked[part] > 0);
    }
}

/// Asks a program everything and checks what it answers.
AnswersOfParts check_program(const std::string& name) {
    INFO(name);
    Memory memory;
    ask_questions(memory);
    const Outcome outcome = run(workshop().compile(name), memory);
    CHECK(outcome.status == 0);
    CHECK(memory.recorded->progress.answered == (1U << part_count) - 2);
    CHECK(memory.recorded->progress.frames == 1);
    AnswersOfParts answers = read_answers(*memory.recorded);
    check_against_direct(answers, outcome.output);
    return answers;
}

Numbers approximately(const Numbers& numbers) {
    Numbers rounded;
    for (const double number : numbers)
        rounded.push_back(std::round(number * 1e4) / 1e4);
    return rounded;
}

} // namespace

TEST_CASE("The driver asks a program with the lab's own names", "[mine]") {
    const AnswersOfParts answers = check_program("classic");
    CHECK(approximately(answers.globals[global_camera]) == Numbers{0, 0, -3.001});
    CHECK(answers.globals[global_yaw] == Numbers{0.25});
    CHECK(answers.globals[global_focal_length] == Numbers{100});
    CHECK(approximately(answers.globals[global_light_position]) == Numbers{0, -0.5, -0.7});
    CHECK(answers.globals[global_light_power] == Numbers{14, 14, 14});
    CHECK(answers.globals[global_indirect] == Numbers{0.5, 0.5, 0.5});
    CHECK(answers.globals[global_screen] == Numbers{100, 80});
    CHECK(answers.globals[global_triangles].size() == 450);
    const double cosine = std::round(std::cos(0.25) * 1e4) / 1e4;
    const double sine = std::round(std::sin(0.25) * 1e4) / 1e4;
    CHECK(approximately(answers.globals[global_rotation]) ==
          Numbers{cosine, 0, sine, 0, 1, 0, -sine, 0, cosine});
}

TEST_CASE("The driver reads constants that are macros", "[mine]") {
    const AnswersOfParts answers = check_program("points");
    CHECK(answers.globals[global_screen] == Numbers{60, 40});
    CHECK(answers.globals[global_focal_length] == Numbers{60});
    CHECK(answers.globals[global_yaw].empty());
}

TEST_CASE("The driver reads the members of a camera and of a light", "[mine]") {
    const AnswersOfParts answers = check_program("per_vertex");
    CHECK(answers.globals[global_camera] == Numbers{0, 0, -3});
    CHECK(answers.globals[global_rotation] == Numbers{1, 0, 0, 0, 1, 0, 0, 0, 1});
    CHECK(answers.globals[global_yaw] == Numbers{0.5});
    CHECK(answers.globals[global_focal_length] == Numbers{60});
    CHECK(approximately(answers.globals[global_light_position]) == Numbers{0, -0.5, -0.7});
    CHECK(approximately(answers.globals[global_light_power]) == Numbers{1.1, 1.1, 1.1});
    CHECK(answers.globals[global_indirect] == Numbers{0.5});
}

TEST_CASE("The driver makes a window for functions that are handed one", "[mine]") {
    const AnswersOfParts answers = check_program("homogeneous");
    CHECK(answers.globals[global_focal_length] == Numbers{48});
    CHECK(answers.globals[global_triangles].empty());
}

TEST_CASE("The driver chooses among overloaded functions and templates", "[mine]") {
    const AnswersOfParts answers = check_program("overloads");
    CHECK(answers.globals[global_screen] == Numbers{40, 30});
    CHECK(answers.globals[global_camera] == Numbers{1, 2, 3});
}

TEST_CASE("The driver finds what is in the unnamed namespace", "[mine]") {
    const AnswersOfParts answers = check_program("hidden");
    CHECK(answers.globals[global_camera] == Numbers{4, 5, 6});
    CHECK(answers.globals[global_yaw] == Numbers{2});
    CHECK(answers.globals[global_light_position] == Numbers{7, 8, 9});
    CHECK(answers.globals[global_focal_length].empty());
    CHECK(answers.globals[global_triangles].size() == 15);
}

TEST_CASE("The driver says what it cannot ask", "[mine]") {
    check_program("unusual");
}

TEST_CASE("The driver asks functions of a second file", "[mine]") {
    const AnswersOfParts answers = check_program("two_files");
    CHECK(answers.globals[global_camera] == Numbers{0, 0, -2});
    CHECK(answers.globals[global_screen] == Numbers{32, 24});
}

TEST_CASE("A crash leaves the answers before it, and other parts can be asked", "[mine]") {
    const std::string program = workshop().compile("crash");
    Memory memory;
    ask_questions(memory);
    const Outcome crashed = run(program, memory);
    REQUIRE(WIFSIGNALED(crashed.status));
    CHECK(WTERMSIG(crashed.status) == SIGABRT);
    const Progress& progress = memory.recorded->progress;
    CHECK(progress.moment == moment_asked);
    CHECK(progress.part == part_interpolate);
    CHECK(progress.question == 1);
    CHECK(progress.answered == (1U << part_globals | 1U << part_vertex_shader));
    const AnswersOfParts answers = read_answers(*memory.recorded);
    REQUIRE(answers.parts[part_interpolate].size() == 1);
    CHECK(answers.parts[part_interpolate][0].front() == 4);
    CHECK(answers.parts[part_interpolate][0].back() == 0);

    Memory again;
    ask_questions(again);
    again.recorded->task.parts = 1U << part_draw_rows;
    CHECK(run(program, again).status == 0);
    CHECK(again.recorded->progress.answered == 1U << part_draw_rows);
    const AnswersOfParts rows = read_answers(*again.recorded);
    REQUIRE(rows.parts[part_draw_rows].size() == 1);
    CHECK(rows.parts[part_draw_rows][0] == Numbers{1, 2, 2, 1, 1, 1});
}

TEST_CASE("A program whose first frame never ends is asked before main()", "[mine]") {
    Memory memory;
    ask_questions(memory);
    memory.recorded->task.before_main = 1;
    CHECK(run(workshop().compile("endless", false), memory).status == 0);
    CHECK(memory.recorded->progress.moment == moment_ended);
    CHECK(memory.recorded->progress.frames == 0);
    const AnswersOfParts answers = read_answers(*memory.recorded);
    CHECK(answers.globals[global_focal_length] == Numbers{10});
    CHECK(answers.globals[global_indirect] == Numbers{0.25, 0.5, 0.75});
    REQUIRE(answers.parts[part_vertex_shader].size() == 2);
    const Numbers& vertex = answers.parts[part_vertex_shader][0];
    CHECK(vertex[1] == int(10 * 0.5 / 2.75) + 15);
    CHECK(vertex[2] == int(10 * -0.25 / 2.75) + 10);
    CHECK(vertex[3] == Approx(1 / 2.75));
    REQUIRE(answers.parts[part_depth_test].size() == 1);
    CHECK(answers.parts[part_depth_test][0] == Numbers{1, 0, 1, 1});
}
