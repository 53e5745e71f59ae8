// Any bytes as a recording of any kind, wrapped or not: whatever pieces they come in, the same comes out, and what a
// session is comes out as it is.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "replay/recording/recording.h"
#include "tests/support/trace_reports.h"

using namespace penpose;

namespace {

/// What comes out, up to its first MiB: packed bytes may be much longer.
std::string text_of(replay::ReadBytes read) {
  constexpr std::size_t k_enough = std::size_t{1} << 20;
  const replay::ReadBytes recording = replay::read_recording(std::move(read));
  std::string all;
  std::vector<std::uint8_t> buffer(4096);
  while (all.size() < k_enough) {
    const auto got = recording(buffer);
    if (!got) return all + got.error().line();
    if (*got > buffer.size()) std::abort();
    if (*got == 0) return all;
    all += base::as_text(base::Bytes(buffer).first(*got));
  }
  return all.substr(0, k_enough);
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const base::Bytes bytes(data, size);
  const std::string text = text_of(replay::read_from(bytes));
  const std::size_t piece = size == 0 ? 1 : 1 + data[size / 2] % 61;
  if (text != text_of(tests::in_pieces(bytes, piece))) std::abort();
  if (base::as_text(bytes).starts_with("# penpose session ") && text != base::as_text(bytes)) std::abort();
  return 0;
}
