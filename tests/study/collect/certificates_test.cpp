// Who is let in over a network: encryption, and certificates in place of passwords.
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "study/collect/exchange/administration.h"
#include "study/model/user_error.h"
#include "tests/study/collect/collected_study_at.h"
#include "tests/support/child_process.h"
#include "tests/support/free_port.h"

namespace certificates_test {

namespace fs = std::filesystem;
using study::collect::ServerError;

/// Issues certificates, as an administrator does with openssl.
class Issuer {
 public:
  Issuer(const fs::path& folder, const std::string& name) : folder_(folder / name) {
    fs::create_directories(folder_);
    put("index.txt", "");
    put("crlnumber", "01\n");
    put("ca.cnf",
        fmt::format(
            "[ca]\ndefault_ca = a\n[a]\ndatabase = {0}/index.txt\ncrlnumber = {0}/crlnumber\n"
            "certificate = {0}/ca.crt\nprivate_key = {0}/ca.key\ndefault_md = sha256\n"
            "default_crl_days = 2\n",
            folder_.string()));
    put("server.cnf", "subjectAltName = DNS:localhost\n");
    call(
        {"req",
         "-x509",
         "-newkey",
         "ec",
         "-pkeyopt",
         "ec_paramgen_curve:prime256v1",
         "-nodes",
         "-subj",
         "/CN=" + name,
         "-days",
         "2",
         "-keyout",
         file("ca.key"),
         "-out",
         file("ca.crt")});
    list();
  }

  std::string file(const std::string& name) const { return folder_ / name; }

  /// For @p role, or for "server".
  void issue(const std::string& role) const {
    call(
        {"req",
         "-new",
         "-newkey",
         "ec",
         "-pkeyopt",
         "ec_paramgen_curve:prime256v1",
         "-nodes",
         "-subj",
         "/CN=" + role,
         "-keyout",
         file(role + ".key"),
         "-out",
         file(role + ".csr")});
    std::vector<std::string> words{
        "x509",
        "-req",
        "-in",
        file(role + ".csr"),
        "-CA",
        file("ca.crt"),
        "-CAkey",
        file("ca.key"),
        "-CAcreateserial",
        "-days",
        "2",
        "-out",
        file(role + ".crt")};
    if (role == "server") words.insert(words.end(), {"-extfile", file("server.cnf")});
    call(words);
  }

  void revoke(const std::string& role) const {
    call({"ca", "-config", file("ca.cnf"), "-revoke", file(role + ".crt")});
    list();
  }

 private:
  void put(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name) << content;
  }
  void list() const {
    call({"ca", "-config", file("ca.cnf"), "-gencrl", "-out", file("root.crl")});
  }
  static void call(std::vector<std::string> words) {
    words.insert(words.begin(), "openssl");
    const auto finished = tests::run(words);
    EXPECT_EQ(finished.status, 0) << finished.error;
  }

  fs::path folder_;
};

class Certificates : public tests::CollectTest {
 protected:
  void SetUp() override {
    CollectTest::SetUp();
    if (IsSkipped()) return;
    ours_ = std::make_unique<Issuer>(scratch_.path(), "ours");
    theirs_ = std::make_unique<Issuer>(scratch_.path(), "theirs");
    ours_->issue("server");
    ours_->issue("station_oslo");
    theirs_->issue("station_oslo");
    for (const auto* name : {"ca.crt", "server.crt", "server.key", "root.crl"}) give(name);
    std::ofstream(postgres().folder() / "data" / "pg_hba.conf")
        << "local all all trust\nhostssl all +palpate_station 127.0.0.1/32 cert\n";
    postgres().set("ssl_cert_file", postgres().folder() / "server.crt");
    postgres().set("ssl_key_file", postgres().folder() / "server.key");
    postgres().set("ssl_ca_file", postgres().folder() / "ca.crt");
    postgres().set("ssl_crl_file", postgres().folder() / "root.crl");
    postgres().set("ssl", "on");
    postgres().listenAt(tests::freePort());
    postgres().stop();
    postgres().start();
    addStation("oslo");
    addStation("bergen");
    runSession("oslo");
  }

  /// Puts a file of ours where the server reads it.
  void give(const std::string& name) const {
    const auto target = postgres().folder() / name;
    fs::copy_file(ours_->file(name), target, fs::copy_options::overwrite_existing);
    struct stat owner {};
    EXPECT_EQ(stat(postgres().folder().c_str(), &owner), 0);
    EXPECT_EQ(chown(target.c_str(), owner.st_uid, owner.st_gid), 0);
    EXPECT_EQ(chmod(target.c_str(), S_IRUSR | S_IWUSR), 0);
  }

  std::string server(const std::string& rest) const {
    return fmt::format(
        "host=localhost hostaddr=127.0.0.1 port={} dbname={} gssencmode=disable {}",
        postgres().port(),
        database(),
        rest);
  }
  std::string with(const Issuer& station, const Issuer& root) const {
    return server(fmt::format(
        "sslmode=verify-full sslrootcert={} sslcert={} sslkey={}",
        root.file("ca.crt"),
        station.file("station_oslo.crt"),
        station.file("station_oslo.key")));
  }

  /// What the person at the desk of @p label reads, who is not let in.
  std::string refusal(const std::string& way, const std::string& label = "oslo") {
    try {
      pushOver(label, way);
      ADD_FAILURE() << "it was let in: " << way;
    } catch (const ServerError& error) {
      EXPECT_EQ(error.kind(), ServerError::Kind::LoginRefused) << error.what();
      return error.what();
    }
    return {};
  }

  std::unique_ptr<Issuer> ours_;
  std::unique_ptr<Issuer> theirs_;
};

/// That @p said has @p words.
void expectWords(const std::string& said, const std::string& words) {
  EXPECT_NE(said.find(words), std::string::npos) << said;
}

TEST_F(Certificates, OfTheStationLetItInAndNothingElseDoes) {
  expectWords(
      refusal(with(*theirs_, *ours_)),
      "does not accept the authority that issued this computer's certificate");
  expectWords(refusal(with(*ours_, *theirs_)), "issued by somebody else than root.crt says");
  expectWords(refusal(with(*ours_, *theirs_)), "clock");
  expectWords(refusal(server("sslmode=disable")), "without encryption");
  expectWords(
      refusal(server("sslmode=require sslcert=/none sslkey=/none")),
      "wants a certificate of this computer");
  expectWords(refusal(with(*ours_, *ours_), "bergen"), "station_bergen");
  EXPECT_TRUE(contentOfServer().empty());

  pushOver("oslo", with(*ours_, *ours_));
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));

  runSession("oslo");
  const auto before = contentOfServer();
  ours_->revoke("station_oslo");
  give("root.crl");
  admin().execute("SELECT pg_reload_conf()");
  const auto isLetIn = [&] {
    try {
      study::collect::Connection(with(*ours_, *ours_), "station_oslo");
      return true;
    } catch (const ServerError&) {
      return false;
    }
  };
  // The server reads it when it gets around to it.
  for (int i = 0; i < 200 && isLetIn(); ++i) usleep(50'000);
  expectWords(refusal(with(*ours_, *ours_)), "was revoked");
  EXPECT_EQ(contentOfServer(), before);
}

TEST_F(Certificates, HaveNoPartInAWrongPasswordWhichIsSaidInWords) {
  std::ofstream(postgres().folder() / "data" / "pg_hba.conf", std::ios::app)
      << "hostnossl all all 127.0.0.1/32 scram-sha-256\n";
  admin().execute("ALTER ROLE station_oslo PASSWORD 'right'; SELECT pg_reload_conf()");
  const auto way = [&](const std::string& password) {
    const auto file = scratch_.write("pgpass", "*:*:*:*:" + password + "\n");
    EXPECT_EQ(chmod(file.c_str(), S_IRUSR | S_IWUSR), 0);
    return server("sslmode=disable passfile=" + file);
  };
  const auto isReloaded = [&] {
    try {
      pushOver("oslo", way("right"));
      return true;
    } catch (const ServerError&) {
      return false;
    }
  };
  for (int i = 0; i < 200 && !isReloaded(); ++i) usleep(50'000);
  const auto said = refusal(way("wrong"));
  expectWords(said, "The server has another password for this role, or none");
  expectWords(said, "(28P01)");
  admin().execute("ALTER ROLE station_oslo PASSWORD NULL");
}

TEST(Passwords, HaveNoPlaceInAnAddress) {
  for (const auto* address :
       {"host=x password=secret",
        "host=x sslpassword=secret",
        "postgresql://me:secret@x/study",
        "postgresql://x/study?sslpassword=secret"}) {
    EXPECT_THROW(study::collect::Connection{address}, study::UserError) << address;
  }
}

class Enrolments : public tests::CollectTest {};

TEST_F(Enrolments, TakeNoAddressWithAPassword) {
  auto owner = admin();
  const auto stations = [&] {
    return owner.query("SELECT count(*) FROM palpate.station").number(0, 0);
  };
  const auto before = stations();
  const auto account = accountOf("tromso");
  const auto key =
      study::storage::StationStore::openOrCreate(study::storage::StationStore::defaultFolder())
          .publicKey();
  EXPECT_THROW(
      study::collect::enrolStation(
          owner, {.site = "tromso", .key = key, .address = "host=x password=secret"}),
      study::UserError);
  EXPECT_EQ(stations(), before);
}

}  // namespace certificates_test
