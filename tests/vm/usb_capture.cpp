// Captures USB requests inside the virtual machine as Wireshark and tcpdump do: usb_capture NODE FILE STOP
//   NODE   of usbmon, /dev/usbmon0 for all buses (Linux, Documentation/usb/usbmon.rst)
//   FILE   gets a capture in the form of pcap, link type 220
//   STOP   it ends once this file exists and nothing is left to be read
// Prints how many packets it wrote, and says "capturing" on the error output when it does.
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <iostream>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <vector>

namespace {

/// The header of a packet, 64 bytes, and the kernel's call that fetches one with its data.
using Header = std::array<std::uint8_t, 64>;
struct Fetch {
  void* header;
  void* data;
  std::size_t room;
};
constexpr unsigned long k_fetch = _IOW(0x92, 10, Fetch);  // MON_IOCX_GETX
constexpr unsigned long k_set_ring_size = _IO(0x92, 4);   // MON_IOCT_RING_SIZE
constexpr unsigned long k_ring_size = 1200 * 1024;        // the most that it takes
constexpr std::size_t k_most_data = 65536;

template <typename Number>
Number number_at(const Header& header, std::size_t at) {
  Number number{};
  std::memcpy(&number, &header[at], sizeof number);
  return number;
}

void put(std::FILE* file, const std::vector<std::uint32_t>& words) {
  std::fwrite(words.data(), sizeof words[0], words.size(), file);
}

int fail(const char* what) {
  std::cerr << "usb_capture: " << what << ": " << std::strerror(errno) << '\n';
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const int node = ::open(argv[1], O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (node < 0) return fail(argv[1]);
  if (::ioctl(node, k_set_ring_size, k_ring_size) != 0) return fail("the ring");
  std::FILE* file = std::fopen(argv[2], "wb");
  if (file == nullptr) return fail(argv[2]);
  put(file, {0xa1b2c3d4, 2 | 4 << 16, 0, 0, 64 + k_most_data, 220});
  std::cerr << "capturing" << std::endl;
  std::vector<std::uint8_t> data(k_most_data);
  long packets = 0;
  for (;;) {
    Header header{};
    Fetch fetch{header.data(), data.data(), data.size()};
    if (::ioctl(node, k_fetch, &fetch) == 0) {
      const auto captured = static_cast<std::uint32_t>(header.size()) + number_at<std::uint32_t>(header, 36);
      put(file, {static_cast<std::uint32_t>(number_at<std::int64_t>(header, 16)), number_at<std::uint32_t>(header, 24),
                 captured, captured});
      std::fwrite(header.data(), 1, header.size(), file);
      std::fwrite(data.data(), 1, captured - header.size(), file);
      ++packets;
      continue;
    }
    if (errno != EAGAIN) return fail("reading");
    if (std::filesystem::exists(argv[3])) break;
    pollfd waiting{node, POLLIN, 0};
    ::poll(&waiting, 1, 100);
  }
  if (std::fclose(file) != 0) return fail(argv[2]);
  std::cout << packets << " packets" << std::endl;
  return 0;
}
