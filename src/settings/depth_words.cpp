#include "settings/depth_words.h"

#include <array>

namespace rasterwalk {

const DepthWords& depth_words(ClipDepth kind) {
    static constexpr std::array list{
        DepthWords{ClipDepth::inv_z, "1/z", "1/z", "0 is infinitely far; larger is nearer.",
                   "larger", "smaller"},
        DepthWords{ClipDepth::ndc, "NDC z", "NDC z",
                   "0 at the near plane, 1 at the far one; smaller is nearer.", "smaller",
                   "larger"},
        DepthWords{ClipDepth::reversed, "reversed z", "rev z",
                   "1 minus NDC z: 1 at the near plane, 0 at the far one; larger is nearer.",
                   "larger", "smaller"},
    };
    static_assert(is_indexed_by(list, &DepthWords::kind));
    return list[static_cast<std::size_t>(kind)];
}

const DepthWords& depth_words(const Settings& settings, SceneSpace space) {
    return depth_words(clip_depth_rule(settings, space));
}

} // namespace rasterwalk
