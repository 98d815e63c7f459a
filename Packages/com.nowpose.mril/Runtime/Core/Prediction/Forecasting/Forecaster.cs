using System;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Forecasts a motion from its newest samples.</summary>
    /// <remarks>
    /// As all classes of the prediction, it allocates nothing after construction. Only one thread may add samples, and no other thread may read meanwhile.
    /// </remarks>
    abstract class Forecaster
    {
        /// <summary>
        /// Number of newest samples that the forecast uses. In a mixture, a line replaces the forecast while there are fewer since the last change point. A
        /// <see cref="Candidates.Candidate"/> does not use the number: its forecaster decides in <see cref="Solve"/>.
        /// </summary>
        public virtual int UsedSamples => 2;

        /// <summary>
        /// Number of newest samples of one motion without which a mixture replaces the forecast by a line: at least three, because all forecasts from two are
        /// this line, and rounding would decide between their equal errors.
        /// </summary>
        public virtual int SamplesInMixture(MotionState motion) => Math.Max(UsedSamples, 3);

        /// <summary>Maximum time of a forecast after the newest sample, in s; infinite without a maximum.</summary>
        public virtual double Span => double.PositiveInfinity;

        /// <summary>Fits the forecaster to the newest samples.</summary>
        /// <returns>Whether the forecaster can forecast from these samples.</returns>
        public abstract bool Solve(MotionState motion);

        /// <summary>Returns a component of the forecast position relative to the position of the newest sample, from the last solve.</summary>
        /// <param name="ahead">Seconds after the newest sample, 0 or more; for the paper's polynomials any time.</param>
        public abstract double At(double ahead, int component);

        /// <summary>Returns the standard deviation of a component, in the samples' unit; NaN if it is unknown.</summary>
        /// <param name="ahead">Seconds after the newest sample, 0 or more.</param>
        public virtual double DeviationAt(double ahead) => double.NaN;

        /// <summary>Fills the points of a <see cref="ForecastTable"/> with forecasts from the last solve.</summary>
        /// <param name="table">Array that receives the forecasts from index <paramref name="start"/> on; the components of a point are adjacent.</param>
        /// <param name="points">Number of points to fill.</param>
        public virtual void Fill(double[] table, int start, int points, int components)
        {
            for (var point = 0; point < points; point++)
                for (var c = 0; c < components; c++) table[start++] = At(point * ForecastTable.Step, c);
        }

        /// <summary>Discards all learned state.</summary>
        public virtual void Reset() { }
    }
}
