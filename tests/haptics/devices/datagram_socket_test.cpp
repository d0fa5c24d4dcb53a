#include "haptics/devices/datagram_socket.h"

#include <gtest/gtest.h>

namespace haptics::devices {
namespace datagram_socket_test {

TEST(DatagramSocket, ReadsAndWritesAddresses) {
  EXPECT_EQ(endpointFrom("127.0.0.1:30200")->text(), "127.0.0.1:30200");
  EXPECT_EQ(endpointFrom("10.1.2.3", 7)->text(), "10.1.2.3:7");
  for (const auto* text :
       {"", ":", "localhost:1", "1.2.3:4", "1.2.3.4:", "1.2.3.4:65536", "1.2.3.4:-1"}) {
    EXPECT_FALSE(endpointFrom(text)) << text;
  }
}

TEST(DatagramSocket, NamesAPortThatIsInUse) {
  const DatagramSocket first(Endpoint{});
  EXPECT_THROW(DatagramSocket{first.local()}, NetworkError);
}

}  // namespace datagram_socket_test
}  // namespace haptics::devices
