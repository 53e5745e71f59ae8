#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/intent/model/composites.h"
#include "core/intent/model/contacts.h"
#include "core/intent/model/control_fields.h"
#include "core/joints/body.h"
#include "core/rig/rig.h"

namespace penpose::intent {

inline constexpr std::size_t k_no_partner = static_cast<std::size_t>(-1);

/// The effect of a rig's controls on the whole model, independent of any drawing. Measured once for a rig.
struct WholeModel {
  /// How far each parameter moves the model: the sum over all vertices of their displacement between the ends of its
  /// range, as a multiple of the median over the parameters that move anything. Dimensionless, so it compares across
  /// rigs.
  std::vector<double> movement;
  /// How far the vertices that a parameter moves go between the ends of its range: the mean displacement, weighted by
  /// itself. Model units.
  std::vector<double> stride;
  /// The parameter that does the same on the model's other side, or k_no_partner. Found by where and how far they move
  /// the model, never by name.
  std::vector<std::size_t> partner;
  /// Groups the parameters of a joint: the first parameter of the joint, or the parameter itself.
  std::vector<std::size_t> group;
  /// For parameters of joints: the joint's number; k_no_partner for others.
  std::vector<std::size_t> joint;
  /// The shape of the skeleton; null without one.
  std::shared_ptr<const joints::Body> body;
  /// What each control does, on a sample of the vertices.
  std::shared_ptr<const ControlFields> fields;
  /// What shapes do where lips touch.
  std::shared_ptr<const Contacts> contacts;
  /// For each control of a joint: the share of what shapes do that happens on what the joint carries, 0 to 1, each
  /// shape counted alike but those of the whole body; 0 of shapes.
  std::vector<double> bears;
  /// Of how many others each control is the sum.
  std::vector<Composite> composites;
  /// For each vertex: the connected piece of the mesh that it belongs to. Empty if that is unknown.
  std::vector<std::uint32_t> pieces;
  /// For each control: of each piece that it moves, ascending, how much it turns the piece: the standard
  /// deviation of its field there.
  struct OfPiece {
    std::uint32_t piece = 0;
    double turn = 0;  ///< model units; of a joint's angle for a radian
  };
  std::vector<std::vector<OfPiece>> by_piece;
  /// For each shape: the separate places that it moves. A place is a set of neighbouring samples that move by at least
  /// a share of the largest way. Empty for joints.
  struct PlaceMoved {
    double way = 0;                      ///< the largest, model units
    std::vector<std::uint32_t> samples;  ///< numbers of ControlFields::samples
  };
  std::vector<std::vector<PlaceMoved>> places;
  /// For each joint: the diagonal of the box of the vertices that follow it before any other, model units.
  std::vector<double> joint_extents;
  /// Its vertices at rest.
  std::shared_ptr<const std::vector<ModelPoint>> rest;
  /// Diagonal of the box of the rest pose, model units.
  double size = 0;
};

[[nodiscard]] WholeModel measure_whole_model(const rig::Rig& rig);

}  // namespace penpose::intent
