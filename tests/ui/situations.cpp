#include "tests/ui/situations.h"

#include <sstream>

#include "picture/overlay.h"
#include "tests/support/catch.h"
#include "tests/ui/made_ladder.h"
#include "ui/actions/compare.h"
#include "ui/actions/lesson_links.h"
#include "ui/actions/open_lesson.h"
#include "ui/hand/key_names.h"
#include "ui/start/start_choice.h"

namespace rasterwalk {

namespace {

constexpr const char* room = "lab-room.toml";
constexpr const char* bench = "one-triangle.toml";

void take_step(Driver& driver, const std::string& step) {
    const std::size_t colon = step.find(':');
    const std::string verb = step.substr(0, colon);
    const std::string object = colon == std::string::npos ? "" : step.substr(colon + 1);
    if (verb == "click") {
        driver.hand.click(object);
    } else if (verb == "key") {
        const KeyPress pressed = parse_key(object);
        driver.hand.press(pressed.key, pressed.modifiers);
    } else if (verb == "lesson") {
        const std::size_t slash = object.find('/');
        open_lesson(driver.ui, object.substr(0, slash), std::stoi(object.substr(slash + 1)));
    } else if (verb == "layers") {
        for (const OverlayInfo& info : overlay_list())
            driver.ui.session.overlays.set(info.overlay, true);
    } else if (verb == "start") {
        begin_at_start(driver.ui);
    } else if (verb == "shown_by") {
        for (const CompareViewInfo& info : compare_view_list()) {
            if (info.name == object) driver.ui.session.compare_view = info.view;
        }
    } else if (verb == "measured") {
        show_made_times(driver);
    } else if (verb == "two_runs") {
        toggle_compare(driver.ui);
    } else {
        follow_link(driver.ui, step);
        INFO(step << ": " << driver.ui.session.notice);
        REQUIRE(driver.ui.session.notice.empty());
    }
    driver.hand.frames(1);
}

} // namespace

std::vector<std::string> words_of_list(const std::string& list) {
    std::istringstream in(list);
    std::vector<std::string> words;
    for (std::string word; in >> word;)
        words.push_back(word);
    return words;
}

void bring_about(Driver& driver, const Situation& situation) {
    for (const std::string& step : words_of_list(situation.steps))
        take_step(driver, step);
    driver.hand.leave();
}

const std::vector<Situation>& workplace_situations() {
    static const std::vector<Situation> all{
        // The triangle: its vertices, clipping, rows, samples.
        {room, "tab:vertices triangle:7 set:camera.yaw=0.1 click:vertices.pixel.column.v0",
         "vertices.other_roundings vertices.other_convention vertices.light.R.blue.v2 "
         "vertices.world.x.v0 vertices.pixel.column.v0 vertices.formula.result"},
        {room, "tab:vertices triangle:7 set:transform=matrices"},
        {"corridor.toml", "tab:vertices triangle:0"},
        {"cylinder.toml", "tab:vertices"},
        {"corridor.toml", "tab:clip set:clip=none triangle:0"},
        {"corridor.toml", "tab:clip set:clip=all triangle:0 click:clip.t.0.0",
         "clip.corner.0.x clip.corner.0.w clip.code.5.2 clip.d.0.0.to clip.new.0.w "
         "clip.pixel.0.row clip.cull.screen_area clip.count.fragments_outside "
         "clip.formula.result"},
        {"corridor.toml", "tab:clip set:clip=all&transform=matrices triangle:5", "clip.plane.near"},
        {"inside-out.toml", "tab:clip triangle:1"},
        {room, "tab:rows triangle:22"},
        {room, "set:stage=rows tab:rows triangle:20"},
        {bench, "cursor:t0/e1/s5 tab:rows"},
        {bench, "key:3 key:End tab:rows", "rows.values rows.header.left"},
        {"sample-outside.toml", "tab:rows"},
        {bench,
         "set:coverage=edge_functions set:stage=fill cursor:t0/b4/c7 tab:rows click:inside.e.1",
         "inside.e.0 inside.e.1 inside.e.2 inside.area inside.weight.0 inside.weight.1 "
         "inside.weight.2 rows.5.right inside.formula.expression"},
        {"shared-edge.toml",
         "set:coverage=edge_functions&stage=fill tab:rows triangle:1 pixel:5,5"},
        {"dented.toml", "set:coverage=edge_functions&stage=fill tab:rows triangle:0 pixel:4,11",
         "inside.way.table inside.way.fan inside.way.active_edges"},
        {"dented.toml", "set:coverage=edge_functions&stage=fill tab:rows triangle:2",
         "inside.way.table inside.way.fan inside.way.active_edges"},
        {room, "set:coverage=edge_functions tab:rows triangle:21 pixel:250,300"},
        {room, "set:stage=edges triangle:7 cursor:t7/e2/s373 tab:microscope",
         "microscope.header.5 microscope.edge.0 microscope.edge.1 microscope.edge.2"},
        {room, "tab:microscope triangle:12",
         "microscope.header.0 microscope.header.1 microscope.header.4 microscope.header.5"},
        {room, "set:stage=depth&hidden=painter triangle:12 tab:hidden",
         "hidden.way.bsp hidden.painter.wrong hidden.depth_buffer.wrong"},
        {room, "set:stage=depth&hidden=bsp cursor:t20/r3/c2 tab:hidden canvas:both",
         "hidden.plane.0 hidden.bsp.wrong"},
        {room, "set:stage=depth&hidden=warnock cursor:w40 tab:hidden",
         "hidden.square hidden.reason hidden.warnock.wrong"},
        // The pixel: its fragment, texture, history, and the graph of its row.
        {room, "tab:fragment pixel:398,121 click:fragment.z.perspective",
         "fragment.z_world.off fragment.light.per_vertex fragment.pixel_light.R.red fragment.after "
         "fragment.fate fragment.pixel fragment.go fragment.z_world fragment.z_world.affine "
         "fragment.formula.result"},
        {room, "tab:fragment"},
        {room, "tab:fragment set:interpolation=zinv_twice canvas:both"},
        {"studs.toml", "pixel:42,26 tab:fragment click:fragment.bump.arrow.y"},
        {room, "set:stage=pixel_light&shadows=rays pixel:410,449 tab:fragment"},
        {room, "set:stage=pixel_light&shadows=map pixel:410,449 tab:fragment"},
        {room, "set:stage=pixel_light&shadows=map cursor:p3:t1/r200/c9 tab:fragment"},
        {room, "set:stage=pixel_light&shadows=map cursor:p3:end tab:vertices canvas:both"},
        {"glass-halves.toml", "pixel:7,5 tab:fragment"},
        {"checkered-floor.toml",
         "tab:texture pixel:120,92 set:texture_filter=trilinear click:texture.texel.0"},
        {"checkered-floor.toml", "tab:texture pixel:120,140"},
        {"brick-heights.toml", "tab:texture pixel:160,118 click:texture.show.normal_map",
         "texture.arrow.x texture.normal_map.red"},
        {"brick-heights.toml", "tab:texture pixel:160,118 click:texture.show.height_map",
         "texture.height_map.red texture.height_map.height"},
        {room, "tab:history pixel:240,300", "", "walk.previous_change walk.next_change"},
        {room, "tab:history"},
        {"two-panes.toml", "tab:history pixel:8,7"},
        {room, "tab:graph triangle:5 pixel:398,121",
         "graph.row.previous graph.row.next graph.row graph.where"},
        {bench, "tab:graph pixel:9,12"},
        {room, "set:stage=edges tab:fragment"},
        {room, "set:stage=edges tab:graph"},
        {room, "set:stage=points tab:fragment pixel:3,3"},
        {bench, "tab:fragment pixel:0,0"},
        {bench, "tab:graph pixel:0,0"},
        {bench, "key:Home tab:graph"},
        {"checkered-floor.toml", "tab:texture pixel:2,2"},
        {"checkered-floor.toml", "set:stage=edges tab:texture"},
        // Two runs, mistakes, settings.
        {room, "tab:compare"},
        {bench, "tab:compare"},
        {"wide-wall.toml", "tab:compare"},
        {room, "set:stage=depth pixel:200,350 two_runs tab:compare shown_by:difference",
         "compare.end compare.swap compare.first compare.next compare.previous "
         "compare.count.moments"},
        {room, "pixel:200,350 two_runs tab:compare shown_by:wipe", "compare.end compare.swap"},
        {room, "pixel:200,350 two_runs tab:compare shown_by:side_by_side",
         "compare.end compare.swap"},
        {room, "pixel:200,350 two_runs tab:compare shown_by:blink", "compare.end compare.swap"},
        {room, "tab:lab", "lab.mode.bugs lab.mode.quiz lab.mode.result"},
        {room, "tab:lab click:lab.mode.quiz", "lab.quiz.start lab.two lab.seed lab.keep_score"},
        {room, "tab:lab click:lab.mode.result"},
        {room, "bug:B3 tab:lab"},
        {room, "bug:B17a tab:lab"},
        {room, "set:stage=depth tab:speed", "speed.obstacle speed.light speed.rung.1"},
        {room, "set:stage=pixel_light tab:speed", "speed.status speed.change", "speed.measure"},
        {room, "set:stage=pixel_light measured tab:speed click:speed.rung.1",
         "speed.rung.0 speed.rung.1 speed.all speed.rounds speed.file speed.foot", "speed.measure"},
        {room, "tab:settings", "settings.preset.handout settings.preset.exact settings.search"},
        {room, "set:camera.yaw=-0.3 tab:settings", "settings.search", "setting.camera.yaw"},
        // The stages, and what is around the picture.
        {room, "key:1"},
        {room, "key:2"},
        {room, "key:3", "lesson.previous lesson.next lesson.bar.rows"},
        {room, "key:4"},
        {room, "key:5"},
        {room, "key:6"},
        {room, "key:7"},
        {bench, "key:7"},
        {"brick-relief.toml", "set:transform=matrices&clip=all&shadows=rays"},
        {"cylinder.toml", "set:coverage=edge_functions&shading=flat&cull=face_normal"},
        {room, "view:overdraw pixel:250,400"},
        {room, "view:depth", "",
         "depth.far depth.near depth.histogram depth.autofit depth.far_text depth.near_text"},
        {room, "overlay:wireframe overlay:drawn_twice overlay:depth", "",
         "legend.wireframe legend.drawn_twice legend.depth canvas.overlays canvas.fit"},
        {room, "set:stage=pixel_light layers"},
        {room, "layers pixel:250,400"},
        {room, "canvas:both"},
        {room, "canvas:outside"},
    };
    return all;
}

const std::vector<Situation>& passing_situations() {
    static const std::vector<Situation> all{
        {room, "key:F1"},
        {room, "key:F2"},
        {room, "key:Ctrl+O", "",
         "files.path files.folder files.up files.here files.do files.cancel"},
        {room, "key:Ctrl+S", "",
         "files.path files.folder files.up files.here files.do files.cancel"},
        {room, "click:canvas.overlays"},
        {room, "click:menu.File"},
        {room, "click:menu.Edit"},
        {room, "click:menu.View"},
        {room, "click:menu.Scene"},
        {room, "click:menu.Lesson"},
        {room, "click:menu.Stage"},
        {room, "click:menu.Compare"},
        {room, "click:menu.Walk"},
        {room, "click:menu.Help"},
        {room, "key:L"},
        {room, "start", "", "start.lessons start.stages start.picture"},
        // Lessons and lectures.
        {room, "lesson:05-row-table/3"},
        {room, "lesson:05-row-table/4 key:T"},
        {room, "lesson:08-depth-buffer/5", "", "graph.row graph.plot graph.legend"},
        {room, "lesson:10-light-per-pixel/2", "",
         "fragment.pixel fragment.place fragment.zinv.perspective fragment.z.perspective "
         "fragment.x.perspective"},
        {room, "lesson:10-light-per-pixel/2 key:F5", "", "lesson.next lesson.whole lecture.leave"},
        // A quiz.
        {room, "tab:lab click:lab.mode.quiz click:lab.quiz.start",
         "lab.choice.B3 lab.guess lab.hint lab.give_up"},
    };
    return all;
}

} // namespace rasterwalk
