// Finds the decoder of a tablet that the library knows, with penpose::decode alone.
#include <cstdio>

#include "firmware_io/decode/decoder_factory.h"

int main() {
  penpose::decode::DeviceIdentity pen;
  pen.vendor = 0x056a;
  pen.product = 0x0061;
  const auto found = penpose::decode::make_decoder(pen);
  if (!found) return 1;
  std::printf("%s %d\n", found->method.c_str(), found->decoder->axes().x.maximum);
  return 0;
}
