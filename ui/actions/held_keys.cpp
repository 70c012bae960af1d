#include "ui/actions/held_keys.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <imgui.h>

#include "settings/setting_table.h"
#include "ui/actions/actions.h"
#include "ui/actions/focus_keys.h"
#include "ui/ui.h"
#include "ui/widgets/imgui_versions.h"
#include "ui/widgets/keys.h"

namespace rasterwalk {

namespace {

/// A key that moves something while it is held.
struct HeldKey {
    int key;
    void (*move)(Settings&, float distance);
};

/// Moves the camera along its own forward axis, level with the floor.
void move_forward(Settings& s, float distance) {
    s.camera.position += distance * glm::vec3(std::sin(s.camera.yaw), 0.0f, std::cos(s.camera.yaw));
}

const HeldKey held_keys[] = {
    {key::up, [](Settings& s, float d) { move_forward(s, d); }},
    {key::down, [](Settings& s, float d) { move_forward(s, -d); }},
    {key::left, [](Settings& s, float d) { s.camera.yaw -= d; }},
    {key::right, [](Settings& s, float d) { s.camera.yaw += d; }},
    {'W', [](Settings& s, float d) { s.light.position.z += d; }},
    {'S', [](Settings& s, float d) { s.light.position.z -= d; }},
    {'A', [](Settings& s, float d) { s.light.position.x -= d; }},
    {'D', [](Settings& s, float d) { s.light.position.x += d; }},
    {'Q', [](Settings& s, float d) { s.light.position.y -= d; }},
    {'E', [](Settings& s, float d) { s.light.position.y += d; }},
};

/// World units, or radians, a second; and the least that a mere touch of the key moves.
constexpr float key_speed = 1.0f;
constexpr float touch_distance = 0.02f;

bool is_arrow(int key) {
    return key >= key::right && key <= key::up;
}

/// The arrows belong to a widget that has the keyboard, and a field has the letters.
bool is_free(const Ui& ui, const HeldKey& held) {
    const bool is_taken = ui.focus.is_shown && is_arrow(held.key);
    return !is_taken && !belongs_to_focus(ui, {held.key});
}

bool modifiers_are_up() {
    const ImGuiIO& io = ImGui::GetIO();
    return !io.KeyCtrl && !io.KeyAlt && !io.KeyShift;
}

} // namespace

void move_by_held_keys(Ui& ui) {
    if (!modifiers_are_up()) return;
    for (const HeldKey& held : held_keys) {
        if (!is_free(ui, held)) continue;
        if (is_key_pressed(held.key, false)) {
            held.move(ui.session.a.settings, touch_distance);
        } else if (is_key_down(held.key)) {
            held.move(ui.session.a.settings, key_speed * std::min(ImGui::GetIO().DeltaTime, 0.1f));
        } else {
            continue;
        }
        clamp_to_ranges(ui.session.a.settings);
    }
}

bool is_moving_by_key(const Ui& ui) {
    if (ImGui::GetIO().WantTextInput || !modifiers_are_up()) return false;
    return std::any_of(std::begin(held_keys), std::end(held_keys), [&](const HeldKey& held) {
        return is_free(ui, held) && is_key_down(held.key);
    });
}

} // namespace rasterwalk
