#pragma once

#include <cstddef>

namespace tests {

/// Counts calls of operator new on this thread during its lifetime. A program that uses it links
/// tests/support/allocation_counter.cpp, which replaces operator new.
class AllocationCounter {
 public:
  AllocationCounter() noexcept;
  std::size_t count() const noexcept;

 private:
  std::size_t before_;
};

}  // namespace tests
