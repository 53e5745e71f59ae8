#pragma once

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/io/model/read_model.h"

namespace penpose::io {

/// Reads a project, or any model as a document that nothing has been done to. Errors as of read_model, and of the
/// project's own part a JSON pointer.
[[nodiscard]] base::Result<document::Document> read_document(base::Bytes bytes, std::string_view file_name_hint,
                                                             const FileResolver& resolve = {});

}  // namespace penpose::io
