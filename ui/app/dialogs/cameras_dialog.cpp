#include <algorithm>
#include <string>

#include "ui/app/camera/camera_desk.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/panels/panels.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// Views that are kept: a touch goes to one; it is named, kept anew, put on a key and removed below.

namespace penpose::app {
namespace {

/// The view that was gone to last, and its name as it is being typed.
struct CamerasEntry {
  std::string chosen;
  std::string text;
};

using KeptView = std::shared_ptr<const document::NamedView>;

void show_kept_views(PanelContext& context, CameraDesk& cameras, const std::vector<KeptView>& kept, float height,
                     CamerasEntry& entry) {
  begin_list(context, "kept cameras", {0, height}, true);
  if (kept.empty()) ImGui::TextWrapped("None is kept yet. Keep this view, or press Ctrl+1 to 9 on the canvas.");
  for (const KeptView& one : kept) {
    ButtonLook look{ImGui::GetContentRegionAvail().x, one->name == entry.chosen, "Look from here"};
    look.left_aligned = true;
    const std::string key = one->key == 0 ? std::string() : "key " + std::to_string(one->key);
    look.key = key;
    if (!icon_button(context, (one->name + "##camera").c_str(), look)) continue;
    cameras.go_to(*one);
    entry = {one->name, one->name};
  }
  ImGui::EndChild();
}

/// The keys 1 to 9, of which a view has one.
void show_camera_keys(PanelContext& context, EditingSession& editing, const document::NamedView& chosen) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float each = (ImGui::GetContentRegionAvail().x - 8 * gap) / 9;
  for (std::uint32_t key = 1; key <= document::k_view_keys; ++key) {
    if (key > 1) ImGui::SameLine();
    const std::string label = std::to_string(key) + "##camera key";
    if (wide_button(context, label.c_str(), each, chosen.key == key, "This key goes to the camera"))
      editing.perform(document::SaveView{chosen.name, chosen.view, key});
  }
}

/// What is done with the view that was gone to.
void show_camera_changes(PanelContext& context, EditingSession& editing, CameraDesk& cameras,
                         const std::vector<KeptView>& kept, CamerasEntry& entry) {
  const auto found =
      std::find_if(kept.begin(), kept.end(), [&](const KeptView& one) { return one->name == entry.chosen; });
  const bool any = found != kept.end();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float third = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  if (any) {
    text_field(context, "##camera name", entry.text, 2 * third + gap, "its name");
    ImGui::SameLine();
    const bool named = !entry.text.empty() && entry.text != entry.chosen;
    ImGui::BeginDisabled(!named);
    const bool renames = wide_button(context, "Rename##camera", third, false, "Call it so");
    ImGui::EndDisabled();
    if (named && (renames || context.accepts) && cameras.rename(entry.chosen, entry.text)) entry.chosen = entry.text;
    show_camera_keys(context, editing, **found);
  }
  if (wide_button(context, "Keep this view##camera", third, false, "Keep what the window shows now")) {
    cameras.keep(0);
    const auto now = cameras.kept();
    if (now.size() > kept.size()) entry = {now.back()->name, now.back()->name};
  }
  if (!any) return;
  ImGui::SameLine();
  if (wide_button(context, "Replace##camera", third, false, "Let it be what the window shows now"))
    cameras.replace(entry.chosen);
  ImGui::SameLine();
  if (wide_button(context, "Remove##camera", third, false, "Keep it no longer")) {
    cameras.remove(entry.chosen);
    entry = {};
  }
}

}  // namespace

void show_cameras_dialog(PanelContext& context, EditingSession& editing, CameraDesk& cameras, Dialogs& dialogs) {
  if (begin_dialog(context, "Cameras", 13)) {
    CamerasEntry& entry = dialogs.state<CamerasEntry>();
    const auto kept = cameras.kept();
    const float rows = std::clamp(static_cast<float>(context.window.height) / context.unit - 8.5F, 2.0F, 6.0F);
    show_kept_views(context, cameras, kept, rows * context.unit, entry);
    show_camera_changes(context, editing, cameras, kept, entry);
    if (primary_button(context, "Done", -1)) dialogs.show(Dialog::none);
  }
  end_dialog();
}

}  // namespace penpose::app
