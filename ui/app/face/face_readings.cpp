#include "ui/app/face/face_readings.h"

#include <algorithm>
#include <cmath>

#include "core/document/features/feature_near.h"

namespace penpose::app {
namespace {

/// Share of a range from which on a control makes another face.
constexpr double k_looks_different = 0.05;

bool look_alike(std::span<const rig::Parameter> parameters, const rig::Pose& a, const rig::Pose& b) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (std::abs(a[i] - b[i]) > k_looks_different * (parameters[i].maximum - parameters[i].minimum)) return false;
  }
  return true;
}

/// Returns the features near a line, the nearest first.
std::vector<std::string> names_near(EditingSession& editing, const document::FaceLine& line) {
  const document::Document& document = editing.document();
  const document::FaceDrawing& face = *document.face;
  const auto points = document::points_of(face.view, line.line, face.middle);
  if (!points) return {};
  const bool known = face.base.size() == document.pose.size();
  auto names = document::features_near(*document.model, known ? face.base : document.pose, editing.features(), *points);
  std::erase(names, line.feature);
  return names;
}

}  // namespace

void FaceReadings::forget() {
  line_.reset();
  waiting_.clear();
  found_.clear();
}

void FaceReadings::begin(EditingSession& editing, document::CurveId line) {
  forget();
  line_ = line;
  revision_ = editing.revision();
  const document::FaceLine* drawn = document::find_face_line(editing.document(), line);
  if (drawn == nullptr) return;
  if (!drawn->feature.empty()) waiting_.push_back({line, drawn->feature, false, true});
  for (const std::string& name : names_near(editing, *drawn)) {
    waiting_.push_back({line, name, false, true});
    waiting_.push_back({line, name, false, false});
  }
  std::reverse(waiting_.begin(), waiting_.end());
}

void FaceReadings::follow(EditingSession& editing, document::CurveId line) {
  if (line_ != line || revision_ != editing.revision()) begin(editing, line);
  if (!searches()) return;
  document::NameFaceLine command = std::move(waiting_.back());
  waiting_.pop_back();
  const document::Document& document = editing.document();
  const auto after = editing.after(command);
  if (!after) return;
  const auto parameters = document.model->rig->parameters();
  const auto same = [&](const FaceReading& one) { return look_alike(parameters, one.pose, after->pose); };
  if (look_alike(parameters, document.pose, after->pose) || std::any_of(found_.begin(), found_.end(), same)) return;
  found_.push_back({std::move(command), after->pose});
}

std::optional<document::CurveId> NewestFaceLine::look_at(const EditingSession& editing) {
  const auto before = std::exchange(face_, editing.document().face);
  const std::size_t steps = std::exchange(steps_, editing.editor().history().undo_count());
  if (!face_ || face_ == before || steps_ <= steps) return std::nullopt;
  const std::size_t known = before ? before->lines.size() : 0;
  if (face_->lines.size() > known) return face_->lines.back().id;
  if (!before || face_->lines.size() < known) return std::nullopt;
  for (std::size_t i = 0; i < known; ++i) {
    if (face_->lines[i].said != before->lines[i].said) return face_->lines[i].id;
  }
  return std::nullopt;
}

}  // namespace penpose::app
