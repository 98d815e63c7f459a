using System;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.Repetition
{
    /// <summary>Compares the newest samples with the history at a lag, and shifts them to the best fit.</summary>
    /// <remarks>Lags are in grid steps of the history, with fractions. Allocates nothing.</remarks>
    sealed class MotionOverlay
    {
        /// <summary>Maximum distance of a match from the lag of <see cref="LagSearch"/>, s.</summary>
        const double Reach = 0.4;

        /// <summary>Ratio of mean squares below which a nearby match replaces that of the longer memory.</summary>
        const double MuchBetter = 0.1;

        /// <summary>Number of samples compared in the search near the lag.</summary>
        const int NearbySamples = 6;

        /// <summary>Approximate maximum number of compared samples; every second of 24, for example.</summary>
        const int ComparedSamples = 12;

        /// <summary>Number of Gauss-Newton steps: the third changes the lag by less than a thousandth of a grid step.</summary>
        const int Refinements = 3;

        /// <summary>Gauss-Newton steps below this share of a grid step are negligible.</summary>
        const double SmallStep = 1e-3;

        readonly MotionHistory _history;
        SampleHistory _newest;
        int _samples;

        public MotionOverlay(MotionHistory history) => _history = history;

        /// <summary>Mean square of the samples' distances from the history, after <see cref="Compare"/>.</summary>
        public double MeanSquare { get; private set; }

        /// <summary>Mean distance of the newest two samples from the history, after <see cref="Compare"/>.</summary>
        public double Offset { get; private set; }

        /// <summary>Sets the samples to compare with the history.</summary>
        /// <param name="count">Number of newest samples.</param>
        public void Take(SampleHistory newest, int count) => (_newest, _samples) = (newest, count);

        /// <summary>Returns the lag at which the samples fit best.</summary>
        /// <param name="lag">Lag of the longer memory's match.</param>
        /// <param name="minLag">Minimum lag: the history after a match must cover a table.</param>
        public double Find(int lag, int minLag)
        {
            var nearby = Nearby(lag, minLag);
            var remembered = Settled(lag, minLag);
            if (nearby == lag) return remembered;
            var settled = Settled(nearby, minLag);
            var squareNearby = Compare(settled) ? MeanSquare : double.PositiveInfinity;
            return !Compare(remembered) || squareNearby < MuchBetter * MeanSquare ? settled : remembered;
        }

        /// <summary>Compares the samples with the history at a lag.</summary>
        /// <returns>False if the history does not cover the lag.</returns>
        public bool Compare(double lag)
        {
            double sum = 0, offset = 0;
            MeanSquare = double.PositiveInfinity;
            var stride = Stride(ComparedSamples);
            var count = 0;
            for (var i = 0; i < _samples; i += i == 0 ? 1 : stride)
            {
                if (!TryCompare(i, lag, out var error, out _)) return false;
                sum += error * error;
                count++;
                if (i < 2) offset += error;
            }
            Offset = offset / Math.Min(count, 2);
            MeanSquare = sum / count;
            return true;
        }

        int Stride(int wanted) => 1 + (_samples - 1) / wanted;

        double Settled(double lag, int minLag)
        {
            for (var i = 0; i < Refinements; i++)
            {
                var refined = Math.Max(Refined(lag), minLag);
                var step = Math.Abs(refined - lag);
                lag = refined;
                if (step < SmallStep) break;
            }
            return lag;
        }

        // A dwell that was longer or shorter than last time shifts the match by the difference.
        int Nearby(int lag, int minLag)
        {
            var best = lag;
            var least = double.PositiveInfinity;
            var reach = (int)(Reach / _history.Step);
            for (var shift = Math.Max(-reach, minLag - lag); shift <= reach; shift++)
            {
                var cost = Nearness(lag + shift, least);
                // Of equal costs, the lag nearest to that of the longer memory is chosen.
                if (cost > least || (cost == least && Math.Abs(shift) >= Math.Abs(best - lag))) continue;
                least = cost;
                best = lag + shift;
            }
            return best;
        }

        // One Gauss-Newton step: returns the lag with the better fit.
        double Refined(double lag)
        {
            double pull = 0, stiffness = 0;
            for (var i = 0; i < _samples; i += Stride(ComparedSamples))
            {
                if (!TryCompare(i, lag, out var error, out var speed)) return lag;
                pull += error * speed;
                stiffness += speed * speed;
            }
            return stiffness > 0 ? lag - Math.Min(Math.Max(pull / stiffness, -1), 1) : lag;
        }

        // Whole grid points are accurate enough for the search near the lag.
        double Nearness(int lag, double enough)
        {
            var sum = 0.0;
            for (var i = 0; i < _samples && sum <= enough; i += Stride(NearbySamples))
            {
                var index = (long)Math.Round(_history.IndexOf(_newest[i].Time)) - lag;
                if (!_history.Covers(index)) return double.PositiveInfinity;
                var error = _newest[i].Position - _history[index];
                sum += error * error;
            }
            return sum;
        }

        bool TryCompare(int age, double lag, out double error, out double speed)
        {
            var index = _history.IndexOf(_newest[age].Time) - lag;
            error = speed = 0;
            if (!_history.Covers(index)) return false;
            error = _newest[age].Position - _history.At(index, out speed);
            return true;
        }
    }
}
