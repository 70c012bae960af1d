#include <cmath>
#include <string>

#include "laboratory/candidate.h"
#include "support/effort.h"
#include "support/random.h"
#include "tests/support/catch.h"

namespace rasterwalk {

TEST_CASE("What is explained in part is never said to be explained in full") {
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

TEST_CASE("A verdict does not say that all is explained where pixels still differ") {
    Diagnosis diagnosis;
    diagnosis.distance = 1000.0;
    diagnosis.different = 500;
    Hypothesis nearly;
    nearly.id = "B9";
    nearly.name = "Nearly";
    nearly.distance = 0.4; // 99.96 % are explained
    nearly.different = 3;
    rank_candidates({nearly}, "this very picture", diagnosis);
    CHECK(diagnosis.verdict == "Most likely B9 “Nearly”, which explains 99.9 % of the difference.");
}

} // namespace rasterwalk
