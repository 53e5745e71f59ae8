#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/fbx/fbx_scene.h"
#include "core/io/fbx/motion/fbx_curve.h"

namespace penpose::io {

/// Curves that were read, by their ids: takes share them.
using FbxCurves = std::map<std::int64_t, std::shared_ptr<const FbxCurve>>;

/// One take of the file: the curves of its layers, by the property that they drive.
class FbxTake {
 public:
  FbxTake(const FbxScene& scene, const FbxObject& stack, FbxCurves& curves);

  /// Returns true if keys move a property away from its value in the file.
  [[nodiscard]] bool moves(std::int64_t object, std::string_view property, const glm::dvec3& still) const;
  [[nodiscard]] bool drives(std::int64_t object, std::string_view property) const;
  /// A property at a time. `still`: its value in the file.
  [[nodiscard]] glm::dvec3 value(std::int64_t object, std::string_view property, const glm::dvec3& still,
                                 double time_s) const;
  void add_curves(std::int64_t object, std::string_view property, std::vector<const FbxCurve*>& curves) const;
  [[nodiscard]] double start_s() const { return start_s_; }
  [[nodiscard]] double stop_s() const { return stop_s_; }
  [[nodiscard]] std::size_t layers() const { return layers_; }
  /// Returns the ids of the objects that have keys, each once.
  [[nodiscard]] std::vector<std::int64_t> objects() const;

 private:
  /// Holds the curves and the weight that one layer gives a property.
  struct Layer {
    std::array<std::shared_ptr<const FbxCurve>, 3> axes;
    glm::dvec3 otherwise{std::numeric_limits<double>::quiet_NaN()};  ///< where an axis has no curve; NaN: as below
    bool first = true, adds = false, replaces = true;
    bool turns_apart = false, multiplies = false;
    std::int64_t id = 0;
    double weight = 1;
    int order = 0;  ///< of the node's rotation
  };
  struct Name {
    std::int64_t object;
    std::string property;
    friend bool operator<(const Name& a, const Name& b) {
      return a.object != b.object ? a.object < b.object : a.property < b.property;
    }
  };
  void add(const FbxScene& scene, const FbxObject& node, const Layer& kind, FbxCurves& curves);
  [[nodiscard]] const std::vector<Layer>* layers_of(std::int64_t object, std::string_view property) const;
  static glm::dvec3 joined(const Layer& layer, std::string_view property, const glm::dvec3& below,
                           const glm::dvec3& value, double weight);
  [[nodiscard]] double weight_of(const Layer& layer, double time_s) const;

  std::map<Name, std::vector<Layer>> all_;
  std::size_t layers_ = 0;
  double start_s_ = 0, stop_s_ = 0;
};

[[nodiscard]] std::vector<std::pair<std::string, FbxTake>> fbx_takes(const FbxScene& scene);

}  // namespace penpose::io
