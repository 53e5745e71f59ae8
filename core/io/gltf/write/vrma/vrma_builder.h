#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/result.h"
#include "core/document/model.h"
#include "core/io/gltf/write/internal/gltf_builder.h"

namespace penpose::io {

/// A VRM animation while it is written: its nodes, and the keys of its one animation.
class VrmaBuilder {
 public:
  VrmaBuilder();

  /// The extension, for what has members there.
  json::Json own = {{"specVersion", "1.0"}};
  std::vector<std::string> notes;  ///< what the format has no place for

  std::size_t add_node(std::string name, const glm::dvec3& place, std::optional<std::size_t> parent);
  /// `values`: as many a key as `type` has numbers, three times that for splines. `path`: "rotation", "translation".
  void add_keys(const std::vector<double>& times_s, document::Interpolation interpolation,
                const std::vector<float>& values, const char* type, std::size_t node, const char* path);
  [[nodiscard]] bool moves_nothing() const { return channels_.empty(); }
  /// The file; call it once. `name`: of the animation, may be empty. Errors: of GltfBuilder::finish.
  [[nodiscard]] base::Result<std::vector<std::uint8_t>> finish(const std::string& name);

 private:
  std::vector<json::Json> nodes_;
  std::vector<std::size_t> scene_;
  std::map<std::vector<float>, std::size_t> inputs_;  ///< accessors of times
  json::Json channels_ = json::Json::array();
  json::Json samplers_ = json::Json::array();
  GltfBuilder builder_;
};

/// A point as JSON, rounded to float.
[[nodiscard]] json::Json float_row(const glm::dvec3& v);
/// All times of some channels, and within splines seven more between two keys; rounded to float, ascending.
[[nodiscard]] std::vector<double> key_times(const std::vector<const document::Channel*>& channels);

}  // namespace penpose::io
