#pragma once

#include <nlohmann/json.hpp>

#include "core/character/demo_head.h"
#include "core/io/model/read_model.h"
#include "tests/core/portrait/feature_distance.h"
#include "tests/support/shared_data.h"

namespace penpose::tests {

/// A head with curves that somebody else drew on it.
struct KnownHead {
  std::string name;
  document::Model model;
  std::map<std::string, Line> curves;
};

/// The built-in head and those of the shared models.
inline std::vector<KnownHead> known_heads() {
  std::vector<KnownHead> heads;
  heads.push_back({"builtin:demo", character::make_demo_head().value(), {}});
  KnownHead& own = heads.back();
  const auto rest = document::posed_positions(own.model);
  for (const document::NamedCurve& curve : own.model.curves) {
    const bool is_border = curve.name == "lip_upper" || curve.name == "lip_lower";
    for (const mesh::MeshPoint& p : curve.points) {
      own.curves[is_border ? curve.name + "_outer" : curve.name].push_back(
          mesh::position_of(p, own.model.mesh->triangles(), rest));
    }
  }
  if (!has_shared()) return heads;
  for (const char* file :
       {"ict_face.glb", "ict_face_narrow.glb", "ict_avatar.glb", "carry_head.glb", "carry_head_answer.glb"}) {
    const std::string name = file;
    KnownHead head{name, io::read_model(read_file(shared_dir() / "meshes" / name), name).value(), {}};
    const char* landmarks = name.starts_with("carry") ? "carry_head_landmarks.json" : "ict_face_landmarks.json";
    const auto file_of_curves = nlohmann::json::parse(read_file(shared_dir() / "meshes" / landmarks));
    const auto places = document::posed_positions(head.model);
    for (const auto& [curve, content] : file_of_curves.at("curves").items()) {
      for (const auto& vertex : content.at("vertices")) head.curves[curve].push_back(places[vertex.get<std::size_t>()]);
    }
    heads.push_back(std::move(head));
  }
  return heads;
}

}  // namespace penpose::tests
