#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "core/io/model/write_model.h"

namespace penpose::io {

/// The pictures that surfaces of a written model name: files beside it.
class FbxPictures {
 public:
  /// All must outlive it.
  FbxPictures(const document::Model& model, const WriteOptions& options, WriteReport& report)
      : model_(model), options_(options), report_(report) {}
  /// The name of the file that holds the picture, which is put into the report; empty for one that is not there.
  const std::string& name_of(std::size_t image);

 private:
  const document::Model& model_;
  const WriteOptions& options_;
  WriteReport& report_;
  std::map<std::size_t, std::string> names_;
};

}  // namespace penpose::io
