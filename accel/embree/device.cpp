// SPDX-License-Identifier: Apache-2.0
#include "accel/embree/device.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "core/error.h"
#include "core/parallel.h"
#include "core/threads.h"

namespace twinray::embree {
namespace {

constexpr std::array<const char*, 6> instruction_sets{"sse2", "sse4.2", "avx", "avx2", "avx512", "default"};

const char* describe(RTCError code) {
  switch (code) {
    case RTC_ERROR_INVALID_ARGUMENT:
      return "invalid argument";
    case RTC_ERROR_INVALID_OPERATION:
      return "invalid operation";
    case RTC_ERROR_OUT_OF_MEMORY:
      return "out of memory";
    case RTC_ERROR_UNSUPPORTED_CPU:
      return "the CPU is not supported";
    case RTC_ERROR_CANCELLED:
      return "cancelled";
    default:
      return "unknown error";
  }
}

}  // namespace

Device::Device(const std::string& configuration)
    : state_(std::make_unique<State>()), device_(rtcNewDevice(configuration.c_str())) {
  if (!device_)
    throw Error(fmt::format("Embree gives no device for \"{}\": {}", configuration,
                            describe(rtcGetDeviceError(nullptr))));
  rtcSetDeviceErrorFunction(device_.get(), on_error, state_.get());
  rtcSetDeviceMemoryMonitorFunction(device_.get(), on_memory, state_.get());
  const RTCError code = rtcGetDeviceError(device_.get());
  if (code != RTC_ERROR_NONE)
    throw Error(fmt::format("Embree refuses the configuration \"{}\": {}", configuration, describe(code)));
}

void Device::check(const char* doing) {
  const std::lock_guard lock(state_->mutex);
  if (state_->code == RTC_ERROR_NONE) return;
  throw Error(fmt::format("Embree failed {}: {}{}{}", doing, describe(state_->code),
                          state_->message[0] ? ": " : "", state_->message));
}

void Device::on_error(void* pointer, RTCError code, const char* message) noexcept {
  State& state = *static_cast<State*>(pointer);
  const std::lock_guard lock(state.mutex);
  if (state.code != RTC_ERROR_NONE) return;
  state.code = code;
  if (message) std::strncpy(state.message, message, sizeof state.message - 1);
}

bool Device::on_memory(void* state, ssize_t bytes, bool) noexcept {
  static_cast<State*>(state)->bytes += bytes;
  return true;
}

std::string configuration(const BuildOptions& options) {
  const std::string& isa = options.embree_isa;
  if (std::find(instruction_sets.begin(), instruction_sets.end(), isa) == instruction_sets.end())
    throw Error(fmt::format("Embree has no instruction set \"{}\"; valid are {}", isa,
                            fmt::join(instruction_sets, ", ")));
  std::string words = isa == "default" ? "" : "max_isa=" + isa;
  // Said only where they are fewer than Embree would take: it holds all of oneTBB to the number.
  const int threads = count_threads(options.threads).usable;
  if (threads < machine_threads()) words += fmt::format("{}threads={}", words.empty() ? "" : ",", threads);
  return words;
}

void attach(RTCScene scene, GeometryOwner geometry, unsigned id) {
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometryByID(scene, geometry.get(), id);
}

void commit(Device& device, RTCScene scene, int threads) {
  with_threads(threads, [&] { rtcCommitScene(scene); });
  device.check("to build its tree");
}

}  // namespace twinray::embree
