#include "tests/judges/drawing/faces/face_reading.h"

#include <algorithm>
#include <chrono>

#include "core/document/features/feature_curves.h"

namespace penpose::judges::drawn {
namespace {

/// What was seen, in words.
std::string words(const FaceReading::Came& came) {
  if (!came.refused.empty()) return "refused: " + came.refused;
  std::string all = verdict_name(came.seen.verdict);
  const auto add = [&](const char* what, const std::vector<std::string>& signs) {
    for (std::size_t i = 0; i < signs.size(); ++i) all += (i == 0 ? std::string("; ") + what + " " : ", ") + signs[i];
  };
  add("missing", came.seen.missing);
  add("seen", came.seen.other);
  add("cannot", came.seen.cannot);
  return all;
}

}  // namespace

FaceReading::FaceReading(const Rig& rig) : face_(face_of(rig)), judge_(FaceJudge::make(*face_).value()) {
  auto found = document::feature_curves_of(face_->model(), face_->whole, {});
  if (found) {
    curves_ = std::move(found->curves);
  } else {
    refused_ = found.error().line();
  }
}

FaceReading::Came FaceReading::read(const portrait::Drawing& drawing, Expression meant, std::optional<Side> side) {
  if (!refused_.empty()) return {judge_.look(rig::rest_pose(face_->rig()), meant, side), refused_};
  const auto found = drawn::read(*face_, curves_, drawing, face_->front_yaw_degrees());
  if (!found) return {judge_.look(rig::rest_pose(face_->rig()), meant, side), found.error().line()};
  return {judge_.look(found->pose, meant, side), {}};
}

Outcome FaceReading::outcome(const portrait::Drawing& drawing, Expression meant, std::optional<Side> side) {
  Outcome out;
  const auto start = std::chrono::steady_clock::now();
  const Came came = read(drawing, meant, side);
  out.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  out.note = words(came);
  if (meant == Expression::rest) {
    out.still = came.seen.moved_percent;
    return out;
  }
  if (came.seen.verdict == Verdict::left_out) return out;
  out.of = 1;
  out.right = came.seen.verdict == Verdict::recognised ? 1 : 0;
  out.nothing = came.seen.verdict == Verdict::nothing ? 1 : 0;
  out.stray = came.seen.torn_percent;
  return out;
}

FaceReading& reading_of(const Rig& rig) {
  thread_local std::unique_ptr<FaceReading> last;
  if (!last || last->face().model().rig != rig.model.rig) last = std::make_unique<FaceReading>(rig);
  return *last;
}

Outcome as_thing(Outcome outcome) {
  outcome.of = 1;
  outcome.right = outcome.still.value_or(0) <= k_seen_percent ? 1 : 0;
  return outcome;
}

}  // namespace penpose::judges::drawn
