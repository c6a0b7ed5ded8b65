#pragma once

// Points that fill the unit square or cube evenly: the first four dimensions of Sobol's sequence,
// scrambled as Owen proposed (1995), by a hash instead of tables (Burley 2020). In two dimensions every
// aligned run of 2^k points is a (0, k, 2)-net: each of the 2^k equal rectangles of any one shape 2^-i
// by 2^(i-k) holds one of them. In three it is a (1, k, 3)-net: each of 2^(k-1) equal boxes holds two, and
// in four a (3, k, 4)-net.
// A few operations on 32 bits a point, without branches: loops over lanes use them, too.

#include <array>
#include <cstdint>

namespace restframe {

inline std::uint32_t bits_reversed(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xff00ff00U) >> 8) | ((x & 0x00ff00ffU) << 8);
  x = ((x & 0xf0f0f0f0U) >> 4) | ((x & 0x0f0f0f0fU) << 4);
  x = ((x & 0xccccccccU) >> 2) | ((x & 0x33333333U) << 2);
  return ((x & 0xaaaaaaaaU) >> 1) | ((x & 0x55555555U) << 1);
}

// A bijection that flips each bit or not by a hash of the seed and all lower bits: with those bits
// reversed it is Owen's scrambling. Sums and products carry upwards only (Laine and Karras 2011); the
// order of the steps is Vegdahl's (2021), with which the flips of any two nodes of the binary tree were
// measured to be independent over seeds. The constants are random even numbers.
inline std::uint32_t scrambled_upwards(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0xaa2b1c5aU;
  x += seed;
  x *= (seed >> 16) | 1U;
  x ^= x * 0x76957d50U;
  return x ^ (x * 0x31b18fb6U);
}

// The second dimension of Sobol's sequence at `index`, its bits reversed (the first one's are the
// index itself). Its generator matrix holds Pascal's triangle modulo 2, which is a Kronecker power
// of a 2 by 2 matrix: a step a factor.
inline std::uint32_t sobol_second_reversed(std::uint32_t index) {
  index ^= (index & 0xaaaaaaaaU) >> 1;
  index ^= (index & 0xccccccccU) >> 2;
  index ^= (index & 0xf0f0f0f0U) >> 4;
  index ^= (index & 0xff00ff00U) >> 8;
  return index ^ (index >> 16);
}

// The direction numbers of one dimension, their bits reversed.
using SobolDirections = std::array<std::uint32_t, 32>;

// Of the third dimension: from the primitive polynomial x^2 + x + 1 and the first numbers 1 and 3, each
// m_k is 2 m_(k-1) xor 4 m_(k-2) xor m_(k-2) (Bratley and Fox 1988, section 2). Bit i of m_k is bit
// k - 1 - i here.
inline constexpr SobolDirections sobol_third = [] {
  SobolDirections reversed{1, 3};
  for (std::size_t k = 2; k < 32; ++k) {
    reversed[k] = reversed[k - 1] ^ reversed[k - 2] ^ (reversed[k - 2] << 2);
  }
  return reversed;
}();

// Of the fourth: from x^3 + x + 1 and the first numbers 1, 3 and 1 (Joe and Kuo 2008), each m_k is
// 4 m_(k-2) xor 8 m_(k-3) xor m_(k-3).
inline constexpr SobolDirections sobol_fourth = [] {
  SobolDirections reversed{1, 3, 4};
  for (std::size_t k = 3; k < 32; ++k) {
    reversed[k] = reversed[k - 2] ^ reversed[k - 3] ^ (reversed[k - 3] << 3);
  }
  return reversed;
}();

// A coordinate of Sobol's sequence at `index`, its bits reversed.
inline std::uint32_t sobol_reversed(const SobolDirections& directions, std::uint32_t index) {
  std::uint32_t reversed = 0;
  for (std::uint32_t bit = 0; bit < 32; ++bit) {
    reversed ^= (0U - ((index >> bit) & 1U)) & directions[bit];
  }
  return reversed;
}

// The order in which the points of a sequence come, changed as a tree's: aligned runs stay together.
inline std::uint32_t shuffled_index(std::uint32_t index_reversed, std::uint32_t seed) {
  return bits_reversed(scrambled_upwards(index_reversed, seed));
}

// From the reversed bits of a coordinate to a number in [0, 1).
inline float scrambled_unit(std::uint32_t coordinate_reversed, std::uint32_t seed) {
  return static_cast<float>(bits_reversed(scrambled_upwards(coordinate_reversed, seed)) >> 8) *
         0x1p-24F;
}

// Where (x, y) comes on a curve that fills the plane square by square (Morton's order). Both below
// 2^16.
inline std::uint32_t morton_place(std::uint32_t x, std::uint32_t y) {
  const auto apart = [](std::uint32_t v) {
    v &= 0xffffU;  // pixels left of and above the display have places, too
    v = (v | (v << 8)) & 0x00ff00ffU;
    v = (v | (v << 4)) & 0x0f0f0f0fU;
    v = (v | (v << 2)) & 0x33333333U;
    return (v | (v << 1)) & 0x55555555U;
  };
  return apart(x) | (apart(y) << 1);
}

}  // namespace restframe
