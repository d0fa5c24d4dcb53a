// A network between stations and server that is cut, stands still, or is slow.
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <thread>

#include <fmt/format.h>

#include "tests/study/collect/collected_study_at.h"
#include "tests/study/collect/line.h"
#include "tests/support/long_form.h"

namespace network_test {

using study::collect::Connection;
using study::collect::ServerError;
using tests::Line;

class Networks : public tests::CollectTest {
 protected:
  void SetUp() override {
    CollectTest::SetUp();
    if (IsSkipped()) return;
    line_ = std::make_unique<Line>(
        fmt::format("{}/.s.PGSQL.{}", postgres().folder().string(), postgres().port()));
  }

  /// What the person at the desk reads; empty: everything arrived.
  std::string saidByAPush(std::chrono::milliseconds patience = std::chrono::minutes(1)) {
    try {
      pushOver("oslo", line_->server(database()), patience);
    } catch (const ServerError& error) {
      EXPECT_EQ(error.kind(), ServerError::Kind::Unreachable) << error.what();
      return error.what();
    }
    return {};
  }

  std::int64_t eventsThere() {
    auto owner = admin();
    return owner.query("SELECT count(*) FROM palpate.event").number(0, 0);
  }

  std::unique_ptr<Line> line_;
};

TEST_F(Networks, ACutAtAnyByteLosesAndDoublesNothing) {
  addStation("oslo");
  simulate("oslo", 1);
  line_->set(Line::Fault::Cut, 200);  // in the first words that are exchanged
  EXPECT_NE(saidByAPush().find("cannot be reached"), std::string::npos);
  EXPECT_TRUE(contentOfServer().empty());
  line_->set(Line::Fault::None);
  EXPECT_EQ(saidByAPush(), "");
  runSession("oslo");
  EXPECT_EQ(saidByAPush(), "");
  const auto one = line_->carried();

  const int cuts = tests::inLongForm(60, 5);
  int cutShort = 0;
  for (int i = 0; i < cuts; ++i) {
    runSession("oslo");
    line_->set(
        Line::Fault::Cut, 300 + one * static_cast<std::size_t>(i) / static_cast<std::size_t>(cuts));
    const auto said = saidByAPush();
    if (said.empty()) continue;
    ++cutShort;
    EXPECT_NE(said.find("Nothing is lost"), std::string::npos) << said;
  }
  EXPECT_GT(cutShort, cuts / 2) << "the control: pushes were cut";
  line_->set(Line::Fault::None);
  EXPECT_EQ(saidByAPush(), "");
  const auto account = accountOf("oslo");
  study::collect::Outbox outbox(folderOf("oslo"), clock_);
  EXPECT_EQ(eventsThere(), outbox.lastEvent());
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
  EXPECT_TRUE(pull().isSound());
  EXPECT_EQ(contentOf({folderOfPull()}), contentOf({folderOf("oslo")}));
  EXPECT_TRUE(incidents().empty());
}

TEST_F(Networks, AServerThatStandsStillIsGivenUp) {
  addStation("oslo");
  runSession("oslo");
  for (const std::size_t bytes : {std::size_t{1'000}, std::size_t{6'000}}) {
    line_->set(Line::Fault::Stop, bytes);
    const auto said = saidByAPush(std::chrono::milliseconds(100));
    EXPECT_NE(said.find("has not answered for 0.1 s"), std::string::npos) << said;
    EXPECT_NE(said.find("Nothing is lost"), std::string::npos) << said;
  }
  line_->set(Line::Fault::None);
  EXPECT_EQ(saidByAPush(), "");
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
}

TEST_F(Networks, ASlowLineTakesItsTime) {
  addStation("oslo");
  runSession("oslo");
  line_->set(Line::Fault::Slow);
  EXPECT_EQ(saidByAPush(), "");
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
  EXPECT_TRUE(pull().isSound());
  EXPECT_EQ(contentOf({folderOfPull()}), contentOf({folderOf("oslo")}));
}

/// Says that it lets nobody in, in German.
class GermanServer {
 public:
  GermanServer() : listener_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* plain = reinterpret_cast<sockaddr*>(&address);
    isSound_ = bind(listener_, plain, size) == 0 && listen(listener_, 2) == 0 &&
               getsockname(listener_, plain, &size) == 0;
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] {
      while (answerOne()) continue;
    });
  }
  ~GermanServer() {
    shutdown(listener_, SHUT_RDWR);
    thread_.join();
    close(listener_);
  }
  GermanServer(const GermanServer&) = delete;
  GermanServer& operator=(const GermanServer&) = delete;

  std::string server() const {
    EXPECT_TRUE(isSound_);
    return fmt::format(
        "host=127.0.0.1 port={} dbname=x user=y sslmode=disable gssencmode=disable", port_);
  }

 private:
  bool answerOne() const {
    const int client = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (client < 0) return false;
    std::array<char, 1000> asked{};
    const bool hasAsked = recv(client, asked.data(), asked.size(), 0) > 0;
    using namespace std::string_literals;
    const auto fields =
        "SFATAL\0VFATAL\0C28000\0Mkein pg_hba.conf-Eintrag f\u00fcr Host \u00bb10.0.0.7\u00ab, Benutzer \u00bby\u00ab\0\0"s;
    const auto size = htonl(static_cast<std::uint32_t>(fields.size() + sizeof(std::uint32_t)));
    const auto message =
        "E" + std::string(reinterpret_cast<const char*>(&size), sizeof size) + fields;
    if (hasAsked) send(client, message.data(), message.size(), MSG_NOSIGNAL);
    close(client);
    return true;
  }

  int listener_;
  bool isSound_ = false;
  int port_ = 0;
  std::thread thread_;
};

TEST(LanguagesOfServers, ARefusalInGermanIsNotTakenForABrokenNetwork) {
  const GermanServer german;
  try {
    const Connection none(german.server());
    FAIL() << "it is connected";
  } catch (const ServerError& error) {
    EXPECT_EQ(error.kind(), ServerError::Kind::LoginRefused);
    EXPECT_NE(std::string(error.what()).find("kein pg_hba.conf-Eintrag"), std::string::npos);
  }
}

}  // namespace network_test
