#pragma once

// The search for what may have made a picture: by which rules and with which numbers it is drawn,
// none of them wrong, and which mistake is made on top of them, or which two.

#include <cstdint>
#include <string>
#include <vector>

#include "laboratory/bug.h"
#include "laboratory/candidate.h"
#include "laboratory/picture_trial.h"
#include "settings/settings.h"

namespace rasterwalk {

/// Something that may have been done to a right picture.
struct Deed {
    std::string id, name; ///< as those of a Suspect
    Assignments set;      ///< what makes it, but for the stage; may be empty
    Orientation orientation = Orientation::upright;
    int right = 0, down = 0;  ///< pixels by which the picture is moved
    const Bug* bug = nullptr; ///< of the laboratory; null: it is none
};

/// All mistakes of the laboratory, then every other word of every choice that the scene can use,
/// then a picture that is turned, and one that is moved by a pixel. The bugs must live as long.
std::vector<Deed> known_deeds(const std::vector<Bug>& bugs, const Scene& scene);

/// A picture that was tried: the right one by some rules, and what was done to it.
struct Trying {
    Settings right;
    std::vector<const Deed*> deeds;
};

/// How it is made.
PictureRecipe recipe_of(const Trying& trying);

/// By which rules and with which numbers it is right, beside those of the reference: each as
/// "light.power=9".
std::vector<std::string> rules_beside(const Settings& right, const Settings& reference);

/// Everything that was tried and is drawn, in no order; the first is the reference. Asks the trial:
/// as long as that is waiting, more is to come.
std::vector<Trying> search_picture(PictureTrial& trial, const Settings& reference,
                                   const std::vector<Deed>& deeds);

/// What a trying assumes, in units of one mistake; a rule or a number that is not wrong costs less.
double assumptions_of(const Trying& trying, const Settings& reference);

/// Of these the one without a deed that comes nearest. What it leaves is to be explained.
const Trying& best_base(PictureTrial& trial, const std::vector<Trying>& tried,
                        const Settings& reference);

/// What an assumption must be worth, in wrong pixels: more where more of them are wrong at the
/// stage that comes nearest. All stages must be drawn.
double assumption_unit(PictureTrial& trial, const Settings& reference);

/// The wrong pixels that a trying leaves, and those that its assumptions must be worth.
double price_of(PictureTrial& trial, const Trying& trying, const Settings& reference, double unit);

} // namespace rasterwalk
