#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"
#include "core/base/version.h"
#include "replay/session/session_player.h"
#include "replay/session/session_recorder.h"
#include "ui/cli/live_option.h"
#include "ui/cli/number_range.h"
#include "ui/cli/pose/tolerance_option.h"
#include "ui/cli/progress.h"
#include "ui/cli/subcommand.h"
#include "ui/cli/tablet/tablet_options.h"
#include "ui/files/append_file.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"
#include "ui/files/session_model.h"
#include "ui/files/trace_file.h"
#include "ui/live/live.h"
#include "ui/render/appearance.h"
#include "ui/render/document_curves.h"
#include "ui/render/renderer.h"

namespace penpose::cli {
namespace {

using json::Json;
using Clock = std::chrono::steady_clock;

constexpr std::size_t k_longest_name = 4096;
/// Of what came out differently, and of what could not be drawn; --json lists all.
constexpr std::size_t k_most_lines = 40;

struct ReplayArguments {
  io::WriteOptions glb;
  std::string session;
  std::string model;
  std::string output;
  std::string picture;
  std::string record;
  files::OwnTablets own;
  std::string live;
  std::optional<std::size_t> strokes;
  bool real_time = false;
  bool by_today = false;
  bool json = false;
};

/// Where the session's model is: where the user says, or where it can be found.
std::string find_model(const ReplayArguments& arguments, const std::string& path) {
  return arguments.model.empty() ? files::find_session_model(arguments.session, path) : arguments.model;
}

base::Result<document::Document> open_model(const ReplayArguments& arguments, const std::string& path) {
  const std::string name = find_model(arguments, path);
  const std::string file = files::model_name(name).file;
  std::error_code code;
  const files::NamedBy named = arguments.model.empty() ? files::NamedBy::file : files::NamedBy::user;
  if (named == files::NamedBy::file && !name.starts_with("builtin:") && !std::filesystem::is_regular_file(file, code)) {
    return base::Error{"there is no model \"" + name + "\"", "", "name it with --model"};
  }
  for (const std::string& output : {arguments.output, arguments.picture}) {
    if (output.empty() || !files::same_file(file, output)) continue;
    return base::Error{"the model \"" + name + "\" is what the session was drawn on and is not written over", "",
                       "choose another name"};
  }
  auto document = files::load_document(name, named);
  if (!document) {
    base::Error error = document.error();
    error.what = "the model \"" + name + "\" cannot be read: " + error.what;
    return error;
  }
  return document;
}

/// Counts steps on a terminal, tells of every pose and hands everything on to a recorder.
class Watcher final : public replay::PlayerObserver {
 public:
  Watcher(std::uintmax_t file_size, std::FILE* file, live::Listener live, replay::PlayerObserver* next)
      : progress_("replaying", file_size), file_(file), live_(std::move(live)), next_(next) {}

  void on_begin(replay::Session& session, const std::string& path) override {
    if (next_ != nullptr) next_->on_begin(session, path);
  }
  void on_device(int device, const decode::DeviceIdentity& identity) override {
    if (next_ != nullptr) next_->on_device(device, identity);
  }
  void on_report(const replay::TraceReport& report) override {
    if (next_ != nullptr) next_->on_report(report);
  }
  void on_line(const replay::SessionLine& line) override {
    if (next_ != nullptr) next_->on_line(line);
  }
  void on_stroke_end() override {
    if (next_ != nullptr) next_->on_stroke_end();
  }
  void on_step(replay::Session& session, const replay::SessionStep& step) override {
    if (next_ != nullptr) next_->on_step(session, step);
    const document::Document& document = session.editor().document();
    live_({document.model->rig->parameters(), document.pose,
           std::chrono::duration<double>(Clock::now().time_since_epoch()).count()});
    const long at = std::ftell(file_);
    if (at <= shown_) return;
    progress_.advance(static_cast<std::size_t>(at - shown_));
    shown_ = at;
  }

 private:
  Progress progress_;
  std::FILE* file_;
  live::Listener live_;
  replay::PlayerObserver* next_;
  long shown_ = 0;
};

/// A session may say any size of its window; a picture has no more pixels than can be drawn in a few seconds.
geometry::Viewport picture_size(geometry::Viewport window) {
  constexpr double k_most_px = 6e6;
  constexpr double k_longest_px = 8192;
  const double shrink = std::min({1.0, std::sqrt(k_most_px / window.width / window.height), k_longest_px / window.width,
                                  k_longest_px / window.height});
  if (shrink >= 1) return window;
  return {std::max(1, static_cast<int>(window.width * shrink)), std::max(1, static_cast<int>(window.height * shrink))};
}

base::Status write_picture(const replay::Session& session, const std::string& path) {
  const document::Document& document = session.editor().document();
  const document::View& view = session.editor().view();
  const auto camera = geometry::Camera::make(view.camera, picture_size(view.viewport));
  if (!camera) return camera.error();
  auto renderer = render::make_offscreen_renderer();
  if (!renderer) return renderer.error();
  const document::Model model = document::model_of(document);
  const render::Appearance appearance = render::make_appearance(model, {});
  const render::PosedMesh posed = render::posed_mesh(model);
  const auto curves = render::document_curves(document);
  render::Scene scene = render::scene_of(model, posed, appearance);
  scene.curves = curves;
  const auto image = (*renderer)->render(scene, *camera);
  if (!image) return image.error();
  const auto png = render::encode_png(*image);
  if (!png) return png.error();
  return files::write_file(path, *png);
}

Json to_json(const replay::RedrawnSession& redrawn) {
  using replay::CameOut;
  Json steps = Json::array();
  for (const replay::RedrawnStep& step : redrawn.steps) {
    Json one = {{"line", step.line}, {"step", step.what}, {"came_out", std::string(replay::name_of(step.came_out))}};
    if (step.stroke > 0) one["stroke"] = step.stroke;
    for (const std::string_view part : step.parts) one["parts"].push_back(std::string(part));
    for (const std::string_view part : step.since) one["since"].push_back(std::string(part));
    if (!step.reason.empty()) one["reason"] = step.reason;
    steps.push_back(std::move(one));
  }
  return {{"edition", redrawn.edition},
          {"same_model", !redrawn.other_model},
          {"strokes", redrawn.strokes},
          {"equal", redrawn.count(CameOut::equal)},
          {"different", redrawn.count(CameOut::differently)},
          {"not_drawn", redrawn.count(CameOut::not_drawn)},
          {"not_compared", redrawn.count(CameOut::not_compared)},
          {"steps", std::move(steps)}};
}

Json to_json(const ReplayArguments& arguments, const replay::ReplayResult& played, double seconds) {
  Json out = {{"model", find_model(arguments, played.model)},
              {"plain", played.plain},
              {"reports", played.reports},
              {"strokes", played.session->stroke_count()},
              {"steps", played.steps},
              {"refused", played.refused},
              {"checked", played.checked},
              {"differing", played.differing},
              {"recorded_s", static_cast<double>(played.last_us - played.first_us) * 1e-6},
              {"replay_s", seconds}};
  if (played.divergence) {
    Json parts = Json::array();
    for (const std::string_view part : played.divergence->parts) parts.push_back(std::string(part));
    out["divergence"] = {{"line", played.divergence->line}, {"parts", std::move(parts)}};
  }
  if (played.redrawn) out["by_today"] = to_json(*played.redrawn);
  const document::Document& document = played.session->editor().document();
  Json parameters = Json::object();
  const auto known = document.model->rig->parameters();
  for (std::size_t i = 0; i < known.size(); ++i) parameters[known[i].name] = document.pose[i];
  out["parameters"] = std::move(parameters);
  out["curves"] = document.curves.size();
  out["keys"] = document.timeline->keys.size();
  out["state"] = played.session->editor().state().whole.hex();
  return out;
}

void print(const ReplayArguments& arguments, const replay::ReplayResult& played, double seconds) {
  const document::Document& document = played.session->editor().document();
  const std::size_t deformers = document.model->deformers ? document.model->deformers->size() : 0;
  std::cout << (played.plain ? "plain trace" : "session") << " on "
            << base::shown_name(find_model(arguments, played.model), k_longest_name) << ": " << played.reports
            << " reports, " << played.session->stroke_count() << " strokes, " << played.steps << " steps, of which "
            << played.refused << " changed nothing\n"
            << "now: " << deformers << " deformers, " << document.curves.size() << " curves, "
            << document.timeline->keys.size() << " keys\n"
            << "state " << played.session->editor().state().whole.hex();
  if (played.checked > 0) {
    std::cout << "; " << (played.checked - played.differing) << " of " << played.checked << " recorded states equal";
  }
  std::cout << "\n"
            << base::format_fixed(static_cast<double>(played.last_us - played.first_us) * 1e-6, 1)
            << " s of drawing replayed in " << base::format_fixed(seconds, 2) << " s\n";
}

/// What came out otherwise than it was recorded.
void print(const replay::RedrawnSession& redrawn) {
  std::cout << replay::summary_of(redrawn) << '\n';
  if (redrawn.other_model) std::cout << "the model is not in the state in which the session began\n";
  std::size_t lines = 0;
  for (const replay::RedrawnStep& step : redrawn.steps) {
    const std::string text = replay::text_of(step);
    if (!text.empty() && ++lines <= k_most_lines) std::cout << "  " << text << '\n';
  }
  if (lines > k_most_lines) std::cout << "  and " << lines - k_most_lines << " more, which --json lists\n";
}

/// Steps that could not be drawn are what failed.
int report_not_drawn(const replay::RedrawnSession& redrawn, const std::string& session) {
  std::size_t lines = 0;
  for (const replay::RedrawnStep& step : redrawn.steps) {
    if (step.came_out != replay::CameOut::not_drawn || ++lines > k_most_lines) continue;
    const std::string number = step.stroke > 0 ? " " + std::to_string(step.stroke) : "";
    std::cerr << "penpose: "
              << base::Error{step.what + number + " could not be drawn by today: " + step.reason,
                             "line " + std::to_string(step.line), "draw what it did anew"}
                     .line(session)
              << '\n';
  }
  return redrawn.count(replay::CameOut::not_drawn) > 0 ? k_failure : k_success;
}

/// No file that is written is one that is read, or one of the others.
base::Status take_roles(const ReplayArguments& arguments, files::FileRoles& files, std::string& blamed) {
  for (const std::string& path : {arguments.session, arguments.model, arguments.own.file}) files.reads(path);
  const std::pair<const std::string&, const char*> outputs[] = {
      {arguments.output, "-o"}, {arguments.picture, "--png"}, {arguments.record, "--session"}};
  for (const auto& [path, option] : outputs) {
    if (path.empty()) continue;
    blamed = path;
    if (auto fits = files.writes(path, option); !fits) return fits;
  }
  return base::Done{};
}

int replay_session(const ReplayArguments& arguments) {
  files::FileRoles files;
  std::string blamed;
  if (const auto fits = take_roles(arguments, files, blamed); !fits) return files::report(fits.error(), blamed);
  const auto own = files::read_own_tablets(arguments.own);
  if (!own) return files::report(own.error());
  const auto file = files::open_trace(arguments.session);
  if (!file) return files::report(file.error(), arguments.session);
  auto live = live::open_live_output(arguments.live, live::live_outputs());
  if (!live) return files::report(live.error());
  std::optional<files::AppendFile> record;
  std::optional<replay::SessionWriter> writer;
  std::optional<replay::SessionRecorder> recorder;
  if (!arguments.record.empty()) {
    auto made = files::AppendFile::create_new(arguments.record);
    if (!made) return files::report(made.error(), arguments.record);
    record.emplace(std::move(made).value());
    writer.emplace([&](std::string_view text, bool sync) { return record->append(text, sync); },
                   "penpose-" + std::string(base::k_version));
    recorder.emplace(*writer, [&](const std::string& path) { return find_model(arguments, path); });
  }
  std::error_code code;
  const auto size = std::filesystem::file_size(arguments.session, code);
  Watcher watcher(code ? 0 : size, file->get(), std::move(live).value(), recorder ? &*recorder : nullptr);

  replay::PlayerOptions options;
  options.pace = arguments.real_time ? replay::Pace::real_time : replay::Pace::full_speed;
  options.open = [&](const std::string& path) { return open_model(arguments, path); };
  options.stop_after_strokes = arguments.strokes;
  options.by_today = arguments.by_today;
  options.may_differ = [&](const std::string& path) {
    return !arguments.model.empty() || files::changes_with_editions(find_model(arguments, path));
  };
  options.own_tablets = &*own;
  options.observer = &watcher;
  const Clock::time_point start = Clock::now();
  const auto played = replay::play_session(files::read_recording_file(file->get()), options);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (!played) return files::report(played.error(), arguments.session);
  if (!played->session) {
    return files::report({"holds nothing to replay: neither reports nor lines of a session", "",
                          "give a session, or a trace as hid-recorder or `penpose record` writes it"},
                         arguments.session);
  }
  int status = k_success;
  for (const auto& problem : played->problems) std::cerr << "penpose: " << problem.line(arguments.session) << '\n';
  if (played->redrawn) status = report_not_drawn(*played->redrawn, arguments.session);
  for (const auto& refusal : played->redrawn ? std::vector<base::Error>() : played->refusals)
    std::cerr << "penpose: " << refusal.line(arguments.session) << '\n';
  for (const auto& guess : played->session->pens().guesses()) files::warn(files::guess_note(guess), arguments.session);
  if (arguments.strokes && played->session->stroke_count() < *arguments.strokes) {
    files::warn("it has no more than " + std::to_string(played->session->stroke_count()) + " strokes",
                arguments.session);
  }
  if (!arguments.output.empty()) {
    if (auto saved = files::save_document(played->session->editor().document(), arguments.output,
                                          files::SaveNotes::loud, arguments.glb);
        !saved) {
      return files::report(saved.error(), arguments.output);
    }
  }
  if (!arguments.picture.empty()) {
    if (auto drawn = write_picture(*played->session, arguments.picture); !drawn) {
      return files::report(drawn.error(), arguments.picture);
    }
  }
  if (arguments.json) {
    std::cout << to_json(arguments, *played, seconds).dump_as_made() << '\n';
  } else {
    print(arguments, *played, seconds);
    if (played->redrawn) print(*played->redrawn);
  }
  if (writer) {
    // What could not be written down is still here, and was saved where it was asked for.
    if (const auto flushed = writer->flush(true); !flushed) status = files::report(flushed.error(), arguments.record);
  }
  return played->divergence ? files::report(replay::error_of(*played->divergence), arguments.session) : status;
}

void add_options(const Command& command, ReplayArguments& arguments) {
  command.add_option("SESSION", arguments.session, "Session, or any recording of a tablet that decode reads")
      .required();
  command.add_option("--model", arguments.model, "Model to draw on, when it is not where the session says");
  command.add_option("-o,--output", arguments.output, "Project or model file to write at the end (.glb, .gltf, .obj)");
  command.add_option("--png", arguments.picture, "PNG file of the last view");
  command.add_option("--stroke", arguments.strokes, "Stop after so many strokes")
      .check(whole_range(0, 1'000'000'000), "0 to 1000000000");
  add_live_option(command, arguments.live);
  command.add_flag("--realtime", arguments.real_time, "At the pace of the recording");
  command.add_option("--session", arguments.record, "Write the replay down as a session of its own");
  command.add_flag("--by-today", arguments.by_today,
                   "Draw a session of an older edition with today's reading, and say which steps come out differently");
  add_tablet_options(command, arguments.own);
  command.add_flag("--json", arguments.json, "Print one JSON object");
  add_tolerance_option(command, arguments.glb);
}

}  // namespace

Subcommand replay_subcommand() {
  return subcommand<ReplayArguments>(
      "replay", files::Rights::no_programs, "Draws a recorded session, or a plain trace, again", add_options,
      replay_session, {"penpose replay drawn.session -o face.glb --png face.png", "the project and a picture of it"},
      {"penpose replay drawn.session --stroke 3 --json", "what it was after three strokes"});
}

}  // namespace penpose::cli
