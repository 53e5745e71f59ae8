#include "ui/files/process/stop_signal.h"

namespace penpose::files {
namespace {

volatile std::sig_atomic_t g_asked = 0;

void note(int /*number*/) { g_asked = 1; }

}  // namespace

StopSignal::StopSignal() {
  g_asked = 0;
  struct sigaction action {};
  action.sa_handler = note;
  sigemptyset(&action.sa_mask);
  for (int i = 0; i < 3; ++i) sigaction(k_signals[i], &action, &before_[i]);
}

StopSignal::~StopSignal() {
  for (int i = 0; i < 3; ++i) sigaction(k_signals[i], &before_[i], nullptr);
}

bool StopSignal::asked() { return g_asked != 0; }

}  // namespace penpose::files
