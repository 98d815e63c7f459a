using MathNet.Numerics.LinearAlgebra;
using MathNet.Numerics.LinearAlgebra.Double;
using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Fitting
{
    /// <summary>
    /// Fits a rotation to weighted rotations and weighted pairs of directions. Uses Davenport's method: the eigenvector of the largest
    /// eigenvalue of a symmetric 4×4 matrix of quaternions. For rotations only, this is Markley's mean; for positions only, Horn's fit.
    /// The result is never a reflection.
    /// </summary>
    /// <remarks>Solving allocates about 1 kB, so do not solve in every frame.</remarks>
    struct RotationFit
    {
        // The matrix B of the fit: the solution R maximises the trace of RᵀB.
        double _b00, _b01, _b02, _b10, _b11, _b12, _b20, _b21, _b22;

        /// <summary>Adds a measured rotation; the translation of a pose is ignored.</summary>
        /// <param name="weight">Inverse variance of its angle about an axis, 1/rad².</param>
        public void Add(in RigidTransform rotation, double weight)
        {
            _b00 += weight * rotation.R00; _b01 += weight * rotation.R01; _b02 += weight * rotation.R02;
            _b10 += weight * rotation.R10; _b11 += weight * rotation.R11; _b12 += weight * rotation.R12;
            _b20 += weight * rotation.R20; _b21 += weight * rotation.R21; _b22 += weight * rotation.R22;
        }

        /// <summary>Adds a vector and its image under the rotation.</summary>
        /// <param name="weight">Inverse variance of the difference between the two along an axis.</param>
        public void Add((double X, double Y, double Z) from, (double X, double Y, double Z) to, double weight)
        {
            // The squared angle of a rotation is about 3 − trace(RᵀB). The squared distance of two vectors is a constant − 2 trace(RᵀB).
            weight *= 2;
            _b00 += weight * to.X * from.X; _b01 += weight * to.X * from.Y; _b02 += weight * to.X * from.Z;
            _b10 += weight * to.Y * from.X; _b11 += weight * to.Y * from.Y; _b12 += weight * to.Y * from.Z;
            _b20 += weight * to.Z * from.X; _b21 += weight * to.Z * from.Y; _b22 += weight * to.Z * from.Z;
        }

        /// <returns>The rotation as a transform with translation 0.</returns>
        public RigidTransform Solve()
        {
            var matrix = new DenseMatrix(4, 4, new[]
            {
                _b00 + _b11 + _b22, _b21 - _b12, _b02 - _b20, _b10 - _b01,
                _b21 - _b12, _b00 - _b11 - _b22, _b01 + _b10, _b02 + _b20,
                _b02 - _b20, _b01 + _b10, _b11 - _b00 - _b22, _b12 + _b21,
                _b10 - _b01, _b02 + _b20, _b12 + _b21, _b22 - _b00 - _b11,
            });
            var solved = matrix.Evd(Symmetricity.Symmetric);
            var largest = 0;
            for (var i = 1; i < 4; i++)
                if (solved.EigenValues[i].Real > solved.EigenValues[largest].Real) largest = i;
            var q = solved.EigenVectors;
            return UnitQuaternion.Normalised(q[1, largest], q[2, largest], q[3, largest], q[0, largest]).At(0, 0, 0);
        }
    }
}
