// SPDX-License-Identifier: Apache-2.0
// Private: vectors whose memory costs little to get.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/mman.h>

namespace twinray {

/// Large arrays lie in pages of 2 MB where the system has them: fewer page faults for who builds them, and
/// fewer misses of the address cache for who reads them. Elements made without a value are not initialised.
template <typename T>
struct BigAllocator {
  using value_type = T;
  static constexpr std::size_t page = std::size_t{1} << 21;

  BigAllocator() = default;
  template <typename U>
  BigAllocator(const BigAllocator<U>&) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    const bool is_large = bytes >= 2 * page;
    const std::size_t alignment = is_large ? page : std::max(alignof(T), alignof(std::max_align_t));
    void* const memory = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
    if (!memory) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    if (is_large) madvise(memory, bytes, MADV_HUGEPAGE);  // If it is refused, nothing is lost.
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  template <typename U>
  void construct(U*) {}
  template <typename U, typename... Values>
  void construct(U* place, Values&&... values) {
    std::construct_at(place, std::forward<Values>(values)...);
  }
  friend bool operator==(const BigAllocator&, const BigAllocator&) { return true; }
};

template <typename T>
using BigVector = std::vector<T, BigAllocator<T>>;

/// Gives the memory of elements that nobody will read again back to the system, before their vector ends: the
/// whole pages among them. Their values are lost.
template <typename T>
void release_memory(T* first, std::size_t count) {
  static_assert(std::is_trivially_destructible_v<T>);
  constexpr std::uintptr_t page = 4096;
  const auto begin = (reinterpret_cast<std::uintptr_t>(first) + page - 1) / page * page;
  const auto end = reinterpret_cast<std::uintptr_t>(first + count) / page * page;
  // If it is refused, nothing is lost.
  if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_DONTNEED);
}

/// Gives the memory that was freed and that the allocator keeps back to the system, where it can be asked to.
inline void release_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace twinray
