#include "view/situation.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/quoted.h"
#include "picture/view_image.h"
#include "pipeline/frame.h"
#include "session/content.h"
#include "session/moments.h"
#include "session/scene_file.h"
#include "session/second_run.h"
#include "settings/setting_table.h"

namespace rasterwalk {

namespace {

namespace fs = std::filesystem;

/// The file in one folder, if it is there and the path does not lead out of the folder, not even by
/// a link of the file system.
std::optional<std::string> find_within(const fs::path& folder, const fs::path& relative) {
    std::error_code fault;
    const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, fault);
    if (fault) return std::nullopt;
    const fs::path file = fs::canonical(root / relative, fault);
    if (fault || !fs::is_regular_file(file, fault)) return std::nullopt;
    const auto [end, ignored] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
    if (end != root.end()) return std::nullopt;
    return (folder / relative).lexically_normal().string();
}

/// Carries out one situation; collects what goes wrong with the line of the key.
class Applier {
  public:
    Applier(Session& session, const Situation& situation)
        : session_(session), situation_(situation) {}

    std::vector<Fault> apply(const std::string& folder) {
        attempt("scene", [&] { open_scene(folder); });
        if (session_.scene == nullptr) return std::move(faults_);
        set_all();
        return apply();
    }

    std::vector<Fault> apply() {
        attempt("vertices", [&] {
            for (const PlacedTriangle& placed : situation_.vertices)
                place_triangle(session_, placed);
        });
        reset_view();
        const Frame frame = prepare_frame(*session_.scene, session_.settings);
        if (situation_.cursor) {
            attempt("cursor", [&] { session_.cursor = moment_of(frame, *situation_.cursor); });
        }
        select();
        compare();
        return std::move(faults_);
    }

  private:
    template <class Deed>
    void attempt(std::string_view key, Deed deed) {
        try {
            deed();
        } catch (const Error& fault) {
            faults_.push_back({situation_.line_of(key), fault.what()});
        }
    }

    void open_scene(const std::string& folder) {
        const std::string wanted = situation_.scene.value_or(std::string(usual_scene));
        set_scene(session_, read_scene_file(find_lesson_file(folder, wanted)));
    }

    void set_all() {
        session_.settings = default_settings(*session_.scene);
        for (const std::string& assignment : situation_.set)
            attempt("set", [&] { set_from_text(session_.settings, assignment); });
    }

    /// As in a fresh session, where the situation does not say otherwise.
    void reset_view() {
        session_.cursor = cursor_end;
        session_.selection = {};
        session_.play.running = false;
        session_.play.owed = 0.0f;
        session_.view = situation_.view.value_or(View::colour);
        session_.overlays = situation_.overlays.value_or(OverlaySet{});
        session_.depth_range = situation_.depth_range;
        session_.compare_view = situation_.compare_view.value_or(session_.compare_view);
        session_.wipe = situation_.wipe.value_or(session_.wipe);
        session_.canvas.grid = situation_.grid.value_or(session_.canvas.grid);
        session_.tab = situation_.tab.value_or("rows");
        session_.canvas.zoom = situation_.zoom.value_or(0.0f);
        const Viewport& size = session_.settings.viewport;
        const glm::vec2 middle(0.5f * static_cast<float>(size.width),
                               0.5f * static_cast<float>(size.height));
        const glm::vec2 near = situation_.pixel ? glm::vec2(*situation_.pixel) : middle;
        session_.canvas.centre = situation_.centre.value_or(near);
        ++session_.jumps; // so that Back leads out of the lesson's place again
    }

    void select() {
        const Viewport& size = session_.settings.viewport;
        const int triangles = static_cast<int>(session_.scene->triangles.size());
        Selection& selection = session_.selection;
        selection.triangle = checked("triangle", situation_.triangle, triangles, "triangles");
        selection.row = checked("row", situation_.row, size.height, "rows");
        selection.vertex = checked("vertex", situation_.vertex, triangle_corners, "vertices");
        const std::optional<glm::ivec2>& pixel = situation_.pixel;
        if (!pixel) return;
        if (pixel->x < 0 || pixel->y < 0 || pixel->x >= size.width || pixel->y >= size.height) {
            report("pixel", "the pixel " + std::to_string(pixel->x).append(",") +
                                std::to_string(pixel->y).append(" lies outside the picture of ") +
                                std::to_string(size.width).append(" x ") +
                                std::to_string(size.height).append(" pixels."));
        } else {
            selection.pixel = pixel;
        }
    }

    std::optional<int> checked(std::string_view key, std::optional<int> number, int count,
                               const char* what) {
        if (!number || (*number >= 0 && *number < count)) return number;
        report(key, "there is no " + std::string(key).append(" ") +
                        std::to_string(*number).append(": the ") + what + " are 0 to " +
                        std::to_string(count - 1).append("."));
        return std::nullopt;
    }

    void report(std::string_view key, std::string sentence) {
        faults_.push_back({situation_.line_of(key), std::move(sentence)});
    }

    void compare() {
        stop_comparing(session_);
        if (!situation_.compare) return;
        attempt("compare", [&] {
            compare_with(session_, settings_with(session_.settings, *situation_.compare));
        });
    }

    Session& session_;
    const Situation& situation_;
    std::vector<Fault> faults_;
};

} // namespace

int Situation::line_of(std::string_view key) const {
    const auto found = lines.find(key);
    return found != lines.end() ? found->second : line;
}

Situation combined(const Situation& base, const Situation& over) {
    Situation result = base;
    const auto take = [](auto& value, const auto& newer) {
        if (newer) value = newer;
    };
    take(result.scene, over.scene);
    result.set.insert(result.set.end(), over.set.begin(), over.set.end());
    take(result.cursor, over.cursor);
    take(result.pixel, over.pixel);
    take(result.triangle, over.triangle);
    take(result.row, over.row);
    take(result.vertex, over.vertex);
    take(result.tab, over.tab);
    take(result.view, over.view);
    take(result.overlays, over.overlays);
    take(result.zoom, over.zoom);
    take(result.centre, over.centre);
    take(result.compare, over.compare);
    take(result.compare_view, over.compare_view);
    take(result.wipe, over.wipe);
    take(result.grid, over.grid);
    take(result.depth_range, over.depth_range);
    if (!over.vertices.empty()) result.vertices = over.vertices;
    if (!over.point_at.empty()) result.point_at = over.point_at;
    if (over.line != 0) result.line = over.line;
    for (const auto& [key, line] : over.lines)
        result.lines[key] = line;
    return result;
}

std::vector<Fault> apply_situation(Session& session, const Situation& situation,
                                   const std::string& folder) {
    return Applier(session, situation).apply(folder);
}

std::vector<Fault> apply_on_scene(Session& session, const Situation& situation) {
    return Applier(session, situation).apply();
}

std::string find_lesson_file(const std::string& folder, std::string_view relative) {
    const fs::path path(relative);
    const bool leads_out =
        std::any_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
    if (path.empty() || path.is_absolute() || leads_out) {
        throw UsageError(in_quotes(relative) + " leads out of the folder of the lessons.");
    }
    if (const auto found = find_within(folder, path)) return *found;
    if (const auto found = find_within(lessons_folder(), path)) return *found;
    throw UsageError("there is no file " + in_quotes(relative) + " in the folder of the lessons.");
}

Settings settings_with(const Settings& settings, const std::vector<std::string>& assignments) {
    Settings result = settings;
    for (const std::string& assignment : assignments)
        set_from_text(result, assignment);
    return result;
}

} // namespace rasterwalk
