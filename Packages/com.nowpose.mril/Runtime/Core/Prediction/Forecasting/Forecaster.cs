namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Forecasts a joint's position from its newest samples. Allocates nothing after construction. Not thread-safe.</summary>
    abstract class Forecaster
    {
        /// <summary>
        /// Number of newest samples that a forecast needs. A mixture uses the forecaster only while this number of samples, and at least three,
        /// belong to one motion. A forecaster that uses more samples than this number extrapolates across change points.
        /// </summary>
        public abstract int Samples { get; }

        /// <summary>Maximum time of a forecast after the newest sample, in s; infinite without a maximum.</summary>
        public virtual double Span => double.PositiveInfinity;

        /// <summary>Fits the forecaster to the newest samples.</summary>
        /// <returns>Whether the forecaster can forecast from these samples.</returns>
        public abstract bool Solve(MotionState motion);

        /// <summary>Returns the forecast position relative to the position of the newest sample, from the last solve.</summary>
        /// <param name="ahead">Seconds after the newest sample, 0 or more.</param>
        public abstract double At(double ahead);

        /// <summary>Returns the standard deviation of the position, in the samples' unit; NaN if it is unknown.</summary>
        /// <param name="ahead">Seconds after the newest sample, 0 or more.</param>
        public virtual double DeviationAt(double ahead) => double.NaN;

        /// <summary>Fills the array of a <see cref="ForecastTable"/> with forecasts from the last solve.</summary>
        /// <param name="table">Array that receives the forecasts from index <paramref name="start"/> on.</param>
        /// <param name="points">Number of points to fill.</param>
        public virtual void Fill(double[] table, int start, int points)
        {
            for (var i = 0; i < points; i++) table[start + i] = At(i * ForecastTable.Step);
        }

        /// <summary>Discards all learned state.</summary>
        public virtual void Reset() { }
    }
}
