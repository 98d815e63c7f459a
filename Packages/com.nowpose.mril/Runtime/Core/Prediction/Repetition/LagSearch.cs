using System;

namespace Nowpose.Prediction.Repetition
{
    /// <summary>
    /// Finds how long ago the joint last moved as it does now: the lags, in whole grid steps, at which the motion resembles itself most.
    /// </summary>
    /// <remarks>
    /// For every lag k it sums the squared differences x(n) − x(n−k) with exponential forgetting, one addition per lag and
    /// compared grid point. The slow forgetting distinguishes one dwell from another. Allocates nothing after construction.
    /// </remarks>
    sealed class LagSearch
    {
        public const int Kept = 3;

        /// <summary>Forgetting time constant of the sums, s.</summary>
        const double Forgetting = 0.25;

        /// <summary>Maximum lag, in s: cycles of up to two minutes.</summary>
        const double MaxLag = 120;

        /// <summary>Interval between the compared grid points, in s: closer ones add little, and each costs a pass over all lags.</summary>
        const double ComparedEvery = 0.15;

        /// <summary>Passes between two choices of lags: a lag is constant while the motion repeats.</summary>
        const int PassesPerChoice = 2;

        /// <summary>Maximum step between compared lags, in s: <see cref="MotionOverlay"/> finds the exact lag near them.</summary>
        const double LagStep = 0.06;

        readonly double[] _costs = new double[MotionHistory.Capacity];
        long _taken;
        int _passes;

        /// <summary>The best lags, best first, as many as <see cref="Count"/>.</summary>
        public int[] Lags { get; } = new int[Kept];

        public int Count { get; private set; }

        public void Reset()
        {
            Array.Clear(_costs, 0, _costs.Length);
            _taken = _passes = 0;
            Count = 0;
        }

        /// <summary>Processes the new grid points.</summary>
        /// <param name="minLag">Minimum lag in grid steps; smaller lags would compare the motion with itself.</param>
        public void Follow(MotionHistory history, int minLag)
        {
            var stride = (int)Math.Ceiling(ComparedEvery / history.Step - 1e-6);
            for (; _taken < history.Count; _taken++)
            {
                if (_taken % stride != 0) continue;
                var longest = (int)Math.Min(MaxLag / history.Step, MotionHistory.Capacity - 1);
                var step = Math.Max(1, (int)(LagStep / history.Step + 1e-6));
                history.AddSquaredDifferences(_taken, minLag, longest, step, Math.Exp(-stride * history.Step / Forgetting), _costs);
                if (_passes++ % PassesPerChoice == 0) Choose(history, minLag, longest, step);
            }
        }

        void Choose(MotionHistory history, int minLag, int longest, int step)
        {
            Count = 0;
            longest = (int)Math.Min(history.Count - 4, longest - 3) - step;
            for (var lag = minLag + step; lag < longest; lag += step)
            {
                var cost = _costs[lag];
                if (cost > _costs[lag - step] || cost >= _costs[lag + step]) continue;
                var place = Count;
                while (place > 0 && cost < _costs[Lags[place - 1]]) place--;
                if (place == Kept) continue;
                if (Count < Kept) Count++;
                for (var i = Count - 1; i > place; i--) Lags[i] = Lags[i - 1];
                Lags[place] = lag;
            }
        }
    }
}
