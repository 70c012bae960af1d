#pragma once

#include <utility>

#include <imgui.h>

#include "ui/app/app.h"
#include "ui/ui.h"

/// Textures are just numbers, and what is drawn is never shown.
class NoTextures : public rasterwalk::TextureHost {
  public:
    ImTextureID upload(ImTextureID old, const rasterwalk::Image&) override {
        return old != nullptr ? old : static_cast<ImTextureID>(this);
    }
};

/// The interface without a graphics system, as large as a usual window. One at a time: ImGui has
/// one context.
class BareInterface {
  public:
    explicit BareInterface(rasterwalk::Session session) {
        ui.session = std::move(session);
        rasterwalk::open_ui(ui, textures_);
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {1600.0f, 1000.0f};
        io.DeltaTime = 1.0f / 60.0f;
    }
    ~BareInterface() { rasterwalk::close_ui(ui); }
    BareInterface(const BareInterface&) = delete;
    BareInterface& operator=(const BareInterface&) = delete;

    /// Builds the next frame.
    void frame() { rasterwalk::build_ui(ui); }

  private:
    NoTextures textures_; // outlives the interface

  public:
    rasterwalk::Ui ui;
};
