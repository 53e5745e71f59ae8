#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/articulation/corrections.h"
#include "core/articulation/region/canvas.h"
#include "core/articulation/sketched_deformers.h"
#include "core/base/result.h"
#include "core/base/state_hash.h"
#include "core/document/humanoid.h"
#include "core/mesh/mesh_point.h"
#include "core/mesh/triangle_mesh.h"
#include "core/rig/blend_shapes.h"
#include "core/rig/character_rig.h"
#include "core/rig/skeleton.h"

namespace penpose::document {

/// The look of a part's surface. Colour is linear RGBA, 0..1.
struct Material {
  std::string name;
  std::array<double, 4> base_color{0.8, 0.8, 0.8, 1.0};
  double metallic = 0;
  double roughness = 0.6;
};

/// A named curve of the model: points glued to the surface.
struct NamedCurve {
  std::string name;
  std::vector<mesh::MeshPoint> points;
};

enum class Interpolation : std::uint8_t { step, linear, cubic_spline };

/// What one channel of an animation drives.
enum class ChannelTarget : std::uint8_t { weights, translation, rotation, scale };

/// One animated property, as glTF keeps it. For weights, `values` holds one run of all blend shapes and then all
/// sketched deformers a key; for a joint, 3 or 4 numbers a key (rotation x y z w). Cubic splines hold in-tangent,
/// value, out-tangent for each key.
struct Channel {
  ChannelTarget target = ChannelTarget::weights;
  std::uint32_t joint = 0;  ///< for translation, rotation, scale: joint of the skeleton
  Interpolation interpolation = Interpolation::linear;
  std::vector<double> times_s;  ///< ascending
  std::vector<double> values;
};

struct Animation {
  std::string name;
  std::vector<Channel> channels;
};

/// An expression does this to the expressions of a kind while it is shown: nothing, all of them go, or as much of them
/// as it is shown (VRMC_vrm 1.0, "ExpressionOverrideType").
enum class ExpressionOverride : std::uint8_t { none, block, blend };

/// A pose with a name over some controls, as VRM's expressions are: no control of its own.
struct Expression {
  std::string name;
  std::vector<std::pair<std::size_t, double>> values;  ///< parameters of the rig and their values
  bool is_binary = false;                              ///< shown wholly from a weight above 0.5 on, else not at all
  /// To the expressions of the mouth (aa, ih, ou, ee, oh), of blinks and of looks.
  ExpressionOverride mouth = ExpressionOverride::none, blink = ExpressionOverride::none,
                     look = ExpressionOverride::none;
};

struct Look;
struct SourceFile;

/// A character as in a file: its rig and its pose.
struct Model {
  std::shared_ptr<const mesh::TriangleMesh> mesh;
  std::vector<Material> materials;                                   ///< one a part, in the order of the parts
  std::shared_ptr<const rig::BlendShapes> shapes;                    ///< null: none
  std::shared_ptr<const articulation::SketchedDeformers> deformers;  ///< null: none
  std::shared_ptr<const articulation::Corrections> corrections;      ///< for combinations of both; null: none
  std::shared_ptr<const rig::Skeleton> skeleton;                     ///< null: none
  std::shared_ptr<const rig::CharacterRig> rig;                      ///< the sum of them all, parameters in this order
  rig::Pose pose;                                                    ///< one value a parameter of the rig
  std::vector<NamedCurve> curves;
  /// Features of the face as somebody corrected them, by name; without points: the face has no such feature.
  std::vector<NamedCurve> features;
  std::vector<Animation> animations;
  std::vector<Expression> expressions;
  Humanoid humanoid;                         ///< as the file says it; empty: it says nothing
  double front_yaw_degrees = 0;              ///< about +y: where its face looks; 0 is +z
  std::shared_ptr<const Look> look;          ///< textures, texture coordinates and colours; null: none
  std::shared_ptr<const SourceFile> source;  ///< the file that it was read from, for saving it again; null: none
  std::vector<std::string> notes;            ///< parts that a reader left out, one line each
};

/// Assembles a model: makes the rig and starts at its rest pose. Errors: shapes for another number of
/// vertices, and those of the rig.
[[nodiscard]] base::Result<Model> make_model(std::shared_ptr<const mesh::TriangleMesh> mesh,
                                             std::shared_ptr<const rig::BlendShapes> shapes,
                                             std::shared_ptr<const rig::Skeleton> skeleton,
                                             std::shared_ptr<const articulation::SketchedDeformers> deformers = {},
                                             std::shared_ptr<const articulation::Corrections> corrections = {});

/// Moves everything but mesh, rig, pose and expressions from one model to another: after a model was built again.
void move_rest(Model& from, Model& to);

/// The model with other blend shapes and sketched deformers (null: none). Pose and animations are kept by the names of
/// the parameters; new ones are at rest. Corrections are built again if the model they were drawn on has changed, and
/// removed with any of their drivers. Errors: those of make_model, such as a duplicate name; a correction that no
/// longer fits (place: "correction NAME").
[[nodiscard]] base::Result<Model> with_controls(Model model, std::shared_ptr<const rig::BlendShapes> shapes,
                                                std::shared_ptr<const articulation::SketchedDeformers> deformers);
/// The model with other sketched deformers and its own blend shapes.
[[nodiscard]] base::Result<Model> with_deformers(Model model,
                                                 std::shared_ptr<const articulation::SketchedDeformers> deformers);
/// The model with exactly these corrections. Each is built on the model with the ones before it. Errors
/// (place "N/..."): those of build_correction and Corrections::make; a name that is a control's.
[[nodiscard]] base::Result<Model> with_corrections(Model model,
                                                   std::span<const articulation::CorrectionSketch> corrections);
/// The canvas for a correction at a pose of these controls, with all others at rest. Errors (place "drivers/N"): no
/// such control, or one of a joint.
[[nodiscard]] base::Result<std::shared_ptr<const articulation::Canvas>> make_posed_canvas(
    const Model& model, std::span<const articulation::Driver> drivers);
[[nodiscard]] std::vector<articulation::CorrectionSketch> correction_sketches(const Model& model);

/// The canvas for strokes.
[[nodiscard]] base::Result<std::shared_ptr<const articulation::Canvas>> make_canvas(const Model& model);
/// Number of parameters that are weights in an animation: blend shapes and deformers.
[[nodiscard]] std::size_t weight_count(const Model& model);

/// World positions of all vertices at the model's pose.
[[nodiscard]] std::vector<geometry::ModelPoint> posed_positions(const Model& model);
/// The box around the world positions at rest; it frames pictures and scales tolerances.
[[nodiscard]] geometry::Box rest_world_box(const Model& model);
/// Of the vertices that its shapes move: of an avatar, its face. Of the whole model where no shape moves anything.
[[nodiscard]] geometry::Box rest_box_of_shapes(const Model& model);

/// The canonical hash (method, section 5) of a document with only this model.
[[nodiscard]] base::Hash128 state_hash(const Model& model);

}  // namespace penpose::document
