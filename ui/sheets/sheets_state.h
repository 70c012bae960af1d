#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "inspect/event_list.h"
#include "lessons/course_test.h"

namespace rasterwalk {

/// A file or folder that the sheet for files lists.
struct FileEntry {
    std::string name;
    bool is_folder = false;
};

/// The sheet on which a file is opened or a view is saved.
struct FileSheet {
    /// `result`: a picture or a text from the student's own program, to be checked; `texture`: an
    /// image to be laid on the model.
    enum class Kind : std::uint8_t { closed, open, save, result, texture };
    Kind kind = Kind::closed;
    std::string path;   ///< as written in the field
    std::string folder; ///< the one listed; kept for the next time
    std::vector<FileEntry> entries;
    std::size_t left_out = 0;  ///< files that are not listed because there are too many
    bool is_cut = false;       ///< there are so many that not all were examined
    std::string fault;         ///< why it was not opened or saved
    std::string to_replace;    ///< a file that already exists: may it be replaced? empty: not asked
    bool wants_focus = false;  ///< the field takes the keyboard in the next frame
    bool has_keyboard = false; ///< it has taken it
    std::vector<std::uint32_t> early_letters; ///< typed before it had the keyboard
    bool early_enter = false;                 ///< and the key after them
};

/// The reading sheets, which leave the rest of the window usable; the topmost first.
enum class Sheet : std::uint8_t { keys, glossary, map, events, test };
inline constexpr std::size_t sheet_count = 5;

/// What the sheet of moments lists, and what it was listed for.
struct EventSheet {
    EventList list;
    int first = 0;                  ///< of very many moments it lists only some; this is the first
    std::vector<int> found;         ///< numbers of the moments that match the search
    std::uint64_t frame_number = 0; ///< of run A
    std::string searched;
};

/// The test before and after the lessons.
struct TestSheet {
    std::optional<CourseTest> test; ///< none before the sheet is first opened
    std::string fault;              ///< why there is none
    bool is_after = false;          ///< the sitting shown is the one after the lessons
    int item = 0;                   ///< the one asked
    bool is_going_back = false;     ///< an item that was answered is shown again
    std::string name;               ///< of the student, for the report
};

/// The sheets over the window.
struct SheetsState {
    FileSheet files;
    std::array<bool, sheet_count> open{};          ///< by Sheet
    std::array<ImGuiID, sheet_count> parts{};      ///< windows that were last drawn for each
    std::array<std::string, sheet_count> search{}; ///< what each is filtered by
    EventSheet events;
    TestSheet test;

    bool is_open(Sheet sheet) const { return open[static_cast<std::size_t>(sheet)]; }
    void show(Sheet sheet, bool is_shown = true) {
        open[static_cast<std::size_t>(sheet)] = is_shown;
    }
    void toggle(Sheet sheet) { show(sheet, !is_open(sheet)); }
    /// The topmost one; none if none is open.
    std::optional<Sheet> topmost() const {
        for (std::size_t i = 0; i < sheet_count; ++i) {
            if (open[i]) return static_cast<Sheet>(i);
        }
        return std::nullopt;
    }
    std::string& search_of(Sheet sheet) { return search[static_cast<std::size_t>(sheet)]; }
};

} // namespace rasterwalk
