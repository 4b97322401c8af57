// Measured materials: reading the tables of the MERL database.

/// The row of a MERL table for an angle between normal and half vector. Rows are narrow near zero, where the highlight
/// is: each ends at the square of its number.
///
/// formula: floor(sqrt(90 thetaHalf / 1 degree)), from 0 to 89
/// source: Matusik et al., "A Data-Driven Reflectance Model", SIGGRAPH 2003, and the reader that comes with the tables
/// test: MerlThetaHalfIndex(0) == 0
/// test: MerlThetaHalfIndex(0.017453292519943295) == 9
/// test: MerlThetaHalfIndex(0.17453292519943295) == 30
/// test: MerlThetaHalfIndex(0.7853981633974483) == 63
/// test: MerlThetaHalfIndex(1.5707963267948966) == 89
[node("Lighting/Measured/MERL Theta Half Index")] [range(0, 89)]
float MerlThetaHalfIndex(
    [range(0, 1.5707963)] [unit("rad")] float thetaHalf = 0  ///< angle between normal and half vector
) {
    float degrees = thetaHalf * INV_PI * 180;
    // A small number is added so that an angle just below a border, by rounding, counts as on it.
    return clamp(floor(sqrt(max(degrees, 0) * 90) + 0.0001), 0, 89);
}

// One texel of a table: `row` is the index of the half vector's angle, `line` that of the difference vector's angle.
float3 measuredTexel(Texture2D table, int row, int line, int column, int2 counts) {
    return table.Load(int2(column, row * counts.y + line), 0).rgb;
}

// Interpolates the texels of one row of half vectors linearly, in both angles of the difference vector.
float3 measuredRow(Texture2D table, int row, float line, float column, int2 counts) {
    int low = clamp(int(floor(line)), 0, counts.y - 1);
    int high = min(low + 1, counts.y - 1);
    float share = clamp(line - float(low), 0, 1);
    // Half a turn around the half vector exchanges light and view, so the last column's neighbour is the first.
    int left = int(floor(column));
    int right = left + 1 >= counts.x ? int(0) : left + 1;
    float way = column - float(left);
    int begin = left < 0 ? counts.x - 1 : left;
    float3 below = lerp(measuredTexel(table, row, low, begin, counts), measuredTexel(table, row, low, right, counts), way);
    float3 above =
        lerp(measuredTexel(table, row, high, begin, counts), measuredTexel(table, row, high, right, counts), way);
    return lerp(below, above, share);
}

/// The reflectance of a measured material for one pair of directions, in units in which a white Lambert surface is 1.
///
/// The table is a texture that `patina import material.binary` writes. It has a column for each angle of the difference
/// vector around the half vector, and for each angle between normal and half vector (narrow rows near the highlight) a
/// line for each angle between half vector and light. The node interpolates it. Angles are computed by atan2, which is
/// exact at the peak, where an arc cosine is not. The result is pi times the BRDF; multiply it by n.l.
///
/// formula: row = H sqrt(theta_h / (pi / 2)), line = D theta_d / (pi / 2), column = P phi_d / pi
/// source: Rusinkiewicz, "A New Change of Variables for Efficient BRDF Representation", EGWR 1998; Matusik et al.,
/// source: "A Data-Driven Reflectance Model", SIGGRAPH 2003
[node("Lighting/Measured/Measured BRDF")]
float3 MeasuredBRDF(
    Texture2D table,                    ///< table from `patina import`; usage "data"
    float3 normal = normalWS,          ///< unit normal
    float3 lightDir = light.direction, ///< unit direction to the light
    float3 view = viewDirWS           ///< unit direction to the viewer
) {
    int2 size = table.Size(0);
    int rows = max(int(floor(sqrt(float(size.y)) + 0.5)), 1);
    int2 counts = int2(size.x, rows);
    float3 halfVector = HalfVectorExact(view, lightDir);

    float3 across = cross(normal, halfVector);
    float sine = length(across);
    float thetaHalf = atan2(sine, max(dot(normal, halfVector), 0));
    // If both are equal, any perpendicular direction is correct.
    float3 helper = abs(halfVector.y) < 0.9 ? float3(0, 1, 0) : float3(1, 0, 0);
    float3 y = sine > 1e-5 ? across / max(sine, 1e-5) : normalize(cross(helper, halfVector));
    float3 x = cross(y, halfVector);
    float thetaDifference = atan2(length(cross(halfVector, lightDir)), max(dot(halfVector, lightDir), 0));
    float2 around = float2(dot(lightDir, x), dot(lightDir, y));
    float phi = dot(around, around) > 1e-7 ? atan2(around.y, around.x) : 0;
    float turn = frac(phi * INV_PI);

    float row = sqrt(saturate(thetaHalf * 2 * INV_PI)) * float(rows) - 0.5;
    float line = saturate(thetaDifference * 2 * INV_PI) * float(rows) - 0.5;
    float column = turn * float(size.x) - 0.5;
    int low = clamp(int(floor(row)), 0, rows - 1);
    int high = min(low + 1, rows - 1);
    return lerp(measuredRow(table, low, line, column, counts), measuredRow(table, high, line, column, counts),
                clamp(row - float(low), 0, 1));
}
