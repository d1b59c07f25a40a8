// SPDX-License-Identifier: Apache-2.0
// Private: Embree's device, scene and geometry as owners, and its errors as twinray::Error.
#pragma once
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>

#include "accel/build_options.h"
#include "accel/embree/api.h"

namespace twinray::embree {

struct Release {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;
using GeometryOwner = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, Release>;

/// A device that remembers its first error and how much memory it holds.
class Device {
 public:
  /// `configuration`: Embree's own words, such as "threads=2". Throws Error where Embree refuses it.
  explicit Device(const std::string& configuration);

  RTCDevice get() const { return device_.get(); }
  /// Throws Error, which says what was being done, if Embree has reported an error.
  void check(const char* doing);
  std::size_t bytes() const { return std::size_t(state_->bytes.load()); }

 private:
  struct State {
    std::atomic<std::ptrdiff_t> bytes = 0;
    std::mutex mutex;
    RTCError code = RTC_ERROR_NONE;
    char message[256] = {};
  };
  static void on_error(void* state, RTCError code, const char* message) noexcept;
  static bool on_memory(void* state, ssize_t bytes, bool post) noexcept;

  std::unique_ptr<State> state_;  // Before the device, which reports to it until it is gone.
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device_;
};

/// The words for options.embree_isa, an upper bound of the instruction set, and the number of threads (0:
/// Embree's choice). Throws Error that lists the instruction sets that Embree knows.
std::string configuration(const BuildOptions& options);

/// Commits a geometry and makes it number `id` of a scene, which keeps it.
void attach(RTCScene scene, GeometryOwner geometry, unsigned id);

/// Builds the scene's tree on `threads` threads (0: as many as the process may use). Throws Error where any
/// call since the device was made has failed.
void commit(Device& device, RTCScene scene, int threads);

}  // namespace twinray::embree
