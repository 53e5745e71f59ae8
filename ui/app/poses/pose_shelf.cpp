#include "ui/app/poses/pose_shelf.h"

#include <algorithm>
#include <cmath>

#include "core/base/text/letters.h"
#include "core/poses/keep_pose.h"
#include "ui/app/widgets/pose_painter.h"
#include "ui/files/load_model.h"
#include "ui/render/picture/image.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

constexpr int k_picture_px = 96;
/// A pose does something to a part whose features go so far in the mean, in their units.
constexpr double k_does = 0.01;

/// Whether a pose moves a part: as measured, else by the names of its controls.
bool moves_part(const poses::KeptPose& pose, FacePart part) {
  double far = 0;
  double count = 0;
  for (const poses::FeatureMoves& one : pose.moves) {
    if (poses::part_of_feature(one.feature) != part) continue;
    for (const auto& move : one.moves) far += geometry::length(move);
    count += static_cast<double>(one.moves.size());
  }
  if (count > 0) return far > k_does * count;
  return std::any_of(pose.values.begin(), pose.values.end(),
                     [&](const poses::KeptValue& one) { return part_of(one.control) == part; });
}

/// A picture of the pose for each part.
void draw_pictures(const document::Model& model, std::span<const portrait::FeatureCurve> features,
                   const rig::Pose& pose, poses::KeptPose& kept) {
  const PictureFrames frames = picture_frames(model, features);
  PosePainter painter;
  for (std::size_t part = 0; part < frames.size(); ++part) {
    const auto png =
        render::encode_png({k_picture_px, k_picture_px, painter.paint(model, pose, frames[part], k_picture_px)});
    if (png) kept.pictures[part] = *png;
  }
}

}  // namespace

const std::string& PoseShelf::folder() const {
  const std::string& chosen = preferences_.settings().pose_folder;
  return chosen.empty() ? usual_ : chosen;
}

void PoseShelf::choose_folder(const std::string& folder) {
  preferences_.settings().pose_folder = folder == usual_ ? std::string() : folder;
  preferences_.changed();
}

bool PoseShelf::refused(const base::Error& error, const std::string& file) {
  notices_.tell(error.line(file), true);
  return false;
}

void PoseShelf::follow() {
  std::error_code code;
  const auto time = fs::last_write_time(folder(), code);
  const auto now = code ? std::optional<fs::file_time_type>() : time;
  if (readings_ > 0 && read_folder_ == folder() && read_time_ == now) return;
  read_time_ = now;
  read();
}

void PoseShelf::read() {
  read_folder_ = folder();
  ++readings_;
  poses_.clear();
  if (read_folder_.empty()) return;
  auto found = files::read_pose_folder(read_folder_);
  if (found) {
    poses_ = std::move(*found);
  } else {
    refused(found.error(), read_folder_);
  }
}

std::vector<std::size_t> PoseShelf::listed(const std::string& search, FacePart part) const {
  const std::string wanted = base::lower_case(search);
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const auto& [path, pose] = poses_[i];
    const std::string name = pose ? pose->name : fs::path(path).filename().string();
    if (base::lower_case(name).find(wanted) == std::string::npos) continue;
    if (part == FacePart::all || (pose && moves_part(*pose, part))) all.push_back(i);
  }
  return all;
}

const files::PoseFile* PoseShelf::find(const std::string& path) const {
  const auto found = std::find_if(poses_.begin(), poses_.end(), [&](const auto& one) { return one.path == path; });
  return found == poses_.end() ? nullptr : &*found;
}

const poses::FaceMeasure* PoseShelf::face() {
  const document::Document& document = editing_.document();
  const auto features = editing_.features();
  if (measured_ != document.model->rig || measured_features_ != features.size()) {
    measured_ = document.model->rig;
    measured_features_ = features.size();
    face_ = poses::FaceMeasure::of(*document.model, features);
    ready_.reset();
  }
  return face_ ? &*face_ : nullptr;
}

std::string PoseShelf::keep(const rig::Pose& pose, const std::string& name) {
  const document::Document& document = editing_.document();
  const poses::FaceMeasure* measure = face();
  std::vector<poses::KeptLine> lines;
  if (measure != nullptr && pose == document.pose)
    lines = poses::lines_of(document, *measure, [&](document::CurveId id) { return editing_.moments().shows(id); });
  const std::string model = fs::path(files::model_name(files_.path()).file).filename().string();
  poses::KeptPose kept = poses::keep_pose(document, pose, name, model, measure, std::move(lines));
  draw_pictures(*document.model, editing_.features(), pose, kept);
  const auto path = files::add_pose(folder(), kept);
  if (!path) {
    refused(path.error(), {});
    return {};
  }
  notices_.tell("\"" + name + "\" is kept in the library" +
                (kept.lines.empty() ? "" : ", with the lines that it was drawn with"));
  read();
  return *path;
}

std::string PoseShelf::rename(const std::string& path, const std::string& name) {
  const files::PoseFile* file = find(path);
  if (file == nullptr || !file->pose) return {};
  const auto renamed = files::rename_pose(path, *file->pose, name);
  if (!renamed) {
    refused(renamed.error(), {});
    return {};
  }
  if (last_ && last_->path == path) last_->path = *renamed;
  read();
  return *renamed;
}

void PoseShelf::bin(const std::string& path) {
  const files::PoseFile* file = find(path);
  if (file == nullptr) return;
  const auto there = files::bin_pose(path);
  if (!there) {
    refused(there.error(), {});
    return;
  }
  binned_ = {*there, path};
  binned_name_ = file->pose ? file->pose->name : fs::path(path).filename().string();
  notices_.tell("\"" + binned_name_ + "\" is in the trash of the library");
  read();
}

void PoseShelf::take_back() {
  if (binned_name_.empty()) return;
  if (const auto back = files::take_back_pose(binned_.first, binned_.second); !back) refused(back.error(), {});
  binned_name_.clear();
  read();
}

const PoseShelf::Ready* PoseShelf::ready(const std::string& path, FacePart part) {
  const files::PoseFile* file = find(path);
  if (file == nullptr || !file->pose) return nullptr;
  const poses::FaceMeasure* measure = face();
  const auto& model = editing_.document().model;
  const bool fits = ready_ && ready_->path == path && ready_->reading == readings_ && ready_->part == part &&
                    ready_->rig == model->rig;
  if (!fits) ready_ = Ready{path, readings_, part, model->rig, poses::take_pose(*file->pose, *model, measure, {part})};
  return &*ready_;
}

document::SetParameters PoseShelf::values_of(const poses::TakenPose& taken, const ShelfChoice& choice,
                                             const rig::Pose& from) const {
  const document::Model& model = *editing_.document().model;
  const auto parameters = model.rig->parameters();
  const auto shared = poses::shared_values(model, from, taken.values, {choice.mirrored, choice.amount});
  const rig::Pose to = poses::with_values(*model.rig, from, shared);
  return values_between(parameters, editing_.document().pose, to);
}

bool PoseShelf::goes_on(const std::string& path, ShelfChoice choice) const {
  if (last_) choice.amount = last_->choice.amount;
  return last_ && last_->choice == choice && last_->path == path && last_->revision == editing_.revision() &&
         last_->before.size() == editing_.document().pose.size();
}

std::optional<double> PoseShelf::amount_of(const std::string& path, ShelfChoice choice) const {
  return goes_on(path, choice) ? std::optional(last_->choice.amount) : std::nullopt;
}

void PoseShelf::preview(const std::string& path, const ShelfChoice& choice) {
  const Ready* one = ready(path, choice.part);
  if (one == nullptr || !one->taken) return;
  const document::Document& document = editing_.document();
  const auto values = values_of(*one->taken, choice, goes_on(path, choice) ? last_->before : document.pose);
  editing_.shown().preview(poses::with_values(*document.model->rig, document.pose, values.values));
}

void PoseShelf::take(const std::string& path, const ShelfChoice& choice) {
  editing_.shown().preview(std::nullopt);
  const Ready* one = ready(path, choice.part);
  if (one == nullptr) return;
  if (!one->taken) {
    refused(one->taken.error(), {});
    return;
  }
  // One more amount of the same pose replaces the step, so that one undo brings the face back.
  const bool again = goes_on(path, choice);
  const rig::Pose before = again ? last_->before : editing_.document().pose;
  if (again) editing_.steps().undo();
  const auto values = values_of(*one->taken, choice, before);
  if (!values.values.empty() && !editing_.perform(values)) return;
  const files::PoseFile* file = find(path);
  if (!again) notices_.tell(poses::words_of(*file->pose, *one->taken));
  // Without a change there is no step to replace.
  last_.reset();
  if (!values.values.empty()) last_ = Last{path, choice, editing_.revision(), before};
}

}  // namespace penpose::app
