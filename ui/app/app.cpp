#include "ui/app/app.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "core/document/timeline.h"
#include "replay/session_player.h"
#include "ui/cli/load_model.h"
#include "ui/cli/save_model.h"
#include "ui/cli/trace_file.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t k_notice_us = 6'000'000;
constexpr std::size_t k_most_notices = 4;
constexpr double k_target_mm = 9;
constexpr double k_mm_per_inch = 25.4;
/// Displays that say less or more than this say nonsense.
constexpr double k_least_dpi = 60;
constexpr double k_most_dpi = 600;
constexpr int k_playing_frame_ms = 16;
constexpr std::int64_t k_longest_step_us = 200'000;

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

bool is_trace(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".session" || extension == ".hid" || extension == ".trace" || extension == ".rec" ||
         extension == ".txt";
}

}  // namespace

App::App(AppOptions options)
    : options_(std::move(options)),
      settings_(load_settings(options_.folders.config)),
      workspace_(
          options_.clock, [this](std::string text, bool is_error) { tell(std::move(text), is_error); },
          options_.own_tablets) {
  if (!options_.folders.state.empty()) abandoned_ = abandoned_sessions(options_.folders.state + "/sessions");
  if (!abandoned_.empty()) {
    panels_.dialog = Dialog::recover;
  } else if (!settings_.steps_seen) {
    panels_.dialog = Dialog::steps;
  }
  // Before the first frame nobody knows where panels are.
  hits_.all = true;
  const char* home = std::getenv("HOME");
  panels_.folder = home != nullptr ? home : "/";
}

App::~App() { end_session(); }

void App::end_session() {
  if (!file_) return;
  const bool worth =
      keep_file_ || workspace_.editor().history().undo_count() > 0 || workspace_.editor().history().redo_count() > 0;
  if (!worth || !leaves_work_) file_->finish(worth);
}

void App::begin_session(document::Document document, const std::string& path) {
  end_session();
  // The workspace holds the writer of the session before until it is opened anew.
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
      tell("this session is not recorded: " + made.error().line(named ? options_.session : options_.folders.state),
           true);
    }
  }
  std::error_code code;
  const bool built_in = path.starts_with("builtin:");
  const std::string full = built_in ? path : fs::absolute(path, code).string();
  player_.reset();
  workspace_.open(std::move(document), next ? &next->writer() : nullptr, code ? path : full);
  file_ = std::move(next);
  broken_told_ = false;
  playing_ = false;
  panels_.time_s = workspace_.document().time_s;
  panels_.deformer.clear();
  highlighted_.reset();
  target_drag_.reset();
  panels_.curve_menu.reset();
  panels_.new_surface = {};
  const auto& deformers = workspace_.document().model->deformers;
  deformer_count_ = deformers ? deformers->size() : 0;
  path_ = full;
  project_ = !built_in && extension_of(path) == ".glb" ? full : std::string();
  surface_.update(workspace_.shown_model(), workspace_.shown_pose());
  frame_from(*render::find_viewpoint("front"));
  workspace_.set_tablet(0, {});
  for (const auto& [device, name] : tablets_) workspace_.set_tablet(device, settings_.tablet);
}

base::Status App::open(const std::string& path) {
  if (is_trace(path)) {
    auto document = document_of_session(path);
    if (!document) return document.error();
    // A session goes on from a project of its own, so that what is recorded from here on can be replayed too.
    std::error_code code;
    const std::string folder =
        options_.folders.state.empty() ? fs::temp_directory_path(code).string() : options_.folders.state;
    fs::create_directories(folder, code);
    const std::string copy = free_path(folder, fs::path(path).stem().string(), ".glb");
    if (const auto saved = cli::save_document(*document, copy); !saved) return saved.error();
    auto again = cli::load_document(copy);
    if (!again) return again.error();
    begin_session(std::move(*again), copy);
    project_.clear();
    return base::Done{};
  }
  auto document = cli::load_document(path);
  if (!document) return document.error();
  begin_session(std::move(*document), path);
  if (!path.starts_with("builtin:")) {
    remember_file(settings_, path_);
    settings_changed();
    panels_.folder = fs::path(path_).parent_path().string();
  }
  return base::Done{};
}

base::Result<document::Document> App::document_of_session(const std::string& path) {
  const auto file = cli::open_trace(path);
  if (!file) return file.error();
  replay::PlayerOptions options;
  options.open = [&](const std::string& model) {
    std::error_code code;
    if (model.empty()) return cli::load_document("builtin:demo");
    const auto beside = fs::path(path).parent_path() / fs::path(model).filename();
    const bool moved = !model.starts_with("builtin:") && !fs::exists(model, code) && fs::exists(beside, code);
    return cli::load_document(moved ? beside.string() : model);
  };
  options.own_tablets = options_.own_tablets;
  auto played = replay::play_session(cli::read_from_file(file->get()), options);
  if (!played) return played.error();
  if (!played->session) {
    return base::Error{"holds nothing to replay: neither reports nor lines of a session", "", "open another file"};
  }
  if (played->divergence) tell("the session did not replay to what was recorded; look at it before going on", true);
  return played->session->editor().document();
}

void App::try_open(const std::string& path) {
  if (const auto opened = open(path); !opened) {
    tell(opened.error().line(path), true);
    return;
  }
  panels_.dialog = Dialog::none;
}

base::Status App::play_trace(const std::string& path) {
  auto player = TracePlayer::load(path);
  if (!player) return player.error();
  if (player->is_session()) {
    auto document = cli::load_document(player->model().empty() ? "builtin:demo" : player->model());
    if (!document) return document.error();
    begin_session(std::move(*document), player->model().empty() ? "builtin:demo" : player->model());
  }
  player_.emplace(std::move(*player));
  last_frame_us_ = options_.clock();
  panels_.dialog = Dialog::none;
  return base::Done{};
}

base::Status App::save(const std::string& path) {
  auto saved = cli::save_document(workspace_.document(), path);
  if (!saved) return saved;
  std::error_code code;
  const std::string full = fs::absolute(path, code).string();
  if (extension_of(path) == ".glb") {
    project_ = full;
    workspace_.mark_saved();
  }
  remember_file(settings_, full);
  settings_changed();
  tell("saved " + full);
  return saved;
}

base::Status App::export_to(const std::string& path) {
  auto written = cli::save_document(workspace_.document(), path);
  if (written) tell("exported " + path);
  return written;
}

void App::save_from_dialog(const std::string& chosen) {
  const std::string path = fs::path(chosen).has_extension() ? chosen : chosen + ".glb";
  if (const auto saved = save(path); !saved) return tell(saved.error().line(path), true);
  panels_.dialog = Dialog::none;
  panels_.file_name.clear();
  if (std::exchange(panels_.saves_first, false) && !workspace_.unsaved()) go_on_without_saving();
}

void App::save_first() {
  panels_.saves_first = true;
  if (!project_.empty()) return save_from_dialog(project_);
  panels_.file_name.clear();
  panels_.dialog = Dialog::save;
}

void App::go_on_without_saving() {
  panels_.dialog = Dialog::none;
  if (panels_.after_unsaved.empty()) return quit();
  try_open(panels_.after_unsaved);
}

void App::recover(bool yes) {
  panels_.dialog = settings_.steps_seen ? Dialog::none : Dialog::steps;
  if (yes && !abandoned_.empty()) {
    const std::string path = abandoned_.front();
    if (const auto opened = open(path); !opened) {
      tell(opened.error().line(path), true);
      return;
    }
    tell("brought back the work of " + fs::path(path).stem().string());
  }
  for (const std::string& path : abandoned_) settle_session(path);
  abandoned_.clear();
}

void App::tell(std::string text, bool is_error) {
  const std::int64_t until = options_.clock() + k_notice_us;
  std::erase_if(notices_, [&](const Notice& one) { return one.text == text; });
  notices_.push_back({std::move(text), is_error, until});
  if (notices_.size() > k_most_notices) notices_.erase(notices_.begin());
}

void App::settings_changed() {
  if (const auto saved = save_settings(settings_, options_.folders.config); !saved) {
    tell("the settings cannot be kept: " + saved.error().line(options_.folders.config), true);
  }
}

double App::scale() const {
  const double dpi = dpi_ >= k_least_dpi && dpi_ <= k_most_dpi ? dpi_ : 96;
  return settings_.scale * dpi / 96;
}

double App::target_px() const {
  const double dpi = dpi_ >= k_least_dpi && dpi_ <= k_most_dpi ? dpi_ : 96;
  return std::ceil(k_target_mm / k_mm_per_inch * dpi * std::max(1.0, settings_.scale));
}

Area App::free_area() const { return free_; }

void App::set_free_area(const Area& area) {
  if (area == free_ || area.width() < 50 || area.height() < 50) return;
  free_ = area;
  if (framed_) frame_from(viewpoint_);
}

void App::advance() {
  const std::int64_t now = options_.clock();
  // A frame that took long does not make a recording jump: what its pen pressed has to be seen first.
  const std::int64_t passed = last_frame_us_ == 0 ? 0 : std::min(now - last_frame_us_, k_longest_step_us);
  last_frame_us_ = now;
  std::erase_if(notices_, [&](const Notice& one) { return one.until_us <= now; });
  if (tablet_near_ && !tablet_is_near()) tablet_near_ = false;
  commit_view();
  if (player_) {
    // A frame that took long must not swallow the trace: what is due is handed on report by report.
    const auto moments = player_->advance(workspace_, passed);
    if (player_->is_session()) {
      // What its pen did to panels and tools is in its lines, in px of the window that it was drawn in.
      view_.camera = workspace_.editor().view().camera;
      show_new_deformer();
    } else {
      take_moments(moments);
    }
  }
  if (playing_) play_on();
  if (panels_.swing) swing();
  workspace_.follow_pen();
}

void App::begin_frame() {
  advance();
  surface_.update(workspace_.shown_model(), workspace_.shown_pose());
  CurveLook look{static_cast<float>(scale()), highlighted_, {}, {}, panels_.onion_skin, panels_.time_s, {}, window_};
  if (panels_.controls_tab) look.deformer = panels_.deformer;
  if (target_drag_) {
    look.dragged = target_drag_->first;
    look.dragged_by = at_ - target_drag_->second;
  }
  curves_ = shown_curves(workspace_, surface_, look);
  if (file_ && file_->writer().broken() && !broken_told_) {
    broken_told_ = true;
    tell("this session is recorded no further: " + file_->writer().broken()->line(file_->path()), true);
  }
}

int App::next_frame_ms() const {
  if (quit_) return 0;
  if (playing_ || panels_.swing || !panel_pointer_.empty()) return k_playing_frame_ms;
  if (player_ && player_->playing()) {
    return static_cast<int>(std::clamp<std::int64_t>(player_->next_in_us() / 1000, 1, 1000));
  }
  if (notices_.empty()) return -1;
  std::int64_t first = notices_.front().until_us;
  for (const Notice& one : notices_) first = std::min(first, one.until_us);
  return static_cast<int>(std::max<std::int64_t>(1, (first - options_.clock()) / 1000 + 1));
}

void App::ask_to_open(const std::string& path) {
  if (!workspace_.unsaved()) return try_open(path);
  panels_.after_unsaved = path;
  panels_.dialog = Dialog::unsaved;
}

void App::ask_to_quit() {
  if (workspace_.unsaved() && panels_.dialog != Dialog::unsaved) {
    panels_.after_unsaved.clear();
    panels_.dialog = Dialog::unsaved;
    return;
  }
  quit_ = true;
}

void App::quit_at_once() {
  leaves_work_ = workspace_.unsaved();
  quit_ = true;
}

std::string App::hint() const {
  const document::Document& document = workspace_.document();
  const drawing::Tool& tool = workspace_.editor().tool();
  switch (tool.kind) {
    case drawing::ToolKind::pose:
      for (const auto& curve : document.curves) {
        if (curve->role == document::PoseCurveRole::reference && !curve->target) {
          return "Now draw where this curve should go: the face follows the pen";
        }
      }
      return "Draw along a feature of the face: a lip, a brow, an eyelid";
    case drawing::ToolKind::oversketch:
      return "Draw over the part of the last target that should change";
    case drawing::ToolKind::constraint:
      return "Draw along what should stay where it is";
    case drawing::ToolKind::pin:
      return "Touch a point that should stay where it is";
    case drawing::ToolKind::erase:
      return "Draw over curves to delete them";
    case drawing::ToolKind::articulate:
      if (!document.pending) return "1 of 4: draw around everything that a new control may move";
      switch (drawing::next_step(document, tool)) {
        case articulation::CurveRole::general:
          return "1 of 4: draw around everything that may move";
        case articulation::CurveRole::specific:
          return "2 of 4: draw around the part that moves fully";
        case articulation::CurveRole::reference:
          return "3 of 4: draw along the feature as it is now";
        case articulation::CurveRole::target:
          return tool.draw_reference ? "4 of 4: draw where the feature should go"
                                     : "4 of 4: draw where it should go (step 3, the feature, is found by itself)";
      }
      break;
    case drawing::ToolKind::none:
      return "Drag a target, touch a curve for what can be done with it, or the face to pick its control";
    case drawing::ToolKind::redraw:
      switch (tool.role) {
        case articulation::CurveRole::general:
          return "Draw around everything that " + tool.deformer + " may move";
        case articulation::CurveRole::specific:
          return "Draw around the part that " + tool.deformer + " moves fully";
        case articulation::CurveRole::reference:
          return "Draw along the feature that " + tool.deformer + " moves, as it is at rest";
        case articulation::CurveRole::target:
          return "Draw where " + tool.deformer + " should bring it";
      }
      break;
    default:
      break;
  }
  return {};
}

}  // namespace penpose::app
