#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace study::collect {

/// A temporary PostgreSQL server, for demonstrations and tests: in a folder below /tmp, reachable
/// by this account only, on a Unix socket in the folder, without a network. Clusters of the system
/// are not touched. If this program runs as root, the server runs under the account postgres or
/// nobody, because PostgreSQL refuses to run as root. The destructor stops the server and removes
/// the folder.
class PrivateServer {
 public:
  /// Whether PostgreSQL's programs are installed.
  static bool isInstalled();

  enum class Disk {
    WithFsync,    ///< fsync on, as on a real server
    WithoutFsync  ///< fsync off: faster, for tests. Data survive a stop of the server, but no power
                  ///< failure
  };

  /// Makes the folder and starts the server.
  /// @throws UserError  if PostgreSQL is not installed. @throws ServerError  if it does not start.
  explicit PrivateServer(Disk disk = Disk::WithFsync);
  ~PrivateServer();
  PrivateServer(const PrivateServer&) = delete;
  PrivateServer& operator=(const PrivateServer&) = delete;

  /// The string with which a Connection reaches this server. @param database  must exist.
  std::string server(const std::string& database = "postgres") const;

  enum class Stop {
    Fast,      ///< closes all connections and writes all data
    Immediate  ///< as in a power failure: the server recovers at the next start
  };
  void stop(Stop how = Stop::Fast);
  /// Starts the server again after stop().
  void start();

  /// Adds a setting to postgresql.conf; it applies from the next start() on.
  void set(const std::string& name, const std::string& value) const;
  /// From the next start() on, the server also listens at 127.0.0.1; pg_hba.conf says who may
  /// connect.
  void listenAt(int port);

  /// With "data" (pg_hba.conf) and "server.log" in it. Belongs to the server's account.
  const std::filesystem::path& folder() const noexcept { return folder_; }
  int port() const noexcept { return port_; }
  /// Process of the server; -1 while it is stopped.
  pid_t id() const noexcept { return id_; }

 private:
  std::filesystem::path folder_;
  int port_ = 5432;
  pid_t id_ = -1;
};

}  // namespace study::collect
