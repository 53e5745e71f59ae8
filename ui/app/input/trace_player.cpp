#include "ui/app/input/trace_player.h"

#include <algorithm>
#include <cmath>

#include "replay/trace/trace_source.h"
#include "ui/files/trace_file.h"

namespace penpose::app {
namespace {

/// Numbers of played tablets, beyond those of tablets that are plugged in.
constexpr int k_first_device = 100;

}  // namespace

base::Result<TracePlayer> TracePlayer::load(const std::string& path) {
  const auto file = files::open_plain(path);
  if (!file) return file.error();
  TracePlayer player;
  std::int64_t now = 0;
  replay::TraceSource source(files::read_recording_file(file->get()));
  std::optional<base::Error> refused;
  const auto on_line = [&](const replay::TraceLine& line) {
    if (line.end.empty()) return;
    const auto parsed = replay::parse_session_line(line.text);
    // Lines of a file that says no version may be anybody's comments; a version that is not known ends everything.
    if (!parsed && line.text.starts_with("# penpose session ")) {
      refused = parsed.error();
      refused->place = "line " + std::to_string(line.number);
    }
    if (!parsed || !*parsed) return;
    replay::SessionLine what = **parsed;
    if (std::holds_alternative<replay::SessionBegins>(what)) {
      player.is_session_ = true;
      return;
    }
    if (auto* named = std::get_if<replay::ModelNamed>(&what)) {
      if (!player.model_) player.model_ = std::move(*named);
      return;
    }
    if (auto* set = std::get_if<replay::TabletSet>(&what)) set->device += k_first_device;
    if (auto* gone = std::get_if<replay::TabletGone>(&what)) gone->device += k_first_device;
    if (auto* lights = std::get_if<replay::LightsSeen>(&what)) lights->device += k_first_device;
    player.events_.push_back(
        {now, 0, {}, {}, std::make_shared<const replay::SessionLine>(std::move(what)), line.number});
  };
  const auto on_device = [&](int device, const decode::DeviceIdentity& identity) {
    player.events_.push_back(
        {now, device + k_first_device, {}, std::make_shared<const decode::DeviceIdentity>(identity), {}, 0});
  };
  source.listen(on_line, on_device);
  std::int64_t first = -1;
  while (true) {
    const auto report = source.next();
    if (!report) return report.error();
    if (refused) return *refused;
    if (!*report) break;
    if (first < 0) first = (*report)->time_us;
    now = std::max(now, (*report)->time_us - first);
    const base::Bytes bytes = (*report)->bytes;
    player.events_.push_back({now, (*report)->device + k_first_device, {bytes.begin(), bytes.end()}, {}, {}, 0});
    ++player.reports_;
  }
  if (player.events_.empty()) {
    return base::Error{"holds nothing to replay: neither reports nor lines of a session", "",
                       "give a session, or a trace as hid-recorder or `penpose record` writes it"};
  }
  return player;
}

void TracePlayer::advance(EditingSession& editing, std::int64_t by_us, Listener& listener) {
  if (!playing()) return;
  time_us_ += static_cast<double>(by_us) * speed_;
  for (; next_ < events_.size() && static_cast<double>(events_[next_].time_us) <= time_us_; ++next_) {
    const Event& event = events_[next_];
    if (event.line) {
      if (const auto* reached = std::get_if<replay::StateReached>(event.line.get())) {
        const auto state = is_session_ && !divergence_ ? editing.state() : reached->state;
        if (!(state == reached->state)) {
          divergence_ = replay::Divergence{event.number, document::differing_parts(state, reached->state)};
        }
        continue;
      }
      editing.act(*event.line);
    } else if (event.identity) {
      editing.input().connect(event.device, *event.identity);
      listener.on_device(event.device, *event.identity);
    } else {
      const auto moments = editing.input().report(event.device, event.bytes);
      const auto hand = editing.session().hand_moments();
      const std::vector<replay::HandMoment> kept(hand.begin(), hand.end());
      listener.on_moments(event.device, moments, kept);
      editing.shown().follow_pen();
    }
  }
  if (next_ < events_.size() || ended_) return;
  ended_ = true;
  for (const Event& event : events_) {
    if (event.identity) {
      editing.input().disconnect(event.device);
      listener.on_gone(event.device);
    }
  }
}

double TracePlayer::progress() const {
  const double whole = events_.empty() ? 0 : static_cast<double>(events_.back().time_us);
  return whole > 0 ? std::clamp(time_us_ / whole, 0.0, 1.0) : 1.0;
}

std::int64_t TracePlayer::next_in_us() const {
  if (next_ == events_.size()) return 0;
  return static_cast<std::int64_t>(std::max(0.0, (static_cast<double>(events_[next_].time_us) - time_us_) / speed_));
}

}  // namespace penpose::app
