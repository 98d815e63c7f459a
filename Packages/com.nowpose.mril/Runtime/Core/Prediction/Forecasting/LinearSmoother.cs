using System;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Forecasting
{
    /// <summary>
    /// A linear smoother: forecasts a position as the weighted sum of the newest samples' positions. The weights depend only on the times of these samples,
    /// so motions that are sampled together can share a forecaster, and the weights are computed once per message.
    /// </summary>
    abstract class LinearSmoother : Forecaster
    {
        /// <summary>
        /// Maximum difference of times that count as equal, in s: more than their rounding errors, and too short for a visible motion.
        /// </summary>
        const double MaxRounding = 1e-9;

        readonly bool _stopsAtReversal;

        // The weights at the first points of a ForecastTable, sample by sample: those of a sample at all points are adjacent.
        readonly double[] _table;
        int _filledPoints;
        bool _isSolved;

        // The samples of the last solve. The first of them is _age samples older than the newest one.
        MotionState _motion;
        int _age;

        /// <param name="samples">Maximum number of newest samples that the forecast uses.</param>
        /// <param name="stopsAtReversal">
        /// Whether <see cref="Fill"/> keeps the forecast constant after a reversal, because drives stop far more often than they reverse.
        /// </param>
        protected LinearSmoother(int samples, bool stopsAtReversal)
        {
            _stopsAtReversal = stopsAtReversal;
            Times = new double[samples];
            _table = new double[ForecastTable.Points * samples];
        }

        public sealed override int UsedSamples => Times.Length;

        /// <summary>Minimum number of samples for a solution outside a mixture.</summary>
        protected virtual int MinSamples => UsedSamples;

        /// <summary>Number of samples that the forecast uses since the last solve.</summary>
        protected int Count { get; private set; }

        /// <summary>Times of the samples relative to the newest, in s.</summary>
        protected double[] Times { get; }

        public override bool Solve(MotionState motion) => Solve(motion, age: 0);

        /// <summary>Solves as if an earlier sample were the newest. <see cref="At"/> is relative to this sample until the next solve.</summary>
        /// <param name="age">Number of newer samples, which are ignored.</param>
        /// <returns>Whether the older samples determine the weights.</returns>
        public bool Solve(MotionState motion, int age)
        {
            var count = Math.Min(motion.Count - age, UsedSamples);
            (_motion, _age) = (motion, age);
            if (count < MinSamples) return false;
            if (count == Count && HasTimes(motion.Times, age)) return _isSolved;
            Count = count;
            for (var i = 0; i < count; i++) Times[i] = motion.Times[age + i] - motion.Times[age];
            _filledPoints = 0;
            return _isSolved = SolveWeights();
        }

        /// <inheritdoc/>
        /// <remarks>Valid until the forecaster solves for another motion. Unlike <see cref="Fill"/>, it also continues a motion after a reversal.</remarks>
        public override double At(double ahead, int component)
        {
            Span<double> weights = stackalloc double[UsedSamples];
            FillWeights(ahead, weights);
            var sum = 0.0;
            for (var j = 1; j < Count; j++) sum += weights[j] * DisplacementOf(j, component);
            return sum;
        }

        /// <inheritdoc/>
        /// <remarks>
        /// Call it after <see cref="Solve(MotionState)"/>. Adds sample after sample to all points: with a sum per point, each addition would wait for
        /// the one before it, which takes 1.6 times as long on Mono.
        /// </remarks>
        public override void Fill(double[] table, int start, int points, int components)
        {
            if (_filledPoints < points) FillTable(points);
            var (weights, displacements) = (_table, _motion.Displacements);
            for (var i = start; i < start + points * components; i++) table[i] = 0;
            for (int j = 1, at = components; j < Count; j++)
                for (var c = 0; c < components; c++)
                {
                    var displacement = displacements[at++];
                    for (int point = 0, weight = j * ForecastTable.Points, i = start + c; point < points; point++, i += components)
                        table[i] += weights[weight++] * displacement;
                }
            if (_stopsAtReversal) Stop(table, start, points, components);
        }

        /// <summary>Computes the part of the weights that depends only on the times.</summary>
        /// <returns>Whether the times determine the weights.</returns>
        protected abstract bool SolveWeights();

        /// <summary>Computes the weights of the samples, the newest first. Changes nothing else.</summary>
        /// <param name="ahead">Seconds after the newest sample, 0 or more.</param>
        /// <param name="weights">Receives the weights.</param>
        protected abstract void FillWeights(double ahead, Span<double> weights);

        bool HasTimes(double[] times, int age)
        {
            for (var i = 0; i < Count; i++)
                if (!(Math.Abs(times[age + i] - times[age] - Times[i]) <= MaxRounding)) return false;
            return true;
        }

        double DisplacementOf(int sample, int component)
        {
            var (positions, components) = (_motion.Displacements, _motion.Components);
            return positions[(_age + sample) * components + component] - positions[_age * components + component];
        }

        void FillTable(int points)
        {
            Span<double> weights = stackalloc double[UsedSamples];
            for (; _filledPoints < points; _filledPoints++)
            {
                FillWeights(_filledPoints * ForecastTable.Step, weights);
                for (var j = 0; j < Count; j++) _table[j * ForecastTable.Points + _filledPoints] = weights[j];
            }
        }

        void Stop(double[] table, int start, int points, int components)
        {
            var velocity = _motion.Velocity;
            var hasStopped = false;
            for (int point = 1, i = start + components; point < points; point++, i += components)
            {
                var progress = 0.0;
                for (var c = 0; c < components; c++) progress += (table[i + c] - table[i + c - components]) * velocity[c];
                hasStopped |= progress <= 0;
                for (var c = 0; c < components && hasStopped; c++) table[i + c] = table[i + c - components];
            }
        }
    }
}
