using System;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>
    /// Weights of a forecast that is linear in the positions of the newest samples. They depend only on the times of these samples, so joints that
    /// are sampled together can share them, and they are computed once per message.
    /// </summary>
    /// <remarks>Allocates nothing after construction. Not thread-safe.</remarks>
    abstract class PositionWeights
    {
        /// <summary>
        /// Maximum difference of times that count as equal, in s: more than their rounding errors, and too short for a visible motion.
        /// </summary>
        const double SameSeconds = 1e-9;

        readonly double[] _table;
        bool _isSolved, _isTableFilled;

        /// <param name="samples">Maximum number of newest samples that the forecast uses.</param>
        protected PositionWeights(int samples)
        {
            Times = new double[samples];
            _table = new double[ForecastTable.Points * samples];
        }

        /// <summary>Maximum number of newest samples that the forecast uses.</summary>
        public int Samples => Times.Length;

        /// <summary>Minimum number of samples.</summary>
        public virtual int MinSamples => Samples;

        /// <summary>Number of samples that the forecast uses since the last update.</summary>
        public int Count { get; private set; }

        /// <summary>
        /// The weights at the points of a <see cref="ForecastTable"/>: those of the newest sample and of the others, point by point.
        /// </summary>
        public double[] Table
        {
            get
            {
                if (_isTableFilled) return _table;
                for (var point = 0; point < ForecastTable.Points; point++) At(point * ForecastTable.Step, _table, point * Samples);
                _isTableFilled = true;
                return _table;
            }
        }

        /// <summary>Times of the samples relative to the newest, in s.</summary>
        protected double[] Times { get; }

        /// <summary>Solves for the times of the newest samples, unless they are the same as before.</summary>
        /// <param name="times">Times of at least <paramref name="age"/> + <paramref name="count"/> samples in s, the newest first.</param>
        /// <param name="count">Number of samples to use, <see cref="MinSamples"/> to <see cref="Samples"/>.</param>
        /// <param name="age">Number of newer samples, which are ignored.</param>
        /// <returns>Whether these times determine the weights.</returns>
        public bool Update(double[] times, int count, int age = 0)
        {
            if (count == Count && HasTimes(times, age)) return _isSolved;
            Count = count;
            for (var i = 0; i < count; i++) Times[i] = times[age + i] - times[age];
            _isTableFilled = false;
            return _isSolved = Solve();
        }

        /// <summary>Computes the weights of the samples, the newest first.</summary>
        /// <param name="ahead">Seconds after the newest sample, 0 or more.</param>
        /// <param name="weights">Receives the weights from index <paramref name="start"/> on.</param>
        public abstract void At(double ahead, double[] weights, int start);

        bool HasTimes(double[] times, int age)
        {
            for (var i = 0; i < Count; i++)
                if (!(Math.Abs(times[age + i] - times[age] - Times[i]) <= SameSeconds)) return false;
            return true;
        }

        /// <summary>Computes the part of the weights that depends only on the times.</summary>
        /// <returns>Whether the times determine the weights.</returns>
        protected abstract bool Solve();
    }
}
