#include "stones/gmsh_ranks.hpp"

#include <string>
#include <utility>

#include "linalg/agree.hpp"
#include "linalg/parcels.hpp"
#include "stones/gmsh_pieces.hpp"

namespace voussoir {
namespace {

/// How pieces of one kind go to ranks, and what is made of them back.
template <class Piece, class Mesh>
struct Trade {
  std::function<std::vector<Mesh>(const std::vector<Piece>&)> PieceMesher::*make;
  void (*write)(ByteWriter&, const Piece&);
  void (*read)(ByteReader&, Piece&);
  void (*write_mesh)(ByteWriter&, const Mesh&);
  void (*read_mesh)(ByteReader&, Mesh&);
};

const Trade<FlatDomain, FlatMesh> of_polygons{
    &PieceMesher::polygons, exchange_domain<ByteWriter, const FlatDomain>, exchange_domain<ByteReader, FlatDomain>,
    exchange_flat<ByteWriter, const FlatMesh>, exchange_flat<ByteReader, FlatMesh>};
const Trade<ClosedMesh, FilledMesh> of_surfaces{
    &PieceMesher::surfaces, exchange_closed<ByteWriter, const ClosedMesh>, exchange_closed<ByteReader, ClosedMesh>,
    exchange_filled<ByteWriter, const FilledMesh>, exchange_filled<ByteReader, FilledMesh>};

template <class Item>
std::vector<Item> all_of_bytes(const Parcel<char>& parcel, void (*read)(ByteReader&, Item&)) {
  const std::string bytes(parcel.items.begin(), parcel.items.end());
  std::vector<Item> items;
  for (ByteReader reader(bytes); reader.left() > 0;) read(reader, items.emplace_back());
  return items;
}

/// Rounds in which all ranks mesh; the first one says what of, until it has no more.
class RanksAtWork {
 public:
  RanksAtWork(const Teuchos::Comm<int>& comm, const PieceMesher& here) : comm_(comm), here_(here) {}

  /// For the first rank.
  PieceMesher mesher() {
    return {[this](const auto& pieces) { return round_of(Round::polygons, of_polygons, pieces); },
            [this](const auto& pieces) { return round_of(Round::surfaces, of_surfaces, pieces); }};
  }
  void end() {
    if (!has_failed_) say(Round::end);
  }
  /// For the others.
  void help() {
    for (Round next = say(Round::end); next != Round::end; next = say(Round::end))
      if (next == Round::polygons)
        share(of_polygons, {});
      else
        share(of_surfaces, {});
  }

 private:
  enum class Round : int { end, polygons, surfaces };

  Round say(Round next) {
    int number = static_cast<int>(next);
    Teuchos::broadcast(comm_, 0, Teuchos::outArg(number));
    return static_cast<Round>(number);
  }

  template <class Piece, class Mesh>
  std::vector<Mesh> round_of(Round what, const Trade<Piece, Mesh>& trade, const std::vector<Piece>& pieces) {
    say(what);
    return share(trade, pieces);
  }

  /// @param pieces  of the first rank  @return what is made of them, on the first rank
  template <class Piece, class Mesh>
  std::vector<Mesh> share(const Trade<Piece, Mesh>& trade, const std::vector<Piece>& pieces) {
    const auto ranks = static_cast<std::size_t>(comm_.getSize());
    std::vector<Parcel<char>> tasks, answers;
    for (std::size_t k = 0, next = 0; k < pieces.size(); k = next) {
      const auto rank = k * ranks / pieces.size();
      ByteWriter writer;
      for (next = k; next < pieces.size() && next * ranks / pieces.size() == rank; ++next)
        trade.write(writer, pieces[next]);
      tasks.push_back({static_cast<int>(rank), {writer.bytes.begin(), writer.bytes.end()}});
    }
    tasks = exchange_parcels(std::move(tasks), comm_);
    has_failed_ = true;  // where they agree on an error all ranks throw it, and nobody waits for a word
    agree(comm_, [&] {
      for (const auto& task : tasks) {
        ByteWriter writer;
        for (const auto& mesh : (here_.*trade.make)(all_of_bytes(task, trade.read))) trade.write_mesh(writer, mesh);
        answers.push_back({0, {writer.bytes.begin(), writer.bytes.end()}});
      }
    });
    has_failed_ = false;
    std::vector<Mesh> meshes;
    for (const auto& answer : exchange_parcels(std::move(answers), comm_))
      for (auto& mesh : all_of_bytes(answer, trade.read_mesh)) meshes.push_back(std::move(mesh));
    return meshes;
  }

  const Teuchos::Comm<int>& comm_;
  const PieceMesher& here_;
  bool has_failed_ = false;
};

}  // namespace

void on_first_rank_meshed_by_all(const Teuchos::Comm<int>& comm, const std::function<void(const PieceMesher&)>& work,
                                 const PieceMesher& here) {
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
