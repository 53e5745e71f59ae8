#pragma once

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/articulation/region/canvas.h"
#include "core/document/model.h"
#include "core/head/head.h"
#include "core/io/model/read_model.h"
#include "tests/support/shared_data.h"

namespace penpose::tests {

/// A face with the lines of its features.
struct MarkedFace {
  std::shared_ptr<const articulation::Canvas> canvas;
  std::map<std::string, std::vector<geometry::ModelPoint>> curves;
};

/// A face of the shared data.
inline MarkedFace shared_face(const std::string& file, const std::string& marks = "ict_face_landmarks.json") {
  const auto bytes = read_file(shared_dir() / "meshes" / file);
  const auto text = read_file(shared_dir() / "meshes" / marks);
  const auto json = nlohmann::json::parse(text.begin(), text.end());
  MarkedFace face{document::make_canvas(io::read_model(bytes, file).value()).value(), {}};
  for (const auto& [name, curve] : json["curves"].items()) {
    for (const auto& v : curve["vertices"]) {
      face.curves[name].push_back(face.canvas->positions()[v.get<std::size_t>()]);
    }
  }
  return face;
}

inline MarkedFace built_in_face() {
  const document::Model head = head::make_head();
  MarkedFace face{document::make_canvas(head).value(), {}};
  for (const auto& curve : head.curves) {
    for (const auto& p : curve.points) {
      const auto& triangle = head.mesh->triangles()[p.triangle];
      geometry::ModelPoint place{0};
      for (std::size_t i = 0; i < 3; ++i) place += face.canvas->positions()[triangle[i]] * p.barycentric[i];
      face.curves[curve.name].push_back(place);
    }
  }
  return face;
}

}  // namespace penpose::tests
