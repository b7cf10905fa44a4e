#include "geometry/patch_face.hpp"
