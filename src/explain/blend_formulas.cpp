#include "explain/blend_formulas.h"

#include "explain/fragment_report.h"
#include "explain/light_formulas.h"

namespace rasterwalk {

void add_blend(FragmentReport& report, const Frame& frame) {
    if (!(report.alpha < 1.0f) || report.fate != Fate::written) return;
    const bool is_swapped = frame.settings.blend == Blend::swapped;
    for (int i = 0; i < 3; ++i) {
        const std::string name = channel_names[static_cast<std::size_t>(i)];
        report.formulas.push_back(
            {"blend." + name,
             "blended " + name,
             is_swapped ? "The surface blended over what was there, by mistake with the weights of "
                          "the surface and the pixel swapped."
                        : "The surface blended over what was there: a share α of the surface and "
                          "the rest of the pixel.",
             is_swapped ? "(1 − α) · S + α · D" : "α · S + (1 − α) · D",
             {{"α",
               {report.alpha},
               from_words(report.texture_alpha == TextureAlpha::blend
                              ? "the alpha of the surface times the alpha of its texture here"
                              : "the alpha of the surface, as the scene gives it")},
              {"S", {report.colour[i]}, from_words("the colour of the fragment by itself")},
              {"D", {report.before[i]}, from_words("what the pixel showed before")}},
             {report.after[i]}});
    }
}

} // namespace rasterwalk
