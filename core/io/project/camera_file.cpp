#include "core/io/project/camera_file.h"

#include <optional>
#include <string>

#include "core/base/json/json.h"

namespace penpose::io {
namespace {

constexpr const char* k_form = R"(write {"eye": [x, y, z], "look_at": [x, y, z]})";

base::Result<glm::dvec3> read_vector(const json::Json& object, const char* key, std::optional<glm::dvec3> fallback) {
  const json::Json* found = json::find(object, key);
  const std::string place = std::string("/") + key;
  if (found == nullptr) {
    if (fallback) return *fallback;
    return base::Error{"the camera has no " + std::string(key), place, k_form};
  }
  if (!found->is_array() || found->size() != 3) return base::Error{"is not a list of three numbers", place, k_form};
  glm::dvec3 vector{0};
  for (int i = 0; i < 3; ++i) {
    const auto number = json::number((*found)[static_cast<std::size_t>(i)]);
    if (!number) return base::Error{"is not a number", place + "/" + std::to_string(i), k_form};
    vector[i] = *number;
  }
  return vector;
}

}  // namespace

base::Result<geometry::CameraPose> read_camera(base::Bytes bytes) {
  // A few hundred bytes are enough; the bound keeps hostile nesting small.
  if (bytes.size() > 65536) return base::Error{"is too large for a camera", "", k_form};
  const auto parsed = json::parse_json(bytes);
  if (!parsed) return base::Error{"is not valid JSON", parsed.error().place, k_form};
  const json::Json& root = *parsed;
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
  if (const json::Json* angle = json::find(root, "vertical_fov_degrees")) {
    const auto degrees = json::number(*angle);
    if (!degrees) return base::Error{"is not a number", "/vertical_fov_degrees", "use 1 to 179 degrees"};
    pose.vertical_fov_degrees = *degrees;
  }
  if (auto checked = geometry::Camera::make(pose, {}); !checked) return checked.error();
  return pose;
}

}  // namespace penpose::io
