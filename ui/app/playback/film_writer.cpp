#include "ui/app/playback/film_writer.h"

#include <utility>

#include "ui/app/input/navigation.h"

namespace penpose::app {

FilmWriter::FilmWriter(EditingSession& editing, Notices& notices, const Canvas& canvas, const Playback& playback)
    : editing_(editing), notices_(notices), canvas_(canvas), playback_(playback) {}

bool FilmWriter::write(const std::string& path, geometry::Viewport size) {
  if (job_) {
    notices_.tell("another film is being written still: " + job_->output(), true);
    return false;
  }
  FilmOrder order;
  order.output = path;
  order.size = size;
  order.rate = playback_.rate();
  const Area all{0, 0, static_cast<double>(size.width), static_cast<double>(size.height)};
  order.camera = framed(canvas_.surface().positions(), size, all, viewpoint_of(canvas_.view().camera)).camera;
  auto job = FilmJob::start(editing_.document(), order);
  if (!job) {
    notices_.tell(job.error().line(path), true);
    return false;
  }
  job_ = std::make_unique<FilmJob>(std::move(*job));
  notices_.tell("writing " + path + "; drawing goes on meanwhile");
  return true;
}

void FilmWriter::follow() {
  const auto ended = job_ ? job_->advance() : std::nullopt;
  if (!ended) return;
  const std::string path = job_->output();
  job_.reset();
  if (ended->ok()) {
    notices_.tell("written: " + path);
  } else {
    notices_.tell(ended->error().line(path), true);
  }
}

}  // namespace penpose::app
