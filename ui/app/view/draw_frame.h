#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ui/app/cast/cast_frame.h"
#include "ui/app/controls/controls.h"
#include "ui/render/behind.h"
#include "ui/render/scene.h"

namespace penpose::app {

/// All that the viewport's picture shows at one moment. Its heavy parts are shared and never change, so that it can be
/// drawn while the app goes on.
struct DrawFrame {
  std::shared_ptr<const document::Model> model;
  std::shared_ptr<const std::vector<mesh::Triangle>> triangles;  ///< null: those of the model
  std::shared_ptr<const std::vector<glm::vec3>> positions;
  std::shared_ptr<const std::vector<glm::vec3>> normals;
  std::shared_ptr<const render::Appearance> appearance;
  std::shared_ptr<const std::vector<render::Color>> overlay;
  std::vector<render::CurveDrawing> curves;
  render::Background background;
  render::Behind behind;
  std::shared_ptr<const render::Image> veil;  ///< of ghosts (render::ghost_veil); null: none
  bool wireframe = false;
  bool clay = false;
  bool matcap = false;
  std::uint64_t shape_number = 0;  ///< as render::Scene
  std::uint64_t pose_number = 0;
  std::uint64_t overlay_number = 0;
  document::View view;
};

/// What of a frame the renderer draws; reads the frame.
[[nodiscard]] render::Scene scene_of(const DrawFrame& frame);

/// Makes frames of what is shown; what has not changed since the one before is shared with it.
class FrameMaker {
 public:
  struct Parts {
    const EditingSession& editing;
    const Canvas& canvas;
    const CanvasLook& look;
    const CanvasDrawing& drawing;
    const Controls& controls;
    const Preferences& preferences;
    const Cast& cast;
  };
  explicit FrameMaker(const Parts& parts) : parts_(parts) {}

  [[nodiscard]] DrawFrame make();

 private:
  void update_surface();
  void update_overlay();

  Parts parts_;
  DrawFrame last_;
  CastFrame cast_;
  std::pair<const mesh::TriangleMesh*, std::uint64_t> shape_;  ///< of the surface, as last_ has it
  std::pair<const document::Model*, std::uint64_t> pose_;      ///< likewise
  std::uint64_t weights_revision_ = 0;
  std::shared_ptr<const document::Model> overlay_model_;
  std::string overlay_deformer_;
};

}  // namespace penpose::app
