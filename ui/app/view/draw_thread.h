#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/app/view/present/presenter.h"

namespace penpose::app {

/// Textures of a look that could not be unpacked.
struct Undrawn {
  std::shared_ptr<const document::Look> look;
  std::vector<std::string> names;
};

/// Draws frames into a window on a thread of its own, so that a picture, which takes a software renderer long, never
/// holds up the pen. All calls from the thread that made it.
class DrawThread {
 public:
  /// ImGui must have its context, and only this draws with it. `drawn` is called from the other thread after every
  /// picture. Errors: those of the presenter.
  static base::Result<std::unique_ptr<DrawThread>> start(std::unique_ptr<Presenter> presenter,
                                                         std::function<void()> drawn);
  ~DrawThread();
  DrawThread(const DrawThread&) = delete;
  DrawThread& operator=(const DrawThread&) = delete;

  /// The frame that was handed over last is not drawn yet.
  [[nodiscard]] bool busy() const;
  /// Hands a frame over with its panels. Precondition: not busy.
  void draw(DrawFrame frame, const ImDrawData& panels);
  /// Sends the picture of the letters again. Waits for it.
  void send_letters();
  /// Whether the same picture drawn again would be smoother.
  [[nodiscard]] bool refining() const;
  /// Textures of this look that could not be unpacked (Look::undrawn); each is told once. Null look: none.
  [[nodiscard]] Undrawn take_undrawn();
  /// The size that the window had when the last picture was drawn, where the system can be asked.
  [[nodiscard]] std::optional<geometry::Viewport> drawable() const;
  /// Why nothing is drawn any more.
  [[nodiscard]] base::Status status() const;
  /// Pictures that were shown so far, and the CPU time of the thread for each.
  [[nodiscard]] std::size_t drawn_count() const;
  [[nodiscard]] std::vector<std::int64_t> times_us() const;

 private:
  struct State;
  explicit DrawThread(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace penpose::app
