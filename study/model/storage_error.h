#pragma once

#include <stdexcept>
#include <string>

namespace study::storage {

/// A study on disk that cannot be opened, read or written; what() is for the person at the desk.
class StorageError : public std::runtime_error {
 public:
  enum class Kind {
    Other,
    Busy,  ///< somebody else is writing
    DiskFull,
    Damaged,  ///< or never was a study
    Newer,    ///< written by a later version of this program
    Unknown,  ///< whether it was kept cannot be found out just now
  };

  explicit StorageError(const std::string& what, Kind kind = Kind::Other)
      : std::runtime_error(what), kind_(kind) {}

  Kind kind() const noexcept { return kind_; }

 private:
  Kind kind_;
};

}  // namespace study::storage
