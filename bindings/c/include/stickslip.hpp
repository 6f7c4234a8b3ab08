// Interface of stickslip.h with destructors and exceptions, for C++17. Header only: programs link only the library.
//
// Objects can be moved but not copied (a history has clone()), and they free themselves. A moved-from object is empty: its
// calls throw STICKSLIP_BAD_POINTER with a message that begins with "history is NULL or misaligned". Every failure throws a
// stickslip::Error with its code, message and numbers. Fields are views into an object and remain valid until the object is
// changed or destroyed. A NULL argument of the C interface corresponds to nullptr or an omitted argument.

#ifndef STICKSLIP_HPP
#define STICKSLIP_HPP

#include "stickslip/core.hpp"
#include "stickslip/bodies.hpp"
#include "stickslip/bulk_strain.hpp"
#include "stickslip/loads.hpp"
#include "stickslip/surface.hpp"
#include "stickslip/normal.hpp"
#include "stickslip/tangential.hpp"
#include "stickslip/coupled.hpp"
#include "stickslip/rolling.hpp"
#include "stickslip/history.hpp"
#include "stickslip/paths.hpp"
#include "stickslip/stress.hpp"

#endif // STICKSLIP_HPP
