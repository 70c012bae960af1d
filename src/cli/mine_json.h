#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/json.h"
#include "mine/checked_program.h"

namespace rasterwalk {

/// Everything that is known about a program. The page and the merged table are made from it.
Json to_json(const CheckedProgram& checked, const std::vector<Bug>& bugs);

/// A row for a hand-in that cannot be checked, and why.
Json row_not_checked(const StudentFiles& files, const std::string& fault);

/// The programs in files that `mine --json` has printed, one after the other, sorted by name.
/// Throws AccessError, or InputError for a file that holds anything else.
Json merged_tables(const std::vector<std::string>& paths);

/// Is this member of a table true? Not if it is missing, or anything else.
bool is_set(const Json& object, const char* key);

/// A text, or the texts of a list, of an object of a table; empty if it has none.
std::string text_of(const Json& object, const char* key);
std::vector<std::string> texts_of(const Json& object, const char* key);

/// Why a program of a table was not checked, a sentence; empty: it was.
std::string fault_of(const Json& program);

/// "right", "differs", "not judged" or "not checked".
std::string_view verdict_words(const Json& program);

/// A page with a table of these programs, which needs no other file.
std::string html_page(const Json& programs);

} // namespace rasterwalk
