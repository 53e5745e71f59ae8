#include "ui/app/files/recording.h"

#include <utility>

namespace penpose::app {

Recording::Recording(Options options, const EditingSession& editing, Notices& notices)
    : options_(std::move(options)), editing_(editing), notices_(notices) {}

void Recording::end() {
  if (!file_) return;
  Aside aside{std::move(file_), keep_};
  end(aside, editing_.editor().history());
  file_ = std::move(aside.file);
}

void Recording::end(Aside& aside, const document::History& history) {
  if (!aside.file) return;
  const bool worth = aside.keep || history.undo_count() > 0 || history.redo_count() > 0;
  if (!worth || !leaves_work_) aside.file->finish(worth);
}

Recording::Aside Recording::set_aside() {
  broken_told_ = false;
  return {std::move(file_), std::exchange(keep_, false)};
}

void Recording::take_up(Aside aside) {
  file_ = std::move(aside.file);
  keep_ = aside.keep;
  broken_told_ = false;
}

std::unique_ptr<SessionFile> Recording::next() {
  end();
  return beside();
}

std::unique_ptr<SessionFile> Recording::beside() {
  const bool named = !options_.first.empty();
  keep_next_ = named;
  if (!named && options_.state_folder.empty()) return nullptr;
  const std::string first = std::exchange(options_.first, {});
  auto made = named ? SessionFile::create(first, options_.program)
                    : SessionFile::create_in(options_.state_folder + "/sessions",
                                             options_.date ? options_.date() : "session", options_.program);
  if (made) return std::move(*made);
  notices_.tell("this session is not recorded: " + made.error().line(named ? first : options_.state_folder), true);
  return nullptr;
}

void Recording::take(std::unique_ptr<SessionFile> file) {
  file_ = std::move(file);
  keep_ = std::exchange(keep_next_, false);
  broken_told_ = false;
}

void Recording::note_project(const std::string& project, const std::string& state) {
  if (file_) file_->note_project(project, state);
}

base::Status Recording::keep_model(const std::string& model) {
  if (!file_) return base::Done{};
  return file_->keep_model(model);
}

void Recording::follow() {
  const bool broken = file_ && file_->writer().broken();
  if (broken == broken_told_ || !file_) return;
  broken_told_ = broken;
  if (!broken) return notices_.tell("recording again; nothing was lost");
  notices_.tell("this session cannot be written now; it stays in memory until it can: " +
                    file_->writer().broken()->line(file_->path()),
                true);
}

}  // namespace penpose::app
