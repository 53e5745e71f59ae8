// Sessions and the traces that they are, from bytes to a document; those of older editions also by today. The model is
// small; nothing that is drawn may crash, and what was replayed is written down and replays to the same state.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "replay/session/session_player.h"
#include "replay/session/session_recorder.h"
#include "tests/support/random_session.h"

using namespace penpose;  // NOLINT(google-build-using-namespace): a program of one file

namespace {

void play(base::Bytes bytes, bool by_today) {
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
  options.by_today = by_today;
  options.may_differ = [](const std::string&) { return true; };
  options.observer = &recorder;
  const auto first = replay::play_session(replay::read_from(bytes), options);
  if (!first || !first->session) return;
  if (!writer.flush(false)) std::abort();
  if (first->redrawn) {
    for (const replay::RedrawnStep& step : first->redrawn->steps) static_cast<void>(replay::text_of(step));
  }
  options.by_today = false;
  options.observer = nullptr;
  const auto second = replay::play_session(replay::read_from(base::as_bytes(again)), options);
  if (!second || !second->session) std::abort();
  const auto a = first->session->editor().state();
  const auto b = second->session->editor().state();
  if (!(a == b) || second->divergence) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 1U << 16U) return 0;
  for (const bool by_today : {false, true}) play({data, size}, by_today);
  return 0;
}
