#pragma once

namespace rasterwalk {

/// Keys by the numbers that GLFW gives them: letters, digits and punctuation have their capital
/// ASCII code. See ui/widgets/imgui_versions.h for how ImGui is asked about them.
namespace key {
inline constexpr int space = 32;
inline constexpr int comma = 44;
inline constexpr int minus = 45;
inline constexpr int period = 46;
inline constexpr int digit_0 = 48;
inline constexpr int equal = 61;
inline constexpr int left_bracket = 91;
inline constexpr int right_bracket = 93;
inline constexpr int escape = 256;
inline constexpr int enter = 257;
inline constexpr int tab = 258;
inline constexpr int backspace = 259;
inline constexpr int insert = 260;
inline constexpr int del = 261;
inline constexpr int right = 262;
inline constexpr int left = 263;
inline constexpr int down = 264;
inline constexpr int up = 265;
inline constexpr int page_up = 266;
inline constexpr int page_down = 267;
inline constexpr int home = 268;
inline constexpr int end = 269;
inline constexpr int f1 = 290;
inline constexpr int f5 = 294;
inline constexpr int f12 = 301;
inline constexpr int keypad_0 = 320;
inline constexpr int keypad_add = 334;
inline constexpr int keypad_subtract = 333;
inline constexpr int keypad_enter = 335;
inline constexpr int first_modifier = 340; ///< Shift, Ctrl, Alt and the like begin here

/// Does the key type a character? Letters, digits and punctuation do, also on the keypad.
constexpr bool writes(int code) {
    return (code >= space && code < escape) || (code >= keypad_0 && code <= keypad_add);
}
} // namespace key

} // namespace rasterwalk
