#include "stones/gmsh_ranks.hpp"

#include <string>
#include <utility>

#include "linalg/agree.hpp"
#include "linalg/parcels.hpp"
#include "stones/gmsh_pieces.hpp"

namespace voussoir {
namespace {

template <class Item>
std::vector<Item> all_of_bytes(const Parcel<char>& parcel, void (*read)(ByteReader&, Item&)) {
  const std::string bytes(parcel.items.begin(), parcel.items.end());
  std::vector<Item> items;
  for (ByteReader reader(bytes); reader.left() > 0;) read(reader, items.emplace_back());
  return items;
}

/// Rounds in which all ranks mesh; the first one says what, until it has no more.
class RanksAtWork {
 public:
  RanksAtWork(const Teuchos::Comm<int>& comm, const PolygonMesher& here) : comm_(comm), here_(here) {}

  /// For the first rank.
  PolygonMesher mesher() {
    return [this](const std::vector<FlatDomain>& domains) {
      say(true);
      return share(domains);
    };
  }
  void end() {
    if (!has_failed_) say(false);
  }
  /// For the others.
  void help() {
    while (say(false)) share({});
  }

 private:
  /// @param more  what the first rank has to say  @return on all ranks
  bool say(bool more) {
    int word = more ? 1 : 0;
    Teuchos::broadcast(comm_, 0, Teuchos::outArg(word));
    return word != 0;
  }

  /// @param domains  of the first rank  @return what is made of them, on the first rank
  std::vector<FlatMesh> share(const std::vector<FlatDomain>& domains) {
    const auto ranks = static_cast<std::size_t>(comm_.getSize());
    std::vector<Parcel<char>> tasks, answers;
    for (std::size_t k = 0, next = 0; k < domains.size(); k = next) {
      const auto rank = k * ranks / domains.size();
      ByteWriter writer;
      for (next = k; next < domains.size() && next * ranks / domains.size() == rank; ++next)
        exchange_domain(writer, domains[next]);
      tasks.push_back({static_cast<int>(rank), {writer.bytes.begin(), writer.bytes.end()}});
    }
    tasks = exchange_parcels(std::move(tasks), comm_);
    has_failed_ = true;  // where they agree on an error all ranks throw it, and nobody waits for a word
    agree(comm_, [&] {
      for (const auto& task : tasks) {
        ByteWriter writer;
        for (const auto& mesh : here_(all_of_bytes<FlatDomain>(task, exchange_domain<ByteReader, FlatDomain>)))
          exchange_flat(writer, mesh);
        answers.push_back({0, {writer.bytes.begin(), writer.bytes.end()}});
      }
    });
    has_failed_ = false;
    std::vector<FlatMesh> meshes;
    for (const auto& answer : exchange_parcels(std::move(answers), comm_))
      for (auto& mesh : all_of_bytes<FlatMesh>(answer, exchange_flat<ByteReader, FlatMesh>))
        meshes.push_back(std::move(mesh));
    return meshes;
  }

  const Teuchos::Comm<int>& comm_;
  const PolygonMesher& here_;
  bool has_failed_ = false;
};

}  // namespace

void on_first_rank_meshed_by_all(const Teuchos::Comm<int>& comm, const std::function<void(const PolygonMesher&)>& work,
                                 const PolygonMesher& here) {
  agree(comm, [&] {
    RanksAtWork ranks(comm, here);
    if (comm.getRank() > 0) return ranks.help();
    try {
      work(comm.getSize() == 1 ? here : ranks.mesher());
    } catch (...) {
      ranks.end();
      throw;
    }
    ranks.end();
  });
}

}  // namespace voussoir
