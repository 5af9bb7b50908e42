// Contracts. A broken contract is a mistake of the program, never of the user
// (those are InputErrors), so the message is for developers.
//
//   VOUSSOIR_EXPECT   before: what the caller owes
//   VOUSSOIR_ASSERT   between: what the algorithm keeps
//   VOUSSOIR_ENSURE   after: what the function promises
//   VOUSSOIR_CHECK    what the data hold, wherever they come from
//
// They hold in every build: a comparison costs nothing beside the work of the function it guards.
#pragma once

#include <stdexcept>
#include <string>

namespace voussoir::detail {

[[noreturn]] inline void contract_broken(const char* kind, const char* condition, const char* file, int line) {
  throw std::logic_error(std::string(file) + ":" + std::to_string(line) + ": " + kind + " does not hold: " + condition);
}

}  // namespace voussoir::detail

#define VOUSSOIR_CONTRACT(kind, condition) \
  ((condition) ? void(0) : ::voussoir::detail::contract_broken(kind, #condition, __FILE__, __LINE__))

#define VOUSSOIR_CHECK(condition) VOUSSOIR_CONTRACT("check", condition)

#define VOUSSOIR_EXPECT(condition) VOUSSOIR_CONTRACT("precondition", condition)
#define VOUSSOIR_ASSERT(condition) VOUSSOIR_CONTRACT("assertion", condition)
#define VOUSSOIR_ENSURE(condition) VOUSSOIR_CONTRACT("postcondition", condition)
