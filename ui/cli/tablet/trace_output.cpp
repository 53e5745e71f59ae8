#include "ui/cli/tablet/trace_output.h"

#include <iostream>

#include "core/base/json/json.h"
#include "ui/cli/commands.h"
#include "ui/files/files.h"
#include "ui/files/own_tablets.h"

namespace penpose::cli {

void print_gathered(std::string& text, std::size_t keep) {
  if (text.size() < keep) return;
  std::cout.write(text.data(), static_cast<std::streamsize>(text.size()));
  text.clear();
}

base::Status each_report(replay::TraceSource& source, const std::function<void(const replay::TraceReport&)>& take) {
  for (;;) {
    const auto report = source.next();
    if (!report) return report.error();
    if (!report->has_value()) return base::Done{};
    take(**report);
  }
}

int end_of_trace(const replay::TraceSource& source, const std::string& path, std::uint64_t reports) {
  if (!std::cout) return files::report({"the output cannot be written", "", "check the disk"});
  if (source.devices().empty() && reports == 0) {
    return files::report({"is no recording: it has neither devices nor reports", "",
                          "give a recording as `penpose record`, hid-recorder, usbhid-dump or Wireshark writes it"},
                         path);
  }
  // After the refusal, which is one line: where nothing can be read, it matters little what each line lacks.
  for (const auto& problem : source.problems()) std::cerr << "penpose: " << problem.line(path) << '\n';
  return k_success;
}

void warn_of_guesses(const std::set<std::string>& guesses, const std::string& path) {
  for (const std::string& guess : guesses) files::warn(files::guess_note(guess), path);
}

void append_json_guess(std::string& out, const std::string& guess) {
  if (guess.empty()) {
    out += "null";
  } else {
    json::append_text(out, guess);
  }
}

}  // namespace penpose::cli
