using System;
using Nowpose.Prediction.Samples;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>Keeps the past of one motion for the candidates that compare the newest samples with it.</summary>
    sealed class PastMotion
    {
        /// <summary>Number of newest samples: more than there are in the window of <see cref="TemplateForecaster"/> at an interval of 20 ms.</summary>
        public const int Kept = 24;

        /// <summary>
        /// Minimum number of sampling intervals before the history starts. Their running mean then determines the grid step. With 4 or 16, the errors
        /// change by at most 0.4 %.
        /// </summary>
        const int MinIntervals = 8;

        /// <summary>Minimum grid step, in s: the capacity of the history then covers two minutes.</summary>
        const double MinStep = 0.02;

        /// <summary>
        /// Maximum gap in the history, in s, even if the limits allow a longer one: the motion in a longer gap cannot be interpolated.
        /// </summary>
        const double MaxGap = 2;

        /// <summary>
        /// Maximum change of the sampling interval, as a factor; a larger change starts a new history. Twice the interval exceeds it. A lost sample
        /// does not, because a gap changes the mean interval by at most a factor of 1.2 (<see cref="SampleTiming"/>).
        /// </summary>
        const double MaxIntervalRatio = 1.6;

        readonly double _maximumGap;
        double _interval;

        /// <param name="components">Number of components of a position.</param>
        /// <param name="maximumGap">Maximum gap between two samples, in s; a longer gap restarts the history.</param>
        public PastMotion(int components, double maximumGap)
        {
            _maximumGap = Math.Min(maximumGap, MaxGap);
            History = new MotionHistory(components);
            Newest = new PositionWindow(Kept, components);
            Reset();
        }

        /// <summary>The motion on a uniform grid, valid while <see cref="HasStarted"/>.</summary>
        public MotionHistory History { get; }

        /// <summary>The newest samples. A wrong one is replaced when the next one shows it.</summary>
        public PositionWindow Newest { get; }

        /// <summary>Number of starts of the history so far. After each start, its indices count from zero again.</summary>
        public int Starts { get; private set; }

        /// <summary>Whether there are enough samples for a history.</summary>
        public bool HasStarted => _interval > 0;

        /// <summary>Adds the newest sample, unless another candidate has added it.</summary>
        public void Take(MotionState motion)
        {
            var (time, meanInterval) = (motion.NewestTime, motion.Timing.MeanInterval);
            if (Newest.Count > 0 && !(time > Newest.Times[0])) return;
            if (Newest.Count > 0 && time - Newest.Times[0] > _maximumGap) Reset();
            // A single gap does not change the mean interval enough to restart.
            if (HasStarted && (meanInterval > MaxIntervalRatio * _interval || meanInterval * MaxIntervalRatio < _interval)) Reset();
            Newest.Add(time, motion.Newest);
            if (!HasStarted) Begin(meanInterval);
            else
            {
                History.Add(time, motion.Newest);
                // A wrong sample would impair the comparisons of the next samples. At rest, what the history replaces may be noise.
                if (motion.IsPreviousWrong) History.Previous.CopyTo(Newest[1]);
            }
        }

        public void Reset()
        {
            _interval = 0;
            History.Start(0);
            Newest.Clear();
        }

        // The grid step is a multiple of the sampling interval, so that samples lie on grid points and need no interpolation.
        void Begin(double interval)
        {
            if (Newest.Count <= MinIntervals) return;
            _interval = interval;
            History.Start(_interval * Math.Ceiling(MinStep / _interval - MotionHistory.Rounding));
            for (var i = MinIntervals; i >= 0; i--) History.Add(Newest.Times[i], Newest[i]);
            Starts++;
        }
    }
}
