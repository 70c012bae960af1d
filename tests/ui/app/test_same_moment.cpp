#include <sstream>

#include "base/image.h"
#include "cli/cli.h"
#include "support/temporary_folder.h"
#include "tests/support/catch.h"
#include "tests/ui/driver.h"
#include "ui/ui.h"

namespace rasterwalk {

TEST_CASE("The command line and the window show the same picture of a moment") {
    struct Moment {
        const char* cursor;
        const char* stage;
    };
    test::TemporaryFolder folder;
    const std::string path = folder.file("moment.png");
    for (const Moment moment : {Moment{"t20/e1/s7", "edges"}, Moment{"t12/r5/c3", "depth"},
                                Moment{"t21/r40/c9", "pixel_light"}, Moment{"t3/v1", "points"}}) {
        INFO(moment.cursor << " of stage " << moment.stage);
        const char* const arguments[] = {"rasterwalk", "render",     "--to", moment.cursor,
                                         "--stage",    moment.stage, "-o",   path.c_str()};
        std::ostringstream out, err;
        CliRequest request;
        REQUIRE(run_cli(static_cast<int>(std::size(arguments)), arguments, out, err, request) == 0);
        Driver driver;
        driver.hand.click(std::string("stage.").append(moment.stage));
        driver.ui.session.cursor = *parse_cursor(moment.cursor);
        driver.ui.session.canvas.zoom = 1.0f; // shown as it is
        driver.hand.frames();
        CHECK(driver.textures.last == read_image(path));
    }
}

} // namespace rasterwalk
