#include "ui/app/canvas/soft_shadows.h"

#include <new>
#include <sys/resource.h>
#include <system_error>
#include <utility>

namespace penpose::app {
namespace {

/// For setpriority: whoever draws goes first.
constexpr int k_patience = 15;

}  // namespace

void SoftShadows::give_up() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
  stop_ = false;
  ready_ = false;
}

void SoftShadows::begin(const std::shared_ptr<const document::Model>& model, const render::Appearance& appearance) {
  give_up();
  light_.reset();
  mesh_ = model->mesh;
  try {
    thread_ = std::thread([this, model, appearance] {
      setpriority(PRIO_PROCESS, 0, k_patience);  // of this thread alone
      try {
        light_ = render::bake_light(*model, appearance, &stop_);
      } catch (const std::bad_alloc&) {
        return;  // it goes without
      }
      ready_ = true;
      if (!stop_) found_();
    });
  } catch (const std::system_error&) {
    return;  // no more threads: it goes without
  }
}

bool SoftShadows::follow(PosedSurface& surface, bool wanted) {
  const std::uint64_t before = surface.shape_number();
  const auto& model = surface.shared_model();
  if (!wanted) {
    if (thread_.joinable()) give_up();
    mesh_.reset();
    surface.set_light(nullptr);
    return surface.shape_number() != before;
  }
  if (mesh_ != model->mesh) begin(model, surface.appearance());
  if (ready_ && thread_.joinable()) thread_.join();
  if (ready_) surface.set_light(light_);
  return surface.shape_number() != before;
}

}  // namespace penpose::app
