#include "core/random.h"

#include <cmath>

#include <Random123/philox.h>

#include "core/check.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

// SplitMix64's finaliser: every input bit changes every output bit.
std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

// FNV-1a, 64 bits.
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

}  // namespace

Rng::Rng(std::uint64_t seed) : key_(mixed(seed)) {}

Rng Rng::stream(std::string_view name, std::uint64_t a, std::uint64_t b) const {
  Rng result(0);
  result.key_ = mixed(mixed(mixed(key_ ^ hash_of(name)) ^ a) ^ b);
  return result;
}

std::uint64_t Rng::bits() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  using Philox = r123::Philox4x32;
  const auto low = [](std::uint64_t v) { return static_cast<std::uint32_t>(v); };
  const auto high = [](std::uint64_t v) { return static_cast<std::uint32_t>(v >> 32); };
  const Philox::ctr_type counter = {{low(counter_), high(counter_), 0, 0}};
  const Philox::key_type key = {{low(key_), high(key_)}};
  const Philox::ctr_type block = Philox()(counter, key);
  ++counter_;
  spare_ = (static_cast<std::uint64_t>(block[3]) << 32) | block[2];
  has_spare_ = true;
  return (static_cast<std::uint64_t>(block[1]) << 32) | block[0];
}

double Rng::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1.0p-53;
}

double Rng::uniform(double low, double high) {
  return low + (high - low) * uniform();
}

double Rng::normal() {
  if (has_spare_normal_) {
    has_spare_normal_ = false;
    return spare_normal_;
  }
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));  // 1 - u is in (0, 1]
  const double angle = 2.0 * kPi * uniform();
  spare_normal_ = radius * std::sin(angle);
  has_spare_normal_ = true;
  return radius * std::cos(angle);
}

double Rng::normal(double mean, double sigma) {
  CHECK(sigma >= 0.0);
  return mean + sigma * normal();
}

std::uint64_t Rng::index(std::uint64_t count) {
  CHECK(count > 0);
  const std::uint64_t limit = UINT64_MAX - UINT64_MAX % count;
  for (;;) {
    const std::uint64_t value = bits();
    if (value < limit) return value % count;
  }
}

}  // namespace mapbed
