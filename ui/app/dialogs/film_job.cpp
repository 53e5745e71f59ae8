#include "ui/app/dialogs/film_job.h"

#include <cerrno>
#include <csignal>
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
#include "ui/files/process/own_program.h"
#include "ui/files/save_model.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX asks for it

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

bool is_film(const std::string& output) { return fs::path(output).extension() == ".mp4"; }

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

/// Where a film is written before it takes the place of the one that was there.
std::string unfinished(const std::string& output) {
  const fs::path path(output);
  std::string name(".");
  name.append(path.stem().string()).append(".unfinished.mp4");
  return (path.parent_path() / name).string();
}

base::Status write_text(const std::string& path, const std::string& text) {
  return files::write_file(path, std::vector<std::uint8_t>(text.begin(), text.end()));
}

}  // namespace

bool has_ffmpeg() {
  const char* path = std::getenv("PATH");
  std::string_view folders = path != nullptr ? path : "";
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    const std::string file = std::string(folders.substr(0, end)) + "/ffmpeg";
    if (end > 0 && ::access(file.c_str(), X_OK) == 0) return true;
    folders.remove_prefix(std::min(end + 1, folders.size()));
  }
  return false;
}

base::Result<FilmJob> FilmJob::start(const document::Document& document, const FilmOrder& order) {
  if (document.timeline->keys.empty()) {
    return base::Error{"there is nothing to film", "", "key a pose first"};
  }
  if (is_film(order.output) && !has_ffmpeg()) {
    return base::Error{"an .mp4 film needs ffmpeg, which is not installed", "",
                       "install the package ffmpeg, or write pictures (.png)"};
  }
  FilmJob job;
  job.order_ = order;
  std::error_code code;
  std::string folder = (fs::temp_directory_path(code) / "penpose-film-XXXXXX").string();
  if (code || ::mkdtemp(folder.data()) == nullptr) {
    return base::Error{"there is no place for the pictures of the film", "", "set TMPDIR to a folder with room"};
  }
  job.folder_ = folder;
  // The clip that is shown, which then is the first animation.
  document::Document shown = document;
  shown.clips.clear();
  if (auto saved = files::save_document(shown, folder + "/model.glb", files::SaveNotes::quiet); !saved) {
    return saved.error();
  }
  if (auto written = write_text(folder + "/camera.json", camera_text(order.camera)); !written) return written.error();
  const std::string size = std::to_string(order.size.width) + "x" + std::to_string(order.size.height);
  const std::string pictures =
      is_film(order.output) ? folder + "/####.png" : fs::path(order.output).replace_extension("").string() + "####.png";
  const auto began =
      job.run({files::own_program(), "render", folder + "/model.glb", "--frames", "--fps", std::to_string(order.rate),
               "--size", size, "--camera", folder + "/camera.json", "-o", pictures});
  if (!began) return began.error();
  return job;
}

FilmJob::FilmJob(FilmJob&& other) noexcept
    : order_(std::move(other.order_)),
      folder_(std::exchange(other.folder_, {})),
      process_(std::exchange(other.process_, -1)),
      joins_(other.joins_) {}

FilmJob::~FilmJob() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  std::error_code code;
  if (!folder_.empty()) {
    fs::remove_all(folder_, code);
    if (joins_) fs::remove(unfinished(order_.output), code);
  }
}

base::Status FilmJob::run(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT: POSIX's type
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
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
  if (failed == 0) return base::Done{};
  process_ = -1;
  return base::Error{words.front() + " could not be started (" + std::strerror(failed) + ")", "",
                     "install it anew, or write pictures (.png)"};
}

std::optional<base::Status> FilmJob::advance() {
  int status = 0;
  const pid_t ended = process_ > 0 ? ::waitpid(process_, &status, WNOHANG) : 0;
  if (ended == 0) return std::nullopt;
  process_ = -1;
  if (ended < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    const auto log = files::read_plain_file(folder_ + "/log", files::k_most_settings_bytes);
    std::string why = log ? std::string(log->begin(), log->end()) : std::string();
    while (!why.empty() && why.back() == '\n') why.pop_back();
    why = why.substr(why.rfind('\n') + 1);
    return base::Status(base::Error{"the film could not be made" + (why.empty() ? "" : " (" + why + ")"), "",
                                    "look whether there is room on the disk, or write pictures (.png)"});
  }
  if (joins_) {
    std::error_code code;
    fs::rename(unfinished(order_.output), order_.output, code);
    if (!code) return base::Status(base::Done{});
    return base::Status(base::Error{"the film cannot be put at its place (" + code.message() + ")", "",
                                    "look whether the folder may be written to"});
  }
  if (!is_film(order_.output)) return base::Status(base::Done{});
  joins_ = true;
  const auto began =
      run({"ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-framerate", std::to_string(order_.rate), "-i",
           folder_ + "/%04d.png", "-pix_fmt", "yuv420p", "-movflags", "+faststart", unfinished(order_.output)});
  if (!began) return began;
  return std::nullopt;
}

}  // namespace penpose::app
