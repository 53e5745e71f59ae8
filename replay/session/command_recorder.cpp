#include "replay/session/command_recorder.h"

#include "replay/session/session_line.h"
#include "replay/trace/trace_writer.h"

namespace penpose::replay {

std::string CommandRecorder::begin(const document::Document& document, std::string_view model_path) {
  TraceWriter writer;
  writer.comment(to_text(SessionBegins{program_}));
  writer.comment(to_text(ModelNamed{hasher_(document).whole, std::string(model_path)}));
  return writer.take();
}

std::string CommandRecorder::lines(std::span<const document::Command> commands,
                                   std::span<const document::Document> after) {
  TraceWriter writer;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    writer.comment(to_text(Performed{commands[i]}));
    writer.comment(to_text(StateReached{hasher_(after[i])}));
  }
  return writer.take();
}

}  // namespace penpose::replay
