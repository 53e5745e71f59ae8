#include <chrono>

#include "tests/judges/drawing/drawing_measures.h"
#include "tests/judges/drawing/known/known_judge.h"

namespace penpose::judges {
namespace {

using namespace drawn;

struct NamedPose {
  std::string name;
  rig::Pose pose;
};

/// Known poses that drawn lines can show, and a face at rest twice: once from its front, once from anywhere.
std::vector<NamedPose> poses_of(const Rig& rig, const JudgedFace& face) {
  const auto parameters = face.rig().parameters();
  const rig::Pose rest = rig::rest_pose(face.rig());
  std::vector<NamedPose> out;
  for (const KnownPose& known : rig.poses) {
    NamedPose one{known.name, rest};
    for (const auto& [name, value] : known.values) {
      if (const auto p = rig::find_parameter(parameters, name)) one.pose[*p] = value;
    }
    if (is_shown_by_lines(face, one.pose)) out.push_back(std::move(one));
  }
  out.push_back({"rest", rest});
  out.push_back({"rest_too", rest});
  return out;
}

Outcome outcome_of(const JudgedFace& face, const NamedPose& meant, const Artist& artist, const KnownDrawing& drawing) {
  Outcome out;
  out.name = meant.name + (drawing.over ? " over" : " beside");
  out.hand = artist.name;
  const auto start = std::chrono::steady_clock::now();
  const auto found = read(face, face.marks, drawing.drawing(), drawing.yaw_degrees);
  out.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  // Who is refused sees a face at rest.
  const auto verdict = found ? judged(face, meant.pose, found->pose, drawing, found->read.lines)
                             : judged(face, meant.pose, rig::rest_pose(face.rig()), drawing, {});
  if (!found) out.note = found.error().line();
  out.right = static_cast<double>(verdict.right);
  out.of = static_cast<double>(verdict.of);
  out.error = verdict.error_percent;
  (out.error ? out.stray : out.still) = verdict.stray_percent;
  return out;
}

/// The numbers of what is looked at: all, or a share of it that differs from measure to measure.
constexpr std::size_t k_brief_step = 4;

template <int Percent>
std::vector<Outcome> judge(const Rig& rig, Extent extent) {
  const JudgedFace face = face_of(rig);
  const auto poses = poses_of(rig, face);
  const auto artists = artists_for(rig.group);
  std::vector<Outcome> out;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const bool rest = !rig::Pose(poses[i].pose).empty() && poses[i].pose == rig::rest_pose(face.rig());
    for (std::size_t a = 0; a < artists.size(); ++a) {
      for (const bool over : {true, false}) {
        // A brief look takes each artist in turn, over the face and beside it.
        const std::size_t number = (i * artists.size() + a) * 2 + (over ? 0 : 1);
        const bool taken = rest ? a == i % artists.size() : (number + Percent / 10) % (k_brief_step * artists.size()) == 0;
        if (extent == Extent::brief && !taken) continue;
        const auto face_seed = seed_of(rig.name, poses[i].name), hand_seed = seed_of(rig.name, poses[i].name, 1000 * Percent + number + 1);
        const Freedom freedom{Percent / 100.0, over};
        out.push_back(outcome_of(face, poses[i], artists[a],
                                 draw_known(face, poses[i].pose, artists[a], freedom, face_seed, hand_seed)));
      }
    }
  }
  return out;
}

}  // namespace

std::array<Measure, 3> known_drawing_measures() {
  return {{{"drawing_exact", has_face, judge<0>},
           {"drawing_10_off", has_face, judge<10>},
           {"drawing_20_off", has_face, judge<20>}}};
}

}  // namespace penpose::judges
