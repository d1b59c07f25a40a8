// SPDX-License-Identifier: Apache-2.0
#include "tests/support/counted_memory.h"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> current{0}, peak{0};

void* counted(void* block) {
  if (!block) throw std::bad_alloc();
  const std::size_t now = current += malloc_usable_size(block);
  std::size_t most = peak;
  while (now > most && !peak.compare_exchange_weak(most, now)) {
  }
  return block;
}

void release(void* block) {
  if (block) current -= malloc_usable_size(block);
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return counted(std::malloc(std::max<std::size_t>(size, 1))); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  void* const block = std::malloc(std::max<std::size_t>(size, 1));
  return block ? counted(block) : nullptr;
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  const std::size_t unit = std::size_t(alignment);
  return counted(std::aligned_alloc(unit, (std::max<std::size_t>(size, 1) + unit - 1) / unit * unit));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }

namespace twinray::test {

PeakMemory::PeakMemory() : start_(current) { peak = start_; }

std::size_t PeakMemory::bytes() const { return peak - std::min<std::size_t>(peak, start_); }

}  // namespace twinray::test
