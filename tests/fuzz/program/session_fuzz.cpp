// Sessions and the traces that they are, from bytes to a document. The model is small; nothing that is drawn may crash,
// and what was replayed is written down and replays to the same state.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "replay/session/session_player.h"
#include "replay/session/session_recorder.h"
#include "tests/support/random_session.h"

using namespace penpose;  // NOLINT(google-build-using-namespace): a program of one file

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 1U << 16U) return 0;
  std::string again;
  replay::SessionWriter writer(
      [&](std::string_view text, bool) -> base::Status {
        again += text;
        return base::Done{};
      },
      "fuzz");
  replay::SessionRecorder recorder(writer);
  replay::PlayerOptions options;
  options.open = tests::open_sheet;
  options.observer = &recorder;
  const auto first = replay::play_session(replay::read_from({data, size}), options);
  if (!first || !first->session) return 0;
  if (!writer.flush(false)) std::abort();
  options.observer = nullptr;
  const auto second = replay::play_session(replay::read_from(base::as_bytes(again)), options);
  if (!second || !second->session) std::abort();
  const auto a = first->session->editor().state();
  const auto b = second->session->editor().state();
  if (!(a == b) || second->divergence) std::abort();
  return 0;
}
