#pragma once

#include <cstdint>

namespace tests {

/// The calls that fail: number @p first after arm(), counted from 1, and, if persistent, all later
/// ones.
struct Fault {
  std::int64_t first = 1;
  bool isPersistent = false;
  int error = 5;  ///< errno: EIO, or 28 for ENOSPC
};

/// Faults of the disk, below SQLite's file system layer: opening, reading, writing, growing,
/// truncating, removing, mapping and flushing files. Locking is left out: if taking a lock fails
/// for any reason, SQLite assumes that another process holds it, and waits.
namespace io_faults {
void arm(const Fault& fault);
/// The number of calls since arm().
std::int64_t disarm();
bool hasFired();
}  // namespace io_faults

/// Faults of memory: an allocation of SQLite fails.
namespace memory_faults {
void arm(const Fault& fault);
std::int64_t disarm();
bool hasFired();
/// Replaces SQLite's allocator. Must be called before any database is open.
void install();
}  // namespace memory_faults

}  // namespace tests
