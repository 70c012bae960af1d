#include "ledger.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

namespace rasterwalk::test {

std::vector<LedgerLine> read_ledger(const std::string& path) {
    std::vector<LedgerLine> ledger;
    std::ifstream file(path);
    for (std::string text; std::getline(file, text);) {
        LedgerLine line;
        std::uint32_t refused = 0;
        if (std::istringstream(text) >> line.format >> line.start >> line.files >> line.read >>
            refused >> line.findings >> line.seconds)
            ledger.push_back(line);
    }
    return ledger;
}

bool append(const std::string& path, const LedgerLine& line) {
    std::ofstream file(path, std::ios::app);
    file << fmt::format("{} {} {} {} {} {} {:.1f}\n", line.format, line.start, line.files,
                        line.read, line.files - line.read - line.findings, line.findings,
                        line.seconds);
    return file.flush().good();
}

LedgerLine sum_of(const std::vector<LedgerLine>& ledger, std::string_view format) {
    LedgerLine sum{std::string(format)};
    std::vector<std::uint32_t> starts;
    for (const LedgerLine& line : ledger) {
        if (line.format != format) continue;
        starts.push_back(line.start);
        sum.files += line.files;
        sum.read += line.read;
        sum.findings += line.findings;
        sum.seconds += line.seconds;
    }
    sum.start = 1;
    while (std::find(starts.begin(), starts.end(), sum.start) != starts.end())
        ++sum.start;
    return sum;
}

} // namespace rasterwalk::test
