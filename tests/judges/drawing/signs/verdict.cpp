#include "tests/judges/drawing/signs/verdict.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "tests/judges/cases/picture.h"
#include "tests/judges/drawing/signs/head_turn.h"

namespace penpose::judges::drawn {
namespace {

/// Of so many controls that show most of a sign all pairs are tried.
constexpr std::size_t k_tried = 10;

CurvePlaces sum_of(const CurvePlaces& one, const CurvePlaces& other, const CurvePlaces& rest) {
  CurvePlaces sum = one;
  for (std::size_t c = 0; c < sum.size(); ++c) {
    for (std::size_t i = 0; i < sum[c].size(); ++i) sum[c][i] += other[c][i] - rest[c][i];
  }
  return sum;
}

}  // namespace

const char* verdict_name(Verdict verdict) {
  constexpr std::array<const char*, 7> k_names{"recognised", "partly", "wrong", "nothing",
                                               "left out",   "still",  "moved"};
  return k_names[static_cast<std::size_t>(verdict)];
}

base::Result<FaceJudge> FaceJudge::make(const JudgedFace& face) {
  CurvePlaces rest = places_of(face.marks, face.rest);
  auto signs = FaceSigns::make(face.marks, rest, face.front_yaw_degrees());
  if (!signs) return signs.error();
  FaceJudge judge(face, std::move(*signs));
  judge.rest_ = std::move(rest);
  judge.find_ways();
  return judge;
}

void FaceJudge::find_ways() {
  const rig::CharacterRig& rig = face_->rig();
  const auto parameters = rig.parameters();
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    if (face_->whole.joint[p] != intent::k_no_partner) continue;
    for (const double end : {parameters[p].maximum, parameters[p].minimum}) {
      if (end == parameters[p].rest) continue;
      rig::Pose pose = rig::rest_pose(rig);
      pose[p] = end;
      CurvePlaces places = places_of(face_->marks, posed(face_->model(), pose));
      if (places != rest_) ways_.push_back(std::move(places));
    }
  }
}

bool FaceJudge::can_show(const AnyOf& sign, std::optional<Side> side) {
  if (ways_.empty()) return true;
  const std::pair key{&sign, side ? static_cast<int>(*side) : -1};
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  std::vector<Signs> shown;
  for (const CurvePlaces& way : ways_) shown.push_back(signs_.of(way, side));
  bool can = std::any_of(shown.begin(), shown.end(), [&](const Signs& one) { return holds(sign, one); });
  std::vector<bool> tried(ways_.size());
  for (const Condition& one : sign) {
    std::vector<std::size_t> order(ways_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return one.above ? shown[a][one.sign] > shown[b][one.sign] : shown[a][one.sign] < shown[b][one.sign];
    });
    for (std::size_t k = 0; k < std::min(k_tried, order.size()); ++k) tried[order[k]] = true;
  }
  for (std::size_t a = 0; a < ways_.size() && !can; ++a) {
    for (std::size_t b = 0; b < a && !can; ++b) {
      can = tried[a] && tried[b] && holds(sign, signs_.of(sum_of(ways_[a], ways_[b], rest_), side));
    }
  }
  known_[key] = can;
  return can;
}

bool FaceJudge::turns_joints(const rig::Pose& pose) const {
  const rig::Pose rest = rig::rest_pose(face_->rig());
  for (std::size_t p = 0; p < pose.size(); ++p) {
    if (face_->whole.joint[p] != intent::k_no_partner && pose[p] != rest[p]) return true;
  }
  return false;
}

Seen FaceJudge::look(const rig::Pose& pose, Expression meant, std::optional<Side> side) {
  const auto places = posed(face_->model(), pose);
  Seen seen;
  seen.moved_percent = 100 * largest_move(face_->rest, places) / signs_.height();
  HeldStill held{places_of(face_->marks, places), 0};
  if (turns_joints(pose)) held = without_head_turn(rest_, held.places, signs_.fixed());
  seen.head_degrees = held.degrees;
  seen.signs = signs_.of(held.places, side);
  seen.torn_percent = 100 * signs_.crossing(held.places) / signs_.height();
  for (const Condition& one : torn_signs()) seen.torn = seen.torn || one.holds(seen.signs);
  if (meant == Expression::rest) {
    seen.verdict = seen.moved_percent <= k_seen_percent ? Verdict::still : Verdict::moved;
    return seen;
  }
  const SignsOf& wanted = signs_of(meant);
  const auto words = [](const AnyOf& any) {
    std::string all;
    for (const Condition& one : any) all += (all.empty() ? "" : " or ") + one.words();
    return all;
  };
  std::size_t need = 0, there = 0;
  for (const AnyOf& sign : wanted.need) {
    if (!can_show(sign, side)) {
      seen.cannot.push_back(words(sign));
      continue;
    }
    ++need;
    if (holds(sign, seen.signs)) {
      ++there;
    } else {
      seen.missing.push_back(words(sign));
    }
  }
  for (const Condition& one : wanted.never) {
    if (one.holds(seen.signs)) seen.other.push_back(one.words());
  }
  if (seen.torn) seen.other.emplace_back("torn");
  if (seen.head_degrees > k_head_degrees) seen.other.emplace_back("head");
  seen.verdict = need == 0                             ? Verdict::left_out
                 : seen.moved_percent < k_seen_percent ? Verdict::nothing
                 : !seen.other.empty()                 ? Verdict::wrong
                 : there == need                       ? Verdict::recognised
                 : 2 * there >= need                   ? Verdict::partly
                                                       : Verdict::wrong;
  return seen;
}

}  // namespace penpose::judges::drawn
