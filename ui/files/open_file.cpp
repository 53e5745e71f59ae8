#include "ui/files/open_file.h"

#include <cerrno>
#include <fcntl.h>
#include <linux/openat2.h>
#include <string_view>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace penpose::files {
namespace {

/// Closes a file at the end of its life.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int get() const { return number_; }
  [[nodiscard]] int release() { return std::exchange(number_, -1); }
  explicit operator bool() const { return number_ >= 0; }

 private:
  int number_;
};

enum class Pipes : bool { refused, taken };

base::Error not_opened() {
  return {"cannot be opened (" + std::generic_category().message(errno) + ")", "",
          "check the name and the permissions"};
}

base::Error leads_out(const std::string& name) {
  return {"lies outside the folder of the file that names it", name, "put it beside that file, not behind a link"};
}

/// What a file may be that is read to its end.
base::Status check_kind(mode_t mode, Pipes pipes) {
  if (S_ISREG(mode)) return base::Done{};
  if (S_ISDIR(mode)) return base::Error{"is a folder", "", "name a file in it"};
  if (S_ISFIFO(mode) && pipes == Pipes::taken) return base::Done{};
  if (S_ISFIFO(mode)) return base::Error{"is a pipe", "", "name a file"};
  return base::Error{"is a device and no file", "", "name a file"};
}

base::Result<File> as_stream(Descriptor file, Pipes pipes) {
  struct stat facts {};
  if (!file || ::fstat(file.get(), &facts) != 0) return not_opened();
  if (const auto fits = check_kind(facts.st_mode, pipes); !fits) return fits.error();
  File stream(::fdopen(file.get(), "rb"), &std::fclose);
  if (!stream) return not_opened();
  static_cast<void>(file.release());
  return stream;
}

/// openat2 with what keeps a name below its folder; -1 with ENOSYS where the kernel has no such call.
int open_below(int folder, const char* name, int flags) {
  struct open_how how {};
  how.flags = static_cast<std::uint64_t>(flags | O_CLOEXEC);
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
  return static_cast<int>(::syscall(SYS_openat2, folder, name, &how, sizeof how));
}

/// The same for older kernels, folder by folder; it follows no link at all.
int open_below_slowly(int folder, std::string_view name, int flags) {
  Descriptor at(::dup(folder));
  while (at) {
    const std::size_t slash = name.find('/');
    const std::string piece(name.substr(0, slash));
    if (piece == "..") {
      errno = EXDEV;
      return -1;
    }
    const bool last = slash == std::string_view::npos;
    if (last) return ::openat(at.get(), piece.c_str(), flags | O_NOFOLLOW | O_CLOEXEC);
    if (!piece.empty())
      at = Descriptor(::openat(at.get(), piece.c_str(), O_PATH | O_NOFOLLOW | O_DIRECTORY | O_CLOEXEC));
    name.remove_prefix(slash + 1);
  }
  return -1;
}

}  // namespace

base::Result<File> open_input(const std::string& path) {
  if (path == k_standard_stream) return as_stream(Descriptor(::dup(STDIN_FILENO)), Pipes::taken);
  // Looked at first: opening a device may do something to it.
  struct stat facts {};
  if (::stat(path.c_str(), &facts) != 0) return not_opened();
  if (const auto fits = check_kind(facts.st_mode, Pipes::taken); !fits) return fits.error();
  // Only a pipe is waited for; some files of /proc would be, too.
  const int waits = S_ISFIFO(facts.st_mode) ? 0 : O_NONBLOCK;
  return as_stream(Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | waits)), Pipes::taken);
}

base::Result<File> open_plain(const std::string& path) {
  struct stat facts {};
  if (::stat(path.c_str(), &facts) != 0) return not_opened();
  if (const auto fits = check_kind(facts.st_mode, Pipes::refused); !fits) return fits.error();
  // It may have become something else since then.
  return as_stream(Descriptor(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)), Pipes::refused);
}

base::Result<File> open_beside(const std::string& folder, const std::string& name) {
  if (name.empty() || name.front() == '/' || name.find('\0') != std::string::npos) return leads_out(name);
  const Descriptor base(::open(folder.empty() ? "." : folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!base) return not_opened();
  const auto open = [&](int flags) {
    const int file = open_below(base.get(), name.c_str(), flags);
    return file < 0 && errno == ENOSYS ? open_below_slowly(base.get(), name, flags) : file;
  };
  struct stat facts {};
  const Descriptor found(open(O_PATH));
  if (!found && (errno == EXDEV || errno == ELOOP)) return leads_out(name);
  if (!found || ::fstat(found.get(), &facts) != 0) return not_opened();
  if (const auto fits = check_kind(facts.st_mode, Pipes::refused); !fits) return fits.error();
  return as_stream(Descriptor(open(O_RDONLY | O_NONBLOCK)), Pipes::refused);
}

}  // namespace penpose::files
