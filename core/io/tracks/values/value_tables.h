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

/// Packets of iFacialMocap, one a line: NAME-PERCENT or, of its second version, NAME&PERCENT between bars, then
/// =head# with pitch, yaw and roll in degrees and a place, rightEye# and leftEye# likewise (its documentation, "For
/// developers"). A time may stand before a packet. 60 a second where none does. Errors: no packet with a face.
[[nodiscard]] base::Result<animation::WeightTrack> read_packets(base::Bytes bytes);
/// Returns true if a text begins with such a packet.
[[nodiscard]] bool has_packets(std::string_view text);

/// Reads the log of a receiver of the Virtual Motion Capture protocol, as text or JSON: "/VMC/Ext/Blend/Val", a name
/// and a value, until "/VMC/Ext/Blend/Apply" ends a frame (protocol.vmc.info); values stay until they come again. Times
/// are those of "/VMC/Ext/T", else a number before the address, else 60 frames a second. Bones are left out, with a
/// note. Errors: no values.
[[nodiscard]] base::Result<animation::WeightTrack> read_vmc_dump(base::Bytes bytes);
[[nodiscard]] bool has_vmc(std::string_view text);

/// Values of controls as JSON: see read_arkit_track.
[[nodiscard]] base::Result<animation::WeightTrack> read_value_json(base::Bytes bytes);

}  // namespace penpose::io
