#include "linalg/exchange.hpp"

#include <Teuchos_OrdinalTraits.hpp>

#include "base/check.hpp"

namespace voussoir {

Exchange::Exchange(const std::vector<long long>& local, int owned, const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
    : comm_(comm), owned_(owned) {
  if (comm->getSize() == 1) return;
  const auto unknown = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  const Teuchos::ArrayView<const GlobalOrdinal> all(local.data(), static_cast<int>(local.size()));
  owned_map_ = Teuchos::rcp(new TpetraMap(unknown, all(0, owned), 0, comm));
  local_map_ = Teuchos::rcp(new TpetraMap(unknown, all, 0, comm));
  import_ = Teuchos::rcp(new TpetraImport(owned_map_, local_map_));
}

void Exchange::update(std::vector<double>& values, int columns) const {
  if (comm().getSize() == 1) return;
  const int rows = static_cast<int>(local_map_->getNodeNumElements());
  VOUSSOIR_EXPECT(static_cast<int>(values.size()) == rows * columns);
  TpetraMultiVector source(owned_map_, columns), target(local_map_, columns);
  {
    auto view = source.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (int i = 0; i < owned_; ++i)
      for (int c = 0; c < columns; ++c) view(i, c) = values[i * columns + c];
  }
  target.doImport(source, *import_, Tpetra::INSERT);
  auto view = target.getLocalViewHost(Tpetra::Access::ReadOnly);
  for (int i = owned_; i < rows; ++i)
    for (int c = 0; c < columns; ++c) values[i * columns + c] = view(i, c);
}

void Exchange::update(std::vector<long long>& values) const {
  if (comm().getSize() == 1) return;
  std::vector<double> exact(values.begin(), values.end());
  update(exact, 1);
  for (std::size_t i = owned_; i < values.size(); ++i) values[i] = static_cast<long long>(exact[i]);
}

}  // namespace voussoir
