// The effort of the tests: never none at all.

#include <cstdlib>
#include <string>

#include "tests/support/catch.h"
#include "tests/support/effort.h"

using namespace rasterwalk;

namespace {

/// RASTERWALK_EFFORT as long as this lives.
class Effort {
  public:
    explicit Effort(const char* value) {
        if (const char* before = std::getenv("RASTERWALK_EFFORT")) before_ = before;
        setenv("RASTERWALK_EFFORT", value, 1);
    }
    ~Effort() {
        if (before_.empty())
            unsetenv("RASTERWALK_EFFORT");
        else
            setenv("RASTERWALK_EFFORT", before_.c_str(), 1);
    }
    Effort(const Effort&) = delete;
    Effort& operator=(const Effort&) = delete;

  private:
    std::string before_;
};

} // namespace

TEST_CASE("Rounds follow the effort, but not below the fewest") {
    const auto [text, wanted] = GENERATE(
        table<const char*, int>({{"1", 200}, {"0.5", 100}, {"0.001", 20}, {"0", 20}, {"3", 600}}));
    const Effort effort(text);
    CHECK(test::rounds(200, 20) == wanted);
}

TEST_CASE("A spread selection has the first and the last, each once") {
    const Effort effort("0.1");
    CHECK(test::spread(31, 3) == std::vector<std::size_t>{0, 10, 20, 30});
    CHECK(test::spread(31, 2).size() == 4);
    CHECK(test::spread(5, 2) == std::vector<std::size_t>{0, 4});
    CHECK(test::spread(3, 7) == std::vector<std::size_t>{0, 1, 2});
    CHECK(test::spread(0, 7).empty());
    const Effort full("1");
    CHECK(test::spread(4, 1) == std::vector<std::size_t>{0, 1, 2, 3});
}

TEST_CASE("An effort that is not a number is refused") {
    for (const char* text : {"", "much", "-1", "0.5x", "nan", "1e9"}) {
        INFO(text);
        const Effort effort(text);
        CHECK_THROWS(test::effort());
    }
}
