// In the place of meshoptimizer where there is no archive of it: files that need its codecs are refused.
#include <meshoptimizer.h>

#include "core/io/gltf/read/compression/meshopt_stream.h"

int meshopt_decodeVertexBuffer(void*, std::size_t, std::size_t, const unsigned char*, std::size_t) {
  return penpose::io::k_meshopt_left_out;
}

int meshopt_decodeIndexBuffer(void*, std::size_t, std::size_t, const unsigned char*, std::size_t) {
  return penpose::io::k_meshopt_left_out;
}

int meshopt_decodeIndexSequence(void*, std::size_t, std::size_t, const unsigned char*, std::size_t) {
  return penpose::io::k_meshopt_left_out;
}
