#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <utility>

#include "pipeline/draw.h"
#include "scene/error.h"
#include "session/bug_rule.h"
#include "session/diagnose.h"
#include "session/setting_table.h"

namespace rasterwalk {

namespace {

enum class Orientation : std::uint8_t { upright, mirrored, upside_down, half_turn };

struct OrientationInfo {
    Orientation orientation;
    const char *id, *name;
};
constexpr std::array<OrientationInfo, 4> orientations{{
    {Orientation::upright, "upright", "upright"},
    {Orientation::mirrored, "mirrored", "Mirrored, left and right exchanged"},
    {Orientation::upside_down, "upside_down", "Upside down"},
    {Orientation::half_turn, "half_turn", "Turned by half a turn"},
}};

/// The picture with its pixels taken from elsewhere; black where that lies outside.
template <class From>
Image rearranged(const Image& image, From from) {
    Image result = image;
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
            const glm::ivec2 p = from(column, row);
            const bool is_inside = p.x >= 0 && p.x < image.width && p.y >= 0 && p.y < image.height;
            const auto place = [&](int x, int y) {
                return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                            static_cast<std::size_t>(x));
            };
            for (std::size_t i = 0; i < 3; ++i) {
                result.rgba[place(column, row) + i] =
                    is_inside ? image.rgba[place(p.x, p.y) + i] : std::uint8_t{0};
            }
        }
    }
    return result;
}

Image oriented(const Image& image, Orientation orientation) {
    const bool x = orientation == Orientation::mirrored || orientation == Orientation::half_turn;
    const bool y = orientation == Orientation::upside_down || orientation == Orientation::half_turn;
    return rearranged(image, [&](int column, int row) {
        return glm::ivec2(x ? image.width - 1 - column : column, y ? image.height - 1 - row : row);
    });
}

Image shifted(const Image& image, int dx, int dy) {
    return rearranged(image,
                      [&](int column, int row) { return glm::ivec2(column - dx, row - dy); });
}

/// FNV-1a.
std::uint64_t fingerprint(const Image& image) {
    std::uint64_t hash = 14695981039346656037u;
    for (const std::uint8_t byte : image.rgba)
        hash = (hash ^ byte) * 1099511628211u;
    return hash;
}

/// What was drawn and measured once.
struct Drawn {
    Settings settings;
    ImageDistance distance; ///< from the picture
    std::uint64_t print = 0;
};

/// Everything that is tried on one picture.
class Trial {
  public:
    Trial(const Image& picture, const Scene& scene) : picture_(picture), scene_(scene) {}

    const Drawn& drawn(const Settings& settings) {
        for (const Drawn& one : drawn_) {
            if (one.settings == settings) return one;
        }
        const Image image = draw_again(settings);
        drawn_.push_back({settings, image_distance(image, picture_), fingerprint(image)});
        return drawn_.back();
    }

    /// The picture itself, which is not kept.
    Image draw_again(const Settings& settings) const {
        return view_image(draw_frame(prepare_frame(scene_, settings)), View::colour);
    }

    void add(Hypothesis hypothesis, const ImageDistance& distance, std::uint64_t print) {
        hypothesis.distance = distance.mean;
        hypothesis.different = distance.different;
        hypothesis.result = print;
        hypotheses.push_back(std::move(hypothesis));
    }
    void add(Hypothesis hypothesis, const Image& image) {
        add(std::move(hypothesis), image_distance(image, picture_), fingerprint(image));
    }
    void add(Hypothesis hypothesis, const Drawn& one) {
        add(std::move(hypothesis), one.distance, one.print);
    }
    /// Of a mistake, with which the lamp's power may be fitted anew.
    void add(Hypothesis hypothesis, const Drawn& one, const Settings& settings) {
        tried.push_back({hypotheses.size(), settings});
        add(std::move(hypothesis), one);
    }

    const Scene& scene() const { return scene_; }
    const Image& picture() const { return picture_; }
    std::vector<Hypothesis> hypotheses;
    struct Tried {
        std::size_t hypothesis = 0; ///< its number
        Settings settings;
    };
    std::vector<Tried> tried;

  private:
    const Image& picture_;
    const Scene& scene_;
    std::deque<Drawn> drawn_; // whose members do not move
};

/// Settings from which the mistakes are tried, and what they assume beside the reference.
struct Base {
    Settings settings;
    std::string remark;
    int assumptions = 0;
};

std::string_view stage_name(Stage stage) {
    return stage_list()[static_cast<std::size_t>(stage)].name;
}

/// The lamp's power with which the picture comes nearest, all else as it is; none if it does not
/// show. Light is the sum of a part without the lamp and one that grows with its power, so two
/// pictures tell it.
std::optional<float> fitted_power(const Trial& trial, Settings settings) {
    if (lighting_of(settings.stage) == Lighting::none) return std::nullopt;
    const auto light = [&](float power) {
        settings.light.power = glm::vec3(power);
        return draw_frame(prepare_frame(trial.scene(), settings));
    };
    const Framebuffer without = light(0.0f), with = light(1.0f);
    double products = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < without.colour.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            const std::uint8_t byte =
                trial.picture().rgba[4 * i + static_cast<std::size_t>(channel)];
            const double part = static_cast<double>(with.colour[i][channel]) -
                                static_cast<double>(without.colour[i][channel]);
            // Black may be a gap, and white may be cut off.
            if (byte == 0 || byte == 255 || !(part > 0.0) || !std::isfinite(part)) continue;
            const double wanted =
                (byte + 0.5) / 255.0 - static_cast<double>(without.colour[i][channel]);
            products += part * wanted;
            squares += part * part;
        }
    }
    if (!(squares > 0.0)) return std::nullopt;
    const double power = products / squares;
    if (!(power > 0.0 && power < static_cast<double>(largest_power))) return std::nullopt;
    return static_cast<float>(power);
}

/// The power as a person would have chosen it, if that fits no worse.
float rounded_power(Trial& trial, Settings settings, float power) {
    const auto distance = [&](float value) {
        settings.light.power = glm::vec3(value);
        return trial.drawn(settings).distance.mean;
    };
    float best = power;
    double smallest = distance(power);
    for (const float digits : {1.0f, 10.0f, 100.0f}) {
        const float candidate = std::round(power * digits) / digits;
        if (candidate <= 0.0f) continue;
        const double there = distance(candidate);
        if (there < smallest) {
            best = candidate;
            smallest = there;
        }
    }
    return best;
}

/// The stage at which the picture comes nearest to having been drawn.
Stage nearest_stage(Trial& trial, const Settings& reference) {
    Settings settings = reference;
    Stage nearest = reference.stage;
    double smallest = trial.drawn(reference).distance.mean;
    for (const StageInfo& info : stage_list()) {
        settings.stage = info.stage;
        const double distance = trial.drawn(settings).distance.mean;
        if (distance < smallest) {
            nearest = info.stage;
            smallest = distance;
        }
    }
    return nearest;
}

std::string power_remark(const std::string& remark, const Settings& settings) {
    return (remark.empty() ? "with" : remark + " and")
        .append(" light.power=")
        .append(number_text(settings.light.power.x));
}

/// The settings with the lamp's power that fits best; none if it does not show, or no power brings
/// the picture clearly nearer.
std::optional<Settings> with_fitted_power(Trial& trial, const Settings& settings) {
    const std::optional<float> power = fitted_power(trial, settings);
    if (!power) return std::nullopt;
    Settings lit = settings;
    lit.light.power = glm::vec3(rounded_power(trial, settings, *power));
    constexpr double clearly_nearer = 0.9;
    const double nearer = trial.drawn(lit).distance.mean;
    if (nearer > clearly_nearer * trial.drawn(settings).distance.mean) return std::nullopt;
    return lit;
}

/// The reference, and what else the student may have set without it being a mistake: the stage and
/// the lamp's power.
std::vector<Base> find_bases(Trial& trial, const Settings& reference) {
    std::vector<Base> bases{{reference, "", 0}};
    const auto add = [&](const Settings& settings, const std::string& remark, int assumptions) {
        for (const Base& base : bases) {
            if (base.settings == settings) return;
        }
        bases.push_back({settings, remark, assumptions});
    };
    const auto at_stage = [&](Stage stage) {
        Settings settings = reference;
        settings.stage = stage;
        return settings;
    };
    const auto remark_of = [&](Stage stage) {
        return stage == reference.stage ? std::string()
                                        : std::string("with stage=").append(stage_name(stage));
    };
    const Stage nearest = nearest_stage(trial, reference);
    add(at_stage(nearest), remark_of(nearest), 1);
    for (const Stage stage : {Stage::vertex_light, Stage::pixel_light}) {
        const std::optional<Settings> lit = with_fitted_power(trial, at_stage(stage));
        if (!lit) continue;
        const std::string remark = remark_of(stage);
        add(*lit, power_remark(remark, *lit), remark.empty() ? 1 : 2);
    }
    return bases;
}

void try_bases(Trial& trial, const std::vector<Base>& bases) {
    for (const Base& base : bases) {
        if (base.assumptions == 0) continue;
        const Settings& first = bases.front().settings;
        const bool other_stage = base.settings.stage != first.stage;
        const bool other_power = !(base.settings.light == first.light);
        const std::string stage(stage_name(base.settings.stage));
        std::string name = other_stage ? "Drawn at stage " + stage : "";
        if (other_power) {
            name.append(name.empty() ? "Another" : " with another").append(" light power");
        }
        trial.add({.id = other_power ? "light_power" : "stage",
                   .name = std::move(name),
                   .remark = base.remark,
                   .assumptions = base.assumptions},
                  trial.drawn(base.settings));
    }
}

void try_orientations(Trial& trial, const std::vector<Base>& bases) {
    for (const Base& base : bases) {
        const Image image = trial.draw_again(base.settings);
        for (const OrientationInfo& info : orientations) {
            if (info.orientation == Orientation::upright) continue;
            trial.add({.id = info.id,
                       .name = info.name,
                       .remark = base.remark,
                       .assumptions = base.assumptions + 1},
                      oriented(image, info.orientation));
        }
    }
}

void try_shifts(Trial& trial, const std::vector<Base>& bases) {
    constexpr std::array<const char*, 3> across{"left", "", "right"}, along{"up", "", "down"};
    for (const Base& base : bases) {
        const Image image = trial.draw_again(base.settings);
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                if (dx == 0 && dy == 0) continue;
                const std::string where_x = across[static_cast<std::size_t>(dx + 1)];
                const std::string where_y = along[static_cast<std::size_t>(dy + 1)];
                const std::string both = where_x.empty() || where_y.empty() ? "" : " and a pixel ";
                std::string name = "Shifted by a pixel ";
                name.append(where_x).append(both).append(where_y);
                trial.add({.id = "shifted",
                           .name = std::move(name),
                           .remark = base.remark,
                           .assumptions = base.assumptions + 1},
                          shifted(image, dx, dy));
            }
        }
    }
}

/// The settings with a bug, unless it changes nothing about the picture.
void try_settings(Trial& trial, Hypothesis hypothesis, const Settings& settings,
                  const Settings& without) {
    const Drawn& one = trial.drawn(settings);
    if (one.print != trial.drawn(without).print) trial.add(std::move(hypothesis), one, settings);
}

Hypothesis suspicion(const Bug& bug, const std::string& remark, int assumptions) {
    return {.id = bug.id,
            .name = bug.name,
            .remark = remark,
            .assumptions = assumptions,
            .is_bug = true};
}

void try_bug(Trial& trial, const std::vector<Base>& bases, const Bug& bug) {
    const Settings& reference = bases.front().settings;
    // As the laboratory shows it, with its own stage and lamp.
    const Settings shown = wrong_run(bug, reference);
    Settings changed = reference;
    apply_bug_rule(bug, changed);
    if (changed == reference) {
        // The reference makes this mistake itself: not to be told from it at the same stage.
        Hypothesis hypothesis = suspicion(bug, "", 1);
        hypothesis.is_bug = false;
        if (!(shown == reference)) trial.add(std::move(hypothesis), trial.drawn(shown));
        return;
    }
    for (const Base& base : bases) {
        Settings settings = base.settings;
        apply_bug_rule(bug, settings);
        try_settings(trial, suspicion(bug, base.remark, base.assumptions + 1), settings,
                     base.settings);
    }
    try_settings(trial, suspicion(bug, "", 1), shown, correct_run(bug, reference));
}

/// With a mistake in the picture the lamp's power was not fitted well: again with the mistakes that
/// come nearest.
void try_powers_again(Trial& trial) {
    constexpr std::size_t most_tried = 4;
    std::vector<Trial::Tried> nearest = trial.tried;
    std::sort(nearest.begin(), nearest.end(), [&](const Trial::Tried& a, const Trial::Tried& b) {
        return trial.hypotheses[a.hypothesis].distance < trial.hypotheses[b.hypothesis].distance;
    });
    if (nearest.size() > most_tried) nearest.resize(most_tried);
    for (const Trial::Tried& one : nearest) {
        const std::optional<Settings> lit = with_fitted_power(trial, one.settings);
        if (!lit) continue;
        Hypothesis hypothesis = trial.hypotheses[one.hypothesis];
        const std::size_t old = hypothesis.remark.find("light.power=");
        if (old != std::string::npos) {
            hypothesis.remark.replace(old, std::string::npos,
                                      "light.power=" + number_text(lit->light.power.x));
        } else {
            hypothesis.remark = power_remark(hypothesis.remark, *lit);
            ++hypothesis.assumptions;
        }
        trial.add(std::move(hypothesis), trial.drawn(*lit));
    }
}

/// Every other word of every choice but the stage.
void try_choices(Trial& trial, const std::vector<Base>& bases) {
    for (const Setting& setting : setting_table()) {
        const auto* const choice = std::get_if<ChoiceSetting>(&setting.kind);
        if (choice == nullptr || setting.name == "stage") continue;
        for (const std::string_view word : choice->words) {
            for (const Base& base : bases) {
                Settings settings = base.settings;
                set_value(settings, setting, word);
                std::string id = std::string(setting.name).append("=").append(word);
                Hypothesis hypothesis{.id = id,
                                      .name = "Drawn by " + id,
                                      .remark = base.remark,
                                      .assumptions = base.assumptions + 1};
                const Drawn& one = trial.drawn(settings);
                if (one.print == trial.drawn(base.settings).print) continue;
                trial.add(std::move(hypothesis), one);
            }
        }
    }
}

} // namespace

ImageDistance image_distance(const Image& a, const Image& b) {
    ImageDistance distance;
    std::int64_t sum = 0;
    for (std::size_t i = 0; i + 3 < a.rgba.size(); i += 4) {
        int pixel = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            pixel += std::abs(static_cast<int>(a.rgba[i + channel]) -
                              static_cast<int>(b.rgba[i + channel]));
        }
        sum += pixel;
        distance.different += pixel > 0 ? 1 : 0;
    }
    const double channels = 3.0 * static_cast<double>(a.rgba.size() / 4);
    if (channels > 0.0) distance.mean = static_cast<double>(sum) / channels;
    return distance;
}

Settings fitted_to(const Settings& settings, const Image& picture, SceneSpace space) {
    Settings fitted = settings;
    const std::string size =
        std::to_string(picture.width).append("x").append(std::to_string(picture.height));
    if (settings.viewport == Viewport{picture.width, picture.height}) return fitted;
    set_value(fitted, *find_setting("viewport.size"), size);
    if (space == SceneSpace::pixels) return fitted;
    const float growth = static_cast<float>(picture.height) /
                         static_cast<float>(std::max(settings.viewport.height, 1));
    set_value(fitted, *find_setting("camera.focal_length"),
              number_text(settings.camera.focal_length * growth));
    return fitted;
}

Diagnosis diagnose_picture(const Image& picture, const Scene& scene, const Settings& reference,
                           const std::vector<Bug>& bugs) {
    Trial trial(picture, scene);
    Diagnosis diagnosis;
    const ImageDistance apart = trial.drawn(reference).distance;
    diagnosis.distance = apart.mean;
    diagnosis.different = apart.different;
    if (!diagnosis.is_same()) {
        const std::vector<Base> bases = find_bases(trial, reference);
        try_bases(trial, bases);
        for (const Bug& bug : bugs)
            try_bug(trial, bases, bug);
        const bool is_found =
            std::any_of(trial.hypotheses.begin(), trial.hypotheses.end(),
                        [](const Hypothesis& h) { return h.is_bug && h.distance == 0.0; });
        if (!is_found) {
            try_powers_again(trial);
            try_choices(trial, bases);
            try_orientations(trial, bases);
            try_shifts(trial, bases);
        }
    }
    rank_suspects(std::move(trial.hypotheses), "this very picture", diagnosis);
    return diagnosis;
}

} // namespace rasterwalk
