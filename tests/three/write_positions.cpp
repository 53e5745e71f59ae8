// write_three_positions FILE.glb OUT.json: where the file's vertices are at eight times of its first animation.
// {"size", "low": [x, y, z], "high" (box over all times), "times": [s, ...], "parts": [{"name", "triangles": [i, j, k,
// ...] (of the part's own vertices), "positions": [[x, y, z, x, y, z, ...] a time]}]}

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "core/document/time/animation_sampling.h"
#include "core/io/model/read_model.h"
#include "tests/support/shared_data.h"

namespace {

using namespace penpose;

/// Shares of the animation: both ends, and between keys (in the demo, on the way into an expression and out of it).
constexpr double k_moments[] = {0, 0.065, 0.197, 0.32, 0.443, 0.571, 0.829, 1};

int fail(const std::string& line) {
  std::fprintf(stderr, "%s\n", line.c_str());
  return 1;
}

nlohmann::json positions_of(const mesh::Part& part, std::span<const geometry::ModelPoint> positions) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& p : positions.subspan(part.first_vertex, part.vertex_count)) {
    for (int axis = 0; axis < 3; ++axis) list.push_back(p[axis]);
  }
  return list;
}

nlohmann::json triangles_of(const mesh::Part& part, const mesh::TriangleMesh& mesh) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& triangle : mesh.triangles().subspan(part.first_triangle, part.triangle_count)) {
    for (const std::uint32_t v : triangle) list.push_back(v - part.first_vertex);
  }
  return list;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto model = io::read_model(tests::read_file(argv[1]), argv[1]);
  if (!model) return fail(model.error().line(argv[1]));
  if (model->animations.empty()) return fail(std::string(argv[1]) + ": has no animation");
  const document::Animation& animation = model->animations.front();
  nlohmann::json out = {{"size", document::rest_world_box(*model).diagonal()}, {"times", nlohmann::json::array()}};
  for (const mesh::Part& part : model->mesh->parts()) {
    out["parts"].push_back(
        {{"name", part.name}, {"triangles", triangles_of(part, *model->mesh)}, {"positions", nlohmann::json::array()}});
  }
  glm::dvec3 low(1e300);
  glm::dvec3 high(-1e300);
  for (const double moment : k_moments) {
    const double time = moment * document::duration_s(animation);
    const auto posed = document::model_at(*model, document::sample(*model, animation, time));
    if (!posed) return fail(posed.error().line(argv[1]));
    const auto positions = document::posed_positions(*posed);
    for (const auto& p : positions) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    out["times"].push_back(time);
    for (std::size_t i = 0; i < model->mesh->parts().size(); ++i) {
      out["parts"][i]["positions"].push_back(positions_of(model->mesh->parts()[i], positions));
    }
  }
  out["low"] = {low.x, low.y, low.z};
  out["high"] = {high.x, high.y, high.z};
  std::ofstream file(argv[2]);
  file << out.dump();
  return file.good() ? 0 : 1;
}
