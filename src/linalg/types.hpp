// Distributed vectors and matrices, the common currency of the program.
// Debian's Tpetra is instantiated for one set of types only: the defaults.
#pragma once

#include <Teuchos_ArrayView.hpp>
#include <Teuchos_RCP.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>
#include <Tpetra_Vector.hpp>
#include <type_traits>
#include <vector>

namespace voussoir {

using TpetraMap = Tpetra::Map<>;
using LocalOrdinal = TpetraMap::local_ordinal_type;
using GlobalOrdinal = TpetraMap::global_ordinal_type;
using TpetraVector = Tpetra::Vector<>;
using TpetraMultiVector = Tpetra::MultiVector<>;
using TpetraOperator = Tpetra::Operator<>;
using TpetraMatrix = Tpetra::CrsMatrix<>;
using TpetraGraph = Tpetra::CrsGraph<>;
using TpetraImport = Tpetra::Import<>;

/// The map of rows that each rank has by their numbers. Collective.
inline Teuchos::RCP<const TpetraMap> map_of(const std::vector<GlobalOrdinal>& rows,
                                            const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  const auto counted_by_tpetra = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return Teuchos::rcp(new TpetraMap(counted_by_tpetra, Teuchos::arrayViewFromVector(rows), 0, comm));
}

static_assert(std::is_same_v<TpetraVector::scalar_type, double>);
static_assert(std::is_same_v<LocalOrdinal, int>);
static_assert(std::is_same_v<GlobalOrdinal, long long>);

}  // namespace voussoir
