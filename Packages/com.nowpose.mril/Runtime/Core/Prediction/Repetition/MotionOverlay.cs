using System;

namespace Nowpose.Prediction.Repetition
{
    /// <summary>Lays the newest samples over the history some time back, and moves them until they fit best.</summary>
    /// <remarks>Lags are in grid steps of the history, with fractions. Allocates nothing.</remarks>
    sealed class MotionOverlay
    {
        /// <summary>A match may lie so far from where the longer memory finds it, s.</summary>
        const double Reach = 0.4;

        /// <summary>The longer memory is left only for a match whose square is this much better.</summary>
        const double MuchBetter = 0.1;

        /// <summary>So many of the samples are enough to find the neighbourhood.</summary>
        const int NearbySamples = 6;

        const int Refinements = 3;

        readonly MotionHistory _history;
        readonly SampleHistory _newest;

        public MotionOverlay(MotionHistory history, SampleHistory newest)
        {
            _history = history;
            _newest = newest;
        }

        /// <summary>Lag of the best fit, after <see cref="TryFind"/>.</summary>
        public double Lag { get; private set; }

        /// <summary>Mean square of what the samples lie off the history there.</summary>
        public double MeanSquare { get; private set; }

        /// <summary>What the newest two samples lie off the history there.</summary>
        public double Offset { get; private set; }

        /// <param name="lag">Where the longer memory finds the match.</param>
        /// <param name="leastLag">Nearer than this the history does not know what followed.</param>
        /// <param name="samples">How many of the newest samples are laid over it.</param>
        /// <returns>False where the history does not reach.</returns>
        public bool TryFind(int lag, int leastLag, int samples)
        {
            var nearby = Settled(Nearby(lag, leastLag, samples), leastLag, samples);
            var squareNearby = SquareAt(nearby, samples);
            var remembered = Settled(lag, leastLag, samples);
            if (!(squareNearby < MuchBetter * SquareAt(remembered, samples))) return !double.IsPositiveInfinity(MeanSquare);
            SquareAt(nearby, samples);
            return true;
        }

        double Settled(double lag, int leastLag, int samples)
        {
            for (var step = 0; step < Refinements; step++) lag = Math.Max(Refined(lag, samples), leastLag);
            return lag;
        }

        // A dwell that was longer or shorter than last time has moved the match by as much.
        int Nearby(int lag, int leastLag, int samples)
        {
            var best = lag;
            var least = double.PositiveInfinity;
            var reach = (int)(Reach / _history.Step);
            for (var shift = Math.Max(-reach, leastLag - lag); shift <= reach; shift++)
            {
                var cost = Nearness(lag + shift, samples);
                // The one that the longer memory found wins where all are alike.
                if (cost > least || (cost == least && Math.Abs(shift) >= Math.Abs(best - lag))) continue;
                least = cost;
                best = lag + shift;
            }
            return best;
        }

        // One step of Gauss and Newton: the shift at which the history would fit the samples better.
        double Refined(double lag, int samples)
        {
            double pull = 0, stiffness = 0;
            for (var i = 0; i < samples; i++)
            {
                if (!TryCompare(i, lag, out var error, out var speed)) return lag;
                pull += error * speed;
                stiffness += speed * speed;
            }
            return stiffness > 0 ? lag - Math.Min(Math.Max(pull / stiffness, -1), 1) : lag;
        }

        double Nearness(double lag, int samples)
        {
            var stride = 1 + (samples - 1) / NearbySamples;
            var sum = 0.0;
            for (var i = 0; i < samples; i += stride)
            {
                if (!TryCompare(i, lag, out var error, out _)) return double.PositiveInfinity;
                sum += error * error;
            }
            return sum;
        }

        double SquareAt(double lag, int samples)
        {
            double sum = 0, offset = 0;
            Lag = lag;
            MeanSquare = double.PositiveInfinity;
            for (var i = 0; i < samples; i++)
            {
                if (!TryCompare(i, lag, out var error, out _)) return MeanSquare;
                sum += error * error;
                if (i < 2) offset += error / 2;
            }
            Offset = offset;
            return MeanSquare = sum / samples;
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
