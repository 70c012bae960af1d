#include "mine/compile/compile.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"
#include "mine/compile/compile_messages.h"
#include "mine/compile/compiler_run.h"
#include "mine/compile/fingerprint.h"
#include "mine/compile/kit_files.h"
#include "mine/compile/program_build.h"
#include "mine/compile/project_folder.h"
#include "mine/compile/source_text.h"
#include "mine/compile/two_at_a_time.h"

namespace rasterwalk {

namespace {

/// Is it a file of the student's?
bool is_own(const std::string& file, const StudentFiles& files) {
    // Its #line may name anything.
    const bool is_plain = file.starts_with('/') && file.find("/../") == file.npos;
    return is_plain && is_below(file, files.folder);
}

/// Puts a message where the student's file led to it; false: none did. A message of the linker that
/// has no place belongs to the program as a whole.
bool move_to_student(SaidMessage& said, const StudentFiles& files) {
    CompileMessage& message = said.message;
    if (is_own(message.file, files)) {
        // The student's definition meets one of the kit's: not the student's fault.
        const bool meets_kit = message.text.find("redefinition of") != std::string::npos ||
                               message.text.find("redeclaration of") != std::string::npos ||
                               message.text.find("conflicting declaration") != std::string::npos;
        return !(meets_kit && !said.notes.empty() && !is_own(said.notes.front().file, files));
    }
    for (const SaidMessage::Place& place : said.through) {
        if (!is_own(place.file, files)) continue;
        message.file = place.file;
        message.line = place.line;
        message.column = 0;
        return true;
    }
    return message.file.empty() && (message.text.starts_with("undefined reference to ") ||
                                    message.text.starts_with("multiple definition of "));
}

/// The messages about the student's files, and whether there are errors elsewhere.
struct Judged {
    std::vector<CompileMessage> messages;
    bool has_own_error = false;
    bool has_foreign_error = false;
};

Judged judge(const BuildOutcome& outcome, const StudentFiles& files) {
    Judged judged;
    for (SaidMessage said : outcome.said) {
        const bool is_students = move_to_student(said, files);
        const bool is_error = said.message.is_error;
        (is_students ? judged.has_own_error : judged.has_foreign_error) |= is_error;
        if (is_students && judged.messages.size() < most_messages) {
            judged.messages.push_back(said.message);
        }
    }
    return judged;
}

/// Names that C++ got after C++14 and that meet a student's, such as size and byte, and what it
/// no longer allows.
bool is_about_standard(const std::vector<CompileMessage>& messages) {
    return std::any_of(messages.begin(), messages.end(), [](const CompileMessage& message) {
        return message.is_error && (message.text.find("is ambiguous") != std::string::npos ||
                                    message.text.find("ISO C++17") != std::string::npos ||
                                    message.text.find("ISO C++1z") != std::string::npos);
    });
}

bool has_word(std::string_view text, std::string_view word) {
    const auto is_letter = [text](std::size_t at) {
        return at < text.size() &&
               (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
    };
    for (std::size_t at = text.find(word); at != std::string_view::npos;
         at = text.find(word, at + 1)) {
        if ((at == 0 || !is_letter(at - 1)) && !is_letter(at + word.size())) return true;
    }
    return false;
}

/// Does an error name something that only the student's own helper has?
bool is_about_own_helper(const std::vector<CompileMessage>& messages,
                         const std::vector<std::string>& own_files) {
    std::string helper;
    for (const std::string& file : own_files)
        helper += read_source(file) + "\n";
    for (const CompileMessage& message : messages) {
        const std::size_t quote = message.text.find('\'');
        if (!message.is_error || quote == std::string::npos) continue;
        // Both names: "'class SDL2Aux' has no member named 'draw'".
        std::string_view rest = std::string_view(message.text).substr(quote);
        rest = rest.substr(0, rest.find('\n'));
        while (!rest.empty()) {
            rest.remove_prefix(std::min(rest.size(), rest.find('\'')));
            if (rest.empty()) break;
            const std::size_t end = rest.find('\'', 1);
            if (end == std::string_view::npos) break;
            const std::string_view name = rest.substr(1, end - 1);
            rest.remove_prefix(end + 1);
            const auto knows = [name](const KitFile& file) { return has_word(file.text, name); };
            const std::vector<KitFile>& kit = kit_files();
            if (!name.empty() && has_word(helper, name) &&
                std::none_of(kit.begin(), kit.end(), knows)) {
                return true;
            }
        }
    }
    return false;
}

std::string work_folder(const StudentFiles& files, const Compiler& compiler,
                        Instrumented instrumented) {
    const std::string project = Fingerprint().add(files.folder).add(files.main).text();
    const std::string above = fmt::format("{}/mine/{}", cache_folder(), project);
    std::string folder = above + (instrumented == Instrumented::no ? "/plain" : "/sanitized");
    if (compiler.is_clang) folder += "-clang";
    make_folder(folder);
    mark_used(above);
    return folder;
}

/// Tries one way after the other.
class Attempts {
  public:
    Attempts(const StudentFiles& files, BuildPlace place)
        : files_(files), place_(std::move(place)) {
        compiled_.compiler = place_.compiler.version;
        compiled_.is_guarded_by_landlock = true;
    }

    Compiled run();

  private:
    bool is_over(BuildWay way);
    void report();

    const StudentFiles& files_;
    BuildPlace place_;
    Compiled compiled_;
    BuildOutcome outcome_;
    Judged judged_;
};

/// Builds it this way; true if there is nothing left to try: it compiles, or the compiler was
/// stopped.
bool Attempts::is_over(BuildWay way) {
    outcome_ = build_program(files_, place_, way);
    judged_ = judge(outcome_, files_);
    compiled_.is_guarded_by_landlock = compiled_.is_guarded_by_landlock && outcome_.has_landlock;
    if (outcome_.is_stopped) {
        compiled_.messages.clear();
        return true;
    }
    if (!outcome_.program.empty()) {
        compiled_.program = outcome_.program;
        compiled_.kit = way.kit;
        compiled_.messages = judged_.messages;
        return true;
    }
    if (outcome_.ended.empty()) return false;
    CompileMessage message;
    message.text = outcome_.ended;
    compiled_.messages = {message};
    return true;
}

/// Takes the messages of the last way tried.
void Attempts::report() {
    compiled_.messages = judged_.messages;
    if (judged_.has_own_error) return;
    // None is about the student's files: better those than no reason at all.
    compiled_.messages.clear();
    for (const SaidMessage& said : outcome_.said) {
        if (!said.message.is_error || compiled_.messages.size() == most_messages) continue;
        compiled_.messages.push_back(said.message);
    }
}

Compiled Attempts::run() {
    // A sanitized program is not asked, and the driver takes a third of its compiling.
    bool needs_no_driver = place_.instrumented == Instrumented::sanitized;
    if (!needs_no_driver) {
        if (is_over({KitUse::with_driver, false})) return compiled_;
        needs_no_driver = judged_.has_foreign_error || !judged_.has_own_error;
    }
    if (needs_no_driver && is_over({KitUse::kit_only, false})) return compiled_;
    report();
    const Judged first = judged_;
    const std::vector<std::string> own_files = outcome_.copies.own_files;
    const std::vector<CompileMessage> messages = compiled_.messages;

    if (is_about_standard(first.messages)) {
        if (is_over({KitUse::kit_only, true})) return compiled_;
    }
    const bool is_kits_fault = first.has_foreign_error || !first.has_own_error;
    if (is_kits_fault || is_about_own_helper(first.messages, own_files)) {
        if (is_over({KitUse::own_helper, false})) return compiled_;
    }
    compiled_.messages = messages;
    return compiled_;
}

} // namespace

Compiled compile_student_program(const StudentFiles& files, const Compiler& compiler,
                                 Instrumented instrumented,
                                 const std::function<bool()>& is_stopped) {
    const auto start = std::chrono::steady_clock::now();
    BuildPlace place;
    place.work = work_folder(files, compiler, instrumented);
    place.compiler = compiler;
    place.instrumented = instrumented;
    place.is_stopped = asked_one_at_a_time(is_stopped);
    Compiled compiled = Attempts(files, place).run();
    compiled.time = std::chrono::duration_cast<std::chrono::milliseconds>(
        std::chrono::steady_clock::now() - start);
    return compiled;
}

} // namespace rasterwalk
