#include "ui/app/film/film_job.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include "core/base/numbers.h"
#include "ui/files/files.h"
#include "ui/files/save_model.h"
#include "ui/film/ffmpeg.h"
#include "ui/film/film_sound.h"
#include "ui/film/frame_name.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX asks for it

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

std::string camera_text(const geometry::CameraPose& camera) {
  std::string text = "{";
  const auto add = [&](const char* name, const auto& p) {
    text.append("\"").append(name).append("\":[").append(base::format_double(p.x)).append(",");
    text.append(base::format_double(p.y)).append(",").append(base::format_double(p.z)).append("],");
  };
  add("eye", camera.eye);
  add("look_at", camera.look_at);
  add("up", camera.up);
  text.append("\"vertical_fov_degrees\":").append(base::format_double(camera.vertical_fov_degrees));
  return text.append("}\n");
}

std::string size_text(geometry::Viewport size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

base::Status write_text(const std::string& path, const std::string& text) {
  return files::write_file(path, std::vector<std::uint8_t>(text.begin(), text.end()));
}

/// The command that makes it of what lies in a folder.
std::vector<std::string> words_of(const FilmOrder& order, const std::string& folder) {
  const film::PxPart& part = order.view.part;
  std::vector<std::string> words{
      order.program,
      "film",
      folder + "/model.glb",
      "--progress",
      "--fps",
      std::to_string(order.rate),
      "--from",
      std::to_string(order.from),
      "--to",
      std::to_string(order.to),
      "--size",
      size_text(order.view.whole),
      "--crop",
      size_text(part.size) + "+" + std::to_string(part.left) + "+" + std::to_string(part.top)};
  const auto add = [&](std::initializer_list<std::string> more) { words.insert(words.end(), more); };
  // The camera of the timeline is the program's own choice.
  if (!order.moves) add({"--camera", folder + "/camera.json"});
  if (order.kind == film::FilmKind::sheet) add({"--sheet", order.every ? std::to_string(*order.every) : "keys"});
  if (order.numbers) add({"--numbers"});
  if (order.wireframe) add({"--wireframe"});
  if (order.clay) add({"--clay"});
  if (order.matcap) add({"--matcap"});
  if (order.shadows) add({"--shadows"});
  if (order.light) add({"--light"});
  if (order.ghosts) {
    add({"--onion", std::to_string(order.ghosts->before) + "," + std::to_string(order.ghosts->after)});
    if (order.ghosts->steps == render::GhostSteps::frames) add({"--onion-every", std::to_string(order.ghosts->every)});
    if (order.ghosts->style == render::GhostStyle::faces) add({"--onion-faces"});
  }
  if (order.sound == nullptr) {
    add({"--silent"});
  } else {
    add({"--sound", folder + "/sound.wav", "--sound-offset",
         base::format_double(static_cast<double>(order.from) / order.rate)});
  }
  add({"-o", order.output});
  return words;
}

}  // namespace

base::Result<FilmJob> FilmJob::start(const document::Document& document, const FilmOrder& order) {
  const auto keyed = [](const document::Document* one) {
    return !one->timeline->keys.empty() || one->camera != nullptr;
  };
  if (!keyed(&document) && std::none_of(order.documents.begin(), order.documents.end(), keyed))
    return base::Error{"there is nothing to film", "", "key a pose first"};
  if (film::row_of(order.kind).needs_ffmpeg && !film::has_ffmpeg()) return film::no_ffmpeg();
  FilmJob job;
  job.order_ = order;
  job.order_.moves = document.camera != nullptr;
  std::error_code code;
  std::string folder = (fs::temp_directory_path(code) / "penpose-film-XXXXXX").string();
  if (code || ::mkdtemp(folder.data()) == nullptr) {
    return base::Error{"there is no place for the pictures of the film", "", "set TMPDIR to a folder with room"};
  }
  job.folder_ = folder;
  const std::string model = folder + "/model.glb";
  const auto saved = order.documents.empty() ? files::save_document(document, model, files::SaveNotes::quiet)
                                             : files::save_cast(order.characters, order.documents, model);
  if (!saved) return saved.error();
  job.order_.documents.clear();
  if (auto written = write_text(folder + "/camera.json", camera_text(order.view.camera)); !written)
    return written.error();
  if (!film::row_of(order.kind).sounds) job.order_.sound = nullptr;
  if (job.order_.sound != nullptr) {
    const auto frames = static_cast<std::size_t>(std::max(0, order.to - order.from)) + 1;
    const auto part = film::sound_of_frames(*order.sound, order.sound_offset_s, order.from, frames, order.rate);
    if (!part) return part.error();
    const auto bytes = film::wav_bytes(*part);
    if (auto written = files::write_file(folder + "/sound.wav", bytes); !written) return written.error();
  }
  if (auto began = job.run(words_of(job.order_, folder)); !began) return began.error();
  // It lives no longer than this call.
  job.order_.sound = nullptr;
  return job;
}

FilmJob::FilmJob(FilmJob&& other) noexcept
    : order_(std::move(other.order_)),
      folder_(std::exchange(other.folder_, {})),
      process_(std::exchange(other.process_, -1)),
      says_(std::exchange(other.says_, -1)),
      heard_(std::move(other.heard_)),
      progress_(other.progress_),
      cancelled_(other.cancelled_) {}

FilmJob::~FilmJob() {
  // It tidies up by itself; nobody waits for that.
  if (process_ > 0 && ::waitpid(process_, nullptr, WNOHANG) == 0) ::kill(process_, SIGTERM);
  if (says_ >= 0) ::close(says_);
  std::error_code code;
  if (!folder_.empty()) fs::remove_all(folder_, code);
}

std::string FilmJob::written() const {
  if (order_.kind != film::FilmKind::pictures) return order_.output;
  return film::frame_name(order_.output, static_cast<std::size_t>(order_.from)) + " and on";
}

void FilmJob::cancel() {
  if (process_ > 0 && !std::exchange(cancelled_, true)) ::kill(process_, SIGTERM);
}

base::Status FilmJob::run(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT: POSIX's type
  arguments.push_back(nullptr);
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    return base::Error{"the film could not be begun (" + std::string(std::strerror(errno)) + ")", "",
                       "close other programs"};
  }
  says_ = ends[0];
  ::fcntl(says_, F_SETFL, O_NONBLOCK);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const std::string log = folder_ + "/log";
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  // The window's own driver is none for pictures without a window.
  std::vector<char*> variables;
  for (char** one = environ; *one != nullptr; ++one) {
    if (std::strncmp(*one, "SDL_VIDEODRIVER=", 16) != 0) variables.push_back(*one);
  }
  variables.push_back(nullptr);
  const int failed =
      ::posix_spawnp(&process_, arguments.front(), &actions, nullptr, arguments.data(), variables.data());
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (failed == 0) return base::Done{};
  process_ = -1;
  return base::Error{words.front() + " could not be started (" + std::strerror(failed) + ")", "", "install it anew"};
}

void FilmJob::read_progress() {
  char block[4096];
  for (ssize_t got = 0; (got = ::read(says_, block, sizeof block)) > 0;) {
    heard_.append(block, static_cast<std::size_t>(got));
  }
  const std::size_t end = heard_.rfind('\n');
  if (end == std::string::npos) return;
  const std::size_t begin = end == 0 ? 0 : heard_.rfind('\n', end - 1) + 1;
  FilmProgress now;
  if (std::sscanf(heard_.c_str() + begin, "%zu %zu", &now.done, &now.all) == 2) progress_ = now;
  heard_.erase(0, end + 1);
}

base::Error FilmJob::failed() const {
  const auto log = files::read_plain_file(folder_ + "/log", files::k_most_settings_bytes);
  std::string why = log ? std::string(log->begin(), log->end()) : std::string();
  while (!why.empty() && why.back() == '\n') why.pop_back();
  why = why.substr(why.rfind('\n') + 1);
  // As it stands on a command line, the program and the file are named first.
  for (const std::string& head : {std::string("penpose: "), order_.output + ": "}) {
    if (why.starts_with(head)) why.erase(0, head.size());
  }
  if (!why.empty()) return {"the film could not be made (" + why + ")", "", ""};
  return {"the film could not be made", "", "look whether there is room on the disk, or write pictures (.png)"};
}

std::optional<base::Status> FilmJob::advance() {
  read_progress();
  int status = 0;
  const pid_t ended = process_ > 0 ? ::waitpid(process_, &status, WNOHANG) : 0;
  if (ended == 0) return std::nullopt;
  process_ = -1;
  if (ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    cancelled_ = false;
    return base::Status(base::Done{});
  }
  return base::Status(failed());
}

}  // namespace penpose::app
