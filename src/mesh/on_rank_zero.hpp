// Work that one rank does for all, with errors that reach every rank.
#pragma once

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <exception>
#include <string>
#include <vector>

#include "base/error.hpp"

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

/// Runs `work` on rank 0. If it throws an InputError every rank throws it, anything else becomes a ResourceError
/// with the same text on every rank. Collective.
template <class Work>
void on_rank_zero(const Teuchos::Comm<int>& comm, Work work) {
  enum { well, input, resource };
  std::vector<int> outcome{well};
  std::vector<std::string> message{std::string()};
  if (comm.getRank() == 0) {
    try {
      work();
    } catch (const InputError& error) {
      outcome = {input};
      message = {error.what()};
    } catch (const std::exception& error) {
      outcome = {resource};
      message = {message_of(error)};
    }
  }
  broadcast_values(comm, outcome);
  if (outcome[0] == well) return;
  broadcast_strings(comm, message);
  if (outcome[0] == input) throw InputError(message[0]);
  throw ResourceError(message[0]);
}

}  // namespace voussoir
