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

  pid_t id() const noexcept { return id_; }

 private:
  std::filesystem::path folder_;
  Disk disk_;
  pid_t id_ = -1;
};

}  // namespace study::collect
