#include <iostream>
#include <optional>
#include <string>

#include "ui/cli/subcommand.h"
#include "ui/cli/track/track_input.h"
#include "ui/files/append_file.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"
#include "ui/files/open_file.h"
#include "ui/serve/conversation.h"

namespace penpose::cli {
namespace {

struct ServeArguments {
  std::string session;
};

constexpr const char* k_help =
    "Answers JSON lines on standard input with one JSON line each on standard output, in order, until the input ends. "
    "A line with an error, {\"ok\": false, \"error\": \"...\"}, has changed nothing.\n"
    "\"do\": load (model), curve (name, vertices, points, or view and line; role), target (curve; points, or view and "
    "line), solve (preset), sketch (view, general, specific, reference, target), animate (track, map), set "
    "(parameters), "
    "perform (command), evaluate (parameters, vertices), view (yaw, pitch, width, height), state, save (path). "
    "docs/library.md has all of "
    "it.";

/// What goes on for so long without an end of a line is no conversation, and may never end.
constexpr std::size_t k_most_of_a_line = 4 * serve::Conversation::k_longest_line;

/// One line without its end. False at the end of the input. What is longer than any line that is read is thrown away
/// up to its end, and is too long still. Errors: more than k_most_of_a_line.
base::Result<bool> next_line(std::istream& in, std::string& line) {
  line.clear();
  std::streambuf& bytes = *in.rdbuf();
  constexpr int k_end = std::char_traits<char>::eof();
  std::size_t length = 0;
  for (int c = bytes.sbumpc(); c != k_end; c = bytes.sbumpc()) {
    if (c == '\n') return true;
    if (++length > k_most_of_a_line) {
      return base::Error{"a line of more than " + std::to_string(k_most_of_a_line >> 20) + " MiB", "standard input",
                         "write JSON objects, one a line"};
    }
    if (line.size() <= serve::Conversation::k_longest_line) line += static_cast<char>(c);
  }
  return length > 0;
}

base::Status check_path(const std::string& path) {
  if (path == files::k_standard_stream)
    return base::Error{"standard input and output are the conversation's own", "", "name a file"};
  return base::Done{};
}

int serve(const ServeArguments& arguments) {
  files::FileRoles roles;
  std::optional<files::AppendFile> record;
  serve::Files files;
  if (!arguments.session.empty()) {
    if (const auto fits = check_path(arguments.session); !fits) return files::report(fits.error(), arguments.session);
    auto made = files::AppendFile::create_new(arguments.session);
    if (!made) return files::report(made.error(), arguments.session);
    record.emplace(std::move(made).value());
    roles.reads(arguments.session);
    files.record = [&](std::string_view text) { return record->append(text, true); };
  }
  files.load = [&](const std::string& path) -> base::Result<document::Document> {
    if (const auto fits = check_path(path); !fits) return fits.error();
    auto loaded = files::load_document(path, files::NamedBy::file);
    // What a session was recorded on is not written over.
    if (loaded && record) roles.reads(path);
    return loaded;
  };
  files.save = [&](const std::string& path, base::Bytes bytes) -> base::Status {
    if (const auto fits = check_path(path); !fits) return fits;
    if (roles.is_read(path))
      return base::Error{"the file is the session's, or what it is recorded on", "", "choose another name"};
    return files::write_file(path, bytes);
  };
  files.read = [&](const std::string& path) -> base::Result<std::vector<std::uint8_t>> {
    if (const auto fits = check_path(path); !fits) return fits.error();
    return files::read_plain_file(path, files::k_most_text_bytes);
  };
  files.track = [&](const std::string& path, const io::TrackFormat* format,
                    std::optional<io::PictureSize> picture) -> base::Result<io::FormattedTrack> {
    if (const auto fits = check_path(path); !fits) return fits.error();
    return read_track(path, format, picture);
  };
  serve::Conversation conversation(std::move(files));
  std::string line;
  while (std::cout) {
    const auto more = next_line(std::cin, line);
    if (!more) return files::report(more.error());
    if (!*more) break;
    std::cout << conversation.answer(line) << '\n' << std::flush;
  }
  return k_success;
}

void add_options(const Command& command, ServeArguments& arguments) {
  command.footer(k_help);
  command.add_option("--session", arguments.session, "Record the conversation as a session, a file that is not there");
}

}  // namespace

Subcommand serve_subcommand() {
  return subcommand<ServeArguments>(
      "serve", files::Rights::no_programs, "Poses for another program: a conversation of JSON lines", add_options,
      serve, {"penpose serve <<< '{\"do\": \"load\", \"model\": \"builtin:head\"}'", "one line in, one line out"},
      {"penpose serve --session talk.session <<< '{\"do\": \"load\", \"model\": \"builtin:demo\"}'",
       "what is said, recorded to be replayed"});
}

}  // namespace penpose::cli
