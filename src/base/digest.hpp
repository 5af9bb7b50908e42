// A number that tells whether bytes are still what they were.
//
// FNV-1a: http://www.isthe.com/chongo/tech/comp/fnv/. Against damage, not against forgery.
#pragma once

#include <cstddef>
#include <cstdint>

namespace voussoir {

constexpr std::uint64_t no_bytes_digest = 14695981039346656037u;

/// @param start  digest of the bytes before these
inline std::uint64_t digest(const void* bytes, std::size_t count, std::uint64_t start = no_bytes_digest) {
  constexpr std::uint64_t prime = 1099511628211u;
  for (std::size_t k = 0; k < count; ++k) start = (start ^ static_cast<const unsigned char*>(bytes)[k]) * prime;
  return start;
}

}  // namespace voussoir
