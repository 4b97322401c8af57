// Matrices: made of vectors, taken apart, and those of the object and the camera. In an expression, mul(M, v), transpose(M),
// determinant(M) and M[0] (a row) compute with them.

/// Whether the vectors of a matrix are its rows or its columns.
enum MatrixAxis {
    Rows,    ///< rows
    Columns  ///< columns
};

/// Makes matrices of four vectors.
///
/// The smaller ones are the upper left parts of the large one.
[node("Math/Matrix/Matrix Construction")] [also("CreateMatrix", "MakeMatrix")]
float4x4 MatrixConstruction(
    float4 m0 = float4(1, 0, 0, 0),      ///< first vector
    float4 m1 = float4(0, 1, 0, 0),      ///< second vector
    float4 m2 = float4(0, 0, 1, 0),      ///< third vector
    float4 m3 = float4(0, 0, 0, 1),      ///< fourth vector
    const MatrixAxis axis = Rows,        ///< what they are of the matrix
    out float3x3 m3x3,                   ///< of the first three numbers of the first three vectors
    out float2x2 m2x2                    ///< of the first two numbers of the first two vectors
) {
    float4x4 rows = float4x4(m0, m1, m2, m3);
    float4x4 made = rows;
    if (axis == Columns) made = transpose(rows);
    m3x3 = float3x3(made[0].xyz, made[1].xyz, made[2].xyz);
    m2x2 = float2x2(made[0].xy, made[1].xy);
    return made;
}

/// The rows or the columns of a matrix.
[node("Math/Matrix/Matrix Split")] [also("SplitMatrix")]
void MatrixSplit(
    float4x4 matrix,               ///< matrix to take apart
    const MatrixAxis axis = Rows,  ///< what to take of it
    out float4 m0,                 ///< first row or column
    out float4 m1,                 ///< second
    out float4 m2,                 ///< third
    out float4 m3                  ///< fourth
) {
    float4x4 rows = matrix;
    if (axis == Columns) rows = transpose(matrix);
    m0 = rows[0];
    m1 = rows[1];
    m2 = rows[2];
    m3 = rows[3];
}

/// Which matrix TransformationMatrix gives.
enum TransformationKind {
    ObjectToWorld,  ///< from the object's space to the world (model matrix)
    WorldToObject,  ///< its inverse
    WorldToView,    ///< from the world to the camera (view matrix)
    WorldToClip,    ///< from the world to clip space (view-projection matrix)
    ClipToWorld     ///< its inverse
};

/// A matrix of the object or of the camera. It transforms columns: mul(M, v).
[node("Input/Matrix/Transformation Matrix")] [also("TransformMatrix", "ModelMatrix", "ViewMatrix")] [inFloat]
float4x4 TransformationMatrix(
    const TransformationKind kind = ObjectToWorld  ///< which matrix
) {
    float4x4 made = objectToWorld;
    if (kind == WorldToObject) made = worldToObject;
    if (kind == WorldToView) made = worldToView;
    if (kind == WorldToClip) made = worldToClip;
    if (kind == ClipToWorld) made = clipToWorld;
    return made;
}
