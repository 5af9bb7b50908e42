#include "linalg/refused_list.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <algorithm>
#include <iostream>
#include <sstream>
#include <tuple>
#include <vector>

#include "base/error.hpp"
#include "linalg/amg_preconditioner.hpp"
#include "linalg/linear_solver.hpp"

namespace voussoir {
namespace {

/// Catches what is printed.
class Unheard {
 public:
  Unheard() : out_(std::cout.rdbuf(nowhere_.rdbuf())), error_(std::cerr.rdbuf(nowhere_.rdbuf())) {}
  ~Unheard() {
    std::cout.rdbuf(out_);
    std::cerr.rdbuf(error_);
  }
  Unheard(const Unheard&) = delete;
  Unheard& operator=(const Unheard&) = delete;

 private:
  std::ostringstream nowhere_;
  std::streambuf *out_, *error_;
};

/// Names and words that a list holds, its sublists among them.
void add_words(const Teuchos::ParameterList& list, std::vector<std::string>& words) {
  for (auto entry = list.begin(); entry != list.end(); ++entry) {
    const auto& name = list.name(entry);
    words.push_back(name);
    if (list.isSublist(name)) add_words(list.sublist(name), words);
    if (list.isType<std::string>(name)) words.push_back(list.get<std::string>(name));
  }
}

/// Of what a library throws the line that has a word of the list, or else the first three: without the place and the
/// condition in the code, nor what might stand there instead.
std::string in_short(const std::string& what, const Teuchos::ParameterList& list) {
  std::vector<std::string> ours, lines;
  add_words(list, ours);
  std::istringstream text(what);
  for (std::string line; std::getline(text, line);)
    if (!line.empty() && line[0] != '.' && line[0] != '/' && line.rfind("Throw ", 0) != 0) lines.push_back(line);
  const auto has_one = [&](const std::string& line) {
    return std::any_of(ours.begin(), ours.end(),
                       [&](const auto& word) { return line.find(word) != std::string::npos; });
  };
  const auto from = std::find_if(lines.begin(), lines.end(), has_one);
  std::string words;
  constexpr int most = 3;  // a name, its list, what is the matter
  int count = 0;
  for (auto line = from == lines.end() ? lines.begin() : from; line != lines.end() && count < most; ++line) {
    words += (count++ > 0 ? " " : "") + *line;
    if (line->back() == '.') break;
  }
  return words;
}

/// What a library says that refuses; empty where it takes all.
template <class Trial>
std::string refusal(const Teuchos::ParameterList& list, const Trial& trial) {
  const Unheard unheard;
  try {
    trial();
    return "";
  } catch (const std::exception& error) {
    if (is_out_of_memory(error)) throw;
    const auto why = in_short(error.what(), list);
    return why.empty() ? "it says no more" : why;
  }
}

Teuchos::RCP<const TpetraMap> map_of(int rows) {
  // MueLu asks for a communicator of MPI.
  return Teuchos::rcp(new TpetraMap(rows, 0, Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF))));
}

/// Neighbours on a lattice are joined by springs and every node is held a little.
struct Lattice {
  Teuchos::RCP<TpetraMatrix> a;
  Teuchos::RCP<TpetraMultiVector> places, near_null;

  /// With more unknowns than a coarsest level has.
  explicit Lattice(int dim) {
    const int side = dim == 2 ? 32 : 10;
    int nodes = 1;
    for (int c = 0; c < dim; ++c) nodes *= side;
    const auto map = map_of(dim * nodes);
    a = Teuchos::rcp(new TpetraMatrix(map, 2 * dim + 1));
    places = Teuchos::rcp(new TpetraMultiVector(map_of(nodes), dim));
    near_null = Teuchos::rcp(new TpetraMultiVector(map, dim));
    for (int i = 0; i < nodes; ++i) {
      std::vector<int> beside;
      for (int c = 0, stride = 1; c < dim; ++c, stride *= side) {
        const int at = i / stride % side;
        places->replaceLocalValue(i, c, at);
        if (at > 0) beside.push_back(i - stride);
        if (at + 1 < side) beside.push_back(i + stride);
      }
      for (int c = 0; c < dim; ++c) {
        near_null->replaceLocalValue(dim * i + c, c, 1);
        std::vector<GlobalOrdinal> column{dim * i + c};
        for (const int j : beside) column.push_back(dim * j + c);
        std::vector<double> value(column.size(), -1);
        value[0] = 2 * dim + 1;
        a->insertGlobalValues(dim * i + c, static_cast<LocalOrdinal>(column.size()), value.data(), column.data());
      }
    }
    a->fillComplete();
  }
};

/// How far a solve comes is not asked: a scene may allow it few iterations.
std::string refused_by_belos(const SolverParameters& given, Symmetry symmetry) {
  return refusal(symmetry == Symmetry::symmetric ? given.belos : given.belos_unsymmetric, [&] {
    const Lattice lattice(2);
    const auto b = Teuchos::rcp(new TpetraVector(lattice.a->getRowMap()));
    b->putScalar(1);
    LinearSolver solver(given);
    for (int times = 0; times < 2; ++times) {  // some names are looked at where a list is given for the second time
      const auto x = Teuchos::rcp(new TpetraVector(b->getMap()));
      std::ignore = solver.solve(lattice.a, nullptr, b, x, 1e-8, symmetry);
    }
  });
}

/// With levels down to the smallest, and parts for ranks: what a scene says of smoothers, of a level, or of ranks is
/// looked at where there are some.
std::string refused_by_muelu(const Teuchos::ParameterList& given, int dim) {
  return refusal(given, [&] {
    const Lattice lattice(dim);
    auto list = given;
    const auto* const coarsest = "coarse: max size";
    if (!list.isParameter(coarsest) || list.isType<int>(coarsest)) list.set(coarsest, dim);
    if (!list.isParameter("repartition: enable")) list.set("repartition: enable", true);
    const AmgPreconditioner amg(lattice.a, lattice.places, lattice.near_null, dim, list);
    TpetraVector r(lattice.a->getRowMap()), z(r.getMap());
    r.putScalar(1);
    amg.apply(r, z);
  });
}

}  // namespace

std::optional<RefusedList> refused_list(const SolverParameters& given, int dim) {
  const auto named = [](const Teuchos::ParameterList& list) { return list.begin() != list.end(); };
  if (named(given.belos))
    if (const auto why = refused_by_belos(given, Symmetry::symmetric); !why.empty())
      return RefusedList{"Belos", "Belos", why};
  if (named(given.belos_unsymmetric))
    if (const auto why = refused_by_belos(given, Symmetry::none); !why.empty())
      return RefusedList{"Belos unsymmetric", "Belos", why};
  if (named(given.muelu))
    if (const auto why = refused_by_muelu(given.muelu, dim); !why.empty()) return RefusedList{"MueLu", "MueLu", why};
  return {};
}

}  // namespace voussoir
