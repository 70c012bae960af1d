#pragma once

// Small files of every supported format, and other texts from outside, changed at random, and what
// must be true for each of them: it is read with a sound result, or it is refused with a sentence;
// and within the bounds. A test tries a few hundred of each format, tests/fuzz/fuzz as many as
// requested.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "support/temporary_folder.h"

namespace rasterwalk::test {

/// A changed file may cost this much computing time, seconds, and this much memory, bytes.
inline constexpr double most_seconds = 2.0;
inline constexpr std::size_t most_memory = std::size_t{200} << 20;

/// The outcome of a file.
struct FileOutcome {
    bool is_read = false; ///< or refused; a file of materials, of which only what is wrong is left
                          ///< out, is read if there is nothing wrong
    std::string problem;  ///< what is wrong with that; empty: nothing
};

/// A format of files, or of texts that are in no file.
struct ChangedFormat {
    std::string name;               ///< "PNG"
    std::vector<std::string> seeds; ///< sound files, at least one
    std::vector<std::string> words; ///< pieces that trip up readers
    FileOutcome (*read)(const std::string& bytes, const TemporaryFolder& folder);
    bool can_refuse = true; ///< or any text is read
};

/// All formats, see changed_formats.h.
std::vector<ChangedFormat> changed_formats();

/// A seed with one to six changes, more often few: bytes and words that are put in, left out or
/// doubled, an end that is missing, or another number.
/// @param number of the file: the same number makes the same file
std::string changed_file(const ChangedFormat& format, std::uint32_t number);

/// Reads the bytes as a file of a format. Too much computing time is trouble, too; so is any
/// exception but the one that refuses bad input.
/// @param folder of the files that others name; see lay_out()
FileOutcome outcome_of(const ChangedFormat& format, const std::string& bytes,
                       const TemporaryFolder& folder);

/// Writes the files that models, materials and scenes name.
void lay_out(const TemporaryFolder& folder);

} // namespace rasterwalk::test
