#include "inspect/visibility_hints.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/numbers.h"
#include "pipeline/draw.h"
#include "settings/setting_table.h"
#include "stages/cull.h"
#include "stages/stages.h"

namespace rasterwalk {

namespace {

/// The work of counting a pixel, relative to a fragment.
constexpr double count_work = 0.4;

bool is_back(const Frame& frame, int triangle, const SightRays& rays) {
    return away_from_camera(as_one_face(frame.given_clip_vertices(triangle)), rays) > 0.0f;
}

void count_visible_rows(const Frame& frame, const Framebuffer& picture, int from, int to,
                        VisiblePixels& visible) {
    const SightRays rays = sight_rays(vertex_rules(frame.settings, frame.scene->space));
    const auto width = static_cast<std::size_t>(picture.size.width);
    int known = -1;
    bool known_is_back = false;
    const std::size_t end = static_cast<std::size_t>(to) * width;
    for (std::size_t i = static_cast<std::size_t>(from) * width; i < end; ++i) {
        const int triangle = picture.owner[i];
        if (triangle < 0) continue;
        if (triangle != known) {
            known = triangle;
            known_is_back = is_back(frame, triangle, rays);
        }
        ++visible.surface;
        visible.backs += known_is_back ? 1 : 0;
        const glm::vec3& colour = picture.colour[i];
        visible.lit += is_invisible(colour) ? 0 : 1;
        const float largest = std::clamp(std::max({colour.r, colour.g, colour.b}), 0.0f, 1.0f);
        visible.light += std::lround(255.0f * largest);
    }
}

/// Is every part of the scene transparent by its material?
bool is_clear(const Scene& scene) {
    return std::all_of(scene.parts.begin(), scene.parts.end(),
                       [](const Part& part) { return is_invisible(glm::vec3(part.alpha)); });
}

/// "blend=off (the 'Half-transparent' setting)"
std::string named(const std::vector<std::string>& assignments) {
    std::string text;
    for (const std::string& assignment : assignments) {
        const Setting* const setting = find_setting(assignment.substr(0, assignment.find('=')));
        text += fmt::format("{}{} (the '{}' setting)", text.empty() ? "" : " and ", assignment,
                            setting->title);
    }
    return text;
}

} // namespace

VisiblePixels count_visible(const Frame& frame, const Framebuffer& picture) {
    VisiblePixels visible;
    count_visible_rows(frame, picture, 0, picture.size.height, visible);
    return visible;
}

VisibilityHintsWork::VisibilityHintsWork(const Frame& frame, const Framebuffer& picture)
    : frame_(&frame), picture_(&picture),
      is_done_(!frame.given->model_report || !has_fragments(frame.settings.stage) ||
               picture.owner.size() > most_hinted_pixels ||
               frame.triangle_count() > most_hinted_triangles) {}

void VisibilityHintsWork::advance(const WorkLimit& limit) {
    if (is_done_) return;
    if (now_.rows < picture_->size.height) {
        if (count(*frame_, *picture_, limit, now_)) choose_tries();
    } else if (draw_try(limit)) {
        is_begun_ = false;
        ++done_;
    }
    is_done_ = now_.rows == picture_->size.height && done_ == tries_.size();
}

/// Counts the next rows; true: those were the last.
bool VisibilityHintsWork::count(const Frame& frame, const Framebuffer& picture,
                                const WorkLimit& limit, Count& count) {
    const int rows = rows_within(limit, count_work, picture.size, count.rows);
    count_visible_rows(frame, picture, count.rows, count.rows + rows, count.visible);
    count.rows += rows;
    return count.rows == picture.size.height;
}

void VisibilityHintsWork::choose_tries() {
    const Settings& settings = frame_->settings;
    const Scene& scene = *frame_->scene;
    const auto add = [&](Remedy remedy, std::vector<std::string> assignments) {
        if (!assignments.empty()) tries_.push_back({remedy, std::move(assignments), {}});
    };
    if (is_black()) {
        std::vector<std::string> opaque;
        if (has_alpha(scene) && settings.blend != Blend::off) opaque.emplace_back("blend=off");
        if (has_texture_alpha(scene) && settings.texture_alpha != TextureAlpha::off)
            opaque.emplace_back("texture_alpha=off");
        add(Remedy::opaque, std::move(opaque));
    }
    const bool is_lit = shading_rule(settings) != Shading::unlit;
    const bool is_one_sided = settings.light_rules.sides == LightSides::one;
    // If both sides are lit, backs are wanted.
    const bool are_unwanted = are_backs() && settings.cull == Cull::none && is_one_sided;
    if (are_unwanted) add(Remedy::without_backs, {"cull=face_normal"});
    if (is_lit && is_one_sided && (are_unwanted || is_black()))
        add(Remedy::lit_from_both_sides, {"light.sides=two"});
    if (!is_black() || now_.visible.surface == 0) return;
    if (is_lit && settings.light.place != LampPlace::camera)
        add(Remedy::lamp_at_camera, {"light.place=camera"});
    if (!scene.textures.empty() && settings.texture == TextureUse::on)
        add(Remedy::without_images, {"texture=off"});
}

void VisibilityHintsWork::begin_try() {
    Settings settings = frame_->settings;
    for (const std::string& assignment : tries_[done_].settings)
        set_from_text(settings, assignment);
    other_.tessellated = frame_->tessellated;
    other_.divided = frame_->divided;
    other_.occluders = frame_->occluders;
    preparation_ = begin_frame(*frame_->given, settings, frame_->replace, other_);
    is_prepared_ = false;
    other_count_ = {};
    is_begun_ = true;
}

/// Goes on with a try; true: it is drawn and counted, or too much work.
bool VisibilityHintsWork::draw_try(const WorkLimit& limit) {
    if (!is_begun_) begin_try();
    if (preparation_) {
        preparation_->advance(limit);
        if (!preparation_->is_done()) return false;
        preparation_ = std::nullopt;
        work_.start(other_);
    }
    if (!is_prepared_) {
        work_.advance({limit.slice, limit.slice});
        if (!work_.is_done()) return false;
        replay_.begin(other_, work_);
        is_prepared_ = true;
    }
    if (!replay_.is_at(cursor_end)) {
        replay_.toward(cursor_end, limit);
        return replay_.is_deferred(cursor_end, limit);
    }
    const Framebuffer& drawn = replay_.toward(cursor_end, limit);
    if (!count(other_, drawn, limit, other_count_)) return false;
    tries_[done_].visible = other_count_.visible;
    return true;
}

VisibilityHint VisibilityHintsWork::hint_of(const Try& tried) const {
    const auto pixels = [](std::int64_t count) { return counted(count, "pixel", "pixels"); };
    const std::string all = pixels(now_.visible.surface), settings = named(tried.settings);
    VisibilityHint hint{{}, {}, {}, tried.settings, {}};
    switch (tried.remedy) {
    case Remedy::opaque:
        hint.finding = is_clear(*frame_->scene) || now_.visible.surface == 0
                           ? "The model is transparent, so you cannot see it"
                           : "Everything you see is black or transparent";
        hint.in_short = "Nothing visible";
        hint.act = "draw it opaque";
        hint.help =
            fmt::format("{} {} {} of it.", settings, tried.settings.size() == 1 ? "shows" : "show",
                        pixels(tried.visible.lit));
        return hint;
    case Remedy::without_backs:
        hint.act = "leave them out";
        hint.help = settings + " shows what is behind them.";
        break;
    case Remedy::lit_from_both_sides:
        hint.act = "light both sides";
        hint.help = settings + " lights them too.";
        break;
    case Remedy::lamp_at_camera:
        hint.act = "put the lamp at the camera";
        break;
    case Remedy::without_images:
        hint.act = "leave the images out";
        break;
    }
    if (tried.remedy == Remedy::without_backs || !is_black()) {
        hint.finding =
            fmt::format("Most of what you see is back faces, {} of {}", now_.visible.backs, all);
        hint.in_short = "Back faces";
    } else {
        hint.finding = "Everything you see is black";
        hint.in_short = "All black";
        hint.help = fmt::format("{} shows {} of {}.", settings, tried.visible.lit, all);
    }
    return hint;
}

/// Does this setting show more?
bool VisibilityHintsWork::helps(const Try& tried) const {
    const VisiblePixels &before = now_.visible, &visible = tried.visible;
    // Next to nothing would be left of a sheet.
    if (tried.remedy == Remedy::without_backs)
        return visible.lit > 0 && 2 * visible.surface > before.surface;
    return is_black() ? visible.lit > 0 : 20 * visible.light > 21 * before.light;
}

std::vector<VisibilityHint> VisibilityHintsWork::hints() const {
    std::vector<VisibilityHint> hints;
    const Try* brightest = nullptr; // of those that light a black picture
    for (const Try& tried : tries_) {
        if (!helps(tried)) continue;
        const bool lights = is_black() && tried.remedy > Remedy::without_backs;
        if (!lights) hints.push_back(hint_of(tried));
        if (lights && (brightest == nullptr || tried.visible.lit > brightest->visible.lit))
            brightest = &tried;
    }
    if (brightest != nullptr) hints.push_back(hint_of(*brightest));
    return hints;
}

std::vector<VisibilityHint> visibility_hints(const Frame& frame, const Framebuffer& picture) {
    VisibilityHintsWork work(frame, picture);
    while (!work.is_done())
        work.advance();
    return work.hints();
}

} // namespace rasterwalk
