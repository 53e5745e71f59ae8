#include <chrono>

#include "tests/judges/cases/known_faces.h"
#include "tests/judges/drawing/drawing_measures.h"
#include "tests/judges/drawing/known/known_drawing.h"
#include "tests/judges/measures/whole_face.h"

namespace penpose::judges {
namespace {

using namespace drawn;

struct NamedPose {
  std::string name;
  rig::Pose pose;
};

/// Known poses that drawn lines can show, and a face at rest twice: once from its front, once from anywhere.
std::vector<NamedPose> poses_of(const Rig& rig, const JudgedFace& face) {
  const rig::Pose rest = rig::rest_pose(face.rig());
  std::vector<NamedPose> out;
  for (const KnownPose& known : rig.poses) {
    NamedPose one{known.name, pose_of(face.rig(), known.values)};
    if (is_shown_by_lines(face, one.pose)) out.push_back(std::move(one));
  }
  out.push_back({"rest", rest});
  out.push_back({"rest_too", rest});
  return out;
}

/// Compares whole models; the size is that of all marks.
WholeFace whole_face(const JudgedFace& face, const Rig& rig) {
  io::PoseCase marks;
  for (const FaceLine& line : rig.lines) marks.references.push_back({line.name, line.vertices, {}, {}});
  return {face.model(), {{}, {marks}}};
}

Outcome outcome_of(const JudgedFace& face, const WholeFace& whole, const NamedPose& meant, const Artist& artist,
                   const KnownDrawing& drawing) {
  Outcome out;
  out.name = meant.name;
  out.hand = artist.name;
  const auto start = std::chrono::steady_clock::now();
  const auto found = read(face, face.marks, drawing.drawing(), drawing.yaw_degrees);
  out.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  out.of = static_cast<double>(drawing.lines.size());
  if (found) {
    out.right = static_cast<double>(right_labels(drawing, found->read.lines));
  } else {
    out.note = found.error().line();
  }
  // Who is refused sees a face at rest.
  whole.judge(whole.moved(meant.pose), whole.moved(found ? found->pose : rig::rest_pose(face.rig())), out);
  return out;
}

/// A brief look takes every fifth pose, drawn by one artist.
bool taken(Extent extent, std::size_t pose, std::size_t artist, std::size_t artists, std::size_t turn) {
  return extent == Extent::whole || ((pose + turn) % 5 == 0 && artist == (pose / 5 + turn) % artists);
}

template <int Percent, bool Over>
std::vector<Outcome> judge(const Rig& rig, Extent extent) {
  const auto kept = face_of(rig);
  const JudgedFace& face = *kept;
  const WholeFace whole = whole_face(face, rig);
  const auto poses = poses_of(rig, face);
  const auto artists = artists_for(rig.group);
  // What a brief look takes differs from measure to measure and from rig to rig.
  const std::size_t turn = seed_of(rig.name, "turn", Percent + (Over ? 1 : 0)) % 64;
  std::vector<Outcome> out;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (std::size_t a = 0; a < artists.size(); ++a) {
      if (!taken(extent, i, a, artists.size(), turn)) continue;
      const std::string by = poses[i].name + " by " + artists[a].name;
      out.push_back(outcome_of(face, whole, poses[i], artists[a],
                               draw_known(face, poses[i].pose, artists[a], {Percent / 100.0, Over},
                                          seed_of(rig.name, poses[i].name), seed_of(rig.name, by, Percent))));
    }
  }
  return out;
}

}  // namespace

std::vector<Measure> known_drawing_measures() {
  return {{"drawing_over", has_face, judge<0, true>},        {"drawing_over_10", has_face, judge<10, true>},
          {"drawing_over_20", has_face, judge<20, true>},    {"drawing_beside", has_face, judge<0, false>},
          {"drawing_beside_10", has_face, judge<10, false>}, {"drawing_beside_20", has_face, judge<20, false>}};
}

}  // namespace penpose::judges
