// Measured materials: where a table of the MERL database keeps the reflectance of a pair of directions.

/// The row of a MERL table that an angle between normal and half vector falls in. Rows are narrow near zero, where the
/// highlight is: each ends at the square of its number.
///
/// formula: floor(sqrt(90 theta_half / 1 degree)), from 0 to 89
/// source: Matusik et al., "A Data-Driven Reflectance Model", SIGGRAPH 2003, and the reader that comes with the tables
/// test: MerlThetaHalfIndex(0) == 0
/// test: MerlThetaHalfIndex(0.017453292519943295) == 9
/// test: MerlThetaHalfIndex(0.17453292519943295) == 30
/// test: MerlThetaHalfIndex(0.7853981633974483) == 63
/// test: MerlThetaHalfIndex(1.5707963267948966) == 89
[node("Lighting/Measured/MERL Theta Half Index")]
float MerlThetaHalfIndex(
    [range(0, 1.5707963)] [unit("rad")] float theta_half = 0  ///< angle between normal and half vector
) {
    float degrees = theta_half * INV_PI * 180;
    // A little is added so that an angle that rounding left just below a border counts as on it.
    return clamp(floor(sqrt(max(degrees, 0) * 90) + 0.0001), 0, 89);
}
