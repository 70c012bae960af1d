#include "ui/app/guard.h"

#include <exception>
#include <new>

#include <imgui_internal.h>

#include "ui/ui.h"

namespace rasterwalk {

namespace {

/// Closes everything begun and not ended in this frame.
void close_what_is_open() {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    if (!context.WithinFrameScope) return;
    for (const ImGuiWindowStackData& open : context.CurrentWindowStack)
        open.Window->DrawList->ChannelsMerge();
    // ImGui closes everything else itself, and checks the fonts on the way. PopFont() would address
    // the innermost window, whichever pushed the font.
    const int fonts = context.CurrentWindowStack.front().StackSizesOnBegin.SizeOfFontStack;
    if (context.FontStack.Size > fonts) {
        context.FontStack.shrink(fonts);
        ImGui::SetCurrentFont(fonts > 0 ? context.FontStack.back() : ImGui::GetDefaultFont());
    }
    // Nor does it check in which window a tab bar was begun; its names are popped with the others.
    context.CurrentTabBar = nullptr;
    context.CurrentTabBarStack.resize(0);
    ImGui::ErrorCheckEndFrameRecover(nullptr);
    context.NextWindowData.ClearFlags();
    context.NextItemData.ClearFlags();
}

} // namespace

bool guarded(Ui& ui, const std::function<void()>& part) {
    try {
        part();
        return true;
    } catch (const std::bad_alloc&) {
        ui.session.notice = "There is not enough memory for this.";
    } catch (const std::exception& fault) {
        ui.session.notice = fault.what();
    }
    ++ui.faults;
    close_what_is_open();
    return false;
}

} // namespace rasterwalk
