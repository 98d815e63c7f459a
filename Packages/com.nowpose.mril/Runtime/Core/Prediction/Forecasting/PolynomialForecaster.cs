using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>
    /// Section-wise polynomials of Schnierle &amp; Röck 2022, Eq. (8): interpolating for h = n, least squares for h &gt; n.
    /// </summary>
    /// <remarks>
    /// For fewer than h + 1 samples, or coinciding stamps, it uses the highest degree that they determine. Degree 0 is hold.
    /// </remarks>
    sealed class PolynomialForecaster : Forecaster
    {
        /// <summary>Maximum h.</summary>
        public const int MaxHistory = 100;

        readonly PolynomialSection _section;

        /// <param name="degree">n, 0 to 3.</param>
        /// <param name="history">h, the number of samples used besides the newest one; n to 100.</param>
        /// <exception cref="ArgumentOutOfRangeException">Degree or history is outside its range.</exception>
        public PolynomialForecaster(int degree, int history)
        {
            if (degree < 0 || degree > PolynomialSection.HighestDegree)
                throw new ArgumentOutOfRangeException(nameof(degree), degree, "0 to " + PolynomialSection.HighestDegree);
            if (history < degree || history > MaxHistory)
                throw new ArgumentOutOfRangeException(nameof(history), history, "must be from the degree to " + MaxHistory);
            Samples = history + 1;
            _section = new PolynomialSection(degree, Samples);
        }

        public override int Samples { get; }

        public override bool Solve(MotionState motion)
        {
            _section.Solve(motion.Samples, Math.Min(motion.Connected, Samples));
            return _section.Degree > 0;
        }

        public override double At(double ahead) => _section.At(ahead);

        public override void Fill(double[] table, int start, int points) => _section.Fill(table, start, points);
    }
}
