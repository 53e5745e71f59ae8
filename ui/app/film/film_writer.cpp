#include "ui/app/film/film_writer.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <tuple>
#include <utility>

#include "ui/app/files/session_files.h"
#include "ui/app/film/playblast_place.h"
#include "ui/app/playback/frames.h"
#include "ui/film/ffmpeg.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

/// Pictures of a sheet are so much smaller than those of a film.
constexpr int k_sheet_share = 4;

int frame_at(double time_s, int rate) { return static_cast<int>(std::lround(frame_of(std::max(time_s, 0.0), rate))); }

}  // namespace

geometry::Viewport FilmWriter::size_of(const FilmEntry& entry) const {
  const geometry::Viewport size = entry.size.value_or(film_size(with_.canvas.free_area()));
  if (entry.kind != film::FilmKind::sheet) return size;
  return {size.width / k_sheet_share, size.height / k_sheet_share};
}

std::pair<int, int> FilmWriter::frames_of(FilmRange range) const {
  const Playback& playback = with_.playback;
  const auto& keys = with_.editing.document().timeline->keys;
  const double others_s = with_.cast.several() ? with_.cast.last_key_s() : 0;
  const double keys_s = std::max(others_s, keys.empty() ? 0 : keys.back().time_s);
  const double end_s = range == FilmRange::keys ? keys_s : playback.last_s();
  if (range != FilmRange::loop) return {0, frame_at(end_s, playback.rate())};
  const LoopRange& loop = playback.loop();
  return {frame_at(loop.begin_s(), playback.rate()), frame_at(loop.end_s(end_s), playback.rate())};
}

bool FilmWriter::lacks_sound() const {
  return with_.editing.document().sound != nullptr && with_.sound.sound() == nullptr;
}

bool FilmWriter::write(const std::string& path, const FilmEntry& entry) {
  if (job_) {
    with_.notices.tell("another film is still being written: " + job_->output(), true);
    return false;
  }
  FilmOrder order;
  order.program = program_;
  order.kind = entry.kind;
  order.output = path;
  const Canvas& canvas = with_.canvas;
  order.view = film_view(canvas.view().camera, canvas.window(), canvas.free_area(), size_of(entry));
  order.rate = with_.playback.rate();
  std::tie(order.from, order.to) = frames_of(entry.range);
  order.every = entry.every;
  order.numbers = entry.numbers;
  order.wireframe = with_.look.wireframe;
  order.clay = with_.look.clay;
  order.matcap = with_.look.matcap;
  order.shadows = with_.canvas.surface().appearance().light != nullptr;
  if (with_.look.ghosts_in_films) order.ghosts = with_.look.ghosts;
  order.light = with_.preferences.settings().light;
  order.sound = with_.sound.sound();
  order.sound_offset_s = with_.sound.document_offset_s();
  if (with_.cast.several()) {
    order.characters = with_.cast.described();
    order.documents = with_.cast.documents();
  }
  auto job = FilmJob::start(with_.editing.document(), order);
  if (!job) {
    with_.notices.tell(job.error().line(path), true);
    return false;
  }
  job_ = std::make_unique<FilmJob>(std::move(*job));
  if (lacks_sound() && film::row_of(entry.kind).sounds) {
    with_.notices.tell(with_.editing.document().sound->file + ": the sound cannot be opened; the film is silent", true);
  }
  return true;
}

void FilmWriter::playblast() {
  const Files& files = with_.files;
  const std::string folder = film_folder(files.project());
  const std::string stem = film_stem(files.project(), files.path()) + "-playblast";
  FilmEntry entry;
  entry.size.reset();
  entry.range = FilmRange::loop;
  entry.numbers = true;
  if (film::has_ffmpeg()) {
    write(free_path(folder, stem, ".mp4"), entry);
    return;
  }
  entry.kind = film::FilmKind::pictures;
  const std::string pictures = free_path(folder, stem, "");
  if (!write((fs::path(pictures) / (stem + ".png")).string(), entry)) return;
  with_.notices.tell("ffmpeg is not installed: writing pictures instead of a film");
}

void FilmWriter::cancel() {
  if (job_) job_->cancel();
}

void FilmWriter::follow() {
  const auto ended = job_ ? job_->advance() : std::nullopt;
  if (!ended) return;
  const std::string path = job_->output();
  const std::string written = job_->written();
  const bool cancelled = job_->cancelled();
  job_.reset();
  if (ended->ok()) {
    with_.notices.tell("written: " + written);
  } else if (cancelled) {
    with_.notices.tell("cancelled: " + path);
  } else {
    with_.notices.tell(ended->error().line(path), true);
  }
}

}  // namespace penpose::app
