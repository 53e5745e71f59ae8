#include "tests/judges/shared/shared_sets.h"

#include <algorithm>
#include <array>

#include "tests/judges/rigs/control_words.h"
#include "tests/judges/shared/kinds.h"
#include "tests/support/shared_data.h"

namespace penpose::judges {
namespace {

using Names = std::vector<std::string>;

/// Which file of cases a measure takes.
struct Files {
  const char* measure;
  const char* cases;
};

std::vector<Outcome> judged(const std::string& measure, const document::Model& model, const SharedFile& file) {
  if (measure == "gesture") return judge_gestures(model, gestures_of(model, file));
  if (measure == "body") return judge_limbs(model, limbs_of(model, file));
  const auto faces = known_faces_of(model, file);
  if (measure == "exact") return judge_exact(model, faces);
  return measure == "meant" ? judge_meant(model, faces) : judge_known_faces(model, faces);
}

SharedSet real(const std::string& name, const std::vector<Files>& files) {
  SharedSet set{name, {}, {}, {}};
  for (const Files& one : files) set.measures.push_back(one.measure);
  set.run = [name, files](const Names& measures) {
    const document::Model model = read_shared_model(name + ".glb");
    std::vector<Judged> all;
    for (const Files& one : files) {
      if (!has(measures, one.measure)) continue;
      all.push_back({one.measure, name, "shared", judged(one.measure, model, read_shared_cases(one.cases))});
    }
    return all;
  };
  return set;
}

SharedSet kind(const std::string& name) {
  return {name,
          {"gesture"},
          [name](const Names&) {
            const Kind made = make_kind(name);
            return std::vector<Judged>{{"gesture", name, "shared", judge_gestures(made.model, made.gestures)}};
          },
          {}};
}

/// With the lines of its features, and with poses that its cases know.
SharedSet face(const std::string& name, const std::vector<Files>& files) {
  SharedSet set = real(name, files);
  set.rig_of = [name, cases = std::string(files.front().cases)] {
    return shared_face(name, read_shared_model(name + ".glb"), read_shared_cases(cases));
  };
  return set;
}

}  // namespace

bool needs_cases(const std::string& measure) {
  constexpr std::array<const char*, 5> k_of_files{"intent", "gesture", "body", "exact", "meant"};
  return std::find(k_of_files.begin(), k_of_files.end(), measure) != k_of_files.end();
}

std::vector<SharedSet> shared_sets() {
  if (!tests::has_shared()) return {};
  std::vector<SharedSet> sets{
      face("ict_face", {{"intent", "ict_face_intent_cases.json"},
                        {"exact", "ict_face_sketch_cases.json"},
                        {"meant", "ict_face_pose_cases.json"}}),
      real("ict_face_narrow", {{"intent", "ict_face_intent_cases.json"}, {"exact", "ict_face_sketch_cases.json"}}),
      face("ict_avatar", {{"intent", "ict_avatar_intent_cases.json"}, {"gesture", "ict_avatar_gestures.json"}}),
      real("cesium_man", {{"body", "cesium_body_cases.json"}}),
  };
  for (const std::string& name : kind_names()) sets.push_back(kind(name));
  return sets;
}

}  // namespace penpose::judges
