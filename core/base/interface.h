#pragma once

namespace penpose::base {

/// Stays where it was made: is neither copied nor moved.
class Fixed {
 public:
  Fixed(const Fixed&) = delete;
  Fixed& operator=(const Fixed&) = delete;

 protected:
  Fixed() = default;
  ~Fixed() = default;
};

/// A base class of virtual functions, which is neither copied nor moved.
class Interface {
 public:
  virtual ~Interface() = default;
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

 protected:
  Interface() = default;
};

}  // namespace penpose::base
