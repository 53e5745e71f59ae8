#include "firmware_io/device/source/driver_guard.h"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace penpose::device {
namespace {

/// How often the guard asks: the kernel takes a moment to free what the dead process had claimed.
constexpr int k_attempts = 250;
constexpr int k_files = 4096;
constexpr timespec k_pause{0, 20'000'000};

base::Error guard_error(const std::string& what, const std::string& node) {
  return {what + " (" + std::generic_category().message(errno) + ")", node, "`penpose devices` says what is missing"};
}

int ask_kernel(int file, int interface) {
  usbdevfs_ioctl request{};
  request.ifno = interface;
  request.ioctl_code = USBDEVFS_CONNECT;
  return ::ioctl(file, USBDEVFS_IOCTL, &request);
}

/// The other process. It was forked from a program with threads, so only plain system calls are allowed; it keeps
/// nothing open but its end of the pipe and the device, and no signal to the program's group reaches it.
[[noreturn]] void stand_guard(int pipe, int device, int interface) {
  ::setsid();
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGTSTP}) std::signal(number, SIG_IGN);
  ::prctl(PR_SET_NAME, "penpose-guard");
  // Files of the parent kept open here, the claimed interface among them, would outlive it.
  // (close_range exists since Linux 5.9; before that, one by one.)
  const unsigned low = static_cast<unsigned>(pipe < device ? pipe : device);
  const unsigned high = static_cast<unsigned>(pipe < device ? device : pipe);
  if (low > 0) ::syscall(SYS_close_range, 0u, low - 1, 0u);
  if (high > low + 1) ::syscall(SYS_close_range, low + 1, high - 1, 0u);
  if (::syscall(SYS_close_range, high + 1, ~0u, 0u) != 0) {
    for (int file = 0; file < k_files; ++file) {
      if (file != pipe && file != device) ::close(file);
    }
  }
  char word = 0;
  ssize_t got = 0;
  do {
    got = ::read(pipe, &word, 1);
  } while (got < 0 && errno == EINTR);
  if (got == 1) ::_exit(0);
  for (int i = 0; i < k_attempts; ++i) {
    if (ask_kernel(device, interface) > 0) ::_exit(0);
    if (errno == ENODEV) ::_exit(0);
    ::nanosleep(&k_pause, nullptr);
  }
  ::_exit(1);
}

}  // namespace

base::Result<std::unique_ptr<DriverGuard>> DriverGuard::start(const std::string& usb_node, int interface) {
  const int device = ::open(usb_node.c_str(), O_RDWR | O_CLOEXEC);
  if (device < 0) return guard_error("cannot be opened", usb_node);
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    const auto error = guard_error("no pipe can be made", usb_node);
    ::close(device);
    return error;
  }
  const int process = ::fork();
  if (process == 0) stand_guard(ends[0], device, interface);
  const auto error = guard_error("no process can be made", usb_node);
  ::close(ends[0]);
  ::close(device);
  if (process < 0) {
    ::close(ends[1]);
    return error;
  }
  return std::unique_ptr<DriverGuard>(new DriverGuard(ends[1], process));
}

DriverGuard::~DriverGuard() {
  const char word = 'q';
  // Should the guard be dead already, SIGPIPE must not end the program: the pipe is written without it.
  sigset_t pipe_signal;
  sigset_t before;
  sigemptyset(&pipe_signal);
  sigaddset(&pipe_signal, SIGPIPE);
  ::pthread_sigmask(SIG_BLOCK, &pipe_signal, &before);
  if (::write(pipe_, &word, 1) < 0 && errno == EPIPE) {
    const timespec at_once{};
    ::sigtimedwait(&pipe_signal, nullptr, &at_once);
  }
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  ::close(pipe_);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

base::Status bind_kernel_driver(const std::string& usb_node, int interface) {
  const int device = ::open(usb_node.c_str(), O_RDWR | O_CLOEXEC);
  if (device < 0) return guard_error("cannot be opened", usb_node);
  const int bound = ask_kernel(device, interface);
  const auto error = bound < 0 ? guard_error("the kernel binds no driver", usb_node)
                               : base::Error{"no driver of the kernel wants it", usb_node, ""};
  ::close(device);
  if (bound <= 0) return error;
  return base::Done{};
}

}  // namespace penpose::device
