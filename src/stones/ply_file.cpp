// PLY: a header that says what follows, then points and faces, ascii or binary.
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>

#include "base/text.hpp"
#include "base/words.hpp"
#include "stones/stone_files.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

const std::map<std::string, PlyType> types{
    {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64}};

struct Property {
  std::string name;
  PlyType type{}, count{};
  bool list = false;
};

struct Element {
  std::string name;
  int number = 0;
  std::vector<Property> properties;
};

struct Header {
  std::string format;
  std::vector<Element> elements;
  std::size_t size = 0;  ///< [bytes]
};

PlyType type_in(const StoneLines& lines, std::size_t word) {
  const auto found = word < lines.words().size() ? types.find(lines.words()[word]) : types.end();
  if (found == types.end())
    lines.refuse("has a property of a type that PLY does not know", "Known are char, short, int, float, double");
  return found->second;
}

Property property_in(const StoneLines& lines) {
  Property p;
  const auto& words = lines.words();
  p.list = words.size() == 5 && words[1] == "list";
  if (!p.list && words.size() != 3)
    lines.refuse("is a property of " + counted(words.size(), "word"), "Export the file anew");
  if (p.list) p.count = type_in(lines, 2);
  p.type = type_in(lines, p.list ? 3 : 1);
  p.name = words.back();
  return p;
}

Header header_in(const std::string& file, StoneLines& lines) {
  Header header;
  if (!lines.next() || lines.words()[0] != "ply")
    refuse_stones(file, "does not begin with the word ply", "Export the file anew");
  while (lines.next()) {
    const auto& words = lines.words();
    if (words[0] == "end_header") {
      header.size = lines.behind();
      return header;
    }
    if (words[0] == "format" && words.size() > 1) header.format = words[1];
    if (words[0] == "element" && words.size() == 3) {
      header.elements.push_back({words[1], lines.whole_number(2), {}});
      if (header.elements.back().number < 0)
        lines.refuse("counts " + counted(header.elements.back().number, "element"),
                     "The file is damaged: export it anew");
    }
    if (words[0] == "property") {
      if (header.elements.empty()) lines.refuse("has a property of no element", "Export the file anew");
      header.elements.back().properties.push_back(property_in(lines));
    }
  }
  refuse_stones(file, "has no end of its header (end_header)", "The file is damaged: export it anew");
}

/// Numbers one after the other, whatever the format.
class Numbers {
 public:
  Numbers(const std::string& file, const std::string& contents, const Header& header, StoneLines& lines)
      : ascii_(header.format == "ascii"),
        lines_(lines),
        bytes_(file, contents, header.size, header.format == "binary_big_endian") {
    if (!ascii_ && header.format.rfind("binary_", 0) != 0)
      refuse_stones(file, "has the format " + in_quotes(header.format),
                    "Known are ascii, binary_little_endian, binary_big_endian");
  }
  void begin_line() {
    if (!ascii_) return;
    word_ = 0;
    if (!lines_.next()) lines_.refuse("is the last, and more are wanted", "It was cut, or is damaged: export it anew");
  }
  double next(PlyType type) {
    if (ascii_) return lines_.number(word_++);
    switch (type) {
      case PlyType::int8:
        return bytes_.plain<std::int8_t>();
      case PlyType::uint8:
        return bytes_.plain<std::uint8_t>();
      case PlyType::int16:
        return bytes_.plain<std::int16_t>();
      case PlyType::uint16:
        return bytes_.plain<std::uint16_t>();
      case PlyType::int32:
        return bytes_.plain<std::int32_t>();
      case PlyType::uint32:
        return bytes_.plain<std::uint32_t>();
      case PlyType::float32:
        return static_cast<double>(bytes_.plain<float>());
      case PlyType::float64:
        break;
    }
    return bytes_.plain<double>();
  }

 private:
  bool ascii_;
  StoneLines& lines_;
  StoneBytes bytes_;
  std::size_t word_ = 0;
};

class PlyReader {
 public:
  PlyReader(const std::string& file, const std::string& contents)
      : file_(file),
        lines_(file, contents),
        header_(header_in(file, lines_)),
        numbers_(file, contents, header_, lines_) {
    stone_.name = stem(file);
    stone_.origin = std::filesystem::path(file).filename().string();
  }

  StoneSurface read() {
    for (const Element& element : header_.elements)
      for (int k = 0; k < element.number; ++k) read_row(element, k);
    if (stone_.faces.empty()) refuse_stones(file_, "has no faces", "A cloud of points is no stone: make it a mesh");
    for (std::size_t k = 0; k < stone_.faces.size(); ++k)
      for (const int point : stone_.faces[k])
        if (point < 0 || point >= static_cast<int>(stone_.points.size()))
          refuse_stones(file_,
                        "face " + std::to_string(k) + " names the point " + std::to_string(point) + ", of " +
                            std::to_string(stone_.points.size()) + " counted from 0",
                        "The file is damaged: export it anew");
    return stone_;
  }

 private:
  void read_row(const Element& element, int row) {
    numbers_.begin_line();
    const bool vertex = element.name == "vertex", face = element.name == "face";
    Vector<3> x{NAN, NAN, NAN};
    for (const Property& p : element.properties) {
      if (p.list) {
        // Others, such as texcoord, may be of any length.
        const bool corners = face && (p.name == "vertex_indices" || p.name == "vertex_index");
        auto list = read_list(p, element, row, corners ? 3 : 0);
        if (corners) stone_.faces.push_back(std::move(list));
        continue;
      }
      const double value = numbers_.next(p.type);
      for (int i = 0; i < 3; ++i)
        if (p.name == std::string(1, static_cast<char>('x' + i))) x[i] = value;
    }
    if (!vertex) return;
    if (!std::isfinite(x[0] + x[1] + x[2]))
      refuse_stones(file_, "vertex " + std::to_string(row) + " has no x, y and z that are numbers",
                    "Export the file anew");
    stone_.points.push_back(x);
  }

  std::vector<int> read_list(const Property& p, const Element& element, int row, int least) {
    const double count = numbers_.next(p.count);
    if (count < least)
      refuse_stones(file_,
                    element.name + " " + std::to_string(row) + " has " + six_digits(count) + " members of its list " +
                        in_quotes(p.name),
                    least > 0 ? "A face needs three corners" : "The file is damaged: export it anew");
    std::vector<int> list;
    for (double k = 0; k < count; ++k) {
      const double value = numbers_.next(p.type);
      list.push_back(value >= 0 && value < 2e9 ? static_cast<int>(value) : -1);
    }
    return list;
  }

  std::string file_;
  StoneLines lines_;
  Header header_;
  Numbers numbers_;
  StoneSurface stone_;
};

}  // namespace

std::vector<StoneSurface> read_ply(const std::string& file, const std::string& contents) {
  return {PlyReader(file, contents).read()};
}

}  // namespace voussoir
