#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/io/fbx/fbx_scene.h"
#include "core/rig/blend_shapes.h"

namespace penpose::io {

/// A channel of blend shapes: one shape, or several that it goes through as its value rises.
struct FbxChannel {
  std::int64_t id = 0;
  std::uint32_t part = 0;           ///< the last one that it moves
  std::vector<double> knees;        ///< ascending: values at which a shape is there as a whole, 1 for 100 %
  std::vector<std::size_t> shapes;  ///< one a knee, of the model
  double value = 0;

  /// Sets the values of its shapes where the channel has this one: straight from none to the first, from knee to knee
  /// and on beyond the last one and beyond nothing, as Maya does it.
  void spread(double channel, std::vector<double>& values) const;
};

/// Reads the channels of meshes. Those of one name and with the same keys, on several meshes, are one.
class FbxShapes {
 public:
  explicit FbxShapes(const FbxScene& scene) : scene_(scene) {}

  /// A mesh whose vertices are numbers of the model.
  struct Part {
    std::uint32_t number = 0;
    std::uint32_t first_vertex = 0, vertex_count = 0;
    std::string name;
    glm::dmat3 placed{1},
        placed_loose{1};  ///< from the mesh to vertices at rest; of those that follow no joint of a skin
    const std::vector<bool>* loose = nullptr;
  };
  /// Returns how many numbers it has looked at.
  std::size_t add(const FbxObject& channel, const Part& part);

  std::vector<rig::BlendShape> shapes;
  std::vector<double> values;
  std::vector<FbxChannel> channels;
  std::vector<std::string> between;  ///< shapes that are not the last one of their channel

 private:
  [[nodiscard]] bool same_keys(std::int64_t a, std::int64_t b) const;
  void add_deltas(const FbxObject& shape, const std::vector<double>& mask, const Part& part, rig::BlendShape& to) const;

  const FbxScene& scene_;
  std::map<std::string, std::vector<std::size_t>> by_name_;  ///< channels
};

}  // namespace penpose::io
