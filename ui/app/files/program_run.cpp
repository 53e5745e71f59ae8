#include "ui/app/files/program_run.h"

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include "ui/files/files.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX asks for it

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

std::string text_of_file(const std::string& path) {
  const auto bytes = files::read_plain_file(path, files::k_most_text_bytes);
  return bytes ? std::string(bytes->begin(), bytes->end()) : std::string();
}

}  // namespace

base::Result<ProgramRun> ProgramRun::prepare() {
  ProgramRun run;
  std::error_code code;
  std::string folder = (fs::temp_directory_path(code) / "penpose-run-XXXXXX").string();
  if (code || ::mkdtemp(folder.data()) == nullptr)
    return base::Error{"there is no place for what lies in between", "", "set TMPDIR to a folder with room"};
  run.folder_ = folder;
  return run;
}

ProgramRun::ProgramRun(ProgramRun&& other) noexcept
    : folder_(std::exchange(other.folder_, {})), process_(std::exchange(other.process_, -1)) {}

ProgramRun::~ProgramRun() {
  if (process_ > 0 && ::waitpid(process_, nullptr, WNOHANG) == 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  std::error_code code;
  if (!folder_.empty()) fs::remove_all(folder_, code);
}

base::Status ProgramRun::start(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // NOLINT: POSIX's type
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  const auto to_file = [&](int number, const std::string& path) {
    ::posix_spawn_file_actions_addopen(&actions, number, path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  };
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  to_file(STDOUT_FILENO, folder_ + "/said");
  to_file(STDERR_FILENO, folder_ + "/log");
  const int failed = ::posix_spawnp(&process_, arguments.front(), &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failed == 0) return base::Done{};
  process_ = -1;
  return base::Error{words.front() + " could not be started (" + std::strerror(failed) + ")", "", "install it anew"};
}

std::optional<base::Status> ProgramRun::ended() {
  int status = 0;
  const pid_t ended = process_ > 0 ? ::waitpid(process_, &status, WNOHANG) : -1;
  if (ended == 0) return std::nullopt;
  process_ = -1;
  if (ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0) return base::Status(base::Done{});
  std::string why = text_of_file(folder_ + "/log");
  while (!why.empty() && why.back() == '\n') why.pop_back();
  why = why.substr(why.rfind('\n') + 1);
  if (why.starts_with("penpose: ")) why.erase(0, 9);
  return base::Status(base::Error{why.empty() ? "it could not be read" : why, "", ""});
}

std::string ProgramRun::said() const { return text_of_file(folder_ + "/said"); }

}  // namespace penpose::app
