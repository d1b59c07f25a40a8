// SPDX-License-Identifier: Apache-2.0
#include "core/exact_sums.h"

#include <iterator>
#include <span>

#include "core/columns.h"
#include "core/error.h"

namespace twinray {

void Carries::add(std::size_t place, std::int64_t carry) {
  const std::lock_guard lock(mutex_);
  if ((carries_[place] += carry) == 0) carries_.erase(place);
}

std::int64_t Carries::at(std::size_t place) const {
  if (carries_.empty()) return 0;
  const auto found = carries_.find(place);
  return found == carries_.end() ? 0 : found->second;
}

void Carries::save(std::size_t begin, std::size_t end, ColumnWriter& to) const {
  const auto first = carries_.lower_bound(begin), last = carries_.lower_bound(end);
  to.put_value(std::uint64_t(std::distance(first, last)));
  for (auto carry = first; carry != last; ++carry) {
    to.put_value(std::uint64_t(carry->first - begin));
    to.put_value(carry->second);
  }
}

void Carries::load(std::size_t places, ColumnReader& from) {
  carries_.clear();
  for (auto left = from.take_value<std::uint64_t>(); left > 0; --left) {
    const auto place = from.take_value<std::uint64_t>();
    const auto carry = from.take_value<std::int64_t>();
    if (place >= places || carry == 0 || !carries_.emplace(place, carry).second)
      throw Error("sums overflow where there are none");
  }
}

void ExactSums::add(std::size_t place, std::size_t channels, std::span<const Rgb> colors,
                    std::size_t stride) {
  constexpr float Rgb::*of[] = {&Rgb::r, &Rgb::g, &Rgb::b};
  for (std::size_t channel = 0; channel < channels; ++channel)
    if (const Int128 sum = fixed_units(colors, of[channel], stride); sum != 0)
      add_units(place + channel, sum);
}

void ExactSums::add_units(std::size_t place, Int128 units) {
  const Int128 sum = Int128(sums_[place]) + units;
  sums_[place] = std::int64_t(std::uint64_t(sum));
  const Int128 rest = sum - sums_[place];
  if (rest != 0) carries_.add(place, std::int64_t(rest >> 64));
}

Int128 ExactSums::units(std::size_t place) const {
  return Int128(carries_.at(place)) * (Int128(1) << 64) + sums_[place];
}

float ExactSums::mean(std::size_t place, std::uint32_t count) const {
  return count == 0 ? 0 : float(double(units(place)) * fixed_unit / count);
}

void ExactSums::save(std::size_t begin, std::size_t end, ColumnWriter& to) const {
  to.put(std::span(sums_).subspan(begin, end - begin));
  carries_.save(begin, end, to);
}

void ExactSums::load(ColumnReader& from) {
  from.take(std::span(sums_));
  carries_.load(sums_.size(), from);
}

}  // namespace twinray
