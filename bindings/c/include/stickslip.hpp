// stickslip.h with destructors and exceptions: C++17, nothing to link but the library.
//
// Objects are moved, not copied (a history has clone()), and free themselves. Every failure is a stickslip::Error with its
// code, message and numbers. Fields are views of what the object holds: valid until it is changed or destroyed. NULL in the
// C interface is nullptr or an argument left out here.

#ifndef STICKSLIP_HPP
#define STICKSLIP_HPP

#include "stickslip/core.hpp"
#include "stickslip/bodies.hpp"
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
