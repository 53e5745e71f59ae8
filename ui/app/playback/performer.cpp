#include "ui/app/playback/performer.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/curve/polyline.h"
#include "core/curve/stroke.h"
#include "core/document/time/timeline.h"
#include "ui/app/playback/frames.h"
#include "ui/app/playback/thin_take.h"

namespace penpose::app {
namespace {

/// "smile, left; jaw opens and 3 more".
std::string listed(EditingSession& editing, const std::vector<std::string>& names) {
  constexpr std::size_t k_most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(k_most, names.size()); ++i)
    text += (i > 0 ? "; " : "") + editing.words_of(names[i]);
  if (names.size() > k_most) text += " and " + std::to_string(names.size() - k_most) + " more";
  return text;
}

}  // namespace

Performer::Performer(EditingSession& editing, Notices& notices, Playback& playback, const Player& player)
    : editing_(editing), notices_(notices), playback_(playback), player_(player) {}

void Performer::begin(std::int64_t now_us) {
  playback_.stop();
  editing_.shown().preview(std::nullopt);
  playback_.place_cursor(on_frame(playback_.time_s(), playback_.rate()));
  performance_.emplace(playback_.time_s(), playback_.rate(), editing_.document().pose);
  steps_ = editing_.editor().history().undo_count();
  from_s_ = playback_.time_s();
  from_us_ = now_us;
}

void Performer::ready() {
  take_.reset();
  if (!playback_.playing() && !playback_.scrubs()) return;
  playback_.stop();
  playback_.end_scrub();
}

const Take* Performer::take() const {
  if (!take_ || performing() || take_->timeline != editing_.document().timeline) return nullptr;
  const std::size_t done = editing_.editor().history().undo_count();
  return done - editing_.steps().can_undo() == take_->steps ? &*take_ : nullptr;
}

void Performer::again() {
  const Take* done = take();
  if (done == nullptr) return;
  const double from_s = done->from_s;
  playback_.stop();
  playback_.undo();
  take_.reset();
  playback_.place_cursor(from_s);
}

void Performer::keep() {
  const Take* done = take();
  if (done == nullptr) return;
  const double from_s = done->from_s;
  take_.reset();
  playback_.go_to(from_s);
}

void Performer::review() {
  const Take* done = take();
  if (done == nullptr) return;
  playback_.go_to(done->from_s);
  playback_.play_or_stop();
}

double Performer::drawn_px() const {
  const replay::DrawnStroke* stroke = editing_.session().pens().current();
  if (stroke == nullptr || stroke->samples.size() < 2) return 0;
  return curve::arc_length<PxPoint>(curve::positions_of(stroke->samples));
}

void Performer::follow(std::int64_t now_us) {
  const bool holds = editing_.shown().live().active();
  if (!performance_) {
    const bool performs = playback_.while_drawing().performs && !player_.plays_session();
    editing_.shown().pull_as_string(performs);
    if (performs && holds) begin(now_us);
    return;
  }
  if (!holds) {
    static_cast<void>(end());
    return;
  }
  double time_s = from_s_ + static_cast<double>(now_us - from_us_) * 1e-6;
  const LoopRange& loop = playback_.loop();
  if (loop.to_s && time_s > *loop.to_s) {
    from_us_ = now_us;
    from_s_ = time_s = loop.begin_s();
  }
  time_s = std::min(time_s, document::k_latest_key_s);
  playback_.place_cursor(time_s);
  const document::Document& document = editing_.document();
  const rig::Pose& pen = editing_.shown().pen_pose();
  performance_->take(time_s, pen, drawn_px());
  editing_.shown().stage(performance_->over(document::pose_at(document, time_s), pen));
}

bool Performer::end() {
  const Performance performance = *std::exchange(performance_, std::nullopt);
  editing_.shown().stage(std::nullopt);
  const document::Document& document = editing_.document();
  // What a drawn target did to the pose belongs to it.
  const bool drawn = editing_.editor().history().undo_count() > steps_;
  const auto parameters = document.model->rig->parameters();
  const auto all =
      drawn ? performance.keys_of_line(parameters, document.pose) : performance.keys(parameters, document.pose);
  const bool any = all && performance.frame_count() > 1;
  playback_.place_cursor(any ? performance.last_s() : document.time_s);
  if (!any) return false;
  const document::KeyPoses keys =
      thinned(document, *all, *editing_.shown().whole_model().fields, editing_.editor().view());
  if (!(drawn ? editing_.perform_with(keys) : editing_.perform(keys))) return true;
  editing_.perform_with(document::GoToTime{playback_.time_s()});
  take_ = Take{performance.first_s(), performance.last_s(), performance.frame_count(),
               keys.times_s.size(),   document.timeline,    steps_};
  const std::string keyed = std::to_string(performance.frame_count()) + " frames are keyed with " +
                            std::to_string(keys.times_s.size()) + " keys: " + listed(editing_, keys.names);
  editing_.last_stroke().say(keyed);
  return true;
}

}  // namespace penpose::app
