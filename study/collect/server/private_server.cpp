#include "study/collect/server/private_server.h"

#include <fcntl.h>
#include <pwd.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "study/collect/server/connection.h"
#include "study/model/user_error.h"

extern char** environ;

namespace study::collect {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSuperuser = "postgres";
constexpr auto kStartTimeout = std::chrono::seconds(60);
constexpr auto kPollInterval = std::chrono::milliseconds(20);

/// The folder of PostgreSQL's programs of the newest version; empty if there is none.
fs::path postgresProgramFolder() {
  fs::path newest;
  int version = 0;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/usr/lib/postgresql", error)) {
    const int number = std::atoi(entry.path().filename().c_str());
    if (number <= version || !fs::exists(entry.path() / "bin" / "initdb", error)) continue;
    version = number;
    newest = entry.path() / "bin";
  }
  return newest;
}

/// The account of the server if this program runs as root; nullptr: this account.
const passwd* serverAccount() {
  if (geteuid() != 0) return nullptr;
  // NOLINTBEGIN(concurrency-mt-unsafe): no other thread calls these
  const auto* account = getpwnam("postgres");
  return account != nullptr ? account : getpwnam("nobody");
  // NOLINTEND(concurrency-mt-unsafe)
}

/// Starts a program under the server's account, with its output in @p log. It ends when this
/// program ends.
pid_t spawn(const fs::path& folder, const fs::path& log, std::vector<std::string> words) {
  std::vector<std::string> all{"setpriv", "--pdeathsig", "QUIT"};
  if (const auto* account = serverAccount()) {
    all.push_back("--reuid=" + std::to_string(account->pw_uid));
    all.push_back("--regid=" + std::to_string(account->pw_gid));
    all.emplace_back("--clear-groups");
  }
  all.emplace_back("--");
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (auto& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(
      &actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, S_IRUSR | S_IWUSR);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t id = -1;
  const int failure =
      posix_spawnp(&id, arguments.front(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return failure == 0 ? id : -1;
}

std::string lastLineOf(const fs::path& log) {
  std::ifstream file(log);
  std::string last;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

[[noreturn]] void failToStart(const fs::path& log) {
  throw ServerError(
      ServerError::Kind::Unreachable,
      "A private PostgreSQL server does not start: " + lastLineOf(log));
}

fs::path makeFolder() {
  std::string name = "/tmp/palpate-server-XXXXXX";
  if (mkdtemp(name.data()) == nullptr) {
    throw UserError("No folder can be made in /tmp. Free some space there.");
  }
  if (const auto* account = serverAccount()) {
    if (chown(name.c_str(), account->pw_uid, account->pw_gid) != 0) failToStart({});
  }
  return name;
}

}  // namespace

bool PrivateServer::isInstalled() {
  return !postgresProgramFolder().empty();
}

PrivateServer::PrivateServer(Disk disk) {
  const auto bin = postgresProgramFolder();
  if (bin.empty()) {
    throw UserError("PostgreSQL is not installed on this computer: sudo apt install postgresql.");
  }
  folder_ = makeFolder();
  const auto log = folder_ / "initdb.log";
  const pid_t id = spawn(
      folder_,
      log,
      {bin / "initdb",
       "-D",
       folder_ / "data",
       "-U",
       kSuperuser,
       "-A",
       "trust",
       "-E",
       "UTF8",
       "--no-locale",
       "--no-sync"});
  int status = -1;
  if (id > 0) waitpid(id, &status, 0);
  try {
    if (status != 0) failToStart(log);
    set("listen_addresses", "");
    set("port", std::to_string(port_));  // and not PGPORT
    set("unix_socket_directories", folder_.string());
    set("fsync", disk == Disk::WithFsync ? "on" : "off");
    set("log_line_prefix", "%m [%p] %q%u@%d %h ");  // shows whose requests were denied
    set("log_connections", "on");
    start();
  } catch (...) {
    stop(Stop::Immediate);
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
    throw;
  }
}

PrivateServer::~PrivateServer() {
  stop();
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string PrivateServer::server(const std::string& database) const {
  return fmt::format(
      "host={} port={} dbname={} user={}", folder_.string(), port_, database, kSuperuser);
}

void PrivateServer::set(const std::string& name, const std::string& value) const {
  std::ofstream settings(folder_ / "data" / "postgresql.conf", std::ios::app);
  settings << name << " = '" << value << "'\n" << std::flush;
  if (!settings) throw UserError("The private server's settings cannot be written.");
}

void PrivateServer::listenAt(int port) {
  port_ = port;
  set("port", std::to_string(port));
  set("listen_addresses", "127.0.0.1");
}

void PrivateServer::start() {
  const auto log = folder_ / "server.log";
  id_ = spawn(folder_, log, {postgresProgramFolder() / "postgres", "-D", folder_ / "data"});
  const auto end = std::chrono::steady_clock::now() + kStartTimeout;
  while (std::chrono::steady_clock::now() < end) {
    if (id_ <= 0 || waitpid(id_, nullptr, WNOHANG) == id_) {
      id_ = -1;  // it has ended by itself
      break;
    }
    try {
      const Connection ready(server());
      return;
    } catch (const ServerError&) {
      std::this_thread::sleep_for(kPollInterval);
    }
  }
  failToStart(log);
}

void PrivateServer::stop(Stop how) {
  if (id_ <= 0) return;
  kill(id_, how == Stop::Fast ? SIGINT : SIGQUIT);
  waitpid(id_, nullptr, 0);
  id_ = -1;
}

}  // namespace study::collect
