// Uses one header-only part, one compiled part and one library Voussoir passes on.
#include <Teuchos_ParameterList.hpp>
#include <string>

#include "base/error.hpp"
#include "base/version.hpp"

int main() {
  Teuchos::ParameterList list;
  list.set("version", std::string(voussoir::version()));
  return list.get<std::string>("version").empty() ? voussoir::exit_resource : voussoir::exit_done;
}
