// Times and values from a text file, for records of motion and load.
#pragma once

#include <Teuchos_Comm.hpp>
#include <string>
#include <vector>

#include "loads/record_layout_parameters.hpp"

namespace voussoir {

/// The same on every rank.
struct TimeSeries {
  std::vector<double> time;          ///< [s] rising
  std::vector<double> value;         ///< one for each time
  std::vector<std::string> heading;  ///< lines above the numbers, comments included
};

/// Reads a file of numbers between commas, semicolons or blanks, laid out as a scene says. Above the first number
/// stands the heading: lines that begin with neither digit, sign nor point; lines that begin with # are comments
/// anywhere. What is laid out otherwise is refused, so no number of the file is left out without having been asked for.
/// Collective: rank 0 reads. Throws InputError on every rank alike.
/// @param where  what the message begins with, "xml/wall.xml: scene > loads > quake > x record"
TimeSeries read_time_series(const std::string& file, const RecordLayoutParameters&, const ValueColumn&,
                            const std::string& where, const Teuchos::Comm<int>& comm);

}  // namespace voussoir
