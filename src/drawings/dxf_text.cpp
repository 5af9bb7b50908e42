#include "drawings/dxf_text.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "drawings/outlined_stone.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {

DxfText::DxfText(const std::string& file, const std::string& contents) : file_(file) {
  if (contents.compare(0, 18, "AutoCAD Binary DXF") == 0)
    refuse_stones(file_, "is a binary DXF", "Save it as an ASCII DXF");
  std::vector<std::string> lines;
  for (const auto& text : lines_of(contents)) lines.push_back(trimmed(text));
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  for (std::size_t k = 0; k + 1 < lines.size(); k += 2) {
    const auto code = whole_number_in(lines[k]);
    if (!code)
      refuse_stones(file_,
                    "line " + std::to_string(k + 1) + " has " + in_quotes(as_utf8(lines[k])) +
                        " where the code of a group is wanted",
                    "It is damaged, or no DXF: save it as an ASCII DXF");
    pairs_.push_back({*code, as_utf8(lines[k + 1]), static_cast<int>(k) + 2});
  }
  const bool ends = std::any_of(pairs_.begin(), pairs_.end(), [](const DxfPair& p) { return p.value == "ENTITIES"; });
  if (!ends) refuse_stones(file_, "has no section ENTITIES", "It is cut, or no DXF: save it as an ASCII DXF");
  if (pairs_.back().value != "EOF")
    refuse_stones(file_, "ends at line " + std::to_string(lines.size()) + " without EOF",
                  "It was cut when it was copied, or is damaged: save it anew");
}

void DxfText::refuse(const DxfPair& at, const std::string& why, const std::string& advice) const {
  refuse_stones(file_, "line " + std::to_string(at.line) + " " + why, advice);
}

double DxfText::number(const DxfPair& p) const {
  const auto value = number_in(p.value);
  if (!value || !std::isfinite(*value))
    refuse(p, "has " + in_quotes(p.value) + " where a number is wanted", "It is damaged: save it anew");
  return *value;
}

int DxfText::whole(const DxfPair& p) const {
  const auto value = whole_number_in(p.value);
  if (!value) refuse(p, "has " + in_quotes(p.value) + " where a whole number is wanted", "It is damaged: save it anew");
  return *value;
}

}  // namespace voussoir
