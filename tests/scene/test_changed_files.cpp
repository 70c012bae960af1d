// Files of every supported format, changed at random: each is read or refused as it should be.
// tests/fuzz/fuzz does the same with many more, under sanitizers.

#include "support/changed_files.h"

#include <string>

#include <fmt/format.h>

#include "support/limited_memory.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

using namespace rasterwalk;

TEST_CASE("Changed files of every format are read or refused, within their bounds") {
    const test::TemporaryFolder folder;
    test::lay_out(folder);
    for (const test::ChangedFormat& format : test::changed_formats()) {
        const int count = test::rounds(1000, 50);
        const std::string said = test::output_within(test::most_memory, [&]() -> std::string {
            int read = 0, refused = 0;
            for (int i = 0; i < count; ++i) {
                const auto number = static_cast<std::uint32_t>(i);
                const std::string bytes = test::changed_file(format, number);
                const test::FileOutcome outcome = test::outcome_of(format, bytes, folder);
                if (!outcome.problem.empty()) return fmt::format("file {}: {}", i, outcome.problem);
                ++(outcome.is_read ? read : refused);
            }
            // Most changes leave no text of a format that has words of its own only.
            const int fewest = count / 50;
            if (read < fewest || (format.can_refuse && refused < fewest))
                return fmt::format("of {} files {} are read, {} refused.", count, read, refused);
            return "";
        });
        INFO(format.name);
        CHECK(said == "");
    }
}

TEST_CASE("Every seed from which files are changed is read") {
    const test::TemporaryFolder folder;
    test::lay_out(folder);
    for (const test::ChangedFormat& format : test::changed_formats()) {
        for (std::size_t i = 0; i < format.seeds.size(); ++i) {
            INFO(format.name << ", seed " << i);
            const test::FileOutcome outcome = test::outcome_of(format, format.seeds[i], folder);
            CHECK(outcome.problem == "");
            CHECK(outcome.is_read);
        }
    }
}
