#include "ui/files/own_tablets.h"

#include "firmware_io/decode/table/tablet_reader.h"
#include "ui/files/files.h"

namespace penpose::files {
namespace {

base::Result<decode::TabletTable> read_tablets(const std::string& path) {
  if (path.empty()) return decode::TabletTable{};
  const auto bytes = read_file(path, k_most_text_bytes);
  if (!bytes) return bytes.error();
  auto tablets = decode::read_tablet_file(base::as_text(*bytes));
  if (!tablets) return tablets;
  for (const decode::Tablet& tablet : tablets->tablets()) {
    for (const std::string& parser : tablet.unread_parsers) {
      warn("the report parser " + parser +
               " is not known, what it reads is left out; describe its reports in a "
               "tablet file of penpose's own form",
           path);
    }
  }
  return tablets;
}

}  // namespace

base::Result<decode::TabletTable> read_own_tablets(const OwnTablets& own) {
  auto tablets = read_tablets(own.file);
  if (!tablets) {
    base::Error error = tablets.error();
    error.place = error.place.empty() ? own.file : own.file + ": " + error.place;
    return error;
  }
  if (own.name.empty()) return tablets;
  auto chosen = tablets->choose(own.name);
  return chosen ? std::move(chosen) : decode::known_tablets().choose(own.name);
}

std::string guess_note(const std::string& guess) {
  return "a guess: " + guess + "; " + k_tablet_option + " NAME says which it is";
}

}  // namespace penpose::files
