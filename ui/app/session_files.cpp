#include "ui/app/session_files.h"

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

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
  const int file = ::open((path + k_lock).c_str(), O_RDWR | O_CLOEXEC | flags, 0666);
  if (file < 0) return -1;
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  ::close(file);
  return -1;
}

/// Whether a stroke or a command is in it.
bool holds_work(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    if (line.starts_with("# penpose state")) return true;
  }
  return false;
}

void remove_quietly(const std::string& path) {
  std::error_code code;
  fs::remove(path, code);
}

}  // namespace

Folders standard_folders() {
  return {below_home("XDG_STATE_HOME", ".local/state"), below_home("XDG_CONFIG_HOME", ".config")};
}

SessionFile::SessionFile(std::string path, cli::AppendFile file, const std::string& program)
    : path_(std::move(path)),
      file_(std::move(file)),
      writer_([this](std::string_view text, bool sync) { return file_.append(text, sync); }, program) {}

base::Result<std::unique_ptr<SessionFile>> SessionFile::create(const std::string& path, const std::string& program) {
  auto file = cli::AppendFile::create_new(path);
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

SessionFile::~SessionFile() {
  static_cast<void>(writer_.flush(true));
  if (lock_ >= 0) ::close(lock_);
}

void SessionFile::finish(bool keep) {
  static_cast<void>(writer_.flush(true));
  if (!keep) remove_quietly(path_);
  remove_quietly(path_ + k_lock);
}

std::vector<std::string> past_sessions(const std::string& folder) {
  std::vector<std::string> found;
  std::error_code code;
  for (fs::directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
    if (it->path().extension() == k_extension) found.push_back(it->path().string());
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
    if (holds_work(path)) {
      found.push_back(path);
    } else {
      remove_quietly(path);
      remove_quietly(path + k_lock);
    }
  }
  return found;
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
