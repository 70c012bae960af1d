#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "inspect/event_list.h"

namespace rasterwalk {

/// A file or folder that the sheet for files lists.
struct FileEntry {
    std::string name;
    bool is_folder = false;
};

/// The sheet on which a file is opened or a view is saved.
struct FileSheet {
    enum class Kind : std::uint8_t { closed, open, save };
    Kind kind = Kind::closed;
    std::string path;   ///< as it stands in the field
    std::string folder; ///< that is listed; kept for the next time
    std::vector<FileEntry> entries;
    std::size_t left_out = 0;  ///< files that are not listed because there are too many
    std::string fault;         ///< why it was not opened or saved
    std::string asked;         ///< file that is there already: may it be replaced? empty: not asked
    bool wants_focus = false;  ///< the field takes the keyboard in the next frame
    bool has_keyboard = false; ///< it has taken it
    std::vector<std::uint32_t> early_letters; ///< that were typed before
    bool early_enter = false;                 ///< and the key after them
};

/// The sheet that lists what a triangle does, moment by moment.
struct EventSheet {
    bool is_open = false;
    std::string search; ///< what it is filtered by

    // What is listed, and for what.
    EventList list;
    int first = 0;                  ///< of very many moments it lists some; this is the first
    std::vector<int> found;         ///< numbers of the moments that have the words
    std::uint64_t frame_number = 0; ///< of run A
    std::string searched;
};

/// The sheets that lie over the window.
struct SheetsState {
    FileSheet files;
    bool shows_glossary = false; ///< the glossary is open
    std::string glossary_search; ///< what it is filtered by
    bool shows_keys = false;     ///< the sheet of keys is open
    EventSheet events;
};

} // namespace rasterwalk
