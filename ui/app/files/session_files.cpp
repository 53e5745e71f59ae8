#include "ui/app/files/session_files.h"

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

#include "replay/session/session_line.h"
#include "replay/trace/trace_reader.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/poses/pose_folder.h"
#include "ui/files/session_model.h"
#include "ui/files/trace_file.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_extension = ".session";
constexpr const char* k_lock = ".open";

std::string below_home(const char* variable, const char* usual) {
  const char* given = std::getenv(variable);
  if (given != nullptr && given[0] == '/') return std::string(given) + "/penpose";
  const char* home = std::getenv("HOME");
  if (home == nullptr || home[0] != '/') return {};
  return std::string(home) + "/" + usual + "/penpose";
}

/// Takes the lock of a session; -1 where another program has it.
int take_lock(const std::string& path, int flags) {
  const int file = ::open((path + k_lock).c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | flags, 0666);
  if (file < 0) return -1;
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  ::close(file);
  return -1;
}

/// The state after its last stroke or command; empty where there is none. Errors: it cannot be read to its end.
base::Result<std::string> last_state(const std::string& path) {
  constexpr std::string_view k_start = "# penpose state ";
  const auto file = files::open_plain(path);
  if (!file) return file.error();
  replay::TraceReader lines(files::read_from_file(file->get()));
  std::string state;
  for (;;) {
    const auto line = lines.next();
    if (!line) return line.error();
    if (!*line) return state;
    std::string_view text = (*line)->text;
    if (!text.starts_with(k_start)) continue;
    text.remove_prefix(k_start.size());
    state = text.substr(0, text.find(' '));
  }
}

struct Note {
  std::string project;
  std::string state;
};

Note note_of(const std::string& path) {
  const auto bytes = files::read_plain_file(path + k_lock, files::k_most_settings_bytes);
  if (!bytes) return {};
  const std::string_view text = base::as_text(*bytes);
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view rest = text.substr(std::min(end + 1, text.size()));
  return {std::string(text.substr(0, end)), std::string(rest.substr(0, rest.find('\n')))};
}

void remove_quietly(const std::string& path) {
  std::error_code code;
  fs::remove(path, code);
}

}  // namespace

Folders standard_folders() {
  return {below_home("XDG_STATE_HOME", ".local/state"), below_home("XDG_CONFIG_HOME", ".config"),
          files::usual_pose_folder(), below_home("XDG_CACHE_HOME", ".cache")};
}

SessionFile::SessionFile(std::string path, files::AppendFile file, const std::string& program)
    : path_(std::move(path)),
      file_(std::move(file)),
      writer_([this](std::string_view text, bool sync) { return file_.append(text, sync); }, program) {}

base::Result<std::unique_ptr<SessionFile>> SessionFile::create(const std::string& path, const std::string& program) {
  auto file = files::AppendFile::create_new(path);
  if (!file) return file.error();
  std::unique_ptr<SessionFile> made(new SessionFile(path, std::move(*file), program));
  made->lock_ = take_lock(path, O_CREAT);
  return made;
}

base::Result<std::unique_ptr<SessionFile>> SessionFile::create_in(const std::string& folder, const std::string& stem,
                                                                  const std::string& program) {
  std::error_code code;
  fs::create_directories(folder, code);
  // Two programs may begin within one second.
  constexpr int k_tries = 20;
  base::Result<std::unique_ptr<SessionFile>> made = base::Error{};
  for (int i = 0; i < k_tries; ++i) {
    made = create(free_path(folder, stem, k_extension), program);
    if (made) break;
  }
  return made;
}

base::Result<std::unique_ptr<SessionFile>> SessionFile::resume(const std::string& path, const std::string& program) {
  const int lock = take_lock(path, O_CREAT);
  if (lock < 0) return base::Error{"this session is open in another window", "", "close that one first"};
  auto file = files::AppendFile::go_on(path);
  if (!file) {
    ::close(lock);
    return file.error();
  }
  std::unique_ptr<SessionFile> made(new SessionFile(path, std::move(*file), program));
  made->lock_ = lock;
  return made;
}

void SessionFile::note_project(const std::string& project, const std::string& state) {
  if (lock_ < 0 || project.find('\n') != std::string::npos) return;
  const std::string text = project + "\n" + state + "\n";
  static_cast<void>(::ftruncate(lock_, 0) == 0 &&
                    ::pwrite(lock_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size()));
}

base::Status SessionFile::keep_model(const std::string& model) {
  const std::string copy = files::kept_model_of(path_, model);
  std::error_code code;
  if (fs::exists(copy, code)) return base::Done{};
  const auto bytes = files::read_plain_file(model);
  // A file that is gone is not written over.
  if (!bytes) return fs::exists(model, code) ? bytes.error() : base::Status(base::Done{});
  if (auto written = files::write_file(copy, *bytes); !written) return written;
  model_copy_ = copy;
  return base::Done{};
}

std::string project_of_session(const std::string& path) { return note_of(path).project; }

std::string work_of_session(const std::string& path) {
  std::string work = project_of_session(path);
  const auto file = files::open_plain(path);
  if (work.empty() && file) {
    // The model is named in one of the first lines.
    constexpr int k_lines = 8;
    replay::TraceReader lines(files::read_from_file(file->get()));
    for (int i = 0; i < k_lines && work.empty(); ++i) {
      const auto line = lines.next();
      if (!line || !*line) break;
      const std::string_view text = (*line)->text;
      const auto said = replay::parse_session_line(text.substr(text.starts_with("# ") ? 2 : 0));
      if (!said || !*said) continue;
      if (const auto* model = std::get_if<replay::ModelNamed>(&**said)) work = model->path;
    }
  }
  return fs::path(files::model_name(work).file).filename().string();
}

SessionFile::~SessionFile() {
  static_cast<void>(writer_.flush(true));
  if (lock_ >= 0) ::close(lock_);
}

void SessionFile::finish(bool keep) {
  static_cast<void>(writer_.flush(true));
  if (!keep) remove_quietly(path_);
  if (!keep && !model_copy_.empty()) remove_quietly(model_copy_);
  remove_quietly(path_ + k_lock);
}

std::vector<std::string> past_sessions(const std::string& folder) {
  std::vector<std::string> found;
  std::error_code code;
  for (fs::directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
    std::error_code unknown;
    if (it->path().extension() == k_extension && it->is_regular_file(unknown)) found.push_back(it->path().string());
  }
  std::sort(found.rbegin(), found.rend());
  return found;
}

std::vector<std::string> abandoned_sessions(const std::string& folder) {
  std::vector<std::string> found;
  for (const std::string& path : past_sessions(folder)) {
    std::error_code code;
    if (!fs::exists(path + k_lock, code)) continue;
    const int lock = take_lock(path, 0);
    if (lock < 0) continue;
    ::close(lock);
    const auto state = last_state(path);
    // What cannot be read now may hold work all the same.
    if (!state) continue;
    if (state->empty()) remove_quietly(path);
    if (state->empty() || *state == note_of(path).state) {
      remove_quietly(path + k_lock);
    } else {
      found.push_back(path);
    }
  }
  return found;
}

bool is_open_session(const std::string& path) {
  std::error_code code;
  return !path.empty() && fs::exists(path + k_lock, code);
}

void settle_session(const std::string& path) { remove_quietly(path + k_lock); }

std::string free_path(const std::string& folder, const std::string& stem, const std::string& extension) {
  std::error_code code;
  std::string path = (fs::path(folder) / (stem + extension)).string();
  for (int i = 2; fs::exists(path, code); ++i) {
    path = (fs::path(folder) / (stem + "-" + std::to_string(i) + extension)).string();
  }
  return path;
}

}  // namespace penpose::app
