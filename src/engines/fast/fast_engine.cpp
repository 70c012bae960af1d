#include "engines/fast/fast_engine.h"

#include <algorithm>
#include <chrono>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "engines/fast/cut_triangles.h"
#include "engines/fast/fast_mesh.h"
#include "engines/fast/large_triangle.h"
#include "engines/fast/worker_pool.h"

namespace rasterwalk {

namespace {

using fast::most_lanes;

const fast::Loops& loops_of(SimdLevel level) {
    switch (level) {
    case SimdLevel::scalar:
        break;
#if defined(RASTERWALK_X86_LOOPS)
    case SimdLevel::sse2:
        return fast::sse2_loops();
    case SimdLevel::clones:
        return fast::clones_loops();
    case SimdLevel::avx2:
        return fast::avx2_loops();
    case SimdLevel::avx512:
        return fast::avx512_loops();
#else
    default:
        break;
#endif
    }
    return fast::scalar_loops();
}

/// A part of the vertices or triangles, in whole lanes.
struct Share {
    std::int32_t first, end;
};
Share share_of(std::int32_t count, int part, int parts) {
    const std::int32_t groups = (count + most_lanes - 1) / most_lanes;
    const auto border = [&](int i) {
        return std::min(count,
                        static_cast<std::int32_t>(std::int64_t{groups} * i / parts) * most_lanes);
    };
    return {border(part), border(part + 1)};
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

struct FastEngine::State {
    /// Some of a picture's triangles. Memory is kept from picture to picture.
    struct Triangles {
        AlignedVector<std::int32_t> memory;
        fast::TriangleList list{};

        /// Empties it.
        void reserve(std::size_t count) {
            const std::size_t room =
                (count + 2 * static_cast<std::size_t>(most_lanes)) & ~std::size_t{most_lanes - 1};
            if (memory.size() < 4 * room) memory.resize(4 * room);
            std::int32_t* const begin = memory.data();
            list = {begin, begin + room, begin + 2 * room, begin + 3 * room, 0};
        }
        /// The lanes after the last are read, but not drawn.
        void pad() {
            for (std::int32_t* of : {list.number, list.a, list.b, list.c})
                std::fill_n(of + list.count, most_lanes, 0);
        }
        std::span<const std::int32_t> numbers() const {
            return {list.number, static_cast<std::size_t>(list.count)};
        }
    };

    /// The triangles of one band that one thread has found.
    struct FoundTriangles {
        Triangles tiny, small, medium, large;
    };

    State(FastMesh to_draw, const FastOptions& with)
        : options(with), loops(loops_of(with.level)), mesh(std::move(to_draw)), pool(with.threads) {
        const auto bands = static_cast<std::size_t>(band_count());
        // One more than there are threads: the triangles made by cutting are sorted separately.
        found.resize((bands + 1) * bands);
        cut.resize(bands);
        large.resize(bands);
        rows.resize(bands);
        band_seconds.resize(bands);
        row_inv_z.resize(bands);
        row_owner.resize(bands);
    }

    int band_count() const { return pool.count(); }
    /// What a thread has found for a band; thread band_count() is cutting.
    FoundTriangles& found_by(int thread, int band) {
        return found[static_cast<std::size_t>(thread * band_count() + band)];
    }
    void sort(const fast::View& view, int thread, const Share& triangles);
    void prepare(const fast::View& view);
    bool has_dense_triangles();
    void draw_band(const fast::View& view, int band, fast::Planes planes);
    void set_borders(int height);

    FastOptions options;
    const fast::Loops& loops;
    FastMesh mesh;
    std::vector<int> borders;          ///< rows at which bands begin, then the height
    std::vector<double> band_seconds;  ///< that the bands of the last picture took
    std::vector<FoundTriangles> found; ///< by thread, and then by band
    std::vector<Triangles> cut;        ///< by thread
    std::vector<std::vector<fast::LargeTriangle>> large; ///< by band, like all that follows
    std::vector<AlignedVector<fast::LargeRows>> rows;
    AlignedVector<fast::Visible> visible;
    std::vector<AlignedVector<float>> row_inv_z; ///< a block of rows, if no planes are kept
    std::vector<AlignedVector<std::int32_t>> row_owner;
    WorkerPool pool; ///< last: its threads end before the data they work on
};

void FastEngine::State::sort(const fast::View& view, int thread, const Share& triangles) {
    std::vector<fast::BandLists> lists;
    const auto room = static_cast<std::size_t>(triangles.end - triangles.first);
    for (int band = 0; band < band_count(); ++band) {
        FoundTriangles& of = found_by(thread, band);
        for (Triangles* triangles_of_size : {&of.tiny, &of.small, &of.medium, &of.large})
            triangles_of_size->reserve(room);
        const auto b = static_cast<std::size_t>(band);
        lists.push_back({borders[b], borders[b + 1], &of.tiny.list, &of.small.list, &of.medium.list,
                         &of.large.list});
    }
    Triangles none;
    Triangles& reaching_out = thread < band_count() ? cut[static_cast<std::size_t>(thread)] : none;
    reaching_out.reserve(room);
    loops.sort_triangles(mesh.view(), view, triangles.first, triangles.end, lists.data(),
                         band_count(), reaching_out.list);
    for (int band = 0; band < band_count(); ++band) {
        FoundTriangles& of = found_by(thread, band);
        for (Triangles* padded : {&of.tiny, &of.small, &of.medium})
            padded->pad();
    }
}

/// Places and light of the vertices, then the triangles by band and size, cut where they must be.
void FastEngine::State::prepare(const fast::View& view) {
    mesh.drop_cut();
    const fast::Mesh lanes = mesh.view();
    pool.run([&](int t) {
        const Share vertices = share_of(mesh.vertex_count, t, band_count());
        const std::int32_t count = vertices.end - vertices.first;
        loops.project_vertices(lanes, view, vertices.first, count);
        if (view.light_at == fast::LightAt::vertices)
            loops.light_vertices(lanes, view, vertices.first, count);
    });
    pool.run([&](int t) { sort(view, t, share_of(mesh.triangle_count, t, band_count())); });
    for (const Triangles& reaching_out : cut)
        cut_triangles(reaching_out.numbers(), view, mesh);
    sort(view, band_count(),
         {mesh.triangle_count, static_cast<std::int32_t>(mesh.triangles.size())});
}

bool FastEngine::State::has_dense_triangles() {
    return std::any_of(found.begin(), found.end(), [](const FoundTriangles& of) {
        return of.tiny.list.count + of.small.list.count + of.medium.list.count > 0;
    });
}

void FastEngine::State::draw_band(const fast::View& view, int band, fast::Planes planes) {
    const auto b = static_cast<std::size_t>(band);
    const auto start = std::chrono::steady_clock::now();
    const fast::Mesh lanes = mesh.view();
    std::vector<std::int32_t> numbers;
    for (int thread = 0; thread <= band_count(); ++thread) {
        const std::span<const std::int32_t> more = found_by(thread, band).large.numbers();
        numbers.insert(numbers.end(), more.begin(), more.end());
    }
    set_up_large(numbers, view, mesh, planes.is_kept == 0, large[b]);
    rows[b].resize(large[b].size());
    const fast::Band part{.first_row = borders[b],
                          .end_row = borders[b + 1],
                          .large = large[b].data(),
                          .large_count = static_cast<std::int32_t>(large[b].size()),
                          .rows = rows[b].data(),
                          .source = mesh.source.data(),
                          .cut_from = mesh.cut_from.data()};
    if (planes.is_kept == 0) {
        const std::size_t block = static_cast<std::size_t>(planes.stride) * fast::block_rows;
        row_inv_z[b].resize(block);
        row_owner[b].resize(block);
        planes.inv_z = row_inv_z[b].data();
        planes.owner = row_owner[b].data();
    }
    if (planes.visible != nullptr) {
        const auto at = [&](int row) { return static_cast<std::ptrdiff_t>(row) * planes.stride; };
        std::fill(planes.visible + at(part.first_row), planes.visible + at(part.end_row), 0);
        for (int thread = 0; thread <= band_count(); ++thread) {
            const FoundTriangles& of = found_by(thread, band);
            loops.draw_medium(lanes, view, of.medium.list, part, planes);
            loops.draw_small(lanes, view, of.small.list, part, planes);
            loops.draw_tiny(lanes, view, of.tiny.list, part, planes);
        }
    }
    loops.finish_rows(lanes, view, part, planes);
    band_seconds[b] = seconds_since(start);
}

/// Bands that would have taken the same time, judging by the last picture: all rows of a band count
/// the same.
void FastEngine::State::set_borders(int height) {
    const auto bands = static_cast<std::size_t>(band_count());
    std::vector<int> next(bands + 1, height);
    double total = 0.0;
    for (const double seconds : band_seconds)
        total += seconds;
    const bool knows = borders.size() == bands + 1 && borders.back() == height && total > 0.0;
    next[0] = 0;
    for (std::size_t b = 1; b < bands; ++b) {
        const double wanted = static_cast<double>(b) / static_cast<double>(bands);
        if (!knows) {
            next[b] = static_cast<int>(wanted * height);
            continue;
        }
        double before = 0.0;
        std::size_t in = 0;
        while (in + 1 < bands && before + band_seconds[in] < wanted * total)
            before += band_seconds[in++];
        const double share = (wanted * total - before) / std::max(band_seconds[in], 1e-9);
        const int row = borders[in] + static_cast<int>(share * (borders[in + 1] - borders[in]));
        // Halfway: a single picture is no safe measure.
        next[b] = std::clamp((row + borders[b]) / 2, next[b - 1], height);
    }
    borders = std::move(next);
}

FastEngine::FastEngine(const Scene& scene, const FastOptions& options)
    : FastEngine(fast_mesh(scene), options) {}

FastEngine::FastEngine(FastMesh mesh, const FastOptions& options) {
    const std::vector<SimdLevel> levels = simd_levels();
    if (std::find(levels.begin(), levels.end(), options.level) == levels.end())
        throw UsageError("this machine or build has no " + std::string(word_of(options.level)));
    state_ = std::make_unique<State>(std::move(mesh), options);
}

FastEngine::~FastEngine() = default;
FastEngine::FastEngine(FastEngine&&) noexcept = default;
FastEngine& FastEngine::operator=(FastEngine&&) noexcept = default;

FastMesh& FastEngine::mesh() {
    return state_->mesh;
}

void FastEngine::draw(const Settings& settings, FastPicture& picture) {
    draw(fast_view(settings), picture);
}

void FastEngine::draw(const fast::View& view, FastPicture& picture) {
    State& s = *state_;
    const auto lanes = static_cast<std::size_t>(most_lanes);
    picture.size = {view.width, view.height};
    // A group of lanes can begin at the last pixel of a row.
    picture.stride = (static_cast<std::size_t>(view.width) + 2 * lanes - 1) / lanes * lanes;
    const std::size_t pixels = picture.stride * static_cast<std::size_t>(view.height);
    s.set_borders(view.height);
    s.prepare(view);
    const bool is_dense = s.has_dense_triangles();
    picture.colour.resize(pixels);
    if (s.options.keeps_planes) {
        picture.inv_z.resize(pixels);
        picture.owner.resize(pixels);
    } else {
        picture.inv_z.clear();
        picture.owner.clear();
    }
    if (is_dense) s.visible.resize(pixels);
    const fast::Planes planes{.stride = static_cast<std::int32_t>(picture.stride),
                              .colour = picture.colour.data(),
                              .visible = is_dense ? s.visible.data() : nullptr,
                              .inv_z = picture.inv_z.data(),
                              .owner = picture.owner.data(),
                              .is_kept = s.options.keeps_planes ? 1 : 0};
    s.pool.run([&](int band) { s.draw_band(view, band, planes); });
}

} // namespace rasterwalk
