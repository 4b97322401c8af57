// Named constants, visible in every node and expression.

/// Half the circumference of the unit circle.
const float PI = 3.14159265358979323846;
/// One full turn in radians.
const float TWO_PI = 6.28318530717958647692;
/// The normalisation of a constant BRDF: the integral of the cosine over the hemisphere is pi.
const float INV_PI = 0.31830988618379067154;
