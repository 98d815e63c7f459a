using System;

namespace Nowpose.Prediction.Repetition
{
    /// <summary>
    /// Finds how long ago the joint last moved as it does now: the lags, in whole grid steps, at which the motion resembles itself most.
    /// </summary>
    /// <remarks>
    /// For every lag k it sums the squared differences x(n) − x(n−k) with exponential forgetting, one addition per lag and
    /// compared grid point. A pass over the lags is divided among several samples, to limit the cost of each. The slow forgetting
    /// distinguishes one dwell from another. Allocates nothing after construction.
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

        /// <summary>
        /// Maximum duration of a pass, in s. With 0.15 s, the errors on recordings are 0.3 % larger, because the lags are chosen later.
        /// </summary>
        const double MaxDuration = 0.06;

        /// <summary>
        /// Maximum step between compared lags, in s: <see cref="MotionOverlay"/> finds the exact lag near them. With 0.1 s, the error of an
        /// exact repetition at 50 ms is three times as large.
        /// </summary>
        const double LagStep = 0.06;

        /// <summary>Grid points between a lag's match and the newest one that the spline of <see cref="MotionHistory"/> needs.</summary>
        const int Margin = 4;

        readonly double[] _costs = new double[MotionHistory.Capacity];
        readonly int[] _best = new int[Kept];
        readonly double[] _bestCosts = new double[Kept];
        int _bestCount;
        long _taken;

        // The current pass: its grid point, the next lag, and the costs of the last two lags.
        long _point;
        int _lag;
        double _cost, _costBefore;

        /// <summary>The best lags, best first, as many as <see cref="Count"/>.</summary>
        public int[] Lags { get; } = new int[Kept];

        public int Count { get; private set; }

        public void Reset()
        {
            Array.Clear(_costs, 0, _costs.Length);
            _taken = 0;
            Count = 0;
        }

        /// <summary>Processes the new grid points.</summary>
        /// <param name="minLag">Minimum lag in grid steps; smaller lags would compare the motion with itself.</param>
        public void Follow(MotionHistory history, int minLag)
        {
            if (_taken == history.Count) return;
            var step = Math.Max(1, (int)(LagStep / history.Step + 1e-6));
            var stride = (int)Math.Ceiling(ComparedEvery / history.Step - 1e-6);
            var parts = Math.Max(1, (int)(MaxDuration / history.Step + 1e-6));
            var keeping = Math.Exp(-stride * history.Step / Forgetting);
            for (; _taken < history.Count; _taken++)
            {
                var part = (int)(_taken % stride);
                if (part >= parts) continue;
                if (part == 0) Begin(minLag);
                var longest = (int)Math.Min(Math.Min(MaxLag / history.Step, MotionHistory.Capacity - 1), _point);
                var lags = Math.Max(0, (longest - minLag) / step + 1);
                Continue(history, minLag + lags * (part + 1) / parts * step, minLag, step, keeping);
                if (part < parts - 1) continue;
                Count = _bestCount;
                Array.Copy(_best, Lags, Kept);
            }
        }

        void Begin(int minLag)
        {
            (_point, _lag, _bestCount) = (_taken, minLag, 0);
            // The first lag has no lower neighbour and is never chosen.
            (_cost, _costBefore) = (double.NegativeInfinity, double.NaN);
        }

        void Continue(MotionHistory history, int end, int minLag, int step, double keeping)
        {
            var (points, costs, now) = (history.Points, _costs, history[_point]);
            var (newest, cost, costBefore) = ((int)_point, _cost, _costBefore);
            var longest = (int)Math.Min(_point, MotionHistory.Capacity) - Margin;
            var i = (_lag - minLag) / step;
            for (var lag = _lag; lag < end; lag += step, i++)
            {
                var difference = now - points[(newest - lag) & MotionHistory.Mask];
                var next = keeping * costs[i] + difference * difference;
                costs[i] = next;
                if (cost < next && cost <= costBefore && lag < longest) Choose(lag - step, cost);
                (costBefore, cost) = (cost, next);
            }
            (_lag, _cost, _costBefore) = (end, cost, costBefore);
        }

        void Choose(int lag, double cost)
        {
            var place = _bestCount;
            while (place > 0 && cost < _bestCosts[place - 1]) place--;
            if (place == Kept) return;
            if (_bestCount < Kept) _bestCount++;
            for (var i = _bestCount - 1; i > place; i--) (_best[i], _bestCosts[i]) = (_best[i - 1], _bestCosts[i - 1]);
            (_best[place], _bestCosts[place]) = (lag, cost);
        }
    }
}
