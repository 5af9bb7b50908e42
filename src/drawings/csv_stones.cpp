// A table of corners: a row for each, in the order they go around their stone.
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "base/text.hpp"
#include "base/words.hpp"
#include "drawings/drawing_files.hpp"
#include "stones/stone_text.hpp"

namespace voussoir {
namespace {

std::string unquoted(const std::string& text) {
  const std::string t = trimmed(text);
  return t.size() >= 2 && t.front() == '"' && t.back() == '"' ? trimmed(t.substr(1, t.size() - 2)) : t;
}

class CsvStones {
 public:
  CsvStones(const std::string& file, const std::string& contents) : file_(file), contents_(contents) {
    if (contents_.compare(0, 3, "\xEF\xBB\xBF") == 0) contents_.erase(0, 3);  // what Excel writes first
  }

  DrawnFile read() {
    std::vector<std::string> words;
    if (next(words)) read_head(words);
    while (next(words)) read_row(words);
    end_stone();
    if (drawn_.stones.empty())
      refuse_stones(file_, "holds no row below its head", "Give a row for each corner: stone, x, y");
    return std::move(drawn_);
  }

 private:
  bool next(std::vector<std::string>& words) {
    words.clear();
    while (words.empty() && at_ < contents_.size()) {
      const auto [end, following] = end_of_line(contents_, at_);
      const std::string text = trimmed(contents_.substr(at_, end - at_));
      at_ = following;
      ++line_;
      if (text.empty() || text[0] == '#') continue;
      if (separator_.empty())
        separator_ = text.find(';') != std::string::npos ? ";" : text.find('\t') != std::string::npos ? "\t" : ",";
      for (const auto& word : split(text, separator_)) words.push_back(as_utf8(unquoted(word)));
    }
    return !words.empty();
  }

  [[noreturn]] void refuse(const std::string& why, const std::string& advice) const {
    refuse_stones(file_, "line " + std::to_string(line_) + " " + why, advice);
  }

  void read_head(const std::vector<std::string>& words) {
    for (std::size_t k = 0; k < words.size(); ++k) column_.emplace(lower(words[k]), k);
    for (const char* wanted : {"stone", "x", "y"}) {
      if (column_.count(wanted)) continue;
      refuse(
          "has no column " + in_quotes(wanted) + did_you_mean(wanted, words) + ": its columns are " + list_of(words),
          "The first line names the columns: stone, x, y (corners in their order around the stone), and where wanted "
          "set and hole");
    }
    if (column_.size() < words.size()) refuse("has two columns of one name: " + list_of(words), "Remove one");
    for (const auto& [name, k] : column_)
      if (name != "stone" && name != "x" && name != "y" && name != "set" && name != "hole")
        drawn_.unused.push_back("the column " + in_quotes(words[k]));
  }

  std::string word(const std::vector<std::string>& words, const std::string& column) const {
    const auto found = column_.find(column);
    return found == column_.end() || found->second >= words.size() ? "" : words[found->second];
  }

  double number(const std::vector<std::string>& words, const std::string& column) const {
    const std::string text = word(words, column);
    const auto value = number_in(text);
    if (value && std::isfinite(*value)) return *value;
    const bool comma = text.find(',') != std::string::npos;
    refuse("has " + (text.empty() ? "nothing" : in_quotes(text)) + " in the column " + column +
               ", where a number is wanted",
           comma ? "Write decimal points, 0.25, not commas" : "Write it as 0.25 or 2.5e-1");
  }

  void read_row(const std::vector<std::string>& words) {
    if (words.size() > column_.size())
      refuse("has " + counted(words.size(), "word") + ", where the head names " + counted(column_.size(), "column"),
             separator_ == "," ? "Write decimal points, 0.25, not commas, and names without commas"
                               : "Give as many as there are columns");
    const std::string name = word(words, "stone");
    if (name.empty()) refuse("names no stone", "Give every corner its stone, by name or number");
    const std::string set = word(words, "set"), hole = word(words, "hole");
    if (stone_.loops.empty() || name != stone_.name) begin_stone(name, set);
    if (set != set_)
      refuse("says that stone " + in_quotes(name) + " is in the set " + in_quotes(set) + ", and the rows above " +
                 in_quotes(set_),
             "Give all corners of a stone one set");
    if (hole != hole_) {
      if (!holes_.insert(hole).second)
        refuse("goes on with hole " + in_quotes(hole) + " of stone " + in_quotes(name) + " after another",
               "Put the rows of one hole together");
      hole_ = hole;
      stone_.loops.emplace_back();
    }
    auto& loop = stone_.loops.back();
    loop.corners.push_back({number(words, "x"), number(words, "y")});
    loop.curved.push_back(0);
  }

  void begin_stone(const std::string& name, const std::string& set) {
    end_stone();
    if (const auto known = line_of_.find(name); known != line_of_.end())
      refuse("goes on with stone " + in_quotes(name) + ", which begins in line " + std::to_string(known->second) +
                 " and ended before other stones",
             "Put the rows of one stone together, or give the other stone a name of its own");
    line_of_[name] = line_;
    stone_ = {};
    stone_.name = name;
    stone_.origin = std::filesystem::path(file_).filename().string() + ", line " + std::to_string(line_);
    stone_.loops.emplace_back();
    hole_.clear();
    holes_ = {""};
    set_ = set;
    if (!set_.empty()) stone_.sets = {set_};
  }

  void end_stone() {
    if (!stone_.loops.empty()) drawn_.stones.push_back(std::move(stone_));
    stone_ = {};
  }

  std::string file_, contents_, separator_;
  std::size_t at_ = 0;
  int line_ = 0;
  std::map<std::string, std::size_t> column_;
  std::map<std::string, int> line_of_;  ///< where each stone begins
  DrawnFile drawn_;
  OutlinedStone stone_;  ///< that is being read
  std::string set_, hole_;
  std::set<std::string> holes_;  ///< of it
};

}  // namespace

DrawnFile read_csv_stones(const std::string& file, const std::string& contents) {
  return CsvStones(file, contents).read();
}

}  // namespace voussoir
