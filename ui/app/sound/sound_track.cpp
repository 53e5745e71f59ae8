#include "ui/app/sound/sound_track.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/sound/mix.h"
#include "ui/files/sound/sound_file.h"

namespace penpose::app {
namespace {

/// So much waits in the queue: what a frame of the window may take.
constexpr double k_ahead_s = 0.15;
/// Beyond that the timeline has jumped.
constexpr double k_jump_s = 0.1;
constexpr std::size_t k_sound_block = 1024;
constexpr double k_fade_s = 0.002;
/// A device that is not needed is kept for so long.
constexpr std::int64_t k_kept_us = 1'000'000;

}  // namespace

SoundTrack::SoundTrack(EditingSession& editing, Notices& notices, Playback& playback, const Files& files)
    : editing_(editing), notices_(notices), playback_(playback), files_(files) {}

void SoundTrack::open(const std::string& path) {
  auto loaded = files::load_sound(path, files_.project());
  if (!loaded) return notices_.tell(loaded.error().line(path), true);
  const document::SoundReference& reference = loaded->reference;
  if (!editing_.perform(document::SetSound{reference.file, reference.content, 0})) return;
  if (open_) output_->close();
  open_ = running_ = false;
  known_ = editing_.document().sound;
  sound_ = std::make_shared<const sound::Sound>(std::move(loaded->sound));
  peaks_ = sound::Peaks(*sound_);
  playback_.sounds_until(offset_s() + sound_->duration_s());
}

void SoundTrack::remove() {
  if (editing_.document().sound) editing_.perform(document::RemoveSound{});
}

void SoundTrack::move(double offset_s) {
  if (editing_.document().sound) editing_.perform(document::MoveSound{offset_s});
}

double SoundTrack::offset_s() const { return dragged_s_.value_or(document_offset_s()); }

double SoundTrack::document_offset_s() const {
  return editing_.document().sound ? editing_.document().sound->offset_s : 0;
}

void SoundTrack::take_document() {
  const auto& now = editing_.document().sound;
  if (now == known_) return;
  // Of a document that was just opened nobody knows yet whether the file is as it was.
  const bool same = editing_.steps().can_undo() > 0 && now && known_ && now->content == known_->content;
  known_ = now;
  if (same) return;
  sound_.reset();
  peaks_ = {};
  if (!now) return;
  const std::string& project = files_.project().empty() ? files_.path() : files_.project();
  auto loaded = files::load_sound_of(*now, project);
  if (!loaded) return notices_.tell(loaded.error().line(now->file), true);
  if (loaded->changed) notices_.tell(now->file + ": the sound is another one than the project was made with");
  sound_ = std::make_shared<const sound::Sound>(std::move(loaded->sound));
  peaks_ = sound::Peaks(*sound_);
}

bool SoundTrack::make_ready() {
  if (!output_) return false;
  if (open_) return true;
  const auto opened = output_->open(sound_->rate_hz);
  open_ = opened.ok();
  if (!open_) {
    notices_.tell(opened.error().line(), true);
    output_.reset();
  }
  return open_;
}

void SoundTrack::hush() {
  if (running_) output_->clear();
  running_ = false;
}

void SoundTrack::begin_at(double time_s) {
  output_->clear();
  next_sample_ = sound::sample_of(time_s / playback_.speed(), sound_->rate_hz);
  running_ = true;
}

void SoundTrack::play(std::int64_t now_us) {
  const double rate = sound_->rate_hz;
  const double speed = playback_.speed();
  if (std::exchange(heard_speed_, speed) != speed) running_ = false;
  if (!running_) {
    begin_at(playback_.time_s());
  } else {
    const auto ahead = static_cast<double>(output_->waiting() + output_->underway());
    const double heard_s = speed * (static_cast<double>(next_sample_) - ahead) / rate;
    if (std::abs(heard_s - playback_.time_s()) > k_jump_s) {
      begin_at(playback_.time_s());
    } else {
      playback_.hear(heard_s, now_us);
    }
  }
  std::vector<float> block(k_sound_block);
  while (static_cast<double>(output_->waiting()) < k_ahead_s * rate) {
    sound::mix_slowed(*sound_, offset_s(), next_sample_, speed, block);
    output_->push(block);
    next_sample_ += static_cast<std::int64_t>(block.size());
  }
}

void SoundTrack::sound_frame(std::int64_t now_us) {
  if (!make_ready()) return;
  std::vector<float> snippet(static_cast<std::size_t>(std::max(1, sound_->rate_hz / playback_.rate())));
  sound::mix(*sound_, offset_s(), sound::sample_of(playback_.time_s(), sound_->rate_hz), snippet);
  sound::fade_ends(snippet, static_cast<std::size_t>(k_fade_s * sound_->rate_hz));
  output_->clear();
  output_->push(snippet);
  close_at_us_ = now_us + k_kept_us;
}

void SoundTrack::follow(std::int64_t now_us) {
  now_us_ = now_us;
  const auto before = sound_;
  take_document();
  if (before != sound_ && open_) {
    output_->close();
    open_ = running_ = false;
  }
  playback_.sounds_until(sound_ ? offset_s() + sound_->duration_s() : 0);
  const bool moved = last_time_s_ && *last_time_s_ != playback_.time_s();
  last_time_s_ = playback_.time_s();
  if (!sound_ || muted_) {
    hush();
  } else if (playback_.playing()) {
    if (!make_ready()) return;
    play(now_us);
    close_at_us_ = now_us + k_kept_us;
  } else {
    hush();
    if (moved) sound_frame(now_us);
  }
  if (open_ && now_us >= close_at_us_) {
    output_->close();
    open_ = running_ = false;
  }
}

int SoundTrack::next_frame_ms() const {
  if (!open_) return -1;
  return static_cast<int>(std::max<std::int64_t>(0, close_at_us_ - now_us_) / 1000) + 1;
}

}  // namespace penpose::app
