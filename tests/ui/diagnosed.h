#pragma once

#include "picture/view_image.h"
#include "pipeline/draw.h"
#include "tests/support/temporary_folder.h"
#include "tests/ui/driver.h"
#include "ui/actions/lab.h"

namespace rasterwalk {

/// Side of pictures that are diagnosed often, pixels.
inline constexpr int small_side = 100;

/// Finishes the check of a file that was begun.
inline void finish_check(Driver& driver) {
    while (is_diagnosing(driver.ui))
        poll_diagnosis(driver.ui, {});
    driver.hand.rest();
}

/// The picture that these settings draw of the driver's scene.
inline Image drawn_by(const Driver& driver, const Settings& settings) {
    const Frame frame = prepare_frame(*driver.ui.session.scene, settings);
    return view_image(draw_frame(frame), View::colour);
}

/// Compares a picture with the lab's room.
inline void check_image(Driver& driver, const Image& picture) {
    test::TemporaryFolder folder;
    const std::string path = folder.file("mine.png");
    write_png(picture, path);
    diagnose_file(driver.ui, path);
    finish_check(driver);
}

/// The same with one that these settings draw of the driver's scene.
inline void check_picture(Driver& driver, const Settings& settings) {
    check_image(driver, drawn_by(driver, settings));
}

/// @param side of the picture: each diagnosis draws it some hundred times
inline Settings pixel_light(const Driver& driver, int side = 120) {
    Settings settings = with_handout_rules(driver.ui.session.a.settings);
    set_step(settings, StripStep::pixel_light);
    settings.viewport = {side, side};
    settings.camera.focal_length = static_cast<float>(side);
    return settings;
}

} // namespace rasterwalk
