#pragma once

#include <cstdint>

namespace tests {

/// Which calls fail: the @p first after it was armed, counted from 1, and, where it is persistent,
/// all that follow.
struct Fault {
  std::int64_t first = 1;
  bool isPersistent = false;
  int error = 5;  ///< errno: EIO, or 28 for ENOSPC
};

/// Faults of the disk, under SQLite's own file system layer: opening, reading, writing, growing,
/// truncating, removing, mapping and flushing of files. (Not locking: SQLite takes a lock that
/// fails for one that somebody holds, whatever the reason, and waits.)
namespace io_faults {
void arm(const Fault& fault);
/// How many calls there were since it was armed.
std::int64_t disarm();
bool hasFired();
}  // namespace io_faults

/// Faults of memory: SQLite asks for some and gets none.
namespace memory_faults {
void arm(const Fault& fault);
std::int64_t disarm();
bool hasFired();
/// Before any database is open: puts itself between SQLite and malloc.
void install();
}  // namespace memory_faults

}  // namespace tests
