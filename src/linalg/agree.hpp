// What ranks tell each other: values of the first, and errors, on which all agree before anyone throws.
#pragma once

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "linalg/reduce.hpp"

namespace voussoir {

/// Gives every rank the values rank 0 has. Collective.
template <class T>
void broadcast_values(const Teuchos::Comm<int>& comm, std::vector<T>& values) {
  long long size = static_cast<long long>(values.size());
  Teuchos::broadcast(comm, 0, 1, &size);
  values.resize(static_cast<std::size_t>(size));
  constexpr long long portion = 1 << 26;  // counts of MPI are ints
  for (long long from = 0; from < size; from += portion)
    Teuchos::broadcast(comm, 0, static_cast<int>(std::min(portion, size - from)), values.data() + from);
}

inline void broadcast_strings(const Teuchos::Comm<int>& comm, std::vector<std::string>& strings) {
  std::vector<int> lengths;
  std::vector<char> text;
  for (const std::string& s : strings) {
    lengths.push_back(static_cast<int>(s.size()));
    text.insert(text.end(), s.begin(), s.end());
  }
  broadcast_values(comm, lengths);
  broadcast_values(comm, text);
  strings.clear();
  auto from = text.begin();
  for (const int length : lengths) {
    strings.emplace_back(from, from + length);
    from += length;
  }
}

/// The text of the first rank that has one, the same on every rank; nothing where none has. Collective.
inline std::optional<std::string> first_text(const Teuchos::Comm<int>& comm, const std::optional<std::string>& mine) {
  const int first = least_over_ranks(comm, mine ? comm.getRank() : comm.getSize());
  if (first == comm.getSize()) return {};
  std::string text = mine.value_or("");
  int size = static_cast<int>(text.size());
  Teuchos::broadcast(comm, first, Teuchos::outArg(size));
  text.resize(static_cast<std::size_t>(size));
  Teuchos::broadcast(comm, first, size, text.data());
  return text;
}

/// The first of the texts that ranks have, rank by rank, at most so many, the same on every rank. Collective.
inline std::vector<std::string> first_texts(const Teuchos::Comm<int>& comm, const std::vector<std::string>& mine,
                                            std::size_t most) {
  std::vector<std::string> texts;
  for (auto next = mine.begin(); texts.size() < most;) {
    const auto text = first_text(comm, next == mine.end() ? std::nullopt : std::optional<std::string>(*next));
    if (!text) break;
    const int from = least_over_ranks(comm, next == mine.end() ? comm.getSize() : comm.getRank());
    if (from == comm.getRank()) ++next;
    texts.push_back(*text);
  }
  return texts;
}

/// Does work that may fail on some ranks. Every rank throws what the first of those would, so that nobody waits: an
/// InputError, or a ResourceError with the text of anything else. Work may be collective as long as its last collective
/// call comes before what fails. Collective.
template <class Work>
void agree(const Teuchos::Comm<int>& comm, const Work& work) {
  constexpr char input = 'i', other = 'o';  // before the message
  std::optional<std::string> failure;
  try {
    work();
  } catch (const InputError& error) {
    failure = input + std::string(error.what());
  } catch (const std::exception& error) {
    failure = other + message_of(error);
  }
  const auto first = first_text(comm, failure);
  if (!first) return;
  if (first->front() == input) throw InputError(first->substr(1));
  throw ResourceError(first->substr(1));
}

/// The same of work that the first rank does for all.
template <class Work>
void on_first_rank(const Teuchos::Comm<int>& comm, const Work& work) {
  agree(comm, [&] {
    if (comm.getRank() == 0) work();
  });
}

}  // namespace voussoir
