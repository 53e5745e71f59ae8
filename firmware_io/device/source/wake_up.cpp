#include "firmware_io/device/source/wake_up.h"

#include <algorithm>
#include <string>

#include "core/base/text/letters.h"

namespace penpose::device {
namespace {

/// The waits are facts of the table; a faulty one must not stop reading for long.
constexpr int k_longest_wait_ms = 2000;

std::string hex(base::Bytes bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += ' ';
    base::append_hex(text, byte, 2);
  }
  return text;
}

bool tell_sent(const TellStep& tell, const std::string& step, const base::Status& sent) {
  tell(step + (sent ? ": sent" : ": refused: " + sent.error().what));
  return sent.ok();
}

/// The id may be missing in the answer of a device, so it is not looked at.
bool is_set(ReportSource& source, base::Bytes report) {
  if (report.empty()) return false;
  const auto answer = source.get_feature(report[0], report.size());
  return answer && answer->size() == report.size() &&
         std::equal(answer->begin() + 1, answer->end(), report.begin() + 1);
}

}  // namespace

WakeUp wake_up_of(const std::optional<decode::TabletMatch>& match) {
  if (!match || !match->certain) return {};
  return {match->identifier->read_strings, match->identifier->send_features, match->identifier->send_outputs,
          match->tablet->feature_delay_ms, false};
}

int wake(ReportSource& source, const WakeUp& steps, const TellStep& tell, const WaitMs& wait) {
  int refused = 0;
  for (const std::uint8_t index : steps.read_strings) {
    const auto text = source.read_string(index);
    const std::string step = "wake string " + std::to_string(index) + ": ";
    tell(step + (text ? "\"" + *text + "\"" : "no answer: " + text.error().what));
  }
  for (const auto& report : steps.send_features) {
    if (steps.feature_delay_ms > 0) wait(std::min(steps.feature_delay_ms, k_longest_wait_ms));
    if (steps.ask_first && is_set(source, report)) {
      tell("wake feature" + hex(report) + ": is set");
      continue;
    }
    refused += tell_sent(tell, "wake feature" + hex(report), source.send_feature(report)) ? 0 : 1;
  }
  for (const auto& report : steps.send_outputs) {
    refused += tell_sent(tell, "wake output" + hex(report), source.send_output(report)) ? 0 : 1;
  }
  return refused;
}

}  // namespace penpose::device
