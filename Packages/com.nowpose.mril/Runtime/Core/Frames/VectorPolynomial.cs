using System;

namespace Nowpose.Frames
{
    /// <summary>
    /// Polynomial through the newest samples of a vector (Schnierle &amp; Röck 2022, Eq. (8)): interpolating for h = n, least squares for
    /// h &gt; n.
    /// </summary>
    /// <remarks>
    /// All components are sampled at the same times, so they have one basis: the polynomials 1, u and u² − au − b, which are orthogonal on
    /// these times. Fewer samples lower the degree; degree 0 is hold.
    /// </remarks>
    sealed class VectorPolynomial
    {
        /// <summary>
        /// Minimum sum of squares of the third basis polynomial, relative to the squares of the times: times that coincide determine no
        /// parabola.
        /// </summary>
        const double MinSquareRatio = 1e-12;

        readonly int _degree, _samples;
        double _centre, _slope, _constant;
        Vector3D _mean, _linear, _quadratic;

        /// <param name="degree">Degree n, 0 to 2.</param>
        /// <param name="history">History h: the number of samples used besides the newest one; at least n.</param>
        public VectorPolynomial(int degree, int history) => (_degree, _samples) = (degree, history + 1);

        /// <summary>Fits the polynomial to the newest samples, of which there is at least one.</summary>
        public void Solve(RecentVectors recent)
        {
            var count = _degree == 0 ? 1 : Math.Min(_samples, recent.Count);
            var newest = recent.TimeOf(0);
            _linear = _quadratic = _mean = default;
            _centre = 0;
            for (var age = 0; age < count; age++)
            {
                _centre += (recent.TimeOf(age) - newest) / count;
                _mean += recent[age] * (1.0 / count);
            }
            if (count > 1) SolveLinear(recent, newest, count);
            if (count > 2 && _degree > 1) SolveQuadratic(recent, newest, count);
        }

        /// <summary>Returns the vector at a given time, in s, after the newest sample.</summary>
        public Vector3D At(double ahead)
        {
            var u = ahead - _centre;
            return _mean + _linear * u + _quadratic * (u * u - _slope * u - _constant);
        }

        void SolveLinear(RecentVectors recent, double newest, int count)
        {
            var (squares, cubes) = (0.0, 0.0);
            for (var age = 0; age < count; age++)
            {
                var u = recent.TimeOf(age) - newest - _centre;
                squares += u * u;
                cubes += u * u * u;
                _linear += (recent[age] - _mean) * u;
            }
            var perSquares = squares > 0 ? 1 / squares : 0;
            _linear *= perSquares;
            (_slope, _constant) = (cubes * perSquares, squares / count);
        }

        void SolveQuadratic(RecentVectors recent, double newest, int count)
        {
            var squares = 0.0;
            for (var age = 0; age < count; age++)
            {
                var u = recent.TimeOf(age) - newest - _centre;
                var value = u * u - _slope * u - _constant;
                squares += value * value;
                _quadratic += (recent[age] - _mean) * value;
            }
            _quadratic *= squares > MinSquareRatio * _constant * _constant ? 1 / squares : 0;
        }
    }
}
