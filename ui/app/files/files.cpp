#include "ui/app/files/files.h"

#include <cstdlib>
#include <filesystem>
#include <utility>

#include "core/base/text/letters.h"
#include "core/document/document_hash.h"
#include "core/io/model/model_formats.h"
#include "core/io/surface/orientation.h"
#include "replay/session/session_recorder.h"
#include "ui/app/dialogs/entries.h"
#include "ui/files/load_model.h"
#include "ui/files/project/beside_project.h"
#include "ui/files/save_model.h"
#include "ui/files/session_model.h"
#include "ui/files/sound/sound_file.h"
#include "ui/files/trace_file.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

std::string extension_of(const std::string& path) { return base::lower_case(fs::path(path).extension().string()); }

bool is_trace(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".session" || extension == ".hid" || extension == ".trace" || extension == ".rec" ||
         extension == ".txt";
}

/// What a session was drawn on, as it names it. An error says which model it is.
base::Result<document::Document> model_of_session(const std::string& session, const std::string& named) {
  const std::string model = files::find_session_model(session, named);
  auto document = files::load_document(model, files::NamedBy::file);
  if (!document) {
    base::Error error = document.error();
    error.what = "the model \"" + model + "\" cannot be read: " + error.what;
    return error;
  }
  return document;
}

/// A folder of this user alone, where there is no home to keep work in; empty where none can be made.
std::string private_folder() {
  std::error_code code;
  std::string name = (fs::temp_directory_path(code) / "penpose-XXXXXX").string();
  return code || ::mkdtemp(name.data()) == nullptr ? std::string() : name;
}

}  // namespace

constexpr Files::Joins Files::k_alone{false, nullptr};

void Files::join(const Joins& joins) {
  if (joins.beside) {
    parts_.cast.add(path_, joins.like);
    parts_.switched();
  } else {
    parts_.cast.begin(path_);
    parts_.opened();
  }
}

void Files::begin_session(document::Document document, const std::string& path, const Joins& joins) {
  parts_.performer.drop();
  std::unique_ptr<SessionFile> next = parts_.recording.next();
  std::error_code code;
  const bool built_in = path.starts_with("builtin:");
  const std::string full = built_in ? path : fs::absolute(path, code).string();
  parts_.player.trace.reset();
  // The editing session holds the writer of the session before until then.
  parts_.editing.open(std::move(document), next ? &next->writer() : nullptr, code ? path : full);
  parts_.recording.take(std::move(next));
  path_ = full;
  // A model that others made is no file to save to: the first save asks for a name.
  if (!joins.beside) project_ = files::is_project(full) ? full : std::string();
  join(joins);
  set_project(project_);
}

void Files::resume(replay::ReplayResult played, std::unique_ptr<SessionFile> file, const Joins& joins) {
  parts_.performer.drop();
  parts_.recording.end();
  parts_.player.trace.reset();
  const std::string project = file ? project_of_session(file->path()) : std::string();
  parts_.editing.resume(std::move(*played.session), file ? &file->writer() : nullptr, played.last_us);
  parts_.recording.take(std::move(file));
  path_ = played.model;
  if (!joins.beside) project_ = project;
  join(joins);
}

void Files::set_project(const std::string& path) {
  project_ = path;
  noted_ = parts_.editing.revision();
  const bool saved = !parts_.editing.unsaved() && !path.empty();
  parts_.recording.note_project(path, saved ? parts_.editing.state().whole.hex() : std::string());
  parts_.cast.note_project(path);
}

void Files::follow() {
  if (!project_.empty() && !parts_.editing.unsaved() && noted_ != parts_.editing.revision()) set_project(project_);
}

base::Status Files::open(const std::string& path) {
  if (const auto name = tour_of_path(path)) {
    auto tour = read_tour(*name, tour_session(*name));
    if (!tour) return tour.error();
    if (const auto opened = open(tour->model); !opened) return opened;
    parts_.features.hide();
    parts_.editing.set_tool({});
    parts_.tour.begin(std::move(*tour));
    return base::Done{};
  }
  if (is_trace(path)) return open_session(path);
  auto cast = files::load_cast(path, files::NamedBy::file);
  if (!cast) return cast.error();
  if (*cast) {
    open_cast(std::move(**cast), path, false);
    parts_.preferences.remember(project_);
    return base::Done{};
  }
  auto document = files::load_document(path, files::NamedBy::file);
  if (!document) return document.error();
  begin_session(std::move(*document), path, k_alone);
  parts_.features.begin(!path.starts_with("builtin:"));
  take_first_tool();
  if (files::is_older_project(path)) {
    for (const std::string& note : parts_.editing.document().model->notes) parts_.notices.tell(note);
  }
  const bool lies = files::leaves_axes_open(path) && io::looks_as_if_z_were_up(*parts_.editing.document().model);
  if (lies) parts_.notices.tell("it looks as if it lay on its back: Z up, in the menu, stands it up");
  if (!path.starts_with("builtin:")) {
    parts_.preferences.remember(path_);
    parts_.dialogs.state<FileChoice>().folder = fs::path(path_).parent_path().string();
  }
  return base::Done{};
}

void Files::take_first_tool() {
  if (parts_.preferences.settings().pose_first) return;
  drawing::Tool draw;
  draw.kind = drawing::ToolKind::draw;
  parts_.editing.set_tool(draw);
}

base::Status Files::open_session(const std::string& path) {
  auto played = played_session(path);
  if (!played) return played.error();
  // A session goes on from a project of its own, so that what is recorded from here on can be replayed too.
  const std::string folder = parts_.state_folder.empty() ? private_folder() : parts_.state_folder;
  if (folder.empty()) return base::Error{"there is no folder to keep work in", "", "set HOME or XDG_STATE_HOME"};
  std::error_code code;
  fs::create_directories(folder, code);
  const std::string copy = free_path(folder, fs::path(path).stem().string(), ".glb");
  if (const auto saved = files::save_document(played->session->editor().document(), copy); !saved) return saved.error();
  auto again = files::load_document(copy);
  if (!again) return again.error();
  begin_session(std::move(*again), copy, k_alone);
  set_project({});
  return base::Done{};
}

base::Status Files::draw_again(const std::string& path) {
  std::unique_ptr<SessionFile> next = parts_.recording.beside();
  std::optional<replay::SessionRecorder> recorder;
  const auto place_of = [&](const std::string& named) { return files::find_session_model(path, named); };
  if (next) recorder.emplace(next->writer(), place_of);
  auto played = played_session(path, recorder ? &*recorder : nullptr, true);
  if (!played) {
    if (next) next->finish(false);
    return played.error();
  }
  parts_.dialogs.state<DrawnAgain>() = {fs::path(path).stem().string(), *std::move(played->redrawn)};
  played->model = place_of(played->model);
  resume(std::move(*played), std::move(next), k_alone);
  parts_.dialogs.show(Dialog::drawn_again);
  return base::Done{};
}

base::Result<replay::ReplayResult> Files::played_session(const std::string& path, replay::PlayerObserver* observer,
                                                         bool by_today) {
  const auto file = files::open_plain(path);
  if (!file) return file.error();
  replay::PlayerOptions options;
  options.open = [&](const std::string& named) { return model_of_session(path, named); };
  options.own_tablets = parts_.own_tablets;
  options.observer = observer;
  options.by_today = by_today;
  options.may_differ = [&](const std::string& named) {
    return files::changes_with_editions(files::find_session_model(path, named));
  };
  auto played = replay::play_session(files::read_recording_file(file->get()), options);
  if (!played) return played;
  if (!played->session) {
    return base::Error{"holds nothing to replay: neither reports nor lines of a session", "", "open another file"};
  }
  if (played->divergence) parts_.notices.tell(replay::error_of(*played->divergence).line(path), true);
  return played;
}

/// Whether opening a file waits for an answer: whether to draw it again.
bool Files::asks_about_edition(const std::string& path) {
  const auto edition = is_trace(path) ? files::older_edition_of(path) : std::nullopt;
  if (!edition) return false;
  parts_.dialogs.state<OlderSession>() = {path, *edition};
  parts_.dialogs.show(Dialog::older_session);
  return true;
}

void Files::try_open(const std::string& path) {
  if (asks_about_edition(path)) return;
  if (const auto opened = open(path); !opened) {
    parts_.notices.tell(opened.error().line(path), true);
    return;
  }
  parts_.dialogs.show(Dialog::none);
}

base::Status Files::play_trace(const std::string& path) {
  auto player = TracePlayer::load(path);
  if (!player) return player.error();
  if (player->is_session()) {
    if (!player->model()) return replay::no_model_error();
    const std::string model = files::find_session_model(path, player->model()->path);
    auto document = model_of_session(path, player->model()->path);
    if (!document) return document.error();
    const base::Hash128 found = document::DocumentHasher()(*document).whole;
    if (!(found == player->model()->hash)) return replay::changed_model_error(model, found, player->model()->hash);
    begin_session(std::move(*document), model, k_alone);
    // What is played is no work on the model's own file.
    set_project({});
    parts_.editing.act(replay::ToolChosen{});
  } else {
    // Pens that were recorded without a word of tools draw with the plain one.
    parts_.editing.set_tool({});
  }
  parts_.player.trace.emplace(std::move(*player));
  parts_.player.began_us = parts_.clock();
  parts_.dialogs.show(Dialog::none);
  return base::Done{};
}

std::optional<document::SetSound> Files::renamed_sound(const document::Document& document, const std::string& opened,
                                                       const std::string& path) const {
  const auto& sound = document.sound;
  if (!sound || !io::keeps_everything(path)) return std::nullopt;
  const std::string name = files::sound_named_from(sound->file, project_.empty() ? opened : project_, path);
  if (name == sound->file) return std::nullopt;
  return document::SetSound{name, sound->content, sound->offset_s};
}

std::optional<document::SetReference> Files::renamed_reference(const std::string& path) const {
  const auto& reference = parts_.editing.document().reference;
  if (!reference || !io::keeps_everything(path)) return std::nullopt;
  document::SetReference renamed{*reference};
  renamed.picture.file = files::renamed_beside(reference->file, project_.empty() ? path_ : project_, path);
  return renamed.picture.file == reference->file ? std::nullopt : std::optional(renamed);
}

base::Status Files::save(const std::string& path) {
  if (parts_.cast.several()) return save_all(path);
  std::error_code code;
  const std::string full = fs::absolute(path, code).string();
  const std::string opened = files::model_name(path_).file;
  const bool same = full == opened || fs::equivalent(full, opened, code);
  if (same) {
    if (const auto kept = parts_.recording.keep_model(opened); !kept) {
      return base::Error{
          "is not saved: the model that the session began on cannot be kept beside it, " + kept.error().what, "",
          "save under another name, or make room at " + fs::path(parts_.recording.path()).parent_path().string()};
    }
  }
  const auto sound = renamed_sound(parts_.editing.document(), path_, path);
  const auto with_sound =
      sound ? parts_.editing.after(*sound) : base::Result<document::Document>(parts_.editing.document());
  if (!with_sound) return with_sound.error();
  const auto reference = renamed_reference(path);
  document::Document renamed = *with_sound;
  if (reference) renamed.reference = std::make_shared<const document::ReferencePicture>(reference->picture);
  auto saved = files::save_document(renamed, path, files::SaveNotes::quiet);
  if (!saved) return saved;
  if (io::keeps_everything(path)) {
    if (sound) parts_.editing.perform_with(*sound);
    if (reference) parts_.editing.perform_with(*reference);
    parts_.editing.mark_saved();
    parts_.cast.mark_saved();
    set_project(full);
  }
  parts_.preferences.remember(full);
  parts_.notices.tell("saved " + full);
  return saved;
}

std::string Files::lost_by_writing(const std::string& path) const {
  std::error_code code;
  if (!fs::exists(path, code) || (!project_.empty() && fs::equivalent(path, project_, code))) return {};
  const std::string name = fs::path(path).filename().string();
  const bool opened = fs::equivalent(path, files::model_name(path_).file, code);
  if (opened && !files::is_project(path))
    return name + " is the model that was opened. It is written over, and is lost as it came.";
  if (files::is_project(path)) return name + " is another project. It is written over, and what is in it is lost.";
  return name + " is a file that penpose did not save. It is written over, and is lost as it is.";
}

base::Status Files::export_to(const std::string& path) {
  auto written = files::save_document(parts_.editing.document(), path, files::SaveNotes::quiet);
  if (written) parts_.notices.tell("exported " + path);
  return written;
}

base::Status Files::bring_back(const std::string& path) {
  // What an older program was drawing when it ended comes back as it is read today.
  if (files::older_edition_of(path)) {
    auto drawn = draw_again(path);
    if (drawn) settle_session(path);
    return drawn;
  }
  auto played = played_session(path);
  if (!played) return played.error();
  auto file = SessionFile::resume(path, parts_.program);
  if (file && !played->divergence) {
    resume(std::move(*played), std::move(*file), k_alone);
    return base::Done{};
  }
  // What cannot be gone on with is left as it is, to be offered again, and its end is what a new session begins on.
  file = base::Error{};
  return open(path);
}

}  // namespace penpose::app
