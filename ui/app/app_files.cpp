#include <cstdlib>
#include <filesystem>
#include <utility>

#include "core/base/text/letters.h"
#include "core/document/document_hash.h"
#include "core/document/time/timeline.h"
#include "replay/session/session_player.h"
#include "ui/app/app.h"
#include "ui/app/input/navigation.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"
#include "ui/files/session_model.h"
#include "ui/files/trace_file.h"

// What the app opens, saves, records and brings back.

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

void App::end_session() {
  performer_.drop();
  if (!file_) return;
  const bool worth =
      keep_file_ || editing_.editor().history().undo_count() > 0 || editing_.editor().history().redo_count() > 0;
  if (!worth || !leaves_work_) file_->finish(worth);
}

void App::begin_session(document::Document document, const std::string& path) {
  end_session();
  std::unique_ptr<SessionFile> next;
  const bool named = !options_.session.empty() && !file_;
  keep_file_ = named;
  if (named || !options_.folders.state.empty()) {
    auto made = named ? SessionFile::create(options_.session, options_.program)
                      : SessionFile::create_in(options_.folders.state + "/sessions",
                                               options_.date ? options_.date() : "session", options_.program);
    if (made) {
      next = std::move(*made);
    } else {
      notices_.tell(
          "this session is not recorded: " + made.error().line(named ? options_.session : options_.folders.state),
          true);
    }
  }
  std::error_code code;
  const bool built_in = path.starts_with("builtin:");
  const std::string full = built_in ? path : fs::absolute(path, code).string();
  player_.trace.reset();
  // The editing holds the writer of the session before until then.
  editing_.open(std::move(document), next ? &next->writer() : nullptr, code ? path : full);
  file_ = std::move(next);
  path_ = full;
  set_project(!built_in && extension_of(path) == ".glb" ? full : std::string());
  show_anew();
}

void App::resume(replay::Playback played, std::unique_ptr<SessionFile> file) {
  end_session();
  keep_file_ = false;
  player_.trace.reset();
  const std::string project = project_of_session(file->path());
  editing_.resume(std::move(*played.session), &file->writer(), played.last_us);
  file_ = std::move(file);
  path_ = played.model;
  project_ = project;
  show_anew();
}

void App::set_project(const std::string& path) {
  project_ = path;
  if (file_)
    file_->note_project(path, editing_.unsaved() || path.empty() ? std::string() : editing_.state().whole.hex());
}

void App::show_anew() {
  broken_told_ = false;
  playback_.begin();
  controls_.open_document();
  highlighted_.reset();
  target_drag_.reset();
  control_drag_.reset();
  panels_.curve_menu.reset();
  canvas_.begin();
  editing_.set_tablet(0, {});
  // The session is another: tablets are plugged in anew, and nothing is held or being turned.
  dial_.reset();
  dial_control_.clear();
  tool_before_.reset();
  tool_held_.reset();
  touch_view_.reset();
  pen_view_.reset();
  for (const int device : plugged_) {
    const decode::DeviceIdentity& tablet = tablets_.at(device);
    desk_.remove(device);
    raw_touch_.erase(device);
    editing_.connect(device, tablet);
    on_device(device, tablet);
    if (editing_.session().pens().decodes(device)) editing_.set_tablet(device, setting_of(device));
    if (const auto on = lights_.find(device); on != lights_.end()) lights_seen(device, on->second);
  }
  // What a receiver hears is for this session to know from its reports, too.
  for (const auto& [device, status] : receiver_status_) {
    editing_.report(device, status);
    const auto hand = editing_.session().hand_moments();
    take_hand(std::vector<replay::HandMoment>(hand.begin(), hand.end()));
  }
}

base::Status App::open(const std::string& path) {
  if (const auto name = tour_of_path(path)) {
    auto tour = read_tour(*name, tour_session(*name));
    if (!tour) return tour.error();
    if (const auto opened = open(tour->model); !opened) return opened;
    tour_.begin(*this, std::move(*tour));
    return base::Done{};
  }
  if (is_trace(path)) {
    auto played = played_session(path);
    if (!played) return played.error();
    // A session goes on from a project of its own, so that what is recorded from here on can be replayed too.
    const std::string folder = options_.folders.state.empty() ? private_folder() : options_.folders.state;
    if (folder.empty()) return base::Error{"there is no folder to keep work in", "", "set HOME or XDG_STATE_HOME"};
    std::error_code code;
    fs::create_directories(folder, code);
    const std::string copy = free_path(folder, fs::path(path).stem().string(), ".glb");
    if (const auto saved = files::save_document(played->session->editor().document(), copy); !saved)
      return saved.error();
    auto again = files::load_document(copy);
    if (!again) return again.error();
    begin_session(std::move(*again), copy);
    set_project({});
    return base::Done{};
  }
  auto document = files::load_document(path, files::NamedBy::file);
  if (!document) return document.error();
  begin_session(std::move(*document), path);
  if (!path.starts_with("builtin:")) {
    remember_file(preferences_.settings(), path_);
    preferences_.changed();
    dialogs_.state<FileChoice>().folder = fs::path(path_).parent_path().string();
  }
  return base::Done{};
}

base::Result<replay::Playback> App::played_session(const std::string& path) {
  const auto file = files::open_plain(path);
  if (!file) return file.error();
  replay::PlayerOptions options;
  options.open = [&](const std::string& named) { return model_of_session(path, named); };
  options.own_tablets = options_.own_tablets;
  auto played = replay::play_session(files::read_from_file(file->get()), options);
  if (!played) return played;
  if (!played->session) {
    return base::Error{"holds nothing to replay: neither reports nor lines of a session", "", "open another file"};
  }
  if (played->divergence) notices_.tell(replay::error_of(*played->divergence).line(path), true);
  return played;
}

void App::try_open(const std::string& path) {
  if (const auto opened = open(path); !opened) {
    notices_.tell(opened.error().line(path), true);
    return;
  }
  dialogs_.show(Dialog::none);
}

base::Status App::play_trace(const std::string& path) {
  auto player = TracePlayer::load(path);
  if (!player) return player.error();
  if (player->is_session()) {
    if (!player->model()) return replay::no_model();
    const std::string model = files::find_session_model(path, player->model()->path);
    auto document = model_of_session(path, player->model()->path);
    if (!document) return document.error();
    const base::Hash128 found = document::DocumentHasher()(*document).whole;
    if (!(found == player->model()->hash)) return replay::other_model(model, found, player->model()->hash);
    begin_session(std::move(*document), model);
    // What is played is no work on the model's own file.
    set_project({});
    editing_.play(replay::ToolChosen{});
  }
  player_.trace.emplace(std::move(*player));
  last_frame_us_ = options_.clock();
  dialogs_.show(Dialog::none);
  return base::Done{};
}

base::Status App::save(const std::string& path) {
  std::error_code code;
  const std::string full = fs::absolute(path, code).string();
  const bool same = full == path_ || fs::equivalent(full, path_, code);
  if (same && file_) {
    if (const auto kept = file_->keep_model(path_); !kept) {
      return base::Error{
          "is not saved: the model that the session began on cannot be kept beside it, " + kept.error().what, "",
          "save under another name, or make room at " + fs::path(file_->path()).parent_path().string()};
    }
  }
  auto saved = files::save_document(editing_.document(), path, files::SaveNotes::quiet);
  if (!saved) return saved;
  if (extension_of(path) == ".glb") {
    editing_.mark_saved();
    set_project(full);
  }
  remember_file(preferences_.settings(), full);
  preferences_.changed();
  notices_.tell("saved " + full);
  return saved;
}

base::Status App::export_to(const std::string& path) {
  auto written = files::save_document(editing_.document(), path, files::SaveNotes::quiet);
  if (written) notices_.tell("exported " + path);
  return written;
}

void App::save_from_dialog(const std::string& chosen) {
  const std::string path = fs::path(chosen).has_extension() ? chosen : chosen + ".glb";
  if (const auto saved = save(path); !saved) return notices_.tell(saved.error().line(path), true);
  dialogs_.show(Dialog::none);
  dialogs_.state<FileChoice>().name.clear();
  if (std::exchange(dialogs_.state<UnsavedWork>().saves_first, false) && !editing_.unsaved()) go_on_without_saving();
}

void App::save_first() {
  dialogs_.state<UnsavedWork>().saves_first = true;
  if (!project_.empty()) return save_from_dialog(project_);
  dialogs_.state<FileChoice>().name.clear();
  dialogs_.show(Dialog::save);
}

void App::go_on_without_saving() {
  dialogs_.show(Dialog::none);
  if (dialogs_.state<UnsavedWork>().then_opens.empty()) return quit();
  try_open(dialogs_.state<UnsavedWork>().then_opens);
}

void App::recover(bool yes) {
  if (abandoned_.empty()) return do_action(Action::cancel);
  const std::string path = abandoned_.front();
  abandoned_.erase(abandoned_.begin());
  if (!yes) settle_session(path);
  if (!yes && !abandoned_.empty()) return;  // the next one is offered
  // Those that were not asked about are offered at the next start.
  do_action(Action::cancel);
  if (!yes) return;
  if (const auto back = bring_back(path); !back) return notices_.tell(back.error().line(path), true);
  notices_.tell("brought back the work of " + fs::path(path).stem().string());
}

base::Status App::bring_back(const std::string& path) {
  auto played = played_session(path);
  if (!played) return played.error();
  auto file = SessionFile::resume(path, options_.program);
  if (file && !played->divergence) {
    resume(std::move(*played), std::move(*file));
    return base::Done{};
  }
  // What cannot be gone on with is left as it is, to be offered again, and its end is what a new session begins on.
  file = base::Error{};
  return open(path);
}

}  // namespace penpose::app
