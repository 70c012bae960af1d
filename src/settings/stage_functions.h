#pragma once

// The registry of functions: which word of which setting puts which function into which slot of
// Stages, and the file that function stands in. Nothing else says so.

#include <span>
#include <string_view>
#include <vector>

#include "settings/setting_table.h"
#include "stages/stage_table.h"

namespace rasterwalk {

/// How a function gets into its slot.
struct SlotFunction {
    std::string_view slot;     ///< member of Stages, or of its ScreenRules: "cull"
    std::string_view function; ///< its name, without template arguments: "cull_by_face_normal"
    bool is_part; ///< the slot holds a function made of this one and of other settings' parts
    void (*put)(Stages&, const Settings&, const Scene*);
};

/// A row of the registry. setting->help, choice_words() and the comments at the word and at the
/// function say what it does.
struct StageFunction {
    const Setting* setting = nullptr;
    std::string_view word; ///< the one that chooses the function; empty: any value, if `acts`
    SlotFunction does;
    std::string_view file; ///< that declares the function, below src: "mistakes/cull.h"
    /// Do the other settings, and the scene, let the word act? The scene may be null: unknown.
    bool (*acts)(const Settings&, const Scene*);

    int word_place = no_word; ///< of the word among those of the setting
};

/// All rows. A later one replaces what an earlier one has put into the same slot.
std::span<const StageFunction> stage_functions();

/// The rows of a setting, or of one of its words; none if the word keeps the lab's functions.
std::vector<const StageFunction*> find_functions(std::string_view setting,
                                                 std::string_view word = {});

/// Has the setting this word, and can it act?
bool is_chosen(const StageFunction& row, const Settings& settings, const Scene* scene);

/// The rows whose functions are in the slots under these settings, in the order of the table. The
/// other slots have the lab's.
std::vector<const StageFunction*> functions_in_use(const Settings& settings,
                                                   const Scene* scene = nullptr);

} // namespace rasterwalk
