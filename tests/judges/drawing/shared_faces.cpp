#include "tests/judges/drawing/shared_faces.h"

#include <algorithm>

#include "core/io/project/case_file.h"
#include "core/io/project/landmark_file.h"
#include "tests/judges/drawing/drawing_measures.h"
#include "tests/judges/shared/shared_cases.h"
#include "tests/support/shared_data.h"

namespace penpose::judges {
namespace {

std::vector<std::uint8_t> file(const std::string& name) {
  return tests::read_file(tests::shared_dir() / "meshes" / name);
}

Rig shared_rig(const std::string& name) {
  Rig rig;
  rig.name = name;
  rig.kind = "of the shared data";
  rig.group = Group::shared;
  rig.model = read_shared_model(name + ".glb");
  const auto curves = io::read_landmarks(file("ict_face_landmarks.json")).value();
  for (const auto& curve : curves) rig.lines.push_back({curve.name, curve.vertices});
  const io::CaseFile cases = io::read_cases(file(name + "_intent_cases.json")).value();
  for (const io::PoseCase& one : cases.cases) {
    // The same pose was drawn by several hands; here it is one.
    const bool known = std::any_of(rig.poses.begin(), rig.poses.end(),
                                   [&](const KnownPose& pose) { return pose.values == one.weights; });
    if (!known && !one.weights.empty()) rig.poses.push_back({one.name, one.weights});
  }
  return rig;
}

}  // namespace

SharedSet shared_face_set(const std::string& name) {
  SharedSet set{name, {}, {}};
  for (const Measure& one : drawing_measures()) set.measures.emplace_back(one.name);
  set.run = [name](const std::vector<std::string>& wanted) {
    const Rig rig = shared_rig(name);
    std::vector<Judged> all;
    for (const Measure& one : drawing_measures()) {
      if (std::find(wanted.begin(), wanted.end(), one.name) != wanted.end())
        all.push_back({one.name, name, group_name(rig.group), one.judge(rig, Extent::whole)});
    }
    return all;
  };
  return set;
}

}  // namespace penpose::judges
