#pragma once

#include <cstddef>
#include <span>

#include "core/base/interface.h"
#include "core/base/result.h"

namespace penpose::app {

/// What samples are heard by. Samples wait in a queue until they are; the window's is SDL's, tests have their own.
class SoundOutput : public base::Interface {
 public:
  /// Makes it ready for samples of a rate, Hz, with an empty queue. Errors: no device.
  virtual base::Status open(int rate_hz) = 0;
  /// Lets the device go, so that it takes no time.
  virtual void close() = 0;
  /// Adds samples behind those that wait. Precondition: it is open.
  virtual void push(std::span<const float> samples) = 0;
  /// Forgets those that wait.
  virtual void clear() = 0;
  /// How many wait.
  [[nodiscard]] virtual std::size_t waiting() const = 0;
  /// How many that wait no more are not yet heard.
  [[nodiscard]] virtual std::size_t underway() const = 0;
};

}  // namespace penpose::app
