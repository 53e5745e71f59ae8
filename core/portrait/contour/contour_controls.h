#pragma once

#include <span>
#include <vector>

#include "core/geometry/camera.h"
#include "core/intent/choosing/choice.h"
#include "core/intent/model/whole_model.h"
#include "core/joints/turn.h"
#include "core/rig/rig.h"

namespace penpose::portrait {

/// What can move a contour: controls by shares of their ranges, and joints by turns about their own axes (in half
/// circles), of which the first lies along the view, so that it turns what is drawn as a whole.
class ContourControls {
 public:
  /// `start`: where nothing has moved; `free`: parameters that may move, ascending.
  ContourControls(const rig::Rig& rig, const intent::WholeModel& whole, const rig::Pose& start,
                  std::span<const std::size_t> free, const geometry::Camera& camera);

  /// Units: a control, those of both sides, or of a joint all axes, or the view's direction alone.
  [[nodiscard]] const intent::Choices& choices() const { return choices_; }
  [[nodiscard]] std::size_t variable_count() const { return variables_.size(); }
  [[nodiscard]] rig::Pose pose_of(const intent::Choice& choice) const;
  /// A pose with one of the choice's variables changed by so much. The variable need not be one of the choice.
  [[nodiscard]] rig::Pose pose_beside(const intent::Choice& choice, std::size_t variable, double change) const;
  /// What turns of joints beyond what is usual cost.
  [[nodiscard]] double lean_costs(const intent::Choice& choice) const;
  /// First guesses of a unit: values of its members.
  [[nodiscard]] std::vector<std::vector<double>> guesses(std::size_t unit) const;

 private:
  static constexpr std::size_t k_no_turn = static_cast<std::size_t>(-1);
  struct Variable {
    std::size_t parameter = 0;
    std::size_t turn = k_no_turn;
    std::size_t axis = 0;
  };
  void add_control(std::size_t parameter);
  void add_joint(std::size_t first, const rig::Joint& joint, const joints::Place& place,
                 const intent::WholeModel& whole, const geometry::Camera& camera);
  [[nodiscard]] std::vector<double> values_of(const intent::Choice& choice) const;
  [[nodiscard]] rig::Pose pose_at(std::span<const double> values) const;
  [[nodiscard]] glm::dvec3 turned(std::span<const double> values, std::size_t turn) const;

  const rig::Rig& rig_;
  const intent::WholeModel& whole_;
  rig::Pose start_;
  std::vector<Variable> variables_;
  std::vector<joints::Turn> turns_;
  std::vector<std::size_t> first_of_turn_;  ///< its first variable of three
  intent::Choices choices_;
};

}  // namespace penpose::portrait
