#include "ui/app/reference/reference_desk.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "ui/app/view/backdrop.h"
#include "ui/files/project/beside_project.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

bool same_file(const document::ReferencePicture& a, const document::ReferencePicture& b) {
  return a.content == b.content && fs::path(a.file).filename() == fs::path(b.file).filename();
}

}  // namespace

std::string ReferenceDesk::project() const {
  return with_.files.project().empty() ? with_.files.path() : with_.files.project();
}

document::ReferencePicture ReferenceDesk::beginning() const {
  document::ReferencePicture picture;
  // As high as what is seen, nearly, and in its middle.
  constexpr double k_share = 0.9;
  const Area& free = with_.canvas.free_area();
  const document::View seen =
      document::view_of_part(with_.canvas.view(), {{free.left, free.top}, {free.right, free.bottom}});
  if (const auto camera = geometry::Camera::make(seen.camera, seen.viewport)) {
    picture.middle = seen.camera.look_at;
    picture.height = k_share * seen.viewport.height * camera->units_per_px(camera->depth(picture.middle));
  }
  picture.beside = beside_;
  if (beside_) picture.opacity = 1;
  return picture;
}

bool ReferenceDesk::open(const std::string& path, bool beside) {
  beside_ = beside;
  reader_.reset();
  if (is_film_file(path)) {
    opens_ = true;
    reader_ = std::make_unique<FilmReader>(path, with_.playback.rate(), with_.cache);
    return true;
  }
  const auto file = open_reference_picture(path);
  if (!file) {
    with_.notices.tell(file.error().line(path), true);
    return false;
  }
  const auto before = with_.editing.document().reference;
  place_new(path, *file);
  return with_.editing.document().reference != before;
}

void ReferenceDesk::place_new(const std::string& path, const ReferenceFile& file) {
  document::ReferencePicture picture = beginning();
  // Another picture stands where the one before it stood.
  if (const auto& before = with_.editing.document().reference) picture = *before;
  picture.file = files::name_beside(path, with_.files.project());
  picture.content = file.content;
  auto made = Backdrop::open(file.frames, path, picture);
  if (!made) return with_.notices.tell(made.error().line(path), true);
  if (!with_.editing.perform(document::SetReference{picture})) return;
  known_ = with_.editing.document().reference;
  doubt_.clear();
  other_.reset();
  with_.look.backdrop = std::move(*made);
  with_.look.backdrop->adjusting = true;
  const std::string cut = file.cut ? "; only the beginning of it is taken" : "";
  const std::size_t frames = file.frames.size();
  with_.notices.tell(frames > 1 ? std::to_string(frames) +
                                      " pictures, one a frame: drag them to where they fit, then Done" + cut
                                : "Drag the picture to where it fits, the wheel sizes it, then Done");
}

void ReferenceDesk::remove() {
  if (with_.editing.document().reference) with_.editing.perform(document::RemoveReference{});
  cancel();
}

void ReferenceDesk::commit() {
  const auto& now = with_.editing.document().reference;
  if (!with_.look.backdrop || !now || now != known_) return;
  const document::ReferencePicture placed = with_.look.backdrop->placed();
  if (placed == *now || !with_.editing.perform(document::SetReference{placed})) return;
  known_ = with_.editing.document().reference;
}

void ReferenceDesk::cancel() {
  if (reader_) reader_->cancel();
}

void ReferenceDesk::accept() {
  const auto& now = with_.editing.document().reference;
  if (!now || !other_) return;
  document::ReferencePicture picture = *now;
  picture.content = other_->content;
  doubt_.clear();
  other_.reset();
  if (with_.editing.perform(document::SetReference{picture})) known_ = with_.editing.document().reference;
  if (with_.look.backdrop) with_.look.backdrop->place(picture);
}

void ReferenceDesk::use(const std::string& path, base::Result<ReferenceFile> file) {
  const auto& now = with_.editing.document().reference;
  if (!now) return;
  if (!file) {
    doubt_ = file.error().line(now->file);
    return with_.notices.tell(doubt_, true);
  }
  auto made = Backdrop::open(file->frames, path, *now);
  if (!made) {
    doubt_ = made.error().line(now->file);
    return with_.notices.tell(doubt_, true);
  }
  with_.look.backdrop = std::move(*made);
  with_.look.backdrop->adjusting = false;
  if (file->content == now->content) return;
  doubt_ = now->file + " is another file than the project was made with";
  other_ = std::move(*file);
}

void ReferenceDesk::take_document() {
  const auto& now = with_.editing.document().reference;
  if (now == known_) return;
  const bool same = now && known_ && with_.look.backdrop && same_file(*now, *known_);
  known_ = now;
  if (same) return with_.look.backdrop->place(*now);
  with_.look.backdrop.reset();
  doubt_.clear();
  other_.reset();
  if (!opens_) reader_.reset();
  if (!now) return;
  const std::string path = files::path_beside(now->file, project());
  if (is_film_file(path)) {
    opens_ = false;
    reader_ = std::make_unique<FilmReader>(path, with_.playback.rate(), with_.cache);
  } else {
    use(path, open_reference_picture(path));
  }
}

void ReferenceDesk::follow() {
  take_document();
  if (reader_ && reader_->ready()) {
    const auto reader = std::move(reader_);
    auto file = reader->take();
    if (!std::exchange(opens_, false)) {
      use(reader->path(), std::move(file));
    } else if (file) {
      place_new(reader->path(), *file);
    } else if (!reader->cancelled()) {
      with_.notices.tell(file.error().line(reader->path()), true);
    }
  }
  if (!with_.look.backdrop) return;
  Backdrop& backdrop = *with_.look.backdrop;
  if (const auto shown = backdrop.show(with_.playback.time_s(), with_.playback.rate()); !shown)
    with_.notices.tell(shown.error().line(backdrop.path()), true);
}

}  // namespace penpose::app
