#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.h"
#include "compare/compare.h"
#include "pipeline/clearing.h"
#include "settings/value_words.h"

namespace rasterwalk {

namespace {

/// Pictures of more than this are not kept for the next comparison.
constexpr std::size_t most_kept_bytes = std::size_t{32} << 20;

/// The finished row table of a triangle; without rows if the run makes none.
void make_rows(const Frame& frame, int triangle, PolygonRows& rows) {
    rows.left.clear();
    rows.right.clear();
    if (!frame.is_drawn(triangle) || frame.settings.stage < Stage::edges) return;
    compute_rows(frame, triangle, rows);
}

/// The rows of the picture in which the two tables differ.
std::int64_t different_rows(const PolygonRows& a, const PolygonRows& b) {
    if (a.size() == 0 || b.size() == 0) return a.size() + b.size();
    const int first = std::min(a.first_row, b.first_row);
    const int last = std::max(a.first_row + a.size(), b.first_row + b.size());
    std::int64_t different = 0;
    for (int row = first; row < last; ++row) {
        const int i = row - a.first_row, k = row - b.first_row;
        const bool in_a = i >= 0 && i < a.size(), in_b = k >= 0 && k < b.size();
        if (!in_a && !in_b) continue; // between two tables that do not overlap
        const bool same = in_a && in_b && a.left[i].column == b.left[k].column &&
                          a.right[i].column == b.right[k].column;
        different += same ? 0 : 1;
    }
    return different;
}

/// An engine without moments that draws one of the runs: "run B is drawn by rays". Empty if the
/// steps draw both.
std::string without_moments_text(const Frame& a, const Frame& b, const Cursor& to) {
    const auto words_of = [&](std::string_view run, const Frame& frame) -> std::string {
        if (drawing_engine(*frame.scene, frame.settings, to) == Engine::steps) return {};
        return fmt::format("{} drawn by {}", run,
                           value_words(*find_setting("engine"), frame.settings));
    };
    const std::string of_a = words_of("Run A is", a), of_b = words_of("run B is", b);
    if (of_a.empty()) return words_of("Run B is", b);
    if (of_b.empty()) return of_a;
    if (a.settings.engine == b.settings.engine) return words_of("Both runs are", a);
    return of_a + " and " + of_b;
}

/// Why no moments of the runs before this one can be compared: they divide the scene into different
/// triangles, or an engine without moments draws one of them. Empty if they can.
std::string no_moments_text(const Frame& a, const Frame& b, const Cursor& to) {
    if (const std::string text = without_moments_text(a, b, to); !text.empty())
        return text + "; only the steps have moments, so only the pictures are compared.";
    if (have_same_moments(a, b)) return {};
    if (a.squares != nullptr || b.squares != nullptr) {
        return "A or B divides the picture into squares, so only the pictures are compared.";
    }
    if (a.has_samples() || b.has_samples()) {
        return "A or B has several samples for each pixel, so only the pictures are compared.";
    }
    if (a.list != nullptr || b.list != nullptr) {
        return "A and B do not draw the same triangles in the same order, so only the pictures are "
               "compared.";
    }
    return fmt::format("A draws {} for each triangle of the scene and B {}, so only the pictures "
                       "are compared.",
                       counted(a.triangles_of_each(), "triangle", "triangles"),
                       b.triangles_of_each());
}

constexpr std::string_view program_text =
    "Of your program only the pixels that it puts are known, so only the pictures are compared";

/// Where the program first puts another pixel than we do, as the only divergence.
void add_parting(const ProgramDrawing& program, DivergenceList& list) {
    const std::optional<Cursor> moment = moment_of_parting(program);
    if (!moment) return;
    const SequenceParting& parting = *program.parting;
    const DivergenceKind kind = !parting.theirs ? DivergenceKind::missing
                                : !parting.ours ? DivergenceKind::extra
                                                : DivergenceKind::other;
    list.count = 1;
    list.first = Divergence{*moment, kind, false, parting_text(parting)};
    list.first_beyond_rounding = list.first;
    if (*moment != cursor_end)
        list.groups.push_back({moment->triangle, moment->phase, kind, 1, *moment, *moment});
}

} // namespace

void ComparisonWork::begin(const Frame& a, const Frame& b, const Cursor& to,
                           std::shared_ptr<const ProgramDrawing> program) {
    end();
    a_ = &a;
    b_ = &b;
    to_ = to;
    work_a_.start(a);
    work_b_.start(b);
    stage_ = ComparisonStage::estimated;
    divergences_ = {};
    pixels_ = {};
    done_ = 0;
    triangles_ = std::min(a.triangle_count(), std::max(to.triangle, 0));
    found_ = {};
    if (program == nullptr) {
        found_.only_pictures = no_moments_text(a, b, to);
    } else {
        // With other settings run A need not put the pixels that the program's were compared with.
        const bool has_order = a.settings == b.settings;
        found_.only_pictures =
            std::string(program_text) + (has_order ? ", and the order of the pixels." : ".");
        if (has_order) add_parting(*program, found_.divergences);
    }
    if (found_.only_pictures.empty()) {
        begin_clearing(cleared_a_, a);
        begin_clearing(cleared_b_, b);
        return;
    }
    pictures_ = std::make_unique<PicturePair>();
    pictures_->b.program = std::move(program);
}

/// Keeps the memory of the pictures for the next comparison, unless it is too much.
void ComparisonWork::end() {
    stage_ = ComparisonStage::done;
    if (walk_ != nullptr) {
        cleared_a_ = walk_->a.take_picture();
        cleared_b_ = walk_->b.take_picture();
    }
    walk_ = nullptr;
    pictures_ = nullptr;
    if (cleared_a_.bytes() + cleared_b_.bytes() > 2 * most_kept_bytes) cleared_a_ = cleared_b_ = {};
}

bool ComparisonWork::estimate(const WorkLimit& limit) {
    for (FrameWork* const work : {&work_a_, &work_b_}) {
        if (work->is_done()) continue;
        work->advance(limit);
        if (!work->is_done()) return false;
    }
    return true;
}

bool ComparisonWork::clear_pictures(const WorkLimit& limit) {
    return clear_rows(cleared_a_, limit) && clear_rows(cleared_b_, limit);
}

double ComparisonWork::missing_work() const {
    const Cursor from = beginning_of(walk_->walk.triangle());
    return compare_work_factor * (work_a_.before(to_) - work_a_.before(from) + work_b_.before(to_) -
                                  work_b_.before(from));
}

/// Counts the rows of the triangles that the walk has passed.
void ComparisonWork::end_triangles() {
    const int end = walk_->walk.is_done() ? a_->triangle_count() : walk_->walk.triangle();
    for (; done_ < end && Cursor{done_, Phase::rows, 0, 0} < to_; ++done_) {
        make_rows(*a_, done_, rows_a_);
        make_rows(*b_, done_, rows_b_);
        found_.different_rows += different_rows(rows_a_, rows_b_);
    }
}

void ComparisonWork::PictureWork::begin(const Frame& frame, FrameWork& work, const Cursor& to) {
    if (program != nullptr) {
        put.begin(program, frame);
        return;
    }
    engine = drawing_engine(*frame.scene, frame.settings, to);
    if (engine == Engine::steps) steps.begin(frame, work);
}

bool ComparisonWork::PictureWork::advance(const Frame& frame, FrameWork& work, const Cursor& to,
                                          const WorkLimit& limit) {
    if (program != nullptr) {
        put.go_to(puts_at(*program, to));
        return true;
    }
    if (engine != Engine::steps) {
        // The frame outlives the work, and its scene with it.
        advance_engine_planes({std::shared_ptr<void>(), frame.scene}, frame, limit, planes);
        if (planes.fault.empty()) return planes.is_whole;
        engine = Engine::steps; // as in the picture that is shown
        steps.begin(frame, work);
    }
    steps.toward(to, {.at_once = limit.at_once, .slice = limit.slice});
    return !(steps.drawn() < to);
}

/// A's and then B's. False: something is left.
bool ComparisonWork::draw_pictures(const WorkLimit& limit) {
    const bool is_a_drawn = pictures_->a.advance(*a_, work_a_, to_, limit);
    const Cursor& drawn = pictures_->a.steps.drawn();
    done_ = is_a_drawn ? triangles_ : std::min(drawn.triangle, triangles_);
    const bool are_drawn = is_a_drawn && pictures_->b.advance(*b_, work_b_, to_, limit);
    for (const PictureWork* const one : {&pictures_->a, &pictures_->b}) {
        if (!one->planes.fault.empty())
            found_.only_pictures = one->planes.fault + ", so only the pictures are compared.";
    }
    return are_drawn;
}

/// Goes through the moments of both runs. False: some are left.
bool ComparisonWork::walk(const WorkLimit& limit) {
    const bool is_little = missing_work() <= limit.at_once;
    const auto end = static_cast<double>(walk_->walk.work()) + limit.slice / compare_work_factor;
    while (!walk_->walk.is_done() && (is_little || static_cast<double>(walk_->walk.work()) < end)) {
        divergences_.walk_part(*a_, *b_, walk_->walk, found_.divergences);
        end_triangles();
    }
    if (!walk_->walk.is_done()) return false;
    end_triangles();
    return true;
}

/// The pixels are counted when both pictures are drawn. False: some are left.
bool ComparisonWork::count_pixels(const WorkLimit& limit) {
    const Framebuffer& a = walk_ != nullptr ? walk_->a.picture() : pictures_->a.picture(to_);
    const Framebuffer& b = walk_ != nullptr ? walk_->b.picture() : pictures_->b.picture(to_);
    const int rows = rows_within(limit, count_pixel_work, a.size, pixels_.rows());
    std::function<void(glm::ivec2)> add_reason;
    // What our stages do there is no reason for what a program does.
    if (pictures_ != nullptr && pictures_->b.program == nullptr) {
        add_reason = [&](glm::ivec2 place) {
            found_.reasons.add({*a_, a, pictures_->a.engine}, {*b_, b, pictures_->b.engine}, place);
        };
    }
    pixels_.count_to(a, b, pixels_.rows() + rows, add_reason);
    if (pixels_.rows() < a.size.height) return false;
    found_.pixels = pixels_.found();
    return true;
}

/// Goes on with the current stage, and moves to the next. False: some of it is left.
bool ComparisonWork::advance_stage(const WorkLimit& limit) {
    switch (stage_) {
    case ComparisonStage::estimated:
        if (!estimate(limit)) return false;
        if (pictures_ != nullptr) {
            pictures_->a.begin(*a_, work_a_, to_);
            pictures_->b.begin(*b_, work_b_, to_);
        }
        stage_ = pictures_ != nullptr ? ComparisonStage::drawn : ComparisonStage::cleared;
        return true;
    case ComparisonStage::cleared:
        if (!clear_pictures(limit)) return false;
        walk_ = std::make_unique<DrawnWalk>(*a_, *b_, to_, std::exchange(cleared_a_, {}),
                                            std::exchange(cleared_b_, {}));
        stage_ = ComparisonStage::walked;
        return true;
    case ComparisonStage::walked:
        if (!walk(limit)) return false;
        stage_ = ComparisonStage::counted;
        return true;
    case ComparisonStage::drawn:
        if (!draw_pictures(limit)) return false;
        stage_ = ComparisonStage::counted;
        return true;
    case ComparisonStage::counted:
        if (!count_pixels(limit)) return false;
        end();
        return true;
    case ComparisonStage::done:
        return false;
    }
    return false;
}

void ComparisonWork::advance(const WorkLimit& limit) {
    while (advance_stage(limit)) {
    }
}

Comparison compare_runs(const Frame& a, const Frame& b, const Cursor& to) {
    ComparisonWork work;
    work.begin(a, b, to);
    work.advance();
    return work.found();
}

} // namespace rasterwalk
