// How the numbers of a record stand in its file, as a scene says it.
#pragma once

#include <string>
#include <vector>

namespace voussoir {

class ParameterSection;

enum class RecordLayout {
  time_and_value,  ///< a row for each time
  values,          ///< values alone, one after the other, however many a line
  peer_at2         ///< values as in PEER's AT2 files, whose heading tells their number and the time between them
};

/// A column of values that a load reads, under the key by which a scene names it.
struct ValueColumn {
  std::string key;     ///< "x column"
  int number = 0;      ///< from 1; 0: not named
  bool in_use = true;  ///< there is a record to take it from
};

struct RecordLayoutParameters {
  RecordLayout layout = RecordLayout::time_and_value;
  int header_lines = 0;  ///< lines at the top that are left out, whatever they hold
  int time_column = 0;   ///< from 1; 0: rows hold two numbers, the time and the value
  double time_step = 0;  ///< [s] between values without times

  /// Declares the keys of the layout, without those of columns.
  void declare(ParameterSection&);
  /// Refuses keys that do not go together. To be called when columns have been declared.
  void check(ParameterSection&, const std::vector<ValueColumn>&) const;
};

}  // namespace voussoir
