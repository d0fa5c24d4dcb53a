#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace study::collect {

/// A PostgreSQL server of its own, for demonstrations and tests: in a folder below /tmp, on a Unix
/// socket in it that only this account can reach, without a network. No cluster of the system is
/// touched. As root it runs under the account postgres, or nobody: PostgreSQL refuses to be root.
/// The destructor stops it, by its process id, and removes the folder.
class PrivateServer {
 public:
  /// Whether PostgreSQL's programs are installed.
  static bool isInstalled();

  enum class Disk {
    Flushed,   ///< as a server in use
    NotWaited  ///< faster, for tests: what a server that is stopped has written stays all the same
  };

  /// Makes the folder and starts the server.
  /// @throws UserError  if PostgreSQL is not installed. @throws ServerError  if it does not start.
  explicit PrivateServer(Disk disk = Disk::Flushed);
  ~PrivateServer();
  PrivateServer(const PrivateServer&) = delete;
  PrivateServer& operator=(const PrivateServer&) = delete;

  /// Where it is, for Connection; @param database  that exists.
  std::string server(const std::string& database = "postgres") const;

  enum class Stop {
    Fast,      ///< ends all connections and writes everything
    Immediate  ///< as if the power failed: it recovers when it is started next
  };
  void stop(Stop how = Stop::Fast);
  /// Starts it after stop().
  void start();

  /// A line of its postgresql.conf, from the next start() on.
  void set(const std::string& name, const std::string& value) const;
  /// From the next start() on it can also be reached at 127.0.0.1, by whom pg_hba.conf lets in.
  void listenAt(int port);

  /// With "data" (pg_hba.conf) and "server.log" in it. Belongs to the server's account.
  const std::filesystem::path& folder() const noexcept { return folder_; }
  int port() const noexcept { return port_; }
  pid_t id() const noexcept { return id_; }

 private:
  std::filesystem::path folder_;
  int port_ = 5432;
  pid_t id_ = -1;
};

}  // namespace study::collect
