#include "cli/mine_command.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <ostream>
#include <string_view>

#include <fmt/format.h>

#include "base/files.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "cli/interrupt.h"
#include "cli/mine_json.h"
#include "mine/checked_program.h"
#include "mine/compile/kit_files.h"
#include "mine/source_lines.h"
#include "stages/stages.h"

namespace rasterwalk {

namespace {

/// "skeleton.cpp:142: ", relative to the program's folder; empty if the place is not known.
std::string place_prefix(const StudentFiles& files, const ProgramPlace& place) {
    if (place.line == 0) return {};
    return fmt::format("{}:{}: ", shown_path(files, place.file), place.line);
}

void print_messages(const StudentFiles& files, const std::vector<CompileMessage>& messages,
                    std::ostream& out) {
    const bool has_error = std::any_of(messages.begin(), messages.end(),
                                       [](const CompileMessage& one) { return one.is_error; });
    if (!has_error) out << "The compiler says more than is kept; the error is not in what is.\n";
    for (const CompileMessage& message : messages) {
        if (!message.is_error) continue;
        out << place_prefix(files, {{}, message.file, message.line}) << message.text << '\n';
        if (!message.cause.empty()) out << "    " << message.cause << '\n';
    }
}

void print_functions(const CheckedProgram& checked, std::ostream& out) {
    if (checked.functions.empty()) return;
    out << "\nEach function with our input:\n";
    for (const FunctionCheck& check : checked.functions) {
        const bool has_counts = check.state == CheckState::right ||
                                check.state == CheckState::wrong || check.state == CheckState::died;
        out << fmt::format("  {:<16}{:<20}{}\n", state_words(checked, check), check.function,
                           has_counts
                               ? fmt::format("{} of {}: {}", check.right, check.asked, check.fed)
                               : std::string());
        const std::string indent(18, ' ');
        if (!check.rule.empty()) out << indent << check.rule << '\n';
        if (!check.first.empty()) out << indent << check.first << '\n';
        for (const std::string& note : check.notes)
            out << indent << note << '\n';
    }
}

void print_picture(const CheckedProgram& checked, std::ostream& out) {
    if (!checked.picture) return;
    const PictureCheck& picture = *checked.picture;
    out << "\nThe picture, at the lab's step “" << stage_info(picture.reference).title << "”: ";
    if (picture.is_right) {
        out << "the same as ours";
        if (checked.sequence) {
            const std::string puts = counted(checked.sequence->puts, "pixel", "pixels");
            out << (checked.sequence->parting
                        ? fmt::format(", though from pixel {} of {} on in another order",
                                      checked.sequence->parting->index, puts)
                        : fmt::format(", and so is the order of its {}", puts));
        }
        out << ".\n";
    } else {
        out << fmt::format("{} of {} pixels differ.\n", picture.different, picture.pixels)
            << (picture.is_judged ? std::string_view(picture.diagnosis.verdict)
                                  : not_judged_words(checked))
            << '\n';
    }
    if (!picture.diagnosis.rules.empty())
        out << "It is drawn with " << picture.diagnosis.rules << ".\n";
}

void print_mistakes(const CheckedProgram& checked, const std::vector<Bug>& bugs,
                    std::ostream& out) {
    if (checked.mistakes.empty()) return;
    out << "\nFix first:\n";
    for (const LikelyMistake& mistake : checked.mistakes) {
        out << "  " << place_prefix(checked.files, mistake.place) << mistake.sentence << '\n';
        for (const std::string& id : mistake.bugs)
            if (const Bug* bug = bug_of_id(bugs, id))
                out << fmt::format("    {}: {}. Lesson {}\n", bug->id, bug->name, bug->lesson);
    }
}

void print_refused(const CheckedProgram& checked, std::ostream& out) {
    for (const RefusedCall& call : checked.run->refused)
        out << "  " << place_prefix(checked.files, call.place) << "it was refused " << call.what
            << (call.count > 1 ? fmt::format(", {} times", call.count) : "") << ".\n";
    if (!checked.run->has_landlock)
        out << "  This system cannot restrict which files a program reads (no Landlock); a filter "
               "kept it from writing any.\n";
}

void print_text(const CheckedProgram& checked, const std::vector<Bug>& bugs, std::ostream& out) {
    const auto seconds = [](std::chrono::milliseconds time) {
        return significant(static_cast<double>(time.count()) / 1000.0, 2);
    };
    out << checked.files.name << '\n';
    if (!checked.compiles()) {
        out << fmt::format("It does not compile with {}.\n\n", checked.compiled.compiler);
        print_messages(checked.files, checked.compiled.messages, out);
        return;
    }
    out << fmt::format("Compiled with {} in {} s; ran for {} s.\n", checked.compiled.compiler,
                       seconds(checked.compiled.time), seconds(checked.run->time));
    if (checked.compiled.kit != KitUse::with_driver)
        out << "Its functions cannot be asked, because the questions do not compile with it; only "
               "its picture is checked.\n";
    print_refused(checked, out);
    print_functions(checked, out);
    print_picture(checked, out);
    if (checked.is_key_tested && checked.key_faults.empty())
        out << "\nWith sanitizers, and with each of its keys held down, nothing was found.\n";
    print_mistakes(checked, bugs, out);
    if (checked.is_right()) out << '\n' << right_words << '\n';
}

/// Writes the program to begin with. Throws UsageError if one of its files is there already.
void write_new_program(const std::string& folder, std::ostream& err) {
    constexpr std::string_view prefix = "new/";
    std::vector<KitFile> files;
    for (const KitFile& file : kit_files())
        if (file.name.starts_with(prefix))
            files.push_back({file.name.substr(prefix.size()), file.text});
    for (const KitFile& file : files) {
        const std::string path = fmt::format("{}/{}", folder, file.name);
        if (std::filesystem::exists(std::filesystem::symlink_status(path)))
            throw UsageError(in_quotes(path) + " is there already; nothing was written.");
    }
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (fault)
        throw AccessError(fmt::format("cannot make {}: {}.", in_quotes(folder), fault.message()));
    for (const KitFile& file : files)
        write_file(fmt::format("{}/{}", folder, file.name), file.text);
    err << "rasterwalk: a program to begin with is in " << in_quotes(folder) << ".\n";
}

/// Throws AccessError if a file cannot be written because its folder is missing: this is said
/// before the programs are checked, which may take an hour.
void expect_folder_of(const std::string& path) {
    std::error_code fault;
    const std::filesystem::path folder = std::filesystem::absolute(path, fault).parent_path();
    if (!std::filesystem::is_directory(folder, fault))
        throw AccessError(fmt::format("cannot write {}: there is no folder {}.", in_quotes(path),
                                      in_quotes(folder.string())));
}

/// The program that a path names. One that is none is a hand-in with a fault if a table is wanted:
/// a table that is missing would end the merge of all others.
StudentFiles named_program(const std::string& path, bool wants_table) {
    try {
        return find_student_files(path);
    } catch (const InputError& fault) {
        if (!wants_table) throw;
        StudentFiles files;
        files.name = std::filesystem::path(path).lexically_normal().filename().string();
        if (files.name.empty()) files.name = path;
        files.folder = path;
        files.fault = fault.what();
        return files;
    }
}

/// The programs to check: one, or those of a folder of hand-ins.
std::vector<StudentFiles> programs_of(const std::vector<std::string>& paths, bool wants_table,
                                      bool& is_single) {
    std::vector<StudentFiles> programs;
    is_single = paths.size() == 1;
    for (const std::string& path : paths) {
        std::vector<StudentFiles> hand_ins;
        if (std::filesystem::is_directory(path)) hand_ins = find_hand_ins(path);
        if (hand_ins.size() > 1) {
            is_single = false;
            programs.insert(programs.end(), hand_ins.begin(), hand_ins.end());
        } else {
            programs.push_back(named_program(path, wants_table || paths.size() > 1));
        }
    }
    return programs;
}

/// "B88a >= instead of >", or of several just as likely ones "B5 or B12"; empty: none is known.
std::string named_bugs(const Json& mistake) {
    const std::vector<std::string> bugs = texts_of(mistake, "bugs"),
                                   names = texts_of(mistake, "names");
    if (bugs.size() == 1 && names.size() == 1) return bugs.front() + ' ' + names.front();
    return fmt::format("{}", fmt::join(bugs, " or "));
}

/// The line of a program in the table, after its name; empty if there is nothing to say.
std::string summary_of(const Json& program) {
    if (const std::string fault = fault_of(program); !fault.empty()) return fault;
    if (!is_set(program, "compiles")) return "it does not compile";
    const Json& mistakes = program["mistakes"];
    if (!mistakes.is_array() || mistakes.empty()) return {};
    const std::string bugs = named_bugs(mistakes.front());
    return bugs + (bugs.empty() ? "" : ". ") + text_of(mistakes.front(), "sentence");
}

void print_summary(const Json& table, std::ostream& out) {
    for (const Json& program : table) {
        const std::string summary = summary_of(program);
        out << fmt::format("{:<12}{}{}{}\n", verdict_words(program), text_of(program, "name"),
                           summary.empty() ? "" : ": ", summary);
    }
}

ExitCode print_table(const Json& table, const MineOptions& options, std::ostream& out) {
    // Before the page: if that cannot be written, the work of an hour is not lost.
    if (options.json) {
        print_json(table, out);
    } else {
        print_summary(table, out);
    }
    if (!options.html.empty()) write_file(options.html, html_page(table));
    const bool all_right = std::all_of(
        table.begin(), table.end(), [](const Json& program) { return is_set(program, "right"); });
    return all_right ? ExitCode::done : ExitCode::difference;
}

/// One program that was named and is none, for a table.
[[noreturn]] void print_not_checked(const StudentFiles& files, const MineOptions& options,
                                    std::ostream& out) {
    const Json row = row_not_checked(files, files.fault);
    if (options.json) print_json(row, out);
    if (!options.html.empty()) write_file(options.html, html_page(Json::array({row})));
    throw InputError(files.fault);
}

/// One program that was named: in words.
ExitCode print_single(const CheckedProgram& checked, const std::vector<Bug>& bugs,
                      const Json& table, const MineOptions& options, std::ostream& out) {
    if (!options.html.empty()) write_file(options.html, html_page(table));
    if (options.json) {
        print_json(table.front(), out);
    } else {
        print_text(checked, bugs, out);
    }
    if (!checked.compiles()) return ExitCode::bad_input;
    return checked.is_right() ? ExitCode::done : ExitCode::difference;
}

} // namespace

ExitCode mine_command(const MineOptions& options, std::ostream& out, std::ostream& err,
                      ProgressLine& progress) {
    if (!(options.seconds > 0.0)) throw UsageError("--seconds takes a number greater than 0.");
    if (!options.new_folder.empty()) {
        write_new_program(options.new_folder, err);
        return ExitCode::done;
    }
    if (options.paths.empty())
        throw UsageError("mine needs a .cpp file, a folder, or --new FOLDER.");
    if (!options.html.empty()) expect_folder_of(options.html);
    if (options.merge) return print_table(merged_tables(options.paths), options, out);
    bool is_single = true;
    const bool wants_table = options.json || !options.html.empty();
    const std::vector<StudentFiles> programs = programs_of(options.paths, wants_table, is_single);
    if (is_single && !programs.front().fault.empty())
        print_not_checked(programs.front(), options, out);
    const std::vector<Bug> bugs = read_bugs();
    const LabScenes lab = read_lab_scenes();
    CheckProgramOptions how;
    how.compiler = options.compiler;
    how.hold_keys = !options.skip_keys;
    how.search = std::chrono::milliseconds(static_cast<std::int64_t>(options.seconds * 1000.0));
    const Interrupt interrupt;
    how.is_stopped = [&] { return interrupt.was_interrupted(); };
    Json table = Json::array();
    for (const StudentFiles& files : programs) {
        if (!files.fault.empty()) {
            table.push_back(row_not_checked(files, files.fault));
            continue;
        }
        how.say = [&](std::string_view what) {
            progress.say(fmt::format("{}: {}", files.name, what));
        };
        const CheckedProgram checked = check_program(files, lab, bugs, how);
        progress.clear();
        if (interrupt.was_interrupted()) break;
        if (!is_single || wants_table) table.push_back(to_json(checked, bugs));
        if (is_single) return print_single(checked, bugs, table, options, out);
    }
    const ExitCode found = print_table(table, options, out);
    return interrupt.was_interrupted() ? ExitCode::interrupted : found;
}

} // namespace rasterwalk
