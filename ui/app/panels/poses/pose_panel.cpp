#include <array>
#include <cmath>
#include <utility>

#include "core/document/expressions.h"
#include "ui/app/input/side_pairs.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/panels/poses/pose_parts.h"
#include "ui/app/playback/frames.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/session/pose_library.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/picture_tile.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

// The poses of the file: those that are keyed, as pictures with names, to be taken as a whole or in part. Beside them
// the library.

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct PosePanelOwners {
  EditingSession& editing;
  Playback& playback;
  PanelState& panels;
  PoseShelf& shelf;
};

/// What is being taken of a pose.
struct PosesShown {
  PoseChoice choice;
  bool blending = false;  ///< it is being blended in
  bool library = false;   ///< those of the user's folder are shown, else those of the file
};

/// The pose that taking the choice would give.
rig::Pose posed(const document::Document& document, const document::SetParameters& values) {
  rig::Pose pose = document.pose;
  const auto parameters = document.model->rig->parameters();
  for (const auto& [name, value] : values.values) {
    if (const auto index = rig::find_parameter(parameters, name)) pose[*index] = value;
  }
  return pose;
}

/// The picture of a pose on a tile that comes next, as far as the tile is seen.
std::optional<PosePictures::Corners> seen_picture(PanelContext& context, const PosePanelOwners& with,
                                                  const document::SharedPose& pose, float width) {
  if (!ImGui::IsRectVisible({width, picture_tile_height(context, width)})) return std::nullopt;
  return context.pictures.place_of(with.editing, pose, with.panels.own.of<PosesShown>().choice.part);
}

/// A picture of a key, which chooses it.
void show_picture(PanelContext& context, const PosePanelOwners& with, const document::PoseKey& key, float width) {
  PoseChoice& choice = with.panels.own.of<PosesShown>().choice;
  const bool chosen = !choice.expression && std::abs(choice.time_s - key.time_s) < 1e-6;
  const std::string frame = "frame " + frame_text(key.time_s, with.playback.rate());
  const std::string label = (key.name.empty() ? frame : key.name) + "##pose " + frame;
  const PictureTile tile{width, seen_picture(context, with, key.pose, width), label.substr(0, label.find("##")),
                         chosen};
  const bool pressed = picture_tile(context, label.c_str(), tile);
  tooltip(context, (frame + ". Touch to choose it, then take it by the slider below").c_str());
  if (!pressed) return;
  choice.time_s = key.time_s;
  choice.expression.reset();
  choice.amount = 1;
}

/// Each expression of a model on its face at rest; made once for a model.
struct ExpressionPoses {
  std::shared_ptr<const document::Model> model;
  std::vector<document::SharedPose> poses;

  const std::vector<document::SharedPose>& of(const std::shared_ptr<const document::Model>& wanted) {
    if (model == wanted) return poses;
    model = wanted;
    poses.clear();
    for (const document::Expression& one : model->expressions) {
      rig::Pose pose = rig::rest_pose(*model->rig);
      document::set_expression(*model, one, 1, pose);
      poses.emplace_back(std::move(pose));
    }
    return poses;
  }
};

/// The expressions that the model came with, as pictures with their names.
void show_expressions(PanelContext& context, const PosePanelOwners& with, const PictureRow& row) {
  PoseChoice& choice = with.panels.own.of<PosesShown>().choice;
  const auto model = with.editing.document().model;
  if (model->expressions.empty()) return;
  ImGui::TextUnformatted("Expressions of the model");
  const auto& poses = with.panels.own.of<ExpressionPoses>().of(model);
  for (std::size_t i = 0; i < model->expressions.size(); ++i) {
    if (i % static_cast<std::size_t>(row.across) != 0) ImGui::SameLine();
    const std::string& name = model->expressions[i].name;
    const PictureTile tile{row.width, seen_picture(context, with, poses[i], row.width), name, choice.expression == i};
    const bool pressed = picture_tile(context, (name + "##expression " + std::to_string(i)).c_str(), tile);
    tooltip(context,
            (name + ": a pose that came with the model. Touch to choose it, then take it by the slider below").c_str());
    if (!pressed) continue;
    choice.expression = i;
    choice.time_s = -1;
    choice.amount = 1;
  }
}

void show_pictures(PanelContext& context, const PosePanelOwners& with, float height) {
  begin_list(context, "pictures", {0, height});
  const PictureRow row = picture_row(context, 4.0F * context.unit, height);
  const auto held = with.editing.document().timeline;
  int column = 0;
  for (const std::size_t k : keys_shown(*held)) {
    if (column++ % row.across != 0) ImGui::SameLine();
    show_picture(context, with, held->keys[k], row.width);
  }
  show_expressions(context, with, row);
  if (held->keys.empty()) {
    ImGui::TextWrapped("No pose is keyed yet. Draw one and press Key; it appears here.");
  }
  ImGui::EndChild();
}

/// What of the chosen pose is taken, and how much of it.
void show_choice(PanelContext& context, const PosePanelOwners& with) {
  PoseChoice& choice = with.panels.own.of<PosesShown>().choice;
  show_part_buttons(context, choice.part, "Which part of the pose to apply");
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float half = 0.5F * (ImGui::GetContentRegionAvail().x - spacing);
  ButtonLook mirror{half, choice.mirrored, "Flip left and right", icon_of(Action::flip_pose)};
  if (icon_button(context, "Mirrored##pose", mirror)) choice.mirrored = !choice.mirrored;
  ImGui::SameLine();
  ImGui::BeginDisabled(!choice.chosen());
  const auto pairs = side_pairs(with.editing.document().model->rig->parameters());
  const auto take = [&](double amount) {
    PoseChoice all = choice;
    all.amount = amount;
    const auto values = values_of_choice(with.editing.document(), all, pairs);
    with.editing.shown().preview(std::nullopt);
    if (!values.values.empty()) with.editing.perform(values);
  };
  if (wide_button(context, "Take##pose", half, false, "Apply the whole pose")) take(1);
  bool released = false;
  double amount = with.panels.own.of<PosesShown>().blending ? choice.amount : 0;
  if (tall_slider(context, "##blend", amount, 0, 1, -1, "blend", released)) {
    with.panels.own.of<PosesShown>().blending = true;
    choice.amount = amount;
    const auto& document = with.editing.document();
    with.editing.shown().preview(posed(document, values_of_choice(document, choice, pairs)));
  }
  if (released && std::exchange(with.panels.own.of<PosesShown>().blending, false)) take(choice.amount);
  ImGui::EndDisabled();
}

/// Keeps the chosen pose in the library.
void show_keep(PanelContext& context, const PosePanelOwners& with) {
  const PoseChoice& choice = with.panels.own.of<PosesShown>().choice;
  document::Document document = with.editing.document();
  ImGui::BeginDisabled(!choice.chosen());
  if (wide_button(context, "Keep in library##pose", -1, false, "Save the chosen pose for every file and rig")) {
    PoseChoice whole = choice;
    whole.part = FacePart::all;
    whole.amount = 1;
    // An expression moves its targets alone: it is kept as it is on a face at rest.
    if (choice.expression) document.pose = rig::rest_pose(*document.model->rig);
    std::string name;
    if (choice.expression && *choice.expression < document.model->expressions.size())
      name = document.model->expressions[*choice.expression].name;
    for (const auto& key : document.timeline->keys) {
      if (!choice.expression && std::abs(key.time_s - choice.time_s) < 1e-6) name = key.name;
    }
    const auto pairs = side_pairs(document.model->rig->parameters());
    with.shelf.follow();
    with.shelf.keep(posed(document, values_of_choice(document, whole, pairs)),
                    name.empty() ? usual_pose_name(with.shelf) : name);
  }
  ImGui::EndDisabled();
}

}  // namespace

void show_part_buttons(PanelContext& context, FacePart& chosen, const char* tip) {
  constexpr std::array<std::pair<FacePart, const char*>, 4> k_parts{{{FacePart::all, "All##part"},
                                                                     {FacePart::brows, "Brows##part"},
                                                                     {FacePart::eyes, "Eyes##part"},
                                                                     {FacePart::mouth, "Mouth##part"}}};
  const float quarter = (ImGui::GetContentRegionAvail().x - 3 * ImGui::GetStyle().ItemSpacing.x) / 4;
  for (const auto& [part, label] : k_parts) {
    if (part != FacePart::all) ImGui::SameLine();
    if (wide_button(context, label, quarter, chosen == part, tip)) chosen = part;
  }
}

void show_poses(PanelContext& context, EditingSession& editing, Playback& playback, PanelState& panels,
                PoseShelf& shelf) {
  const PosePanelOwners with{editing, playback, panels, shelf};
  PosesShown& shown = panels.own.of<PosesShown>();
  const float half = 0.5F * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
  if (wide_button(context, "This file##poses", half, !shown.library, "Keyed poses of this file")) shown.library = false;
  ImGui::SameLine();
  if (wide_button(context, "Library##poses", half, shown.library, "Your saved poses, for every file and rig"))
    shown.library = true;
  if (shown.library) return show_pose_shelf(context, shelf, editing, panels, shown.choice.part);
  const float below = 4 * (context.unit + ImGui::GetStyle().ItemSpacing.y);
  show_pictures(context, with, std::max(context.unit, ImGui::GetContentRegionAvail().y - below));
  show_choice(context, with);
  show_keep(context, with);
}

}  // namespace penpose::app
