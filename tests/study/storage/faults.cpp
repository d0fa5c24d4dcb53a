#include "tests/study/storage/faults.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include <sqlite3.h>

namespace tests {
namespace {

/// Counts calls, and decides which of them fail.
struct Trigger {
  Fault fault;
  std::int64_t calls = 0;
  bool isArmed = false;
  bool hasFired = false;

  void arm(const Fault& wanted) { *this = {.fault = wanted, .isArmed = true}; }
  std::int64_t disarm() {
    isArmed = false;
    return calls;
  }
  bool fails() {
    if (!isArmed) return false;
    ++calls;
    const bool isHit = fault.isPersistent ? calls >= fault.first : calls == fault.first;
    hasFired = hasFired || isHit;
    return isHit;
  }
};

Trigger disk;
Trigger memory;

/// A function of SQLite's table of system calls, wrapped so that it can fail.
template <int kWhich, typename Result, typename... Arguments>
struct Wrapped {
  using Call = Result (*)(Arguments...);
  static inline Call real = nullptr;

  static Result call(Arguments... arguments) {
    if (disk.fails()) {
      errno = disk.fault.error;
      return (Result)(-1);  // MAP_FAILED, for a mapping
    }
    return real(arguments...);
  }

  static void install(const char* name) {
    auto* vfs = sqlite3_vfs_find(nullptr);
    auto* present = reinterpret_cast<Call>(vfs->xGetSystemCall(vfs, name));
    if (present == nullptr || present == &call) return;
    real = present;
    vfs->xSetSystemCall(vfs, name, reinterpret_cast<sqlite3_syscall_ptr>(&call));
  }
};

void installDisk() {
  Wrapped<0, int, const char*, int, int>::install("open");
  Wrapped<1, ssize_t, int, void*, size_t>::install("read");
  Wrapped<2, ssize_t, int, void*, size_t, off_t>::install("pread");
  Wrapped<3, ssize_t, int, void*, size_t, off_t>::install("pread64");
  Wrapped<4, ssize_t, int, const void*, size_t>::install("write");
  Wrapped<5, ssize_t, int, const void*, size_t, off_t>::install("pwrite");
  Wrapped<6, ssize_t, int, const void*, size_t, off_t>::install("pwrite64");
  Wrapped<7, int, int, off_t>::install("ftruncate");
  Wrapped<8, int, int, struct stat*>::install("fstat");
  Wrapped<9, int, const char*>::install("unlink");
  Wrapped<10, void*, void*, size_t, int, int, int, off_t>::install("mmap");
}

sqlite3_mem_methods realMemory;

void* faultyMalloc(int size) {
  return memory.fails() ? nullptr : realMemory.xMalloc(size);
}
void* faultyRealloc(void* block, int size) {
  return memory.fails() ? nullptr : realMemory.xRealloc(block, size);
}

}  // namespace

namespace io_faults {
void arm(const Fault& fault) {
  installDisk();
  disk.arm(fault);
}
std::int64_t disarm() {
  return disk.disarm();
}
bool hasFired() {
  return disk.hasFired;
}
}  // namespace io_faults

namespace memory_faults {
void install() {
  if (realMemory.xMalloc != nullptr) return;
  sqlite3_shutdown();
  sqlite3_config(SQLITE_CONFIG_GETMALLOC, &realMemory);
  sqlite3_mem_methods methods = realMemory;
  methods.xMalloc = faultyMalloc;
  methods.xRealloc = faultyRealloc;
  sqlite3_config(SQLITE_CONFIG_MALLOC, &methods);
  sqlite3_config(SQLITE_CONFIG_LOOKASIDE, 0, 0);  // every allocation then calls malloc
  sqlite3_initialize();
}
void arm(const Fault& fault) {
  memory.arm(fault);
}
std::int64_t disarm() {
  return memory.disarm();
}
bool hasFired() {
  return memory.hasFired;
}
}  // namespace memory_faults

}  // namespace tests

// SQLite's table of system calls has no entry for flushing files. The linker finds these functions
// before the C library's.
extern "C" {
int fdatasync(int file) {
  if (tests::disk.fails()) {
    errno = tests::disk.fault.error;
    return -1;
  }
  return static_cast<int>(syscall(SYS_fdatasync, file));
}

int fsync(int file) {
  if (tests::disk.fails()) {
    errno = tests::disk.fault.error;
    return -1;
  }
  return static_cast<int>(syscall(SYS_fsync, file));
}
}
