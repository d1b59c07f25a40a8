// SPDX-License-Identifier: Apache-2.0
#include "check/exact.h"

#include <algorithm>
#include <limits>

namespace twinray {
namespace {

using Limbs = std::vector<std::uint32_t>;

bool is_less(const Limbs& a, const Limbs& b) {
  if (a.size() != b.size()) return a.size() < b.size();
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

/// a += b, for a at least as long as b.
void add(Limbs& a, const Limbs& b) {
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < a.size() && (i < b.size() || carry); ++i) {
    carry += std::uint64_t(a[i]) + (i < b.size() ? b[i] : 0);
    a[i] = std::uint32_t(carry);
    carry >>= 32;
  }
  if (carry) a.push_back(std::uint32_t(carry));
}

/// a -= b, for a not less than b.
void subtract(Limbs& a, const Limbs& b) {
  std::int64_t borrow = 0;
  for (std::size_t i = 0; i < a.size() && (i < b.size() || borrow); ++i) {
    borrow += std::int64_t(a[i]) - (i < b.size() ? b[i] : 0);
    a[i] = std::uint32_t(borrow);
    borrow >>= 32;
  }
}

}  // namespace

Bounded operator/(const Bounded& a, const Bounded& b) {
  const double least = std::fabs(b.value) - b.error;
  if (!(least > 0)) return {0, std::numeric_limits<double>::infinity()};
  const double quotient = a.value / b.value;
  return Bounded::rounded(quotient, (a.error + std::fabs(quotient) * b.error) / least * (1 + 0x1p-48));
}

Bounded square_root(const Bounded& a) {
  const double high = std::sqrt(std::max(a.value + a.error, 0.0)) * (1 + 0x1p-50);
  const double low = std::sqrt(std::max(a.value - a.error, 0.0)) * (1 - 0x1p-50);
  return Bounded::rounded(0.5 * (high + low), 0.5 * (high - low));
}

Exact::Exact(float value) : negative_(value < 0) {
  const float mantissa = std::frexp(std::fabs(value), &exponent_);
  exponent_ -= 24;
  limbs_ = {std::uint32_t(mantissa * 0x1p24f)};
  trim();
}

void Exact::trim() {
  while (!limbs_.empty() && limbs_.back() == 0) limbs_.pop_back();
  const auto first = std::find_if(limbs_.begin(), limbs_.end(), [](std::uint32_t limb) { return limb != 0; });
  exponent_ = limbs_.empty() ? 0 : exponent_ + 32 * int(first - limbs_.begin());
  limbs_.erase(limbs_.begin(), first);
}

Limbs Exact::shifted(int bits) const {
  const std::size_t whole = std::size_t(bits / 32);
  const int part = bits % 32;
  Limbs out(whole + limbs_.size() + 1, 0);
  for (std::size_t i = 0; i < limbs_.size(); ++i) {
    const std::uint64_t wide = std::uint64_t(limbs_[i]) << part;
    out[whole + i] |= std::uint32_t(wide);
    out[whole + i + 1] = std::uint32_t(wide >> 32);
  }
  while (!out.empty() && out.back() == 0) out.pop_back();
  return out;
}

Exact operator-(Exact a) {
  a.negative_ = !a.negative_;
  return a;
}

Exact operator+(const Exact& a, const Exact& b) {
  if (a.limbs_.empty()) return b;
  if (b.limbs_.empty()) return a;
  Exact sum;
  sum.exponent_ = std::min(a.exponent_, b.exponent_);
  Limbs p = a.shifted(a.exponent_ - sum.exponent_), q = b.shifted(b.exponent_ - sum.exponent_);
  const bool swap = is_less(p, q);
  if (swap) std::swap(p, q);
  sum.negative_ = swap ? b.negative_ : a.negative_;
  if (a.negative_ == b.negative_)
    add(p, q);
  else
    subtract(p, q);
  sum.limbs_ = std::move(p);
  sum.trim();
  return sum;
}

Exact operator*(const Exact& a, const Exact& b) {
  Exact product;
  product.limbs_.assign(a.limbs_.size() + b.limbs_.size(), 0);
  product.exponent_ = a.exponent_ + b.exponent_;
  product.negative_ = a.negative_ != b.negative_;
  for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < b.limbs_.size(); ++j) {
      carry += std::uint64_t(a.limbs_[i]) * b.limbs_[j] + product.limbs_[i + j];
      product.limbs_[i + j] = std::uint32_t(carry);
      carry >>= 32;
    }
    product.limbs_[i + b.limbs_.size()] = std::uint32_t(carry);
  }
  product.trim();
  return product;
}

Bounded Exact::bounded() const {
  double value = 0;
  const std::size_t used = std::min<std::size_t>(limbs_.size(), 4);
  for (std::size_t i = 0; i < used; ++i) value = value * 0x1p32 + limbs_[limbs_.size() - 1 - i];
  value = std::ldexp(value, exponent_ + 32 * int(limbs_.size() - used));
  return {negative_ ? -value : value, limbs_.size() <= 1 ? 0 : std::fabs(value) * 0x1p-50};
}

}  // namespace twinray
