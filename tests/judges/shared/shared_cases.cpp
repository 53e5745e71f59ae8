#include "tests/judges/shared/shared_cases.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <regex>

#include "core/document/source_file.h"
#include "core/io/model/read_model.h"
#include "tests/judges/rigs/control_words.h"
#include "tests/support/shared_data.h"

namespace penpose::judges {
namespace {

std::vector<std::uint8_t> bytes_of(const std::string& name) {
  return tests::read_file(tests::shared_dir() / "meshes" / name);
}

template <typename Value>
Value or_end(base::Result<Value> result, const std::string& name) {
  if (!result) {
    std::fprintf(stderr, "%s\n", result.error().line(name).c_str());
    std::exit(1);
  }
  return std::move(result).value();
}

}  // namespace

SharedFile read_shared_cases(const std::string& name) {
  const auto bytes = bytes_of(name);
  SharedFile file{or_end(io::read_cases(bytes), name), {}};
  const auto json = nlohmann::json::parse(bytes.begin(), bytes.end());
  for (const auto& one : json.at("cases")) file.meant.push_back(one);
  return file;
}

document::Model read_shared_model(const std::string& name) {
  return or_end(io::read_model(bytes_of(name), name), name);
}

Rig shared_face(const std::string& name, document::Model model, const SharedFile& file) {
  Rig rig;
  rig.name = name;
  rig.kind = "a real face";
  rig.group = Group::shared;
  rig.model = std::move(model);
  const auto bytes = bytes_of("ict_face_landmarks.json");
  const auto json = nlohmann::json::parse(bytes.begin(), bytes.end());
  for (const auto& [curve, line] : json.at("curves").items())
    rig.lines.push_back({curve, line.at("vertices").get<std::vector<std::uint32_t>>()});
  for (const io::PoseCase& one : file.cases.cases) {
    if (!one.weights.empty()) rig.poses.push_back({one.name, one.weights});
  }
  return rig;
}

std::vector<std::string> controls_like(const document::Model& model, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (const rig::Parameter& p : model.rig->parameters()) {
    const std::string control = control_of(p.name);
    if (std::regex_match(control, expression) && (found.empty() || found.back() != control)) found.push_back(control);
  }
  return found;
}

std::vector<KnownFace> known_faces_of(const document::Model& model, const SharedFile& file) {
  std::vector<KnownFace> faces;
  for (const io::PoseCase& one : file.cases.cases) {
    KnownFace face;
    face.asked = one;
    face.truth = pose_of(*model.rig, one.weights);
    face.true_controls = static_cast<double>(one.weights.size());
    faces.push_back(std::move(face));
  }
  return faces;
}

std::vector<Gesture> gestures_of(const document::Model& model, const SharedFile& file) {
  std::vector<Gesture> gestures;
  for (std::size_t i = 0; i < file.meant.size(); ++i) {
    Gesture gesture;
    gesture.asked = file.cases.cases[i];
    for (const std::string pattern : file.meant[i].at("need")) gesture.needed.push_back(controls_like(model, pattern));
    for (const std::string pattern : file.meant[i].at("accept")) {
      for (std::string& name : controls_like(model, pattern)) gesture.accepted.push_back(std::move(name));
    }
    gestures.push_back(std::move(gesture));
  }
  return gestures;
}

std::vector<Limb> limbs_of(const document::Model& model, const SharedFile& file) {
  const auto& nodes = model.source->nodes;
  std::vector<Limb> limbs;
  for (std::size_t i = 0; i < file.meant.size(); ++i) {
    std::vector<Move::Turn> turns;
    for (const auto& turn : file.meant[i].at("turns")) {
      const auto joint = std::find(nodes.begin(), nodes.end(), std::optional(turn[0].get<std::size_t>()));
      turns.push_back({static_cast<std::size_t>(joint - nodes.begin()), {turn[1], turn[2], turn[3]}});
    }
    limbs.push_back({file.cases.cases[i], "", turned_pose(model, turns)});
  }
  return limbs;
}

}  // namespace penpose::judges
