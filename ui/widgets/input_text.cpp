// ImGui's text fields for std::string, for a standard library other than the one that the system's
// ImGui was compiled with: the rest of ImGui has no types of it.

#include <cstddef>
#include <string>

#include <imgui.h>
#include <imgui_stdlib.h>

namespace {

/// The text, and what the caller gave.
struct Typed {
    std::string* text;
    ImGuiInputTextCallback callback;
    void* user_data;
};

/// Makes the text as long as what is typed.
int resize(ImGuiInputTextCallbackData* data) {
    const Typed& typed = *static_cast<const Typed*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
        typed.text->resize(static_cast<std::size_t>(data->BufTextLen));
        data->Buf = typed.text->data();
        return 0;
    }
    data->UserData = typed.user_data;
    return typed.callback(data);
}

} // namespace

bool ImGui::InputText(const char* label, std::string* text, ImGuiInputTextFlags flags,
                      ImGuiInputTextCallback callback, void* user_data) {
    return InputTextWithHint(label, nullptr, text, flags, callback, user_data);
}

bool ImGui::InputTextWithHint(const char* label, const char* hint, std::string* text,
                              ImGuiInputTextFlags flags, ImGuiInputTextCallback callback,
                              void* user_data) {
    Typed typed{text, callback, user_data};
    flags |= ImGuiInputTextFlags_CallbackResize;
    return InputTextWithHint(label, hint, text->data(), text->capacity() + 1, flags, resize,
                             &typed);
}
