#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/rig/blend_shapes.h"
#include "core/rig/skeleton.h"
#include "tests/judges/rigs/parts.h"

namespace penpose::judges {

/// Muscles and how much of each.
using Recipe = std::vector<std::pair<std::string, double>>;
/// What a control stands for.
using Means = std::vector<std::string>;

/// Puts a face together: shapes that are sums of muscles, and joints. Controls keep the order in which they are added.
class FaceBuilder {
 public:
  FaceBuilder(std::string name, std::string kind, Group group, const Parts& parts);

  /// A shape that stands for the muscles that are at least half as strong in it as the strongest, or for `means`.
  void shape(std::string name, const Recipe& recipe, std::optional<Means> means = {});
  /// A shape for each side: "_L" and "_R" stand behind the name and behind muscles that end with "_".
  void sides(const std::string& name, const Recipe& recipe);
  /// The same with other ends of the name.
  void sides(const std::string& before, const std::string& left, const std::string& right, const std::string& behind,
             const Recipe& recipe);
  /// A shape of a whole face, which stands for nothing that is drawn alone; it is a pose of its own.
  void emote(std::string name, const Recipe& recipe);

  /// A joint of which no vertex is carried yet. `degrees` are its limits either way about each axis.
  std::size_t joint(std::string name, std::int32_t parent, const ModelPoint& at, double degrees = 60);
  /// Vertices that follow a joint by these shares; what is left of a vertex goes on following what carried it before.
  void carry(std::size_t joint, std::span<const double> share);
  /// That an angle of a joint ("jaw.rx", 0.3) does what muscles do at their most.
  void turn_means(std::string parameter, double at_most, Means muscles);

  /// Adds a known pose, in values of controls.
  void pose(std::string name, std::vector<std::pair<std::string, double>> values);

  /// Known poses are the ordinary expressions of which the rig has every muscle (expressions.h), and those added.
  [[nodiscard]] Rig build();

 private:
  struct Act {
    std::string parameter;
    Means means;
    double at_one;  ///< the value at which its muscles are at their most
  };
  void add_expressions();

  Rig rig_;
  const Parts& parts_;
  std::vector<rig::BlendShape> shapes_;
  std::vector<rig::Joint> joints_;
  std::vector<ModelPoint> joint_places_;
  std::vector<std::vector<rig::Influence>> influences_;
  std::vector<Act> acts_;
};

}  // namespace penpose::judges
