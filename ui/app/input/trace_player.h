#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/interface.h"
#include "core/base/result.h"
#include "firmware_io/decode/sample/device_identity.h"
#include "replay/session/session_player.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// A trace or a session in place of hardware, played into an editing session at its own pace.
class TracePlayer {
 public:
  /// Reads the whole file. Errors: those of reading it; nothing in it; a session of a version that is not known.
  static base::Result<TracePlayer> load(const std::string& path);

  /// The model that a session names; none for a plain trace, which is drawn on what is open.
  [[nodiscard]] const std::optional<replay::ModelNamed>& model() const { return model_; }
  [[nodiscard]] bool is_session() const { return is_session_; }

  /// Told of a device of the trace: that it came, what its pen and the other hand did, that it is gone.
  class Listener : public base::Interface {
   public:
    virtual void on_device(int device, const decode::DeviceIdentity& identity) = 0;
    virtual void on_moments(int device, std::span<const replay::PenMoment> pen,
                            std::span<const replay::HandMoment> hand) = 0;
    virtual void on_gone(int device) = 0;
  };

  /// Hands everything up to `by_us` of playing time on, report by report. At the end tablets have gone.
  void advance(EditingSession& editing, std::int64_t by_us, Listener& listener);
  void set_playing(bool playing) { playing_ = playing; }
  [[nodiscard]] bool playing() const { return playing_ && !finished(); }
  void set_speed(double speed) { speed_ = speed; }
  [[nodiscard]] double speed() const { return speed_; }
  [[nodiscard]] bool finished() const { return next_ == events_.size() && ended_; }
  [[nodiscard]] double progress() const;
  /// Microseconds until the next event, at the speed chosen.
  [[nodiscard]] std::int64_t next_in_us() const;
  [[nodiscard]] std::size_t report_count() const { return reports_; }
  /// The first recorded state that the editing session did not come to.
  [[nodiscard]] const std::optional<replay::Divergence>& divergence() const { return divergence_; }

 private:
  /// A line where there is one, else a device that is declared, else a report.
  struct Event {
    std::int64_t time_us = 0;
    int device = 0;
    std::vector<std::uint8_t> bytes;
    std::shared_ptr<const decode::DeviceIdentity> identity;
    std::shared_ptr<const replay::SessionLine> line;
    std::uint64_t number = 0;  ///< of the line in the file, from 1
  };

  std::vector<Event> events_;
  std::optional<replay::ModelNamed> model_;
  std::optional<replay::Divergence> divergence_;
  bool is_session_ = false;
  bool playing_ = true;
  bool ended_ = false;
  double speed_ = 1;
  double time_us_ = 0;
  std::size_t next_ = 0;
  std::size_t reports_ = 0;
};

}  // namespace penpose::app
