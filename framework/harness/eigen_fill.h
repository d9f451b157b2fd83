// No include guard: Eigen reads this file twice, for harness/types.h has it for a plugin of DenseBase and of Array.
//
// With EIGEN_INITIALIZE_MATRICES_BY_NAN, Eigen fills its objects by
// `coeffRef(i)=std::numeric_limits<Scalar>::quiet_NaN();`, whose bits are those of -(0/0), too. Between its two
// readings stand the headers in which Eigen fills: there the statement goes on and fills with a NaN of bits that no
// computation begins with, complex numbers in both parts; floats and whole numbers with the bytes that variables have.
// Arithmetic hands them on, so that a number that was never written is told from one that was computed
// (course/testing/never_written.h).
#ifndef quiet_NaN
#define quiet_NaN()                                                          \
  quiet_NaN(), coeffRef(i) = [] {                                            \
    constexpr double fill = __builtin_nan("0xFEFEFEFE");                     \
    if constexpr (std::is_same<Scalar, float>::value)                        \
      return __builtin_bit_cast(float, 0xFEFEFEFEU);                         \
    else if constexpr (std::is_same<Scalar, bool>::value)                    \
      return true;                                                           \
    else if constexpr (std::is_integral<Scalar>::value)                      \
      return static_cast<Scalar>(0xFEFEFEFEFEFEFEFEU);                       \
    else if constexpr (std::is_constructible<Scalar, double, double>::value) \
      return Scalar(fill, fill);                                             \
    else                                                                     \
      return static_cast<Scalar>(fill);                                      \
  }()
#else
#undef quiet_NaN
#endif
