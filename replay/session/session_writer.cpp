#include "replay/session/session_writer.h"

#include <utility>

namespace penpose::replay {
namespace {

/// Reports of a stroke that goes on are handed over when so many bytes have come together.
constexpr std::size_t k_most_pending = std::size_t{1} << 16;
/// What cannot be written is kept up to so many bytes: hours of drawing.
constexpr std::size_t k_most_kept = std::size_t{1} << 26;

}  // namespace

SessionWriter::SessionWriter(AppendText append, std::string program)
    : append_(std::move(append)), program_(std::move(program)) {}

base::Status SessionWriter::flush(bool sync) {
  const std::string text = writer_.take();
  if (given_up_) return *broken_;
  kept_ += text;
  if (kept_.empty() && !sync) return base::Done{};
  auto status = append_(kept_, sync || broken_);
  if (status) {
    broken_.reset();
    kept_.clear();
    return status;
  }
  if (!broken_) broken_ = status.error();
  given_up_ = kept_.size() > k_most_kept;
  if (given_up_) kept_.clear();
  return status;
}

base::Status SessionWriter::begin(const base::Hash128& model, std::string_view path) {
  writer_.comment(to_text(SessionBegins{program_}));
  writer_.comment(to_text(ModelNamed{model, std::string(path)}));
  return flush(true);
}

base::Status SessionWriter::declare(int device, const TraceDevice& facts) {
  writer_.declare(device, facts);
  return flush(false);
}

void SessionWriter::report(int device, std::int64_t time_us, base::Bytes bytes) {
  writer_.report(device, time_us, bytes);
  if (writer_.pending() > k_most_pending) static_cast<void>(flush(false));
}

base::Status SessionWriter::line(const SessionLine& line) {
  writer_.comment(to_text(line));
  return flush(false);
}

base::Status SessionWriter::state(const document::DocumentState& state) {
  writer_.comment(to_text(StateReached{state}));
  return flush(true);
}

}  // namespace penpose::replay
