#pragma once

namespace berm {

class HeightGrid {};

}  // namespace berm
