#pragma once

// The strip at the top of the window: the steps of the pipeline that the scene or the settings can
// use, in order, and how far the picture is computed.
//
// Some entries are steps: they set how far the picture is drawn, with which shading, and whether
// textures and normal maps are looked up. The others are doors: they lead to where work is seen
// that no step of its own turns on, and set nothing.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/language.h"

namespace rasterwalk {

struct Scene;
struct Session;
struct Settings;

/// A part of the work; a bar in the strip separates it from the next one.
enum class StripGroup : std::uint8_t { view, coverage, visibility, light, surface, picture };

/// How an entry of the strip is joined to the previous one.
enum class StripJoin : std::uint8_t {
    begins_group, ///< another part of the work begins
    follows,      ///< it goes on from there
    alternative,  ///< it takes that one's place
};

/// What an entry is called.
struct StripWords {
    std::string_view title; ///< on the button
    std::string_view help;  ///< one sentence
};

/// An entry of the strip.
struct StripEntry {
    std::string_view name; ///< after "stage." in the names of its action and its button
    StripGroup group = StripGroup::view;
    StripJoin join = StripJoin::follows; ///< to another one of its group
    StripWords words;
    bool (*is_usable)(const Scene&, const Settings&) = nullptr;
    bool (*is_computed)(const Scene&, const Settings&) = nullptr;
    void (*set)(const Scene&, Settings&) = nullptr; ///< null: a door
    std::string_view tab;     ///< of the inspector, which shows what it draws or leads to
    StripWords other_words{}; ///< where has_other_words is true
    bool (*has_other_words)(const Scene&, const Settings&) = nullptr; ///< null: nowhere
};

/// All entries in their order.
std::span<const StripEntry> strip_list();

using StripRow = std::vector<const StripEntry*>;

/// The entries that the scene and the settings can use, and the chosen one in any case. During a
/// quiz none that would give away a hidden setting.
StripRow usable_entries(const Session& session);

/// Those that are usable at some step: what a strip needs room for, whichever is chosen.
StripRow entries_of_all_steps(const Session& session);

/// Does the picture contain this work? The last such entry is how far it is computed.
bool is_computed(const StripEntry& entry, const Session& session);

/// The step that the settings are at; never a door.
const StripEntry& chosen_entry(const Session& session);

/// Its title in this scene: light at every pixel is called Phong shading only where normals or
/// colours vary, or a surface shines.
std::string title_of(const StripEntry& entry, const Session& session,
                     const Language& language = english());
/// What it does in this scene.
std::string help_of(const StripEntry& entry, const Session& session,
                    const Language& language = english());

/// How an entry is joined to the one shown before it.
StripJoin join_between(const StripEntry& before, const StripEntry& entry);

/// Takes a step, which also shows its tab if the inspector follows the stage. Does nothing for a
/// door.
void take_step(Session& session, const StripEntry& entry);

} // namespace rasterwalk
