// `rasterwalk engines` with stand-ins for llvmpipe's program: shell scripts with the same output.
// Whether llvmpipe itself draws the same is tested in tests/pictures.

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/interrupt.h"
#include "cli/run.h"
#include "engines/measure.h"
#include "engines/own_engines.h"
#include "engines/workload.h"
#include "scene/read_scene.h"
#include "session/content.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;

namespace {

constexpr int side = 20;

/// During its lifetime, this script stands in for the peer's program.
class StandIn {
  public:
    explicit StandIn(const std::string& script) {
        use(folder_.write("peer", "#!/bin/sh\n" + script));
    }
    ~StandIn() { unsetenv("RASTERWALK_LLVMPIPE"); }
    StandIn(const StandIn&) = delete;
    StandIn& operator=(const StandIn&) = delete;

    static void use(const std::string& program) {
        std::error_code ignored;
        std::filesystem::permissions(program, std::filesystem::perms::owner_all, ignored);
        setenv("RASTERWALK_LLVMPIPE", program.c_str(), 1);
    }

  private:
    TemporaryFolder folder_;
};

/// Four bytes for each pixel of the lit room as the steps draw it.
std::string bytes_of_room() {
    const Scene room =
        workload_scene(Workload::w1, read_scene(lessons_folder() + '/' + std::string(usual_scene)));
    const Settings settings = workload_settings(Workload::w1, room, {side, side});
    std::string bytes;
    for (const std::uint32_t colour :
         steps_engine(room, settings)->picture(compared_picture).colour)
        for (const int shift : {0, 8, 16, 24})
            bytes += static_cast<char>(colour >> shift & 0xffU);
    return bytes;
}

/// Answers with this picture, and says that every round takes it 2 and 3 milliseconds.
std::string answering_script(const std::string& picture_path) {
    return "echo ready a stand-in\n"
           "while read -r word rest; do case $word in\n"
           "round) echo 2 3 ;;\n"
           "picture) echo bytes 1600; cat '" +
           picture_path + "' ;;\nesac; done\n";
}

const std::vector<std::string> small_run{"engines",   "--workload", "w1",     "--size", "20x20",
                                         "--threads", "1",          "--simd", "scalar"};

CliRun run_small(const std::string& more = {}) {
    std::vector<std::string> arguments = small_run;
    if (!more.empty()) arguments.push_back(more);
    return run(arguments);
}

} // namespace

TEST_CASE("engines --json gives the machine, the method and the results") {
    const TemporaryFolder folder;
    const StandIn peer(answering_script(folder.write("picture", bytes_of_room())));
    const CliRun result = run_small("--json");
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    const json answer = json::parse(result.out);
    CHECK(answer["command"] ==
          "rasterwalk engines --simd scalar --threads 1 --size 20x20 --workload w1 --json");
    CHECK(answer["machine"]["processor"] != "");
    CHECK(answer["machine"]["processors"] >= 1);
    CHECK(answer["machine"]["simd"][0] == "scalar");
    REQUIRE(answer["measurements"].size() == 1);
    const json& measurement = answer["measurements"][0];
    CHECK(measurement["workload"] == "w1");
    CHECK(measurement["size"] == "20x20");
    CHECK(measurement["threads"] == 1);
    CHECK(measurement["time"] == "processor");
    CHECK(measurement["rounds"] == 5);
    CHECK(measurement["llvmpipe"] == "a stand-in");
    REQUIRE(measurement["engines"].size() == 4);
    const json &student = measurement["engines"][0], &steps = measurement["engines"][1],
               &fast = measurement["engines"][2], &last = measurement["engines"][3];
    CHECK(student["engine"] == "student");
    CHECK(student["ratio"].is_null());
    CHECK_THAT(student["remark"].get<std::string>(), ContainsSubstring("draws different edges: "));
    CHECK(steps["engine"] == "steps");
    CHECK(steps["from_llvmpipe"]["differ"] == 0);
    CHECK(steps["from_llvmpipe"]["pixels"] == 400);
    CHECK(steps["ratio"].get<double>() * steps["milliseconds"].get<double>() ==
          Approx(last["milliseconds"].get<double>()));
    CHECK(fast["engine"] == "fast scalar");
    CHECK(last["engine"] == "llvmpipe");
    CHECK(last["from_llvmpipe"].is_null());
    CHECK(last["ratio"].is_null());
}

TEST_CASE("A picture that differs is exit code 1, and the difference is shown in place of ratios") {
    const TemporaryFolder folder;
    std::string bytes = bytes_of_room();
    bytes.replace(4 * side, 40, std::string(40, '\0')); // ten pixels of row 1
    const StandIn peer(answering_script(folder.write("picture", bytes)));
    const CliRun result = run_small();
    CHECK(result.exit_code == 1);
    CHECK_THAT(result.out, ContainsSubstring("draws something different: 10 of 400 pixels differ"));
    CHECK_THAT(result.out, ContainsSubstring("the first at 0,1"));
}

TEST_CASE(
    "A peer that is missing, stops early or talks nonsense gives a sentence and exit code 4") {
    const auto complaint = [] {
        const CliRun result = run_small();
        CHECK(result.exit_code == 4);
        CHECK(result.out.empty());
        return result.err;
    };
    {
        const StandIn peer("");
        StandIn::use("/nowhere/rasterwalk-llvmpipe");
        CHECK(complaint() == "rasterwalk: cannot start '/nowhere/rasterwalk-llvmpipe': No such "
                             "file or directory.\n");
    }
    {
        const StandIn peer("exit 4\n");
        CHECK_THAT(complaint(), ContainsSubstring("ended with exit code 4"));
    }
    {
        const StandIn peer("echo ready a stand-in; read -r line; kill -SEGV $$\n");
        CHECK_THAT(complaint(), ContainsSubstring("Segmentation fault"));
    }
    {
        const StandIn peer("echo good morning; exec sleep 1000\n");
        CHECK_THAT(complaint(), ContainsSubstring("'good morning'"));
    }
    {
        const StandIn peer("echo ready; while read -r line; do echo 1; done\n");
        CHECK_THAT(complaint(), ContainsSubstring("gave an unexpected answer"));
    }
}

TEST_CASE("Meaningless options of engines are wrong usage") {
    const auto complaint = [](const std::string& option, const std::string& value) {
        const CliRun result = run({"engines", option, value});
        CHECK(result.exit_code == 2);
        return result.err;
    };
    CHECK_THAT(complaint("--workload", "w4"), ContainsSubstring("there is no workload 'w4'"));
    CHECK_THAT(complaint("--simd", "mmx"), ContainsSubstring("'mmx'; choose from scalar"));
    CHECK_THAT(complaint("--threads", "3"),
               ContainsSubstring("--threads must be a whole number from 1 "
                                 "to 2, not '3'"));
    CHECK_THAT(complaint("--rounds", "4"), ContainsSubstring("from 5 to 1000"));
    CHECK_THAT(complaint("--rounds", "many"), ContainsSubstring("'many'"));
    CHECK_THAT(complaint("--size", "0x0"), ContainsSubstring("0x0"));
    CHECK(run({"engines", "extra"}).exit_code == 2);
}

TEST_CASE("After Ctrl+C engines ends with 130 and prints what it has") {
    // The peer presses it the third time it is asked how long something took.
    const TemporaryFolder folder;
    std::string script = answering_script(folder.write("picture", bytes_of_room()));
    const std::string answer = "round) echo 2 3 ;;";
    script.replace(script.find(answer), answer.size(),
                   "round) n=$((n + 1)); [ $n -lt 5 ] || kill -INT $PPID; echo 2 3 ;;");
    const StandIn peer(script);
    std::vector<std::string> arguments = small_run;
    arguments.insert(arguments.end(), {"--rounds", "1000", "--json"});
    const CliRun result = run(arguments);
    CHECK(result.exit_code == 130);
    const json answer_json = json::parse(result.out);
    REQUIRE(answer_json["measurements"].size() == 1);
    const int rounds = answer_json["measurements"][0]["rounds"];
    CHECK(rounds >= 2);
    CHECK(rounds < 1000);
}

TEST_CASE("Ctrl+C is noted, however often, and the previous handler is then restored") {
    std::signal(SIGINT, SIG_IGN);
    {
        const Interrupt interrupt;
        std::raise(SIGINT);
        CHECK_FALSE(interrupt.was_interrupted()); // ignored, as nohup wants it
    }
    std::signal(SIGINT, SIG_DFL);
    {
        const Interrupt interrupt;
        CHECK_FALSE(interrupt.was_interrupted());
        std::raise(SIGINT);
        std::raise(SIGINT); // as `timeout -s INT` sends it to a program and to its group
        CHECK(interrupt.was_interrupted());
    }
    CHECK(std::signal(SIGINT, SIG_DFL) == SIG_DFL);
}
