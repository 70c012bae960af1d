#include "cli/commands.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <system_error>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/language_files.h"
#include "base/numbers.h"
#include "base/quoted.h"
#include "cli/json.h"
#include "cli/prose_files.h"
#include "facts/facts.h"
#include "laboratory/bug.h"
#include "lessons/course.h"
#include "lessons/course_test.h"
#include "lessons/lesson.h"
#include "lessons/lesson_advice.h"
#include "lessons/lesson_check.h"
#include "lessons/lesson_list.h"
#include "lessons/lesson_run.h"
#include "lessons/task_luck.h"
#include "lessons/translation_check.h"
#include "scene/read_obj.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "settings/setting_table.h"
#include "text/prose.h"
#include "text/style.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

bool is_lesson_name(const std::string& name) {
    return name.size() > 6 && name.ends_with(".md") && name[2] == '-' &&
           name.find_first_not_of("0123456789") == 2;
}

/// The files of a folder that can be checked, by name.
std::vector<std::string> files_in(const fs::path& folder) {
    std::vector<std::string> files;
    std::error_code fault;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        const std::string name = entry->path().filename().string();
        const bool is_data = name == "presets.toml" || name == "glossary.toml" ||
                             name == "bugs.toml" || name == "course.toml" ||
                             name == "course-test.toml" ||
                             (name == "texts.toml" && is_translation(entry->path().string()));
        const bool is_scene = folder.filename() == "scenes" && name.ends_with(".toml");
        const bool is_model = folder.filename() == "models" && is_model_file(name);
        if (is_lesson_name(name) || is_data || is_scene || is_model)
            files.push_back(entry->path().string());
    }
    if (fault) throw AccessError("cannot read '" + folder.string() + "': " + fault.message() + ".");
    std::sort(files.begin(), files.end());
    return files;
}

/// The folders of languages in a folder, by name, also of those without texts.
std::vector<fs::path> languages_in(const fs::path& folder) {
    std::vector<fs::path> languages;
    std::error_code fault, ignored;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        if (is_language_code(entry->path().filename().string()) && entry->is_directory(ignored))
            languages.push_back(entry->path());
    }
    std::sort(languages.begin(), languages.end());
    return languages;
}

/// The same, with the models, scenes and languages below a folder of lessons.
std::vector<std::string> files_below(const fs::path& folder) {
    std::vector<std::string> files = files_in(folder);
    std::vector<fs::path> folders{folder / "models", folder / "scenes"};
    const bool is_of_languages = is_list_of_texts((folder / "texts.toml").string());
    for (fs::path& language : languages_in(is_of_languages ? folder : folder / "languages")) {
        // The texts are checked even if they are missing.
        std::error_code ignored;
        if (!fs::exists(fs::symlink_status(language / "texts.toml", ignored)))
            files.push_back((language / "texts.toml").string());
        folders.push_back(std::move(language));
    }
    for (const fs::path& below : folders) {
        std::error_code ignored;
        if (!fs::is_directory(below, ignored)) continue;
        for (std::string& file : files_in(below))
            files.push_back(std::move(file));
    }
    return files;
}

std::vector<std::string> files_to_check(const std::vector<std::string>& paths) {
    std::vector<std::string> files;
    for (const std::string& path : paths) {
        std::error_code fault;
        const fs::file_status status = fs::status(path, fault);
        if (fs::is_directory(status)) {
            for (std::string& file : files_below(fs::path(path).lexically_normal()))
                files.push_back(std::move(file));
        } else if (!fs::exists(status)) {
            const bool is_missing = status.type() == fs::file_type::not_found;
            throw AccessError("cannot read '" + path + "': " +
                              (is_missing ? "there is no such file." : fault.message() + "."));
        } else {
            files.push_back(path);
        }
    }
    return files;
}

/// The tools for checking files, one after another.
struct FileCheck {
    Session session = empty_session();
    LessonTrial trial{};
    std::ostream& out;
    ProgressLine& progress;
    bool luck = false; ///< tasks are tried at random
    StyleGuide guide{};
};

/// Random tries at a task.
constexpr int luck_tries = 300;

/// Prints how often each task is solved by luck; returns how many faults that shows.
int check_luck(const Lesson& lesson, FileCheck& check) {
    int faults = 0;
    const auto print = [&](const LessonTask& task, const std::string& sentence) {
        check.progress.clear();
        check.out << fault_text(lesson, {task.done_line, sentence}) << '\n';
    };
    for (const LessonTask& task : lesson.tasks) {
        if (!task.done || task.recipe.empty()) continue; // already reported
        check.progress.say(fmt::format("Trying the task '{}'", task.id));
        const TaskLuck luck = luck_of(lesson, task, luck_tries, check.session, check.trial);
        if (luck.control.empty()) {
            print(task, fmt::format("the task '{}' has nothing to try at random.", task.id));
            continue;
        }
        print(task, fmt::format("the task '{}' is solved by {:.1f} % of random tries with {}.",
                                task.id, 100.0 * luck.passed / luck.tries, luck.control));
        const auto refuse = [&](const std::string& sentence) {
            print(task, fmt::format("the task '{}': {}", task.id, sentence));
            ++faults;
        };
        if (is_luck(luck)) refuse("at most 10 % of random tries may solve it.");
        if (luck.ends_pass) refuse("an end of its slider solves it.");
        if (luck.unanswered > 0) {
            refuse(fmt::format("'not_yet' has no answer to {} of {} tries, such as {}.",
                               luck.unanswered, luck.tries, luck.unanswered_by));
        }
    }
    return faults;
}

/// Prints the faults of one file; returns how many there are.
int check_file(const std::string& path, FileCheck& check) {
    const std::string name = fs::path(path).filename().string();
    check.progress.say("Checking " + name);
    const auto read = [&](auto reader) {
        try {
            reader();
            return 0;
        } catch (const Error& fault) {
            check.progress.clear();
            check.out << fault.what() << '\n';
            return 1;
        }
    };
    if (name == "presets.toml") return read([&] { read_presets(path); });
    if (name == "glossary.toml") return read([&] { read_glossary(path); });
    if (name == "bugs.toml") return read([&] { read_bugs(path); });
    if (name == "course.toml") {
        const fs::path folder = fs::path(path).parent_path();
        return read(
            [&] { check_course_files(parse_course(read_file(path), path), folder.string()); });
    }
    if (name == "course-test.toml") return read([&] { parse_course_test(read_file(path), path); });
    if (is_view_file(name)) {
        ViewOptions options;
        options.file = path;
        return read([&] { open_view(options); });
    }
    if (is_list_of_texts(path))
        return read([&] { parse_language(read_file(path, largest_language), path); });
    if (name == "texts.toml" && is_translation(path)) {
        int faults = 0;
        const int refused = read([&] {
            for (const Fault& fault : text_faults(path)) {
                check.progress.clear();
                check.out << fmt::format("{}:{}: {}\n", path, fault.line, fault.sentence);
                ++faults;
            }
        });
        return faults + refused;
    }
    if (name.ends_with(".toml")) return read([&] { read_scene_file(path); });
    if (is_model_file(name)) {
        int faults = 0;
        const int refused = read([&] {
            const ObjReport report = read_obj(path).report;
            check.progress.clear();
            for (const std::string& line : fault_lines(report))
                check.out << line << '\n';
            faults = static_cast<int>(report.counts.faults);
        });
        return faults + refused;
    }
    const Lesson lesson = read_lesson(path);
    std::vector<Fault> faults =
        check_lesson(lesson, check.session, check.trial, [&](const std::string& part) {
            check.progress.say(fmt::format("Checking {}: {}", name, part));
        });
    if (faults.empty() && is_translation(path)) faults = differences_from_english(lesson);
    check.progress.clear();
    for (const Fault& fault : faults)
        check.out << fault_text(lesson, fault) << '\n';
    const int unlucky = check.luck && faults.empty() ? check_luck(lesson, check) : 0;
    return static_cast<int>(faults.size()) + unlucky;
}

/// Prints the advice on the lessons among these files, each in the course of its folder; returns
/// how much there is.
int print_advice(const std::vector<std::string>& files, const Session& session, std::ostream& out) {
    std::map<std::string, std::map<std::string, std::vector<std::string>>> of_folder;
    int count = 0;
    for (const std::string& file : files) {
        if (!is_lesson_name(fs::path(file).filename().string())) continue;
        const std::string folder = fs::absolute(file).parent_path().string();
        const std::string id = fs::path(file).stem().string();
        const auto [known, is_new] = of_folder.try_emplace(folder);
        if (is_new) {
            LessonList list;
            list.read_folder(folder);
            const std::vector<Lesson>& lessons = list.all();
            const std::vector<std::vector<Fault>> advice = advice_on(lessons, session.glossary);
            for (std::size_t i = 0; i < lessons.size(); ++i) {
                for (const Fault& one : advice[i])
                    known->second[lessons[i].id].push_back(
                        fmt::format("{}: advice: {}", one.line, one.sentence));
            }
        }
        for (const std::string& sentence : known->second[id]) {
            out << file << ':' << sentence << '\n';
            ++count;
        }
    }
    return count;
}

/// Prints what the languages among these files still lack: how much, or all of it.
void print_gaps(const std::vector<std::string>& files, bool prints_all, std::ostream& out) {
    for (const std::string& file : files) {
        if (fs::path(file).filename() != "texts.toml" || !is_translation(file)) continue;
        const fs::path folder = fs::absolute(file).lexically_normal().parent_path();
        const TranslationGaps gaps =
            translation_gaps(lessons_folder_of(file), folder.filename().string());
        const auto translated = [](int all, const std::vector<std::string>& missing) {
            return fmt::format("{} of {}", all - static_cast<int>(missing.size()), all);
        };
        out << fmt::format("{}: {} texts and {} lessons are translated.\n", file,
                           translated(gaps.all_texts, gaps.texts),
                           translated(gaps.all_lessons, gaps.lessons));
        if (!prints_all) continue;
        for (const std::string& text : gaps.texts)
            out << "    " << in_quotes(text) << '\n';
        for (const std::string& lesson : gaps.lessons)
            out << "    " << lesson << '\n';
    }
}

/// The largest file whose style is checked, bytes.
constexpr std::size_t largest_prose = std::size_t{4} << 20;

/// Prints the phrases of one file that read as if translated; returns how many there are.
int check_style(const std::string& path, FileCheck& check) {
    const ProseKind kind = prose_kind(path).value_or(ProseKind::script);
    const std::vector<Fault> faults =
        style_faults(prose_of(read_file(path, largest_prose), kind), check.guide);
    check.progress.clear();
    for (const Fault& fault : faults)
        check.out << path << ':' << fault.line << ": " << fault.sentence << '\n';
    return static_cast<int>(faults.size());
}

const char* type_name(ValueType type) {
    switch (type) {
    case ValueType::number:
        return "number";
    case ValueType::word:
        return "word";
    case ValueType::moment:
        return "moment";
    case ValueType::truth:
        return "truth";
    }
    return "";
}

} // namespace

ExitCode check_command(const CheckOptions& options, std::ostream& out, std::ostream& err,
                       ProgressLine& progress) {
    FileCheck check{.out = out, .progress = progress, .luck = options.luck};
    if (options.style) check.guide = read_style(lessons_folder() + "/style.toml");
    const std::vector<std::string> files =
        options.style ? prose_files(options.paths) : files_to_check(options.paths);
    if (files.empty()) {
        throw InputError(options.style
                             ? "there is nothing to check: no file there holds text or comments."
                             : "there is nothing to check, neither lessons nor scenes.");
    }
    int faults = 0;
    for (const std::string& file : files)
        faults += options.style ? check_style(file, check) : check_file(file, check);
    progress.clear();
    if (faults == 0 && !options.style) print_gaps(files, options.advice, out);
    const int advice = options.advice ? print_advice(files, check.session, out) : 0;
    const std::string in_files = counted(static_cast<std::int64_t>(files.size()), "file", "files");
    if (faults > 0) {
        err << "rasterwalk: " << counted(faults, "fault", "faults") << " in " << in_files << ".\n";
        return ExitCode::difference;
    }
    out << in_files << ", no faults";
    if (options.advice) out << ", " << counted(advice, "piece", "pieces") << " of advice";
    out << ".\n";
    return ExitCode::done;
}

void facts_command(const FactsOptions& options, std::ostream& out) {
    Json list = Json::array();
    for (const std::string& name : all_names()) {
        const ValueRange range = find_name(name).value_or(ValueRange{});
        std::string help;
        for (const Fact& fact : fact_table()) {
            if (fact.name == name) help = fact.help;
        }
        const bool is_setting = help.empty();
        if (is_setting) help = "Setting; see rasterwalk settings.";
        if (!options.json) {
            out << name << "   " << type_name(range.type) << "\n    " << help << '\n';
            if (!is_setting && !range.words.empty()) {
                out << "    One of:";
                for (const std::string_view word : range.words)
                    out << ' ' << word;
                out << '\n';
            }
        }
        list.push_back({{"help", help},
                        {"name", name},
                        {"type", type_name(range.type)},
                        {"words", range.words}});
    }
    if (options.json) print_json({{"facts", std::move(list)}}, out);
}

} // namespace rasterwalk
