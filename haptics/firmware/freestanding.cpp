// What the compiler may call, although there is no C library.
#include <stddef.h>

extern "C" {
void* memcpy(void* to, const void* from, size_t count) {
  auto* out = static_cast<volatile char*>(to);
  const auto* in = static_cast<const char*>(from);
  for (size_t i = 0; i < count; ++i) out[i] = in[i];
  return to;
}

void* memset(void* to, int value, size_t count) {
  auto* out = static_cast<volatile char*>(to);
  for (size_t i = 0; i < count; ++i) out[i] = static_cast<char>(value);
  return to;
}
}
