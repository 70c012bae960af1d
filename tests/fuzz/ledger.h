#pragma once

// What was read so far, one line for each part of a run, so that several runs add up and one that
// is killed loses a minute at most.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterwalk::test {

/// The files of one format and one start value.
struct LedgerLine {
    std::string format;
    std::uint32_t start = 0, files = 0, read = 0, findings = 0; ///< a finding is not read
    double seconds = 0.0;                                       ///< of computing time
};

/// The lines of a file that has been appended to; none if there is no such file.
std::vector<LedgerLine> read_ledger(const std::string& path);

/// @return whether the line could be written
bool append(const std::string& path, const LedgerLine& line);

/// The sums of a format's lines; `start` is the first value, from 1, that has no line.
LedgerLine sum_of(const std::vector<LedgerLine>& ledger, std::string_view format);

} // namespace rasterwalk::test
