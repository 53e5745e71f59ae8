#pragma once

#include "core/animation/track.h"
#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/io/text/csv_reader.h"

namespace penpose::io {

/// Whether a table has a column Timecode, or columns of ARKit's blend shapes behind whatever prefix, or a row a score.
[[nodiscard]] bool has_value_columns(const CsvReader& table);

/// Values of controls as a table: see read_arkit_track.
[[nodiscard]] base::Result<animation::WeightTrack> read_value_table(base::Bytes bytes);

/// Whether JSON holds scores of blend shapes, near its beginning.
[[nodiscard]] bool mentions_values(std::string_view json);

/// Values of controls as JSON: see read_arkit_track.
[[nodiscard]] base::Result<animation::WeightTrack> read_value_json(base::Bytes bytes);

}  // namespace penpose::io
