#include "ui/cli/camera_file.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace penpose::cli {
namespace {

using nlohmann::json;

constexpr const char* k_form = R"(write {"eye": [x, y, z], "look_at": [x, y, z]})";

base::Result<glm::dvec3> read_vector(const json& object, const char* key, std::optional<glm::dvec3> fallback) {
  const auto found = object.find(key);
  const std::string place = std::string("/") + key;
  if (found == object.end()) {
    if (fallback) return *fallback;
    return base::Error{"the camera has no " + std::string(key), place, k_form};
  }
  if (!found->is_array() || found->size() != 3) return base::Error{"is not a list of three numbers", place, k_form};
  glm::dvec3 vector{0};
  for (int i = 0; i < 3; ++i) {
    const json& number = (*found)[static_cast<std::size_t>(i)];
    if (!number.is_number()) return base::Error{"is not a number", place + "/" + std::to_string(i), k_form};
    vector[i] = number.get<double>();
  }
  return vector;
}

}  // namespace

base::Result<geometry::CameraPose> read_camera(base::Bytes bytes) {
  // A few hundred bytes are enough; the bound keeps hostile nesting small.
  if (bytes.size() > 65536) return base::Error{"is too large for a camera", "", k_form};
  const json root = json::parse(bytes.begin(), bytes.end(), nullptr, false);
  if (root.is_discarded()) return base::Error{"is not valid JSON", "", k_form};
  if (!root.is_object()) return base::Error{"is not a JSON object", "/", k_form};
  geometry::CameraPose pose;
  const auto eye = read_vector(root, "eye", std::nullopt);
  if (!eye) return eye.error();
  const auto look_at = read_vector(root, "look_at", std::nullopt);
  if (!look_at) return look_at.error();
  const auto up = read_vector(root, "up", glm::dvec3{0, 1, 0});
  if (!up) return up.error();
  pose.eye = *eye;
  pose.look_at = *look_at;
  pose.up = *up;
  if (const auto angle = root.find("vertical_fov_degrees"); angle != root.end()) {
    if (!angle->is_number()) return base::Error{"is not a number", "/vertical_fov_degrees", "use 1 to 179 degrees"};
    pose.vertical_fov_degrees = angle->get<double>();
  }
  if (auto checked = geometry::Camera::make(pose, {}); !checked) return checked.error();
  return pose;
}

}  // namespace penpose::cli
