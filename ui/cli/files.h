#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::cli {

/// The whole file. Errors: it does not exist, may not be read, or is no regular file or pipe.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> read_file(const std::string& path);

/// Writes all bytes to a temporary file beside `path` and renames it, so that `path` holds either its old or its new
/// content.
[[nodiscard]] base::Status write_file(const std::string& path, base::Bytes bytes);

/// Prints "penpose: FILE: PLACE: WHAT; REMEDY" as one line on standard error and returns the exit status of a failure.
int report(const base::Error& error, const std::string& file = {});

/// Prints what a reader or writer has to say of a file on standard error, one line as an error is.
void warn(const std::string& note, const std::string& file);

}  // namespace penpose::cli
