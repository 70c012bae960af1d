#pragma once

// One way in which a picture may have been made: right by some rules and with some numbers, then
// changed, most often by a mistake; and what such an explanation is worth.

#include <string>
#include <vector>

#include "laboratory/bug.h"
#include "laboratory/candidate.h"
#include "laboratory/picture_trial.h"
#include "settings/settings.h"

namespace rasterwalk {

/// A change that may have been made to a right picture, most often by a mistake.
struct Change {
    std::string id, name; ///< as in a Suspect
    Assignments set;      ///< the settings that make it, except for the stage; may be empty
    Orientation orientation = Orientation::upright;
    int right = 0, down = 0;  ///< pixels by which the picture is moved
    const Bug* bug = nullptr; ///< of the laboratory; null: none
};

/// All mistakes in the laboratory, then every other word of every choice that the scene can use,
/// then a picture that is turned, and one that is moved by a pixel. The bugs must outlive the
/// result.
std::vector<Change> known_changes(const std::vector<Bug>& bugs, const Scene& scene);

/// A picture that was tried: the right one by some rules, and the changes to it.
struct Attempt {
    Settings right;
    std::vector<const Change*> changes;
};

/// How to make it.
PictureRecipe recipe_of(const Attempt& attempt);

/// The rules and numbers by which it is right, besides the reference's, each as "light.power=9".
std::vector<std::string> extra_rules(const Settings& right, const Settings& reference);

/// How much an attempt assumes, in units of one mistake; a rule or a number that is not wrong costs
/// less.
double assumptions_of(const Attempt& attempt, const Settings& reference);

/// The attempt without changes that comes nearest to the picture. What it leaves must be explained.
const Attempt& best_base(PictureTrial& trial, const std::vector<Attempt>& tried,
                         const Settings& reference);

/// What an assumption must be worth, in wrong pixels: more if more of them are wrong at the stage
/// that comes nearest. All stages must be drawn.
double assumption_unit(PictureTrial& trial, const Settings& reference);

/// The wrong pixels that an attempt leaves, plus those that its assumptions must be worth.
double price_of(PictureTrial& trial, const Attempt& attempt, const Settings& reference,
                double unit);

} // namespace rasterwalk
