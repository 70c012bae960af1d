// `rasterwalk ladder`: its table, its JSON, the race, and what it refuses. No time is tested.

#include <csignal>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "cli/run.h"
#include "engines/ladder/ladder.h"
#include "session/content.h"
#include "tests/support/catch.h"

using namespace rasterwalk;
using namespace rasterwalk::test;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;

namespace {

/// A terminal that presses Ctrl+C when these words are written to it.
class Presser : public std::stringbuf {
  public:
    explicit Presser(std::string words) : words_(std::move(words)) {}

  private:
    int sync() override { return 0; }
    std::streamsize xsputn(const char* text, std::streamsize count) override {
        if (std::string(text, static_cast<std::size_t>(count)).find(words_) != std::string::npos)
            std::raise(SIGINT);
        return count;
    }

    std::string words_;
};

} // namespace

TEST_CASE("ladder prints every rung, what it gains and whether it draws the same") {
    const CliRun result = run({"ladder", "--rounds", "2", "--size", "60x60"});
    CHECK(result.err == "");
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.out, ContainsSubstring("60x60, 2 rounds"));
    for (const auto& list : {ladder(), wrong_turnings()}) {
        for (const Rung& rung : list)
            CHECK_THAT(result.out, ContainsSubstring("\n" + std::string(rung.name)));
    }
    CHECK_THAT(result.out, ContainsSubstring("same picture"));
    CHECK_THAT(result.out, ContainsSubstring("other edges, light of the centre: "));
}

TEST_CASE("ladder --json has every round, and gains that follow from the medians") {
    const CliRun result = run({"ladder", "--rounds", "3", "--size", "60x60", "--json"});
    REQUIRE(result.exit_code == 0);
    const json answer = json::parse(result.out);
    CHECK(answer["rounds"] == 3);
    CHECK(answer["size"] == "60x60");
    CHECK(answer["machine"]["processor"] != "");
    const json& rungs = answer["rungs"];
    REQUIRE(rungs.size() == ladder().size() + wrong_turnings().size());
    CHECK(rungs[0]["gain"].is_null());
    for (std::size_t i = 1; i < ladder().size(); ++i) {
        const json &before = rungs[i - 1], &rung = rungs[i];
        CAPTURE(rung["name"].get<std::string>());
        CHECK(rung["milliseconds"].size() == 3);
        CHECK(rung["gain"].get<double>() ==
              before["median"].get<double>() / rung["median"].get<double>());
        CHECK(rung["gain_in_all"].get<double>() ==
              rungs[0]["median"].get<double>() / rung["median"].get<double>());
        CHECK((rung["differ"] > 0) == ladder()[i].has_other_edges);
    }
}

TEST_CASE("ladder --rung prints one rung, with what changed and why it helped") {
    const CliRun result =
        run({"ladder", "--rounds", "1", "--size", "20x20", "--rung", "one_division"});
    CHECK(result.exit_code == 0);
    const Rung& rung = *find_rung("one_division");
    CHECK_THAT(result.out, ContainsSubstring(std::string(rung.change)));
    CHECK_THAT(result.out, ContainsSubstring(std::string(rung.why)));
    CHECK_THAT(result.out, ContainsSubstring("src/engines/ladder/one_division.cpp"));
    CHECK_THAT(result.out, !ContainsSubstring("\nno_vectors "));
}

TEST_CASE("ladder --race prints the wrong pixels of each run") {
    const CliRun result = run({"ladder", "--race", "3", "--json"});
    CHECK(result.exit_code == 0);
    const json answer = json::parse(result.out);
    CHECK(answer["pixels"] == 250'000);
    CHECK(answer["wrong"].size() == (ladder_threads() == 1 ? 0 : 3));
}

TEST_CASE("What the ladder cannot draw, and meaningless options, are wrong usage") {
    const CliRun turned = run({"ladder", "--set", "camera.yaw=0.2"});
    CHECK(turned.exit_code == 2);
    CHECK(turned.out == "");
    CHECK_THAT(turned.err, ContainsSubstring("a camera that is turned"));
    for (const std::string option : {"--rounds", "--race"}) {
        for (const std::string value : {"0", "1001", "x"}) {
            const CliRun result = run({"ladder", option, value});
            CAPTURE(option, value);
            CHECK(result.exit_code == 2);
            CHECK_THAT(result.err, ContainsSubstring(option));
        }
    }
    for (const std::vector<std::string>& with : {std::vector<std::string>{"--rounds", "3"},
                                                 {"--rung", "bands"},
                                                 {"--size", "60x60"},
                                                 {lessons_folder() + "/scenes/lab-room.toml"}}) {
        std::vector<std::string> words{"ladder", "--race", "3"};
        words.insert(words.end(), with.begin(), with.end());
        const CliRun result = run(words);
        CAPTURE(with.front());
        CHECK(result.exit_code == 2);
        CHECK(result.out == "");
        CHECK_THAT(result.err, ContainsSubstring("--race"));
    }
    const CliRun misspelled = run({"ladder", "--rung", "no_vector"});
    CHECK(misspelled.exit_code == 2);
    CHECK_THAT(misspelled.err, ContainsSubstring("no_vectors"));
}

TEST_CASE("ladder ends with 130 after Ctrl+C and prints what it has") {
    std::signal(SIGINT, SIG_DFL); // where it is ignored, it is no interrupt
    Presser presser("1 of");      // when the second round begins
    std::ostream terminal(&presser);
    const CliRun result =
        run({"ladder", "--rounds", "50", "--size", "20x20", "--json"}, {}, &terminal);
    CHECK(result.exit_code == 130);
    CHECK(json::parse(result.out)["rounds"] == 1);
}

TEST_CASE("After Ctrl+C, nothing is said about pictures that no rung has drawn") {
    std::signal(SIGINT, SIG_DFL); // where it is ignored, it is no interrupt
    Presser presser("0 of");      // before the first picture
    std::ostream terminal(&presser);
    const CliRun text = run({"ladder", "--size", "20x20"}, {}, &terminal);
    CHECK(text.exit_code == 130);
    CHECK_THAT(text.out, ContainsSubstring("\nbands\n"));
    CHECK_THAT(text.out, !ContainsSubstring("same picture"));
    const CliRun result = run({"ladder", "--size", "20x20", "--json"}, {}, &terminal);
    CHECK(result.exit_code == 130);
    const json rung = json::parse(result.out)["rungs"].back();
    CHECK(rung["differ"].is_null());
    CHECK(rung["largest"].is_null());
    CHECK(rung["median"].is_null());
}
