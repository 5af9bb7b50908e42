// Contracts. A broken contract is a mistake of the program, never of the user
// (those are InputErrors), so the message is for developers.
//
//   VOUSSOIR_EXPECT   before: what the caller owes      | in debug and audit
//   VOUSSOIR_ASSERT   between: what the algorithm keeps  | builds only
//   VOUSSOIR_ENSURE   after: what the function promises  |
//   VOUSSOIR_CHECK    always on, for what must never be skipped
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

#ifdef VOUSSOIR_CONTRACTS
#define VOUSSOIR_EXPECT(condition) VOUSSOIR_CONTRACT("precondition", condition)
#define VOUSSOIR_ASSERT(condition) VOUSSOIR_CONTRACT("assertion", condition)
#define VOUSSOIR_ENSURE(condition) VOUSSOIR_CONTRACT("postcondition", condition)
#else
#define VOUSSOIR_EXPECT(condition) void(0)
#define VOUSSOIR_ASSERT(condition) void(0)
#define VOUSSOIR_ENSURE(condition) void(0)
#endif
