#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/panels/poses/pose_parts.h"
#include "ui/app/poses/pose_shelf.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/pose_picture.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

// The library of poses: those of the user's folder, as pictures with names, for any rig.

namespace penpose::app {
namespace {

/// What is shown of the library.
struct ShelfShown {
  std::string search;
  std::string chosen;  ///< path
  std::string name;    ///< being typed for the chosen one
  bool mirrored = false;
  bool blending = false;
  double amount = 1;
};

struct Shelf {
  PoseShelf& poses;
  EditingSession& editing;
  ShelfShown& shown;
  FacePart part;
};

void choose(const Shelf& with, const std::string& path) {
  const files::PoseFile* file = with.poses.find(path);
  with.shown.chosen = path;
  with.shown.name = file != nullptr && file->pose ? file->pose->name : std::string();
}

ShelfChoice choice_of(const Shelf& with, double amount = 1) { return {with.part, with.shown.mirrored, amount}; }

void take(const Shelf& with, double amount) { with.poses.take(with.shown.chosen, choice_of(with, amount)); }

/// A file as a picture with its name; grey where it is no pose, whose tip says why. True when it is pressed.
bool show_file(PanelContext& context, const Shelf& with, const files::PoseFile& file, float width) {
  const std::string stem = std::filesystem::path(file.path).filename().string();
  const std::string name = file.pose ? file.pose->name : stem;
  const std::string label = name + "##kept " + stem;
  const ImVec2 size{width, width + ImGui::GetFontSize() + context.gap};
  ImGui::PushID(label.c_str());
  const bool pressed = ImGui::InvisibleButton("##kept", size);
  ImGui::PopID();
  note(context, label.c_str());
  if (!ImGui::IsItemVisible()) return pressed;
  const ImVec2 from = ImGui::GetItemRectMin();
  const ImVec2 to = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool lit = file.pose.ok() && ImGui::IsItemHovered();
  list.AddRectFilled(from, to, ImGui::GetColorU32(lit ? ImGuiCol_ButtonHovered : ImGuiCol_Button),
                     ImGui::GetStyle().FrameRounding);
  const ImU32 ink = ImGui::GetColorU32(file.pose ? ImGuiCol_Text : ImGuiCol_TextDisabled);
  if (file.pose) {
    auto part = static_cast<std::size_t>(with.part);
    if (file.pose->pictures[part].empty()) part = 0;
    const std::string of_file = file.path + " " + std::to_string(with.poses.readings()) + " " + std::to_string(part);
    const auto& png = file.pose->pictures[part];
    const auto place = png.empty() ? std::nullopt : context.pictures.place_of(of_file, png);
    if (png.empty()) {
      const std::string none = fitted_text("no picture", width - 2 * context.gap);
      list.AddText({from.x + context.gap, from.y + 0.4F * width}, ImGui::GetColorU32(ImGuiCol_TextDisabled),
                   none.c_str());
    }
    if (place)
      list.AddImageRounded(ImGui::GetIO().Fonts->TexID, {from.x + 2, from.y + 2}, {to.x - 2, from.y + width - 2},
                           place->first, place->second, k_untinted, 4);
  } else {
    const std::string cannot = fitted_text("no pose", width - 2 * context.gap);
    list.AddText({from.x + context.gap, from.y + 0.4F * width}, ink, cannot.c_str());
  }
  const std::string text = fitted_text(name, width - 2 * context.gap);
  const float wide = ImGui::CalcTextSize(text.c_str()).x;
  list.AddText({0.5F * (from.x + to.x - wide), from.y + width + 0.25F * context.gap}, ink, text.c_str());
  if (file.path == with.shown.chosen)
    list.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_ButtonActive), ImGui::GetStyle().FrameRounding, 0, scaled(2.5F));
  const std::string tip = file.pose ? name + ", kept of " + (file.pose->model.empty() ? "a rig" : file.pose->model) +
                                          ". A touch takes it; the slider below takes less of it"
                                    : file.pose.error().line(stem);
  tooltip(context, tip.c_str());
  return pressed;
}

void show_files(PanelContext& context, const Shelf& with, float height) {
  begin_list(context, "library", {0, height});
  const auto [across, width] = picture_row(context, 4.0F * context.unit, height);
  const auto listed = with.poses.listed(with.shown.search, with.part);
  std::string pressed;
  int column = 0;
  for (const std::size_t i : listed) {
    if (column++ % across != 0) ImGui::SameLine();
    const files::PoseFile& file = with.poses.poses()[i];
    if (show_file(context, with, file, width)) pressed = file.path;
  }
  if (with.poses.poses().empty()) {
    ImGui::TextWrapped("The library is empty. Pose the face and press Keep to save it here for every rig.");
  } else if (listed.empty()) {
    ImGui::TextWrapped("No pose matches.");
  }
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_TextDisabled));
  ImGui::TextWrapped("%s", with.poses.folder().c_str());
  ImGui::PopStyleColor();
  ImGui::EndChild();
  if (pressed.empty()) return;
  // A second touch is no second step.
  const bool again = pressed == with.shown.chosen && with.poses.amount_of(pressed, choice_of(with)) == 1.0;
  choose(with, pressed);
  const files::PoseFile* file = with.poses.find(pressed);
  with.shown.amount = 1;
  if (file != nullptr && file->pose && !again) take(with, 1);
}

/// The name of the chosen pose, and what is done to its file.
void show_chosen(PanelContext& context, const Shelf& with) {
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float half = 0.5F * (ImGui::GetContentRegionAvail().x - spacing);
  const files::PoseFile* file = with.poses.find(with.shown.chosen);
  ImGui::BeginDisabled(file == nullptr || !file->pose);
  bool accepted = false;
  text_field(context, "##pose name", with.shown.name, half, "its name", &accepted);
  ImGui::EndDisabled();
  if (accepted && file != nullptr && file->pose && with.shown.name != file->pose->name) {
    const std::string renamed = with.poses.rename(with.shown.chosen, with.shown.name);
    choose(with, renamed.empty() ? with.shown.chosen : renamed);
  }
  ImGui::SameLine();
  const bool takes_back = file == nullptr && !with.poses.binned().empty();
  if (takes_back) {
    if (wide_button(context, "Bring back##pose", -1, false,
                    ("\"" + with.poses.binned() + "\" out of the trash").c_str()))
      with.poses.take_back();
    return;
  }
  ImGui::BeginDisabled(file == nullptr);
  if (wide_button(context, "Delete##pose", -1, false, "Move to the library's trash")) {
    with.poses.bin(with.shown.chosen);
    choose(with, {});
  }
  ImGui::EndDisabled();
}

void show_amount(PanelContext& context, const Shelf& with) {
  ShelfShown& shown = with.shown;
  const float half = 0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  ButtonLook mirror{half, shown.mirrored, "Flip left and right", icon_of(Action::flip_pose)};
  if (icon_button(context, "Mirrored##kept", mirror)) shown.mirrored = !shown.mirrored;
  ImGui::SameLine();
  if (wide_button(context, "Keep##pose", -1, false, "Save the current face to the library, for every rig")) {
    const std::string path = with.poses.keep(with.editing.document().pose, usual_pose_name(with.poses));
    if (!path.empty()) choose(with, path);
  }
  const files::PoseFile* file = with.poses.find(shown.chosen);
  ImGui::BeginDisabled(file == nullptr || !file->pose);
  bool released = false;
  double amount = shown.blending ? shown.amount : with.poses.amount_of(shown.chosen, choice_of(with)).value_or(0);
  if (tall_slider(context, "##share", amount, 0, 1, -1, "amount", released)) {
    shown.blending = true;
    shown.amount = amount;
    with.poses.preview(shown.chosen, choice_of(with, amount));
  }
  if (released && std::exchange(shown.blending, false)) take(with, shown.amount);
  ImGui::EndDisabled();
}

}  // namespace

std::string usual_pose_name(const PoseShelf& shelf) {
  for (int i = 1;; ++i) {
    const std::string name = "pose " + std::to_string(i);
    const auto same = [&](const files::PoseFile& one) { return one.pose && one.pose->name == name; };
    if (std::none_of(shelf.poses().begin(), shelf.poses().end(), same)) return name;
  }
}

void show_pose_shelf(PanelContext& context, PoseShelf& poses, EditingSession& editing, PanelState& panels,
                     FacePart& part) {
  poses.follow();
  const Shelf with{poses, editing, panels.own.of<ShelfShown>(), part};
  text_field(context, "##find pose", with.shown.search, -1, "search");
  const float below = 4 * (context.unit + ImGui::GetStyle().ItemSpacing.y);
  show_files(context, with, std::max(2 * context.unit, ImGui::GetContentRegionAvail().y - below));
  show_part_buttons(context, part, "Which part to show and apply");
  show_amount(context, with);
  show_chosen(context, with);
}

}  // namespace penpose::app
