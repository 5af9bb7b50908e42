// Values as bytes, for another process of this program. What is read may come from a process that worked on a file of a
// stranger, so no number of it is believed.
#pragma once

#include <algorithm>
#include <string>
#include <type_traits>

#include "base/error.hpp"

namespace voussoir {

[[noreturn]] inline void refuse_bytes(const std::string& why) {
  throw InputError("mesh > gmsh: what gmsh made of the file is no mesh\n  (" + why +
                   ").\n  Open the file in gmsh itself; where it is damaged, save it anew in format 4.1.");
}

/// Values one after the other. Functions that take either of the two write and read, so that these cannot drift apart.
struct ByteWriter {
  std::string bytes;
  template <class T>
  void plain(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  /// @param bytes_each  of a member, at the least
  template <class T>
  std::size_t size(const T& list, std::size_t) {
    plain(list.size());
    return list.size();
  }
};

struct ByteReader {
  const char* at;
  const char* end;
  explicit ByteReader(const std::string& bytes) : at(bytes.data()), end(bytes.data() + bytes.size()) {}
  std::size_t left() const { return static_cast<std::size_t>(end - at); }
  template <class T>
  void plain(T& value) {
    if (left() < sizeof value) refuse_bytes("it ends too early");
    std::copy(at, at + sizeof value, reinterpret_cast<char*>(&value));
    at += sizeof value;
  }
  template <class T>
  std::size_t size(T& list, std::size_t bytes_each) {
    std::size_t count = 0;
    plain(count);
    if (count > left() / bytes_each) refuse_bytes("it ends too early");
    list.resize(count);
    return count;
  }
};

/// @param list  of values without pointers, or a string
template <class Bytes, class List>
void plain_list(Bytes& bytes, List& list) {
  const std::size_t count = bytes.size(list, sizeof list[0]);
  for (std::size_t k = 0; k < count; ++k) bytes.plain(list[k]);
}

}  // namespace voussoir
