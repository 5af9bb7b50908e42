// Numbers from a text file, for records of motion and load.
#pragma once

#include <Teuchos_Comm.hpp>
#include <string>
#include <vector>

namespace voussoir {

/// Rows of numbers, one column after the other.
struct CsvTable {
  std::vector<std::vector<double>> columns;
};

/// Reads a file of `columns` numbers in each row, separated by commas, semicolons or blanks. Empty lines and lines that
/// begin with # or a letter (a heading) are skipped. Further columns are left out. Collective: rank 0 reads. Throws
/// InputError on every rank alike when the file cannot be read, a row is short, a number is none or not finite.
/// @param where  what the message begins with, "xml/wall.xml: scene > loads > quake > file"
CsvTable read_csv(const std::string& file, std::size_t columns, const std::string& where,
                  const Teuchos::Comm<int>& comm);

}  // namespace voussoir
