#include "mesh/gmsh_request.hpp"

#include "mesh/bytes.hpp"

namespace voussoir {
namespace {

/// @param p  const when it is written
template <class Bytes, class Parameters>
void exchange_request(Bytes& bytes, Parameters& p) {
  plain_list(bytes, p.file);
  bytes.plain(p.unit);
  bytes.plain(p.element_size);
  bytes.plain(p.cells);
}

}  // namespace

std::string bytes_of(const GmshParameters& p) {
  ByteWriter writer;
  exchange_request(writer, p);
  for (const auto& [name, value] : p.geometry) {
    plain_list(writer, name);
    writer.plain(value);
  }
  return writer.bytes;
}

GmshParameters gmsh_parameters_of(const std::string& bytes) {
  ByteReader reader(bytes);
  GmshParameters p;
  exchange_request(reader, p);
  while (reader.left() > 0) {
    std::string name;
    plain_list(reader, name);
    reader.plain(p.geometry[name]);
  }
  return p;
}

}  // namespace voussoir
