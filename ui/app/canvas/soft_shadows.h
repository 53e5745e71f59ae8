#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>

#include "ui/app/view/posed_surface.h"
#include "ui/render/light/baked_light.h"

namespace penpose::app {

/// Soft shadows of the model that is shown, found beside what goes on, by a thread that gives way to all others.
class SoftShadows {
 public:
  /// `found` is called on that thread when there is something to take.
  explicit SoftShadows(std::function<void()> found) : found_(std::move(found)) {}
  ~SoftShadows() { give_up(); }
  SoftShadows(const SoftShadows&) = delete;
  SoftShadows& operator=(const SoftShadows&) = delete;

  /// Begins with a model that is new, gives the surface what was found, and takes it away where it is not wanted. True:
  /// the surface looks different now.
  bool follow(PosedSurface& surface, bool wanted);

 private:
  void begin(const std::shared_ptr<const document::Model>& model, const render::Appearance& appearance);
  void give_up();

  std::function<void()> found_;
  std::shared_ptr<const mesh::TriangleMesh> mesh_;  ///< that the shadows are of, or will be
  std::shared_ptr<const render::BakedLight> light_;
  std::thread thread_;
  std::atomic<bool> stop_ = false;
  std::atomic<bool> ready_ = false;
};

}  // namespace penpose::app
