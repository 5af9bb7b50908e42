// A linear programme, solved by CLP: maximise cost . x, where rows of A x and x itself lie between bounds.
#pragma once

#include <memory>
#include <vector>

namespace voussoir {

struct ProgrammeEntry {
  int row;
  double value;
};

enum class ProgrammeEnd { optimal, infeasible, unbounded, failed };

/// Which variables stand at their bounds, per column, then per row; empty when nothing is known.
using ProgrammeBasis = std::vector<unsigned char>;

struct ProgrammeSolution {
  ProgrammeEnd end = ProgrammeEnd::failed;
  double value = 0;           ///< of the objective
  std::vector<double> x;      ///< per column
  std::vector<double> price;  ///< per row: change of the objective per change of its bounds
  int iterations = 0;
};

/// A column that rests at its upper bound, as a basis has it, rests at its lower bound instead; one of the basis stays.
void rest_at_lower_bound(ProgrammeBasis&, int column);

/// While a programme is solved CLP asks so, every tenth of a second; once the answer is yes it ends as one that failed,
/// and so does every other from then on.
void end_linear_programmes_when(bool (*asked_to_stop)());

class LinearProgramme {
 public:
  LinearProgramme();
  ~LinearProgramme();
  LinearProgramme(LinearProgramme&&) noexcept;
  LinearProgramme& operator=(LinearProgramme&&) noexcept;

  int add_row(double lower, double upper);
  int add_column(std::vector<ProgrammeEntry> entries, double lower, double upper, double cost);
  void set_row(int row, double lower, double upper);
  void set_column(int column, double lower, double upper);
  void set_cost(int column, double cost);
  int rows() const;
  int columns() const;

  /// From the basis of the last time, where there is one.
  ProgrammeSolution maximise();
  /// The same by the dual method: where its prices may stay as they are, and bounds have changed.
  ProgrammeSolution maximise_from_prices();
  /// That of the last time.
  ProgrammeBasis basis() const;
  /// Begins from the basis of another programme that is nearly the same. Columns that the other had not yet got, the
  /// last ones, rest at their lower bounds; a basis of other rows or of more columns is of no use.
  void start_from(ProgrammeBasis);

 private:
  struct Parts;
  ProgrammeSolution solution() const;
  std::unique_ptr<Parts> parts_;
};

}  // namespace voussoir
