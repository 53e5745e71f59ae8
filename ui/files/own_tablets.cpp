#include "ui/files/own_tablets.h"

#include "firmware_io/decode/table/tablet_reader.h"
#include "ui/files/files.h"

namespace penpose::files {

base::Result<decode::TabletTable> read_own_tablets(const std::string& path) {
  if (path.empty()) return decode::TabletTable{};
  const auto bytes = read_file(path, k_most_text_bytes);
  if (!bytes) return bytes.error();
  return decode::read_tablet_file(base::as_text(*bytes));
}

}  // namespace penpose::files
