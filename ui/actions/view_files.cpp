#include "ui/actions/view_files.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/files.h"
#include "base/image.h"
#include "base/image_format.h"
#include "base/letter_case.h"
#include "laboratory/printed_rows.h"
#include "lessons/lesson_list.h"
#include "mine/compile/project_folder.h"
#include "opening/command_line_text.h"
#include "opening/opened_view.h"
#include "opening/view_link.h"
#include "scene/applied_texture.h"
#include "scene/companion_file.h"
#include "scene/read_obj.h"
#include "session/content.h"
#include "session/scene_file.h"
#include "ui/actions/actions.h"
#include "ui/actions/lab.h"
#include "ui/actions/mine.h"
#include "ui/actions/open_lesson.h"
#include "ui/actions/reading.h"
#include "ui/ui.h"
#include "ui/widgets/widgets.h"
#include "view/state_file.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view view_ending = ".walk.toml";

bool has_text_ending(const std::string& path) {
    return in_small_letters(path).ends_with(".txt");
}

/// Can the student's own result have this name? A JPG does not preserve it.
bool has_result_ending(const std::string& path) {
    return has_exact_image_ending(path) || has_text_ending(path);
}

/// A picture, whatever its name, or a text. Reading it says if it is a JPG, which cannot be
/// checked.
bool is_result(const std::string& path) {
    return is_image_file(path) || has_image_ending(path) || has_text_ending(path);
}

/// A source of the student's own program, or the folder of one.
bool is_program(const std::string& path) {
    std::error_code ignored;
    return is_source_name(path) || fs::is_directory(path, ignored);
}

/// What the sheet lists; anything can be opened by its name.
bool is_listed(FileSheet::Kind kind, const std::string& name) {
    if (kind == FileSheet::Kind::save) return is_view_file(name);
    if (kind == FileSheet::Kind::result) return has_result_ending(name) || is_source_name(name);
    if (kind == FileSheet::Kind::texture) return has_image_ending(name);
    constexpr std::string_view other_data[] = {"presets.toml", "bugs.toml", "glossary.toml",
                                               "course.toml", "course-test.toml"};
    if (std::find(std::begin(other_data), std::end(other_data), name) != std::end(other_data)) {
        return false;
    }
    return name.ends_with(".toml") || is_model_file(name) || is_lesson_file(name) ||
           has_result_ending(name) || is_source_name(name);
}

bool comes_before(const FileEntry& a, const FileEntry& b) {
    if (a.is_folder != b.is_folder) return a.is_folder;
    const std::string left = in_small_letters(a.name), right = in_small_letters(b.name);
    return left != right ? left < right : a.name < b.name;
}

std::string current_folder() {
    std::error_code fault;
    const fs::path folder = fs::current_path(fault);
    return fault ? "/" : folder.string();
}

bool is_own(const std::string& path) {
    return name_in_lessons_folder(path).has_value();
}

/// Where a view of this session can be saved: next to its scene, if that is not the program's own.
std::string folder_for(const Session& session) {
    std::error_code fault;
    if (!session.lesson_folder.empty()) return fs::absolute(session.lesson_folder, fault).string();
    const fs::path scene = fs::absolute(session.scene->path, fault);
    return fault || is_own(scene.string()) ? current_folder() : scene.parent_path().string();
}

std::string name_for(const Session& session) {
    if (!session.lesson.empty()) {
        return session.lesson + "-step-" + std::to_string(session.step) + std::string(view_ending);
    }
    const std::string stem = fs::path(session.scene->path).stem().string();
    return (stem.empty() ? "view" : stem) + std::string(view_ending);
}

void begin_sheet(Ui& ui, FileSheet::Kind kind) {
    FileSheet& sheet = ui.sheets.files;
    std::string folder = std::move(sheet.folder);
    sheet = {};
    sheet.kind = kind;
    sheet.wants_focus = true;
    enter_folder(sheet, folder.empty() ? current_folder() : folder);
}

void save_to(Ui& ui, const std::string& path) {
    FileSheet& sheet = ui.sheets.files;
    std::error_code ignored;
    if (fs::exists(path, ignored) && sheet.to_replace != path) {
        sheet.to_replace = path;
        sheet.fault.clear();
        return;
    }
    write_view(ui.session, path);
    show_info(ui.session, "Saved as " + path + ".");
    sheet.kind = FileSheet::Kind::closed;
}

/// The file is written next to the scene that it names, and stays there for the next one.
void save_as_download(Ui& ui) {
    try {
        const std::string name = name_for(ui.session);
        const std::string path = folder_for(ui.session) + "/" + name;
        write_view(ui.session, path);
        ui.host.hand_out(path);
        show_info(ui.session, "Saved as " + name + ".");
    } catch (const Error& fault) {
        ui.session.notice = fault.what();
    }
}

} // namespace

void show_view(Ui& ui, Session&& opened) {
    Session& session = ui.session;
    end_quiz(session);
    opened.undo = std::move(session.undo);
    opened.places = std::move(session.places);
    opened.jumps = session.jumps + 1;
    opened.play.granularity = session.play.granularity;
    opened.play.speed = session.play.speed;
    session = std::move(opened);
    ui.inspector.scroll_to_row = true;
    take_up_lesson(ui);
}

void open_file(Ui& ui, const std::string& path) {
    refuse_endless_file(path);
    if (is_program(path)) {
        check_my_program(ui, path);
    } else if (is_result(path)) {
        diagnose_file(ui, path);
    } else {
        read_and_open(ui, path);
    }
}

void check_result(Ui& ui, const std::string& path) {
    refuse_endless_file(path);
    if (is_program(path)) {
        check_my_program(ui, path);
        return;
    }
    // A file that cannot be read is reported on the sheet, next to the other files.
    if (!is_result(path)) {
        throw InputError(fmt::format("{}: what can be checked is a program (.cpp), a picture ({}) "
                                     "or printed rows (.txt).",
                                     path, exact_image_formats));
    }
    if (!is_image_file(path)) parse_printed_rows(read_file(path), path);
    diagnose_file(ui, path);
}

void apply_texture(Ui& ui, const std::string& path) {
    ui.session.scene = std::make_shared<const Scene>(with_texture(*ui.session.scene, path));
    show_info(ui.session, "Applied " + fs::path(path).filename().string() + " to the model.");
}

void open_dropped(Ui& ui, const std::string& path) {
    stop_reading(ui);
    try {
        open_file(ui, path);
        ui.sheets.files.kind = FileSheet::Kind::closed;
    } catch (const Error& fault) {
        show_opening_fault(ui, path, fault.what());
    }
}

void show_opening_fault(Ui& ui, const std::string& path, const std::string& sentence) {
    if (ui.host.is_browser) {
        ui.session.notice = sentence;
        return;
    }
    begin_sheet(ui, FileSheet::Kind::open);
    const std::string folder = fs::path(path).parent_path().string();
    if (!folder.empty()) enter_folder(ui.sheets.files, folder);
    ui.sheets.files.path = path;
    ui.sheets.files.fault = sentence;
}

void copy_command_line(Ui& ui) {
    try {
        const std::string line = command_line_text(ui.session);
        ImGui::SetClipboardText(line.c_str());
        show_info(ui.session, std::string("Copied: ").append(line));
    } catch (const Error& fault) {
        ui.session.notice = fault.what();
    }
}

void copy_link(Ui& ui) {
    try {
        const std::string& page = ui.host.page;
        const std::string link = page + view_link(ui.session);
        ImGui::SetClipboardText(link.c_str());
        const char* const what =
            page.empty() ? "Copied what goes after the address of the page: " : "Copied: ";
        show_info(ui.session, what + link);
    } catch (const Error& fault) {
        ui.session.notice = fault.what();
    }
}

void begin_opening(Ui& ui) {
    if (ui.host.is_browser) return ui.host.choose_file(false);
    begin_sheet(ui, FileSheet::Kind::open);
}

void begin_choosing_result(Ui& ui) {
    if (ui.host.is_browser) return ui.host.choose_file(true);
    begin_sheet(ui, FileSheet::Kind::result);
}

void begin_choosing_texture(Ui& ui) {
    if (ui.host.is_browser) {
        ui.session.notice = "A browser hands over only one file at a time. Name the image in the "
                            "model's .mtl, and open the model on the desktop.";
        return;
    }
    begin_sheet(ui, FileSheet::Kind::texture);
}

void begin_saving(Ui& ui) {
    if (hides_settings(ui.session)) {
        ui.session.notice = "The view can be saved once the quiz is over.";
        return;
    }
    if (ui.host.is_browser) return save_as_download(ui);
    if (ui.sheets.files.folder.empty() || !is_own(ui.session.scene->path)) {
        ui.sheets.files.folder = folder_for(ui.session);
    }
    begin_sheet(ui, FileSheet::Kind::save);
    ui.sheets.files.path = name_for(ui.session);
}

void enter_folder(FileSheet& sheet, const std::string& folder, std::size_t most_seen) {
    std::error_code fault;
    const fs::path place = fs::weakly_canonical(folder, fault);
    fs::directory_iterator entry(place, fs::directory_options::skip_permission_denied, fault);
    if (fault) {
        sheet.fault = "The folder " + folder + " cannot be read: " + fault.message() + ".";
        return;
    }
    sheet.folder = place.string();
    sheet.entries.clear();
    sheet.left_out = 0;
    sheet.is_cut = false;
    sheet.fault.clear();
    sheet.to_replace.clear();
    std::size_t seen = 0;
    for (const fs::directory_iterator end; !fault && entry != end; entry.increment(fault)) {
        sheet.is_cut = ++seen > most_seen;
        if (sheet.is_cut) break;
        FileEntry found{entry->path().filename().string(), false};
        std::error_code ignored;
        found.is_folder = entry->is_directory(ignored);
        if (found.name.starts_with('.')) continue;
        if (found.is_folder || is_listed(sheet.kind, found.name)) sheet.entries.push_back(found);
    }
    std::sort(sheet.entries.begin(), sheet.entries.end(), comes_before);
    if (sheet.entries.size() > most_listed_files) {
        sheet.left_out = sheet.entries.size() - most_listed_files;
        sheet.entries.resize(most_listed_files);
    }
}

std::string meant_path(const FileSheet& sheet) {
    std::string typed = sheet.path;
    if (const char* home = std::getenv("HOME"); home != nullptr && typed.starts_with("~/")) {
        typed = home + typed.substr(1);
    }
    const fs::path path = (fs::path(sheet.folder) / typed).lexically_normal();
    std::error_code ignored;
    std::string text = path.string();
    if (sheet.kind != FileSheet::Kind::save || is_view_file(text) ||
        fs::is_directory(path, ignored)) {
        return text;
    }
    if (text.ends_with(".toml")) text.resize(text.size() - 5);
    return text + std::string(view_ending);
}

void finish_sheet(Ui& ui) {
    FileSheet& sheet = ui.sheets.files;
    if (sheet.path.empty()) return;
    const std::string path = meant_path(sheet);
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
        enter_folder(sheet, path);
        sheet.path.clear();
        sheet.wants_focus = true;
        return;
    }
    try {
        if (sheet.kind == FileSheet::Kind::save) {
            save_to(ui, path);
        } else {
            if (sheet.kind == FileSheet::Kind::result) {
                check_result(ui, path);
            } else if (sheet.kind == FileSheet::Kind::texture) {
                apply_texture(ui, path);
            } else {
                open_file(ui, path);
            }
            sheet.kind = FileSheet::Kind::closed;
        }
    } catch (const Error& fault) {
        sheet.fault = fault.what();
        sheet.to_replace.clear();
    }
}

} // namespace rasterwalk
