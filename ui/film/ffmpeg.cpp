#include "ui/film/ffmpeg.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX asks for it

namespace penpose::film {
namespace {

/// Above the descriptors that the program gets, so that none is written over before it is passed on.
constexpr int k_high_file = 64;
constexpr useconds_t k_look_us = 20'000;
constexpr std::size_t k_longest_line = 300;

std::string last_line(int log) {
  std::string text(std::size_t{1} << 16, '\0');
  const off_t size = ::lseek(log, 0, SEEK_END);
  const off_t from = std::max<off_t>(0, size - static_cast<off_t>(text.size()));
  const ssize_t got = ::pread(log, text.data(), text.size(), from);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  std::string last;
  while (!text.empty() && last.empty()) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
    const std::size_t begin = text.rfind('\n') + 1;
    last = text.substr(begin);
    text.resize(begin);
    // It says this after every reason.
    if (last == "Conversion failed!" && !text.empty()) last.clear();
  }
  return last.substr(0, k_longest_line);
}

class FileActions {
 public:
  FileActions() { ::posix_spawn_file_actions_init(&actions_); }
  ~FileActions() {
    ::posix_spawn_file_actions_destroy(&actions_);
    for (const int file : held_) ::close(file);
  }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  /// The program has this file of ours as its `number`.
  bool pass(int file, int number) {
    const int high = ::fcntl(file, F_DUPFD_CLOEXEC, k_high_file);
    if (high < 0) return false;
    held_.push_back(high);
    return ::posix_spawn_file_actions_adddup2(&actions_, high, number) == 0;
  }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }
  bool swallow_output() {
    return ::posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0) == 0;
  }

 private:
  posix_spawn_file_actions_t actions_{};
  std::vector<int> held_;
};

/// In a group of its own: Ctrl-C ends this program, which ends ffmpeg.
int spawn(pid_t& process, const FileActions& actions, const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT: POSIX's type
  arguments.push_back(nullptr);
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  const int failed = ::posix_spawnp(&process, arguments.front(), actions.get(), &attributes, arguments.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  return failed;
}

}  // namespace

base::Error given_up() { return {"was cancelled; nothing was written", "", "begin it again"}; }

base::Error no_ffmpeg() {
  return {"needs ffmpeg, which is not installed", "", "install the package ffmpeg, or write pictures (.png)"};
}

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

MemoryFile::MemoryFile() : file_(::memfd_create("penpose", MFD_CLOEXEC)) {}

MemoryFile::~MemoryFile() {
  if (file_ >= 0) ::close(file_);
}

base::Status MemoryFile::fill(std::span<const std::uint8_t> bytes) const {
  while (file_ >= 0 && !bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) break;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  if (file_ >= 0 && bytes.empty()) return base::Done{};
  return base::Error{"the sound of the film finds no room (" + std::generic_category().message(errno) + ")", "",
                     "free some memory, or film fewer frames"};
}

base::Result<Ffmpeg> Ffmpeg::start(const std::vector<std::string>& arguments, const std::vector<int>& files) {
  if (!has_ffmpeg()) return no_ffmpeg();
  Ffmpeg one;
  int ends[2] = {-1, -1};
  one.log_ = ::memfd_create("penpose-ffmpeg", MFD_CLOEXEC);
  if (one.log_ < 0 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    return base::Error{"ffmpeg could not be started (" + std::generic_category().message(errno) + ")", "",
                       "close other programs, or write pictures (.png)"};
  }
  one.input_ = ends[0];
  FileActions actions;
  bool passed =
      actions.pass(ends[1], STDIN_FILENO) && actions.pass(one.log_, STDERR_FILENO) && actions.swallow_output();
  ::close(ends[1]);
  int number = STDERR_FILENO;
  for (const int file : files) passed = passed && actions.pass(file, ++number);
  std::vector<std::string> words{"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-y"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const int failed = passed ? spawn(one.process_, actions, words) : errno;
  if (failed == 0) return one;
  one.process_ = -1;
  return base::Error{"ffmpeg could not be started (" + std::generic_category().message(failed) + ")", "",
                     "install it anew, or write pictures (.png)"};
}

Ffmpeg::Ffmpeg(Ffmpeg&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      input_(std::exchange(other.input_, -1)),
      log_(std::exchange(other.log_, -1)) {}

Ffmpeg::~Ffmpeg() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  if (input_ >= 0) ::close(input_);
  if (log_ >= 0) ::close(log_);
}

base::Error Ffmpeg::failed() const {
  const std::string why = last_line(log_);
  return {"ffmpeg failed" + (why.empty() ? std::string() : " (" + why + ")"), "",
          "look whether there is room on the disk, or write pictures (.png)"};
}

base::Status Ffmpeg::write(std::span<const std::uint8_t> bytes, const Stop& stop) {
  while (!bytes.empty()) {
    if (stop && stop()) return given_up();
    const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) {
      if (auto ended = finish(stop); !ended) return ended;
      return failed();
    }
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return base::Done{};
}

base::Status Ffmpeg::finish(const Stop& stop) {
  if (input_ >= 0) ::close(std::exchange(input_, -1));
  int status = 0;
  for (;;) {
    const pid_t ended = ::waitpid(process_, &status, WNOHANG);
    if (ended == process_ || (ended < 0 && errno != EINTR)) break;
    if (stop && stop()) return given_up();
    ::usleep(k_look_us);
  }
  process_ = -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return base::Done{};
  return failed();
}

}  // namespace penpose::film
