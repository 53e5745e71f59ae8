#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/articulation/region/region.h"
#include "core/document/commands/command.h"
#include "core/document/document.h"
#include "core/drawing/tool.h"

namespace penpose::app {

/// What a deformer that is being drawn, or drawn again, would be: its weights in colour while the regions are drawn,
/// its reference as it is found or was drawn, and the face with it while the target is drawn. Strokes for deformers are
/// drawn on the model at rest, so that is what is shown.
class SketchPreview {
 public:
  /// The tool is in hand and no stroke is being drawn.
  void show(const document::Document& document, const drawing::Tool& tool);
  /// A stroke goes on.
  void follow(const document::Document& document, const drawing::Tool& tool, const document::View& view,
              const curve::Stroke& stroke);
  /// A control's target is pulled: the face as the control would make it at that target, as posed elsewhere. A pull
  /// that would be refused leaves what is shown.
  void pull(const document::Document& document, const document::PullBetween& pull);
  void stroke_ended();
  /// Another tool was taken.
  void end();

  /// Null: the document's own model is shown.
  [[nodiscard]] const std::shared_ptr<const document::Model>& model() const { return model_; }
  /// Of `model`, or of the document's model: at rest, with the deformer that is drawn at `amount`.
  [[nodiscard]] const rig::Pose* pose() const { return pose_ ? &*pose_ : nullptr; }
  /// One a vertex, -1 outside of the region, -2 where the second lasso holds what the first does not; empty when there
  /// is nothing to show.
  [[nodiscard]] const std::vector<float>& weights() const { return weights_; }
  /// Grows when the weights change.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// The border of the region, in world space as the model is shown.
  [[nodiscard]] const std::vector<std::vector<geometry::ModelPoint>>& outline() const { return outline_; }
  /// How many pieces of the model the first lasso holds.
  [[nodiscard]] std::uint32_t pieces() const { return weights_.empty() ? 0 : region_.pieces; }
  /// The second lasso where it was drawn last but holds nothing of the region; else empty.
  [[nodiscard]] const std::vector<geometry::PxPoint>& refused_core() const { return refused_core_; }
  /// The reference of the deformer being drawn, found by itself or drawn, in world space at rest; empty before step 3.
  [[nodiscard]] const std::vector<geometry::ModelPoint>& reference() const { return reference_; }
  /// Why one that was found by itself may not be what is meant; empty: nothing speaks against it.
  [[nodiscard]] const std::string& reference_doubt() const { return reference_doubt_; }
  /// Where the points of the region are, in world space at rest; none before step 2.
  [[nodiscard]] std::vector<geometry::ModelPoint> region_points() const;
  /// How far the deformer that is drawn is shown, as a share of its range.
  void set_amount(double amount);
  [[nodiscard]] double amount() const { return amount_; }

 private:
  bool set_canvas(const document::Document& document);
  bool set_region(const document::Document& document, const articulation::Sketch& sketch);
  void show_weights(std::size_t vertex_count, const std::vector<double>* weights,
                    const std::vector<geometry::PxPoint>* core = nullptr);
  void find_reference(const articulation::Sketch& sketch, const std::vector<std::uint32_t>& specific);
  void build(const document::Document& document, articulation::Sketch sketch, std::optional<std::size_t> in_place_of,
             std::optional<double> at = std::nullopt);
  void build_correction(const document::Document& document, articulation::Sketch sketch);
  void follow_redraw(const document::Document& document, const drawing::Tool& tool, const document::View& view,
                     const std::vector<geometry::PxPoint>& line);

  std::shared_ptr<const document::Model> rested_;  ///< whose rest pose `pose_` is
  std::shared_ptr<const document::Model> canvas_of_;
  std::shared_ptr<const articulation::Canvas> canvas_;
  std::shared_ptr<const document::PendingSketch> region_of_;
  std::vector<geometry::PxPoint> region_lasso_;
  articulation::Surface region_surface_;
  articulation::Taken region_taken_;
  std::optional<geometry::Camera> region_camera_;
  std::vector<articulation::Driver> canvas_pose_;
  std::vector<std::vector<geometry::ModelPoint>> outline_;
  std::vector<geometry::PxPoint> core_;  ///< as it is being drawn
  std::vector<geometry::PxPoint> refused_core_;
  articulation::Region region_;
  std::vector<float> weights_;
  std::uint64_t revision_ = 0;
  std::vector<geometry::ModelPoint> reference_;
  std::string reference_doubt_;
  std::shared_ptr<const document::Model> model_;
  std::optional<rig::Pose> pose_;
  std::optional<std::size_t> drawn_;  ///< the parameter of `model_` that is drawn
  double amount_ = 1;
};

}  // namespace penpose::app
