namespace Nowpose.Prediction.Forecasting
{
    /// <summary>Says where a joint will be, from its newest samples. Allocates nothing once made; one thread.</summary>
    abstract class Forecaster
    {
        /// <summary>Samples of one motion that it needs.</summary>
        public abstract int Samples { get; }

        /// <summary>How far its forecasts reach, s; infinite where nothing bounds them.</summary>
        public virtual double Span => double.PositiveInfinity;

        /// <summary>Solves for the newest samples.</summary>
        /// <returns>False where it has nothing to say of them.</returns>
        public abstract bool Solve(MotionState motion);

        /// <summary>Position relative to the newest sample's, by what was solved last.</summary>
        /// <param name="ahead">Seconds after the newest sample, 0 or more.</param>
        public abstract double At(double ahead);

        /// <summary>Standard deviation of the position, in the samples' unit; NaN where it is unknown.</summary>
        /// <param name="ahead">Seconds after the newest sample, 0 or more.</param>
        public virtual double DeviationAt(double ahead) => double.NaN;

        /// <summary>Fills a table of <see cref="ForecastTable"/> by what was solved last.</summary>
        /// <param name="table">To hold the table from <paramref name="start"/> on.</param>
        /// <param name="points">How much of it is wanted.</param>
        public virtual void Fill(double[] table, int start, int points)
        {
            for (var i = 0; i < points; i++) table[start + i] = At(i * ForecastTable.Step);
        }

        /// <summary>Forgets what it has learned.</summary>
        public virtual void Reset() { }
    }
}
