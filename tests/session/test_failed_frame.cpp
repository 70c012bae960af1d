// What could not be prepared for lack of memory does not count as prepared the next time. The
// allocations of this test program go through the functions below, which can be made to fail.

#include <cstdlib>
#include <limits>
#include <memory>
#include <new>

#include "pipeline/draw.h"
#include "session/results.h"
#include "support/bits.h"
#include "support/made_scene.h"
#include "tests/support/catch.h"

namespace {

/// Larger blocks than this are refused, in this thread.
thread_local std::size_t largest_block = std::numeric_limits<std::size_t>::max();

} // namespace

void* operator new(std::size_t bytes) {
    if (bytes > largest_block) throw std::bad_alloc();
    if (void* const block = std::malloc(bytes > 0 ? bytes : 1)) return block;
    throw std::bad_alloc();
}
void operator delete(void* block) noexcept {
    std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
    std::free(block);
}

using namespace rasterwalk;

TEST_CASE("A frame that could not be prepared is prepared the next time") {
    Session session;
    session.scene = std::make_shared<const Scene>(test::made_scene(20));
    session.a.settings = default_settings(*session.scene);
    Results results;
    update(session, results);
    REQUIRE(results.a.frame.triangle_count() == 20);

    session.scene = std::make_shared<const Scene>(test::made_scene(4000));
    largest_block = 100'000;
    CHECK_THROWS_AS(update(session, results), std::bad_alloc);
    // What remains still belongs together.
    CHECK(results.a.frame.triangle_count() == 20);
    CHECK(results.a.frame.scene == results.a.scene.get());
    largest_block = std::numeric_limits<std::size_t>::max();

    update(session, results);
    CHECK(results.a.frame.triangle_count() == 4000);
    const Framebuffer expected = draw_frame(prepare_frame(*session.scene, session.a.settings));
    CHECK(test::first_difference(*results.a.framebuffer, expected).empty());
}
