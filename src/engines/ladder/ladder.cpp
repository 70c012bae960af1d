#include "engines/ladder/ladder.h"

#include <array>
#include <system_error>
#include <thread>

#include "engines/fast/simd_level.h"
#include "engines/ladder/rungs.h"
#include "engines/own_engine.h"
#include "engines/own_engines.h"

namespace rasterwalk {

namespace {

template <rungs::Draw draw_rung>
class RungEngine final : public OwnEngine {
  public:
    RungEngine(const Scene& scene, const Settings& settings) : OwnEngine(settings), scene_(scene) {}

  private:
    void draw(const Settings& settings) override { draw_rung(scene_, settings, picture_); }
    std::vector<std::uint32_t> colours() const override { return picture_.colour; }

    const Scene& scene_;
    LadderPicture picture_;
};

template <rungs::Draw draw_rung>
std::unique_ptr<TimedEngine> make_rung(const Scene& scene, const Settings& settings) {
    return std::make_unique<RungEngine<draw_rung>>(scene, settings);
}

using DrawWithPool = void(const Scene&, const Settings&, LadderPicture&, WorkerPool&);

template <DrawWithPool draw_rung>
class PoolEngine final : public OwnEngine {
  public:
    PoolEngine(const Scene& scene, const Settings& settings)
        : OwnEngine(settings), scene_(scene), pool_(ladder_threads()) {}

  private:
    void draw(const Settings& settings) override { draw_rung(scene_, settings, picture_, pool_); }
    std::vector<std::uint32_t> colours() const override { return picture_.colour; }

    const Scene& scene_;
    WorkerPool pool_;
    LadderPicture picture_;
};

template <DrawWithPool draw_rung>
std::unique_ptr<TimedEngine> make_with_pool(const Scene& scene, const Settings& settings) {
    return std::make_unique<PoolEngine<draw_rung>>(scene, settings);
}

std::unique_ptr<TimedEngine> make_fast(const Scene& scene, const Settings& settings) {
    return fast_engine(scene, settings, best_simd_level(), ladder_threads());
}

constexpr std::array<Rung, 9> rung_list{{
    {.name = "lab_loop",
     .title = "The lab's loop",
     .change = "The loop as a student writes it: a vector for every edge and every row.",
     .why = "It is where the ladder begins: every gain is measured from here.",
     .file = "lab_loop.cpp",
     .make = make_rung<rungs::lab_loop::draw>},
    {.name = "kept_vectors",
     .title = "Vectors that stay",
     .change = "The vectors are allocated once, and used again for every edge and row.",
     .why = "No memory is asked for, cleared and given back at each edge and row.",
     .file = "kept_vectors.cpp",
     .make = make_rung<rungs::kept_vectors::draw>},
    {.name = "no_vectors",
     .title = "No vectors",
     .change = "A pixel is used as soon as interpolation has made it; only the ends of rows are "
               "kept.",
     .why = "The pixels of a row are no longer written to memory and read again.",
     .file = "no_vectors.cpp",
     .make = make_rung<rungs::no_vectors::draw>},
    {.name = "depth_first",
     .title = "Depth first",
     .change = "Along a row only 1/z is stepped; the rest is worked out for pixels that pass the "
               "depth test.",
     .why = "A hidden pixel costs an addition and a comparison; where little is hidden, as in the "
            "lab's room, that gains little or nothing.",
     .file = "depth_first.cpp",
     .make = make_rung<rungs::depth_first::draw>},
    {.name = "one_division",
     .title = "One division, one root",
     .change = "Light is worked out from values that are still divided by z.",
     .why = "Divisions and roots take longer than products, and now there is at most one of each.",
     .file = "one_division.cpp",
     .make = make_rung<rungs::one_division::draw>},
    {.name = "edge_functions",
     .title = "Edge functions",
     .change = "Edge functions, not a row table, say where a row begins and ends; centres of "
               "pixels count.",
     .why = "Nothing is carried along edges, and a pixel's place in the world follows from its "
            "column, row and 1/z.",
     .file = "edge_functions.cpp",
     .has_other_edges = true,
     .make = make_rung<rungs::edge_functions::draw>},
    {.name = "many_at_a_time",
     .title = "Many pixels at a time",
     .change = "The loop over a row has no branch, so the compiler makes it draw several pixels "
               "at once.",
     .why = "One instruction works on four or eight numbers; that some pixels are lit in vain "
            "costs less.",
     .file = "many_at_a_time.cpp",
     .make = make_rung<rungs::many_at_a_time::draw>},
    {.name = "bands",
     .title = "Two threads",
     .change = "The picture is divided into bands of rows, and two threads draw every second one.",
     .why = "They share no pixel, so neither waits for the other at one; that helps only if a "
            "second processor is free.",
     .file = "bands.cpp",
     .threads = 2,
     .make = make_with_pool<rungs::bands::draw>},
    {.name = "fast_engine",
     .title = "The fast engine",
     .change = "Near triangles come first, vertices are shaded once, and loops are written for "
               "this machine's instructions.",
     .why = "Groups of pixels that are hidden are not lit, and light in a plane has a short "
            "formula: see fast/large_triangle.h.",
     .file = "../fast/fast_engine.cpp",
     .threads = 2,
     .make = make_fast},
}};

constexpr std::array<Rung, 4> wrong_list{{
    {.name = "light_before_depth",
     .title = "Light before depth",
     .change = "Every pixel gets its light before its depth is tested.",
     .why = "The light of every hidden pixel is worked out for nothing.",
     .file = "light_before_depth.cpp",
     .against = "depth_first",
     .make = make_rung<rungs::light_before_depth::draw>},
    {.name = "whole_box",
     .title = "The whole box",
     .change = "Every pixel of a triangle's box is tested against all three edges.",
     .why = "A triangle covers at most half of the box around it, so many tests are for nothing.",
     .file = "whole_box.cpp",
     .against = "edge_functions",
     .make = make_rung<rungs::whole_box::draw>},
    {.name = "columns_first",
     .title = "Columns first",
     .change = "The loop over columns is outside, the loop over rows inside.",
     .why = "Pixels that follow each other are a whole row apart in memory, so no instruction "
            "reads several at once.",
     .file = "columns_first.cpp",
     .against = "many_at_a_time",
     .make = make_rung<rungs::columns_first::draw>},
    {.name = "two_threads_one_buffer",
     .title = "Two threads, one depth buffer",
     .change = "Two threads take the triangles in turn and share one depth buffer without a lock.",
     .why = "Between the test of a pixel and its write the other thread can write something "
            "nearer, which is lost.",
     .file = "two_threads_one_buffer.cpp",
     .threads = 2,
     .against = "edge_functions",
     .is_random = true,
     .make = make_with_pool<rungs::two_threads_one_buffer::draw>},
}};

} // namespace

int ladder_threads() {
    static const int threads = [] {
        try {
            std::thread([] {}).join();
            return most_threads;
        } catch (const std::system_error&) {
            return 1;
        }
    }();
    return threads;
}

std::span<const Rung> ladder() {
    return rung_list;
}

std::span<const Rung> wrong_turnings() {
    return wrong_list;
}

std::size_t rung_count() {
    return rung_list.size() + wrong_list.size();
}

const Rung& rung_at(std::size_t place) {
    return place < rung_list.size() ? rung_list[place] : wrong_list[place - rung_list.size()];
}

std::size_t rung_before(std::size_t place) {
    const std::string_view against = rung_at(place).against;
    if (against.empty()) return place == 0 ? 0 : place - 1;
    std::size_t before = 0;
    while (rung_at(before).name != against)
        ++before;
    return before;
}

const Rung* find_rung(std::string_view name) {
    for (std::size_t place = 0; place < rung_count(); ++place) {
        if (rung_at(place).name == name) return &rung_at(place);
    }
    return nullptr;
}

} // namespace rasterwalk
