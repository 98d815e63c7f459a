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

        readonly MotionHistory _history;

        // One cost per lag, after an infinite one, which is never a minimum.
        readonly double[] _costs = new double[MotionHistory.Capacity + 1];
        readonly int[] _best = new int[Kept];
        readonly double[] _bestCosts = new double[Kept];
        int _bestCount;
        long _taken;

        // Grid steps between two compared lags and between two compared points, grid points that share a pass, and forgetting factor.
        int _step, _stride, _parts;
        double _keeping;

        // The current pass: its grid point, and the number of lags that it has compared.
        long _point;
        int _minLag, _compared;

        public LagSearch(MotionHistory history) => _history = history;

        /// <summary>The best lags, best first, as many as <see cref="Count"/>.</summary>
        public int[] Lags { get; } = new int[Kept];

        public int Count { get; private set; }

        /// <summary>Discards all costs, after the history has been cleared.</summary>
        public void Start()
        {
            Array.Clear(_costs, 0, _costs.Length);
            _costs[0] = double.PositiveInfinity;
            _taken = 0;
            Count = 0;
            if (!(_history.Step > 0)) return;
            _step = Math.Max(1, (int)(LagStep / _history.Step + 1e-6));
            _stride = (int)Math.Ceiling(ComparedEvery / _history.Step - 1e-6);
            _parts = Math.Max(1, (int)(MaxDuration / _history.Step + 1e-6));
            _keeping = Math.Exp(-_stride * _history.Step / Forgetting);
        }

        /// <summary>Processes the new grid points.</summary>
        /// <param name="minLag">Minimum lag in grid steps; smaller lags would compare the motion with itself.</param>
        public void Follow(int minLag)
        {
            _minLag = minLag;
            for (; _taken < _history.Count; _taken++)
            {
                var part = (int)(_taken % _stride);
                if (part >= _parts) continue;
                if (part == 0) (_point, _compared, _bestCount) = (_taken, 0, 0);
                var longest = (int)Math.Min(Math.Min(MaxLag / _history.Step, MotionHistory.Capacity - 1), _point);
                var lags = Math.Max(0, (longest - minLag) / _step + 1);
                Continue(lags * (part + 1) / _parts);
                if (part < _parts - 1) continue;
                Count = _bestCount;
                Array.Copy(_best, Lags, Kept);
            }
        }

        // Adds the squared differences at the next lags to their costs, and finds the local minima.
        void Continue(int end)
        {
            var (points, costs, now, keeping, step, worst) = (_history.Points, _costs, _history[_point], _keeping, _step, Worst);
            var point = (int)_point - _minLag - _compared * step;
            for (var i = _compared + 1; i <= end; i++)
            {
                costs[i] = keeping * costs[i] + Square(now - points[point & MotionHistory.Mask]);
                point -= step;
                if (costs[i - 1] < worst && costs[i - 1] < costs[i] && costs[i - 1] <= costs[i - 2]) worst = Consider(i - 1);
            }
            _compared = end;
        }

        static double Square(double x) => x * x;

        // Returns the cost below which a further lag is kept.
        double Consider(int i)
        {
            var lag = _minLag + (i - 1) * _step;
            // The first lag has no lower neighbour, and the history must cover the neighbourhood of the last one.
            if (i > 1 && lag + _step < Math.Min(_point, MotionHistory.Capacity) - Margin) Keep(lag, _costs[i]);
            return Worst;
        }

        double Worst => _bestCount < Kept ? double.PositiveInfinity : _bestCosts[Kept - 1];

        void Keep(int lag, double cost)
        {
            if (_bestCount < Kept) _bestCount++;
            var place = _bestCount - 1;
            for (; place > 0 && cost < _bestCosts[place - 1]; place--) (_best[place], _bestCosts[place]) = (_best[place - 1], _bestCosts[place - 1]);
            (_best[place], _bestCosts[place]) = (lag, cost);
        }
    }
}
