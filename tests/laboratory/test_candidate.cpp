#include <cmath>
#include <string>

#include "laboratory/candidate.h"
#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"

namespace rasterwalk {

TEST_CASE("A partial explanation is never reported as a full one") {
    CHECK(explained_text(1.0, 0) == "100 %");
    CHECK(explained_text(1.0, 1) == "100.0 %");
    CHECK(explained_text(0.874, 0) == "87 %");
    CHECK(explained_text(0.874, 1) == "87.4 %");
    CHECK(explained_text(0.996, 0) == "99.6 %");
    CHECK(explained_text(0.9997, 0) == "99.9 %");
    CHECK(explained_text(0.99999999, 1) == "99.9 %");
    CHECK(explained_text(0.0, 1) == "0.0 %");
    test::Random random(31);
    for (int i = 0; i < test::rounds(2000, 100); ++i) {
        const double part = 1.0 - std::pow(10.0, random.number(-12.0f, 0.0f));
        for (const int digits : {0, 1}) {
            const double said = std::stod(explained_text(part, digits));
            INFO(part << ", " << digits << " digits: " << said);
            CHECK(said < 100.0);
            CHECK(std::abs(said - 100.0 * part) <= (digits == 0 ? 0.5 : 0.1));
        }
    }
}

namespace {
namespace candidates {

Hypothesis made_by(std::vector<std::string> ids, std::int64_t left, std::uint64_t result) {
    Hypothesis h;
    for (const std::string& id : ids)
        h.candidate.mistakes.push_back({{id}, {"Name of " + id}});
    h.candidate.distance = static_cast<double>(left) / 1000.0;
    h.candidate.different = left;
    h.candidate.explained = 1.0 - static_cast<double>(left) / 500.0;
    h.candidate.is_likely = h.candidate.explained >= explains_nearly_all;
    h.assumed = static_cast<double>(ids.size());
    h.price = static_cast<double>(left) + h.assumed;
    h.result = result;
    h.is_of_bugs = true;
    return h;
}

std::string verdict(std::vector<Hypothesis> hypotheses) {
    Diagnosis diagnosis;
    diagnosis.different = 500;
    diagnosis.candidates = ranked(std::move(hypotheses));
    return verdict_on(diagnosis);
}

TEST_CASE("A verdict does not say that all is explained where pixels still differ") {
    CHECK(verdict({made_by({"B9"}, 3, 1)}) ==
          "Most likely B9 “Name of B9”, which explains 99 % of the difference.");
    CHECK(verdict({made_by({"B9"}, 0, 1)}) == "Exact match: B9 “Name of B9”.");
    CHECK(verdict({made_by({"B9"}, 100, 1)}) ==
          "No known mistake explains the difference; the best match, B9 “Name of B9”, explains 80 "
          "% of it.");
    CHECK(verdict({made_by({"B9"}, 400, 1)}) == "No known mistake explains the difference.");
}

TEST_CASE("Mistakes with the same result are one candidate, under all their names") {
    CHECK(verdict({made_by({"B9"}, 0, 1), made_by({"B8"}, 0, 1)}) ==
          "Exact match: B9 “Name of B9” or B8 “Name of B8”.");
    CHECK(verdict({made_by({"B9", "B3"}, 0, 1), made_by({"B9", "B4"}, 0, 1)}) ==
          "Exact match: B9 “Name of B9” together with B3 “Name of B3” or B4 “Name of B4”.");
}

TEST_CASE("A candidate that adds nothing to a better one is not listed") {
    // A second mistake that leaves more differences, the same mistake alone, and one that is no
    // better.
    const std::vector<Candidate> listed =
        ranked({made_by({"B3"}, 50, 1), made_by({"B3", "B9"}, 60, 2), made_by({"B5"}, 90, 3),
                made_by({"B5"}, 95, 4), made_by({"B8"}, 500, 5)});
    REQUIRE(listed.size() == 2);
    CHECK(listed[0].ids() == std::vector<std::string>{"B3"});
    CHECK(listed[1].ids() == std::vector<std::string>{"B5"});
    // Next to a candidate that makes exactly the same picture, no other explains more.
    CHECK(ranked({made_by({"B3", "B9"}, 0, 1), made_by({"B5"}, 90, 3)}).size() == 1);
}

} // namespace candidates
} // namespace

} // namespace rasterwalk
