#include "session/strip.h"

#include <algorithm>

#include "session/session.h"

namespace rasterwalk {

namespace {

bool is_always(const Scene&, const Settings&) {
    return true;
}

bool has_camera(const Scene& scene, const Settings&) {
    return scene.space == SceneSpace::world;
}

bool has_matrices(const Scene& scene, const Settings& s) {
    return has_camera(scene, s) && s.transform == Transform::matrices;
}

/// Is anything clipped, rejected or culled, besides what the lab leaves out?
bool has_clipping(const Scene& scene, const Settings& s) {
    const bool clips = s.clip != Clip::leave_out && s.clip != Clip::none;
    return has_camera(scene, s) && (clips || s.reject != Reject::none || s.cull != Cull::none);
}

bool tests_edges(const Scene&, const Settings& s) {
    return s.coverage == Coverage::edge_functions;
}

/// Do flat, Gouraud and Phong shading differ in more than where the light is computed?
bool has_shadings(const Scene& scene, const Settings& s) {
    const CornerDifferences& differ = scene.mesh.differences();
    return has_camera(scene, s) && (differ.normals || differ.colours || scene.mesh.is_shiny());
}

bool has_paint(const Scene& scene, const Settings& s) {
    return has_camera(scene, s) && has_texture(scene);
}

bool has_bent_normals(const Scene& scene, const Settings& s) {
    return has_camera(scene, s) && has_normal_map(scene);
}

bool has_samples_of_pixels(const Scene&, const Settings& s) {
    return sampling_rule(s) != Sampling::centre;
}
bool has_shadows(const Scene& scene, const Settings& s) {
    return shadow_rule(s, scene.space) != Shadows::off;
}

template <Stage stage>
bool reaches(const Scene&, const Settings& s) {
    return s.stage >= stage;
}

bool is_flat(const Scene& scene, const Settings& s) {
    return has_shadings(scene, s) && shading_rule(s) == Shading::flat;
}

bool is_lit_at_vertices(const Scene&, const Settings& s) {
    return shading_rule(s) == Shading::gouraud;
}

/// Also of a shading that has no entry of its own.
bool is_lit_at_pixels(const Scene& scene, const Settings& s) {
    return reaches<Stage::shade>(scene, s) && !is_flat(scene, s) && !is_lit_at_vertices(scene, s);
}

bool is_painted(const Scene& scene, const Settings& s) {
    return has_paint(scene, s) && reaches<Stage::shade>(scene, s) && s.texture == TextureUse::on;
}

bool is_bent(const Scene& scene, const Settings& s) {
    return has_bent_normals(scene, s) && bends_normals(s);
}

template <Stage stage>
void draw_up_to(const Scene&, Settings& s) {
    set_step(s, {stage});
}

/// What a scene does not have is left as it is: the next scene may have it.
void use_images(const Scene& scene, TextureUse texture, NormalMapUse normal_map, Settings& s) {
    if (has_texture(scene)) s.texture = texture;
    if (has_normal_map(scene)) s.normal_map = normal_map;
}

template <Shading shading>
void shade(const Scene& scene, Settings& s) {
    set_step(s, {Stage::shade, shading});
    use_images(scene, TextureUse::off, NormalMapUse::off, s);
}

void paint(const Scene& scene, Settings& s) {
    s.stage = Stage::shade;
    use_images(scene, TextureUse::on, NormalMapUse::off, s);
}

/// Only light at every pixel has a normal to bend.
void bend(const Scene& scene, Settings& s) {
    set_step(s, StripStep::pixel_light);
    use_images(scene, TextureUse::on, NormalMapUse::on, s);
}

/// A step that is a stage, with the words and the tab of the stage.
StripEntry stage_entry(std::string_view name, StripGroup group, StripJoin join,
                       bool (*is_computed)(const Scene&, const Settings&),
                       void (*set)(const Scene&, Settings&)) {
    const StageInfo& info = *find_stage(name);
    return {.name = info.name,
            .group = group,
            .join = join,
            .words = {info.title, info.menu_help},
            .is_usable = info.needs_depth ? has_camera : is_always,
            .is_computed = is_computed,
            .set = set,
            .tab = info.tab};
}

std::vector<StripEntry> make_strip_list() {
    using Group = StripGroup;
    constexpr StripJoin follows = StripJoin::follows, alternative = StripJoin::alternative;
    const StripEntry space{
        .name = "space",
        .group = Group::view,
        .words = {"Space", "Goes to the shown triangle's vertices, which the matrices take from "
                           "space to space, and shows them from outside; changes no setting."},
        .is_usable = has_matrices,
        .is_computed = is_always,
        .tab = "vertices"};
    const StripEntry clip{
        .name = "clip",
        .group = Group::view,
        .words = {"Clip", "Goes to where the shown triangle is clipped or culled, and shows it "
                          "from outside; changes no setting."},
        .is_usable = has_clipping,
        .is_computed = is_always,
        .tab = "clip"};
    StripEntry rows = stage_entry("rows", Group::coverage, follows, reaches<Stage::rows>,
                                  draw_up_to<Stage::rows>);
    rows.other_words = {"Inside", "Which pixels are inside every triangle, by its edge functions."};
    rows.has_other_words = tests_edges;
    const StripEntry flat{.name = "flat",
                          .group = Group::light,
                          .join = alternative,
                          .words = {"Flat", "Light computed once for every triangle."},
                          .is_usable = has_shadings,
                          .is_computed = is_flat,
                          .set = shade<Shading::flat>,
                          .tab = "fragment"};
    StripEntry vertex_light = stage_entry("vertex_light", Group::light, alternative,
                                          is_lit_at_vertices, shade<Shading::gouraud>);
    vertex_light.other_words = {"Gouraud", vertex_light.words.help};
    vertex_light.has_other_words = has_shadings;
    StripEntry pixel_light = stage_entry("pixel_light", Group::light, alternative, is_lit_at_pixels,
                                         shade<Shading::phong>);
    pixel_light.other_words = {"Phong", pixel_light.words.help};
    pixel_light.has_other_words = has_shadings;
    const StripEntry texture{.name = "texture",
                             .group = Group::surface,
                             .words = {"Texture", "The colour of surfaces, read from an image."},
                             .is_usable = has_paint,
                             .is_computed = is_painted,
                             .set = paint,
                             .tab = "texture"};
    const StripEntry normal_map{
        .name = "normal_map",
        .group = Group::surface,
        .words = {"Normal map", "Normals that an image bends before the light is computed."},
        .is_usable = has_bent_normals,
        .is_computed = is_bent,
        .set = bend,
        .tab = "fragment"};
    const StripEntry shadow{
        .name = "shadow",
        .group = Group::surface,
        .words = {"Shadow", "Goes to where shadows are found: the first picture of the shadow map, "
                            "or the picked pixel's fragment; changes no setting."},
        .is_usable = has_shadows,
        .is_computed = has_shadows,
        .tab = "fragment"};
    const StripEntry resolve{
        .name = "resolve",
        .group = Group::picture,
        .words = {"Resolve", "Goes to where the samples of each pixel become one colour, after the "
                             "last triangle; changes no setting."},
        .is_usable = has_samples_of_pixels,
        .is_computed = has_samples_of_pixels,
        .tab = "history"};
    return {
        space,
        clip,
        stage_entry("points", Group::coverage, follows, is_always, draw_up_to<Stage::points>),
        stage_entry("edges", Group::coverage, follows, reaches<Stage::edges>,
                    draw_up_to<Stage::edges>),
        rows,
        stage_entry("fill", Group::coverage, follows, reaches<Stage::fill>,
                    draw_up_to<Stage::fill>),
        stage_entry("depth", Group::visibility, follows, reaches<Stage::depth>,
                    draw_up_to<Stage::depth>),
        flat,
        vertex_light,
        pixel_light,
        texture,
        normal_map,
        shadow,
        resolve,
    };
}

/// What may be known of the settings: during a quiz only that they were the lab's.
const Settings& known_settings(const Session& session) {
    static const Settings of_the_lab;
    return hides_settings(session) ? of_the_lab : session.a.settings;
}

StripRow entries_of_use(const Session& session, const Settings& settings) {
    const StripEntry* const chosen = &chosen_entry(session);
    StripRow row;
    for (const StripEntry& entry : strip_list()) {
        if (entry.is_usable(*session.scene, settings) || &entry == chosen) row.push_back(&entry);
    }
    return row;
}

const StripWords& words_of(const StripEntry& entry, const Session& session) {
    const bool has_others = entry.has_other_words != nullptr &&
                            entry.has_other_words(*session.scene, known_settings(session));
    return has_others ? entry.other_words : entry.words;
}

} // namespace

std::span<const StripEntry> strip_list() {
    static const std::vector<StripEntry> list = make_strip_list();
    return list;
}

StripRow usable_entries(const Session& session) {
    return entries_of_use(session, known_settings(session));
}

StripRow entries_of_all_steps(const Session& session) {
    Settings settings = known_settings(session);
    set_step(settings, StripStep::pixel_light);
    return entries_of_use(session, settings);
}

bool is_computed(const StripEntry& entry, const Session& session) {
    return entry.is_computed(*session.scene, session.a.settings);
}

const StripEntry& chosen_entry(const Session& session) {
    const std::span<const StripEntry> list = strip_list();
    return *std::find_if(list.rbegin(), list.rend(), [&](const StripEntry& entry) {
        return entry.set != nullptr && is_computed(entry, session);
    });
}

std::string title_of(const StripEntry& entry, const Session& session, const Language& language) {
    return std::string(tr(words_of(entry, session).title, language));
}

std::string help_of(const StripEntry& entry, const Session& session, const Language& language) {
    std::string help(tr(words_of(entry, session).help, language));
    const Scene& scene = *session.scene;
    if (entry.group != StripGroup::light) return help;
    const std::string sentence = help.substr(0, help.size() - 1);
    if (has_texture(scene)) return tr(language, "{}, without textures.", sentence);
    return has_normal_map(scene) ? tr(language, "{}, without normal maps.", sentence) : help;
}

StripJoin join_between(const StripEntry& before, const StripEntry& entry) {
    return before.group == entry.group ? entry.join : StripJoin::begins_group;
}

void take_step(Session& session, const StripEntry& entry) {
    if (entry.set == nullptr) return;
    const bool was_chosen = &chosen_entry(session) == &entry;
    entry.set(*session.scene, session.a.settings);
    follow_stage(session);
    // Textures and normal maps have tabs of their own within one stage.
    const bool is_of_light = entry.group >= StripGroup::light;
    if (!was_chosen && is_of_light && is_offered(session, *find_tab(entry.tab)))
        suggest_tab(session, entry.tab);
}

} // namespace rasterwalk
