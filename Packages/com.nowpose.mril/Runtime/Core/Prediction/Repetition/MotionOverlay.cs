using System;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.Repetition
{
    /// <summary>Lays the newest samples over the history some time back, and moves them until they fit best.</summary>
    /// <remarks>Lags are in grid steps of the history, with fractions. Allocates nothing.</remarks>
    sealed class MotionOverlay
    {
        /// <summary>Maximum distance of a match from the lag of <see cref="LagSearch"/>, s.</summary>
        const double Reach = 0.4;

        /// <summary>The longer memory is left only for a match whose square is this much better.</summary>
        const double MuchBetter = 0.1;

        /// <summary>Number of samples compared to find the neighbourhood.</summary>
        const int NearbySamples = 6;

        /// <summary>Samples compared at most, about: of 24 every second.</summary>
        const int ComparedSamples = 12;

        /// <summary>Steps of Gauss and Newton: the third moves by less than a thousandth of the grid.</summary>
        const int Refinements = 3;

        /// <summary>A step below this share of the grid's changes nothing.</summary>
        const double SmallStep = 1e-3;

        readonly MotionHistory _history;
        SampleHistory _newest;
        int _samples;

        public MotionOverlay(MotionHistory history) => _history = history;

        /// <summary>Mean square of the samples' distances from the history, after <see cref="Compare"/>.</summary>
        public double MeanSquare { get; private set; }

        /// <summary>Mean distance of the newest two samples from the history, after <see cref="Compare"/>.</summary>
        public double Offset { get; private set; }

        /// <summary>Takes the samples to be laid over the history.</summary>
        /// <param name="count">How many of the newest.</param>
        public void Take(SampleHistory newest, int count) => (_newest, _samples) = (newest, count);

        /// <summary>The lag at which the samples fit best.</summary>
        /// <param name="lag">Where the longer memory finds the match.</param>
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
        /// <returns>False where the history does not reach.</returns>
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

        // A dwell that was longer or shorter than last time has moved the match by as much.
        int Nearby(int lag, int minLag)
        {
            var best = lag;
            var least = double.PositiveInfinity;
            var reach = (int)(Reach / _history.Step);
            for (var shift = Math.Max(-reach, minLag - lag); shift <= reach; shift++)
            {
                var cost = Nearness(lag + shift, least);
                // The one that the longer memory found wins where all are alike.
                if (cost > least || (cost == least && Math.Abs(shift) >= Math.Abs(best - lag))) continue;
                least = cost;
                best = lag + shift;
            }
            return best;
        }

        // One step of Gauss and Newton: the shift at which the history would fit the samples better.
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

        // Whole grid points are near enough to find the neighbourhood.
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
