#pragma once

#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/rig/blend_shapes.h"
#include "core/rig/skeleton.h"
#include "tests/judges/rigs/expressions.h"
#include "tests/judges/rigs/parts.h"

namespace penpose::judges {

/// Muscles and how much of each.
using Recipe = std::vector<std::pair<std::string, double>>;
/// What a control stands for.
using Means = std::vector<std::string>;

/// Parameters and the values at which they do something.
using Values = std::vector<std::pair<std::string, double>>;

/// Puts a face together: shapes that are sums of muscles, and joints. Controls keep the order in which they are added.
class FaceBuilder {
 public:
  /// What controls stand for, and the values at which their muscles are at their most.
  struct Act {
    Values at_most;
    Means means;
  };
  /// May give a shape another name, another recipe and fewer things that it stands for; false leaves it out.
  using Maker = std::function<bool(std::string& name, Recipe& recipe, Means& means)>;

  FaceBuilder(std::string name, std::string kind, Group group, const Parts& parts);

  /// From now on each shape is made by someone's own taste.
  void made_by(Maker maker) { maker_ = std::move(maker); }

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
  /// The same with axes of its own: `frame` takes them to those of the model.
  std::size_t joint(std::string name, std::int32_t parent, const ModelPoint& at, double degrees,
                    const glm::dquat& frame);
  /// Vertices that follow a joint by these shares; what is left of a vertex goes on following what carried it before.
  void carry(std::size_t joint, std::span<const double> share);
  /// That an angle of a joint ("jaw.rx", 0.3) does what muscles do at their most.
  void turn_means(std::string parameter, double at_most, Means muscles);
  /// The same of several angles at once, of one joint or more.
  void turns_mean(Values at_most, Means muscles);
  /// The angles of a joint at which it has turned by so much (radians) about an axis of the model.
  [[nodiscard]] Values turned_about(std::size_t joint, const ModelVector& axis, double angle) const;

  /// All shapes and turns so far, in the order in which they were added.
  [[nodiscard]] std::span<const Act> acts() const { return acts_; }

  /// Adds a known pose, in values of controls.
  void pose(std::string name, Values values);

  /// Expressions of which it has a known pose beside the ordinary ones, if the rig has every muscle.
  void also_known(std::vector<Expression> more) { more_ = std::move(more); }

  /// Known poses are the ordinary expressions of which the rig has every muscle (expressions.h), and those added.
  [[nodiscard]] Rig build();

 private:
  /// The shape's name, if there is one.
  std::optional<std::string> add_shape(std::string name, Recipe recipe, std::optional<Means> means);
  void add_expressions();

  Rig rig_;
  const Parts& parts_;
  Maker maker_;
  std::vector<rig::BlendShape> shapes_;
  std::vector<rig::Joint> joints_;
  std::vector<ModelPoint> joint_places_;
  std::vector<glm::dquat> joint_frames_;
  std::vector<std::vector<rig::Influence>> influences_;
  std::vector<Act> acts_;
  std::vector<Expression> more_;
};

}  // namespace penpose::judges
