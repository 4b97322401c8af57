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
[node("Math/Matrix/Matrix Construction")] [also("CreateMatrix", "MakeMatrix", "Matrix2x2", "Matrix3x3", "Matrix4x4")]
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
    ClipToWorld,    ///< its inverse
    ViewToWorld,    ///< from the camera to the world
    ViewToClip,     ///< from the camera to clip space (projection matrix)
    ClipToView      ///< its inverse
};

/// The inverse of a matrix that only turns and moves, as a camera does: it turns back, and moves the origin back.
float4x4 InverseOfRigid(float4x4 rigid) {
    float3 back = -mul(float4(mul(rigid, float4(0, 0, 0, 1)).xyz, 0), rigid).xyz;
    float4x4 turned = transpose(rigid);
    return float4x4(float4(turned[0].xyz, back.x), float4(turned[1].xyz, back.y), float4(turned[2].xyz, back.z), float4(0, 0, 0, 1));
}

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
    if (kind == ViewToWorld) made = InverseOfRigid(worldToView);
    if (kind == ViewToClip) made = mul(worldToClip, InverseOfRigid(worldToView));
    if (kind == ClipToView) made = mul(worldToView, clipToWorld);
    return made;
}
