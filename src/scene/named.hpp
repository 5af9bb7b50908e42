// What a scene gives a name.
#pragma once

#include <string>

namespace voussoir {

template <class Parameters>
struct Named {
  std::string name;
  Parameters parameters;
};

}  // namespace voussoir
