#include "linalg/numbering.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "base/check.hpp"
#include "linalg/parcels.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {
namespace {

struct Told {
  long long thing, number;  ///< a count, or a first number
};

}  // namespace

FirstNumbers first_numbers(const std::vector<long long>& things, const std::vector<long long>& counts, long long in_all,
                           const Teuchos::Comm<int>& comm) {
  VOUSSOIR_EXPECT(counts.size() <= things.size() && "counts: of the own things, which come first");
  const long long ranks = comm.getSize(), rank = comm.getRank();
  const auto keeper = [&](long long thing) { return static_cast<int>(thing * ranks / in_all); };
  const auto first_kept = [&](long long r) { return (r * in_all + ranks - 1) / ranks; };
  Post<Told> tell(comm);
  Post<long long> ask(comm);
  for (std::size_t k = 0; k < counts.size(); ++k) tell.add(keeper(things[k]), {things[k], counts[k]});
  for (const long long thing : things) ask.add(keeper(thing), thing);
  const long long from = first_kept(rank);
  std::vector<long long> first(static_cast<std::size_t>(first_kept(rank + 1) - from), 0);
  for (const auto& [thing, count] : std::move(tell).send_all()) first[thing - from] = count;
  const long long here = std::accumulate(first.begin(), first.end(), 0LL);
  long long next = 0;
  Teuchos::scan(comm, Teuchos::REDUCE_SUM, here, Teuchos::outArg(next));
  next -= here;
  for (auto& number : first) next += std::exchange(number, next);
  Post<Told> answer(comm);
  for (const auto& parcel : std::move(ask).send())
    for (const long long thing : parcel.items) answer.add(parcel.rank, {thing, first[thing - from]});
  std::unordered_map<long long, long long> heard;
  for (const auto& [thing, number] : std::move(answer).send_all()) heard[thing] = number;
  FirstNumbers numbers;
  for (const long long thing : things) numbers.first.push_back(heard.at(thing));
  numbers.total = total_over_ranks(comm, here);
  return numbers;
}

}  // namespace voussoir
