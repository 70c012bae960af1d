#include <cstdlib>
#include <filesystem>
#include <string>

#include "cli/json.h"
#include "lessons/progress.h"
#include "session/content.h"
#include "tests/cli/run.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace rasterwalk;
using namespace rasterwalk::test;

namespace {

/// During the test, what is kept between runs goes to this folder.
class OwnState {
  public:
    OwnState() {
        if (const char* before = std::getenv("XDG_STATE_HOME")) before_ = before;
        setenv("XDG_STATE_HOME", folder_.file("state").c_str(), 1);
        std::filesystem::create_directories(folder_.file("state/rasterwalk"));
    }
    ~OwnState() {
        if (before_.empty()) {
            unsetenv("XDG_STATE_HOME");
        } else {
            setenv("XDG_STATE_HOME", before_.c_str(), 1);
        }
    }
    OwnState(const OwnState&) = delete;
    OwnState& operator=(const OwnState&) = delete;

    std::string progress() const { return folder_.file("state/rasterwalk/progress.toml"); }

  private:
    TemporaryFolder folder_;
    std::string before_;
};

} // namespace

TEST_CASE("'rasterwalk lessons' lists the lessons and their progress") {
    const OwnState state;
    const CliRun fresh = run({"lessons"});
    CHECK(fresh.exit_code == 0);
    CHECK(fresh.err.empty());
    CHECK(fresh.out.find("05-row-table  ") != std::string::npos);
    CHECK(fresh.out.find("Done.") == std::string::npos);
    CHECK(fresh.out.find("The lab: 13 lessons, ") == 0);
    const std::size_t second_track = fresh.out.find("\nThe machine underneath: 9 lessons, ");
    CHECK(fresh.out.find("13-reading-a-bug  ") < second_track);
    CHECK(second_track < fresh.out.find("14-arrows  "));
    CHECK(fresh.out.find("04-edges  ") < fresh.out.find("02-moving-the-camera  "));
    CHECK(fresh.out.find("02-moving-the-camera  ") < fresh.out.find("05-row-table  "));

    Progress progress;
    const Lesson edges = read_lesson(lessons_folder() + "/04-edges.md");
    for (int step = 0; step < static_cast<int>(edges.steps.size()); ++step)
        progress.record_step(edges.id, step);
    for (const LessonTask& task : edges.tasks)
        progress.record_task(edges.id, task.id);
    for (const LessonPuzzle& puzzle : edges.puzzles)
        progress.record_task(edges.id, puzzle.id);
    for (const LessonPrediction& prediction : edges.predictions)
        progress.record_answer(edges.id, prediction.id, {"1", false});
    progress.record_step("05-row-table", 2);
    progress.record_step("99-gone", 1);
    write_progress({}, progress, state.progress());
    const CliRun later = run({"lessons"});
    CHECK(later.err.empty());
    CHECK(later.out.find("04-edges  " + edges.title) == later.out.find("04-edges"));
    CHECK(later.out.find("    Done.\n") != std::string::npos);
    CHECK(later.out.find("So far 1 of 9 steps, 0 of ") != std::string::npos);
    CHECK(later.out.find("99-gone") == std::string::npos);

    const CliRun json = run({"lessons", "--json"});
    CHECK(json.exit_code == 0);
    CHECK(json.out.find("\"id\" : \"04-edges\"") != std::string::npos);
    CHECK(json.out.find("\"done\" : true") != std::string::npos);
    CHECK(json.out.find("\"track\" : \"The lab\"") != std::string::npos);
    const Json lessons = Json::parse(json.out).at("lessons");
    CHECK(lessons.at(4).at("id") == "05-row-table");
    CHECK(lessons.at(4).at("needs") == Json::array({"04-edges"}));
}

TEST_CASE("'rasterwalk lessons' warns about progress that cannot be read, and goes on") {
    const OwnState state;
    std::ofstream(state.progress()) << "lessons = 5\n";
    const CliRun result = run({"lessons"});
    CHECK(result.exit_code == 0);
    CHECK(result.err == "rasterwalk: your progress cannot be read: " + state.progress() +
                            ":1: the lessons must be a table.\n");
    CHECK(result.out.find("01-pinhole-camera") != std::string::npos);
}
