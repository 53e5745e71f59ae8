// A conversation of JSON lines: nothing that is said may crash, a line with an error changes nothing, every answer is
// one line, and what was recorded replays to the same state.

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "replay/session/session_player.h"
#include "tests/support/models/sheet_model.h"
#include "ui/serve/conversation.h"

using namespace penpose;  // NOLINT(google-build-using-namespace): a program of one file

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 1U << 15U) return 0;
  std::string session;
  serve::Conversation conversation({tests::open_sheet,
                                    [](const std::string&, base::Bytes) -> base::Status { return base::Done{}; },
                                    [&](std::string_view text) -> base::Status {
                                      session += text;
                                      return base::Done{};
                                    }});
  static_cast<void>(conversation.answer(R"({"do":"load"})"));
  std::string_view text(reinterpret_cast<const char*>(data), size);
  for (int lines = 0; !text.empty() && lines < 40; ++lines) {
    const std::size_t end = text.find('\n');
    const auto before = conversation.character()->state();
    const std::size_t recorded = session.size();
    const std::string answer = conversation.answer(text.substr(0, end));
    if (answer.find('\n') != std::string::npos || !answer.starts_with('{')) std::abort();
    const bool refused = answer.find("\"ok\":false") != std::string::npos;
    const bool same = conversation.character()->state() == before && session.size() == recorded;
    if (refused && answer.find("\"ok\":true") == std::string::npos && !same) std::abort();
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  replay::PlayerOptions options;
  options.open = tests::open_sheet;
  const auto again = replay::play_session(replay::read_from(base::as_bytes(session)), options);
  if (!again || !again->session || again->divergence || again->refused > 0) std::abort();
  if (!(again->session->editor().state() == conversation.character()->state())) std::abort();
  return 0;
}
