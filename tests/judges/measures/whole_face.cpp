#include "tests/judges/measures/whole_face.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"
#include "tests/judges/cases/picture.h"
#include "tests/judges/hands/hand.h"

namespace penpose::judges {
namespace {

/// A vertex should stay that should move by no more than this share of what moves most.
constexpr double k_stays = 0.02;

double square(const ModelVector& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

}  // namespace

WholeFace::WholeFace(const document::Model& model, const io::CaseFile& file)
    : model_(model), rest_(posed(model, rig::rest_pose(*model.rig))), at_rest_(rig::rest_pose(*model.rig)) {
  geometry::Box box;
  for (const io::PoseCase& one : file.cases) {
    for (const io::CaseReference& reference : one.references) {
      for (const std::uint32_t v : reference.vertices) box.add(rest_[v]);
    }
  }
  size_ = box.diagonal();
}

std::vector<ModelVector> WholeFace::moved(const rig::Pose& pose) const {
  std::vector<ModelVector> way = posed(model_, pose);
  for (std::size_t v = 0; v < way.size(); ++v) way[v] -= rest_[v];
  return way;
}

void WholeFace::judge(const std::vector<ModelVector>& truth, const std::vector<ModelVector>& found,
                      Outcome& outcome) const {
  double most = 0;
  double wrong = 0;
  double all = 0;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    most = std::max(most, geometry::length(truth[v]));
    wrong += square(found[v] - truth[v]);
    all += square(truth[v]);
  }
  const bool still = most <= 1e-9 * size_;
  double stray = 0;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    if (still || geometry::length(truth[v]) <= k_stays * most) stray = std::max(stray, geometry::length(found[v]));
  }
  (still ? outcome.still : outcome.stray) = 100 * stray / size_;
  if (!still) outcome.error = 100 * std::sqrt(wrong / all);
}

double WholeFace::left(const io::PoseCase& one, const std::vector<ModelVector>& found) const {
  constexpr std::size_t k_samples = 200;
  const Picture picture(one.view_yaw_degrees, size_);
  double sum = 0;
  for (const io::CaseReference& reference : one.references) {
    std::vector<PxPoint> drawn;
    for (const ModelPoint& p : reference.target) drawn.push_back(picture.flat(p));
    drawn = resampled(drawn, k_samples);
    double distances = 0;
    for (const std::uint32_t v : reference.vertices) {
      const PxPoint p = picture.flat(rest_[v] + found[v]);
      double least = 1e300;
      for (const PxPoint& q : drawn) least = std::min(least, geometry::distance(p, q));
      distances += least;
    }
    sum += distances / static_cast<double>(reference.vertices.size());
  }
  return 100 * sum / static_cast<double>(one.references.size()) / Picture::k_face_px;
}

void WholeFace::count_controls(const rig::Pose& pose, Outcome& outcome) const {
  constexpr double k_counts = 0.02;
  double count = 0;
  for (std::size_t i = 0; i < pose.size(); ++i) {
    if (std::abs(pose[i] - at_rest_[i]) <= k_counts) continue;
    ++count;
    outcome.note +=
        (outcome.note.empty() ? "" : " ") + model_.rig->parameters()[i].name + "=" + base::format_fixed(pose[i], 2);
  }
  outcome.controls = count;
}

}  // namespace penpose::judges
