#include "ui/app/face/kept_features.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/document/model_hash.h"
#include "core/io/project/feature_file.h"
#include "ui/files/files.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

bool same_features(const document::Model& a, const document::Model& b) {
  return std::equal(
      a.features.begin(), a.features.end(), b.features.begin(), b.features.end(),
      [](const auto& one, const auto& other) { return one.name == other.name && one.points == other.points; });
}

}  // namespace

KeptFeatures::KeptFeatures(std::string folder, EditingSession& editing, Notices& notices)
    : folder_(std::move(folder)), editing_(editing), notices_(notices) {}

std::string KeptFeatures::path_of(const mesh::TriangleMesh& mesh) const {
  return folder_.empty() ? folder_ : folder_ + "/features/" + document::hash_topology(mesh).hex() + ".json";
}

void KeptFeatures::forget() {
  shown_ = applied_ = false;
  began_at_s_.reset();
  revision_ = editing_.revision();
  model_ = editing_.document().model;
}

void KeptFeatures::begin(bool of_file) {
  forget();
  if (of_file && model_->features.empty()) apply_kept();
  const document::FeatureCurves& features = editing_.all_features();
  shown_ = !features.curves.empty() || !features.unsure.empty();
  revision_ = editing_.revision();
  model_ = editing_.document().model;
}

void KeptFeatures::apply_kept() {
  const mesh::TriangleMesh& mesh = *model_->mesh;
  const std::string path = path_of(mesh);
  std::error_code code;
  if (path.empty() || !fs::exists(path, code)) return;
  const auto bytes = files::read_plain_file(path, files::k_most_text_bytes);
  if (!bytes) return notices_.tell(bytes.error().line(path), true);
  const auto file = io::read_features(*bytes, mesh);
  if (!file) return notices_.tell(file.error().line(path), true);
  for (const document::NamedCurve& one : file->features) {
    // One step: the session has them all, and needs no file to be played again.
    const document::PlaceFeature command{one.name, one.points};
    if (!(applied_ ? editing_.perform_with(command) : editing_.perform(command))) return;
    applied_ = true;
  }
  if (!applied_) return;
  editing_.mark_saved();
  notices_.tell("Features as you corrected them for this mesh");
}

void KeptFeatures::keep() {
  const document::Model& model = *editing_.document().model;
  const std::string path = path_of(*model.mesh);
  if (path.empty()) return;
  std::error_code code;
  if (model.features.empty()) {
    // Undoing what opening did is no wish for all files to come.
    const bool undone = applied_ && editing_.editor().history().undo_count() == 0;
    if (!undone) fs::remove(path, code);
    return;
  }
  fs::create_directories(fs::path(path).parent_path(), code);
  const std::string text = io::write_features({document::hash_topology(*model.mesh), model.features});
  if (const auto written = files::write_file(path, base::as_bytes(text)); !written)
    notices_.tell("the features are not kept for other files: " + written.error().line(path), true);
}

void KeptFeatures::follow(double time_s, bool plays) {
  if (!began_at_s_) began_at_s_ = time_s;
  const replay::DrawnStroke* stroke = editing_.session().pens().current();
  const bool draws = stroke != nullptr && stroke->on_canvas &&
                     editing_.editor().tool().kind != drawing::ToolKind::feature &&
                     !drawing::is_tap(stroke->samples, stroke->view.viewport);
  if (draws || plays || time_s != *began_at_s_) hide();
  if (revision_ == editing_.revision()) return;
  revision_ = editing_.revision();
  const auto before = std::exchange(model_, editing_.document().model);
  const bool corrected = before->mesh == model_->mesh && !same_features(*before, *model_);
  if (!corrected) return hide();
  keep();
}

}  // namespace penpose::app
