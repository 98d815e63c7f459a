using System;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>
    /// Finds how long ago the joint last moved in the same way as now: the lags, in whole grid steps, at which the past motion is most similar to the
    /// present motion.
    /// </summary>
    /// <remarks>
    /// For every lag k it sums the squared differences x(n) − x(n−k) with exponential forgetting, one addition per lag and
    /// compared grid point. The last half second therefore counts most, which distinguishes one dwell from another. The positions of
    /// an endless joint are unwrapped, so a cycle that ends one or more turns away from its start is not recognised. Allocates nothing after
    /// construction.
    /// </remarks>
    sealed class LagSearch
    {
        public const int Kept = 3;

        /// <summary>Time constant of the forgetting factor of the sums, in s.</summary>
        const double Forgetting = 0.25;

        /// <summary>Maximum lag, in s: cycles of up to two minutes.</summary>
        const double MaxLag = 120;

        readonly MotionHistory _history;
        readonly SearchDensity _density;

        // Costs of the lags, preceded by an infinite cost, which is never a minimum.
        readonly double[] _costs;
        readonly double[] _lagCosts = new double[Kept];
        long _taken;

        // Grid steps between two compared lags and between two compared points, and the forgetting factor.
        int _step, _stride;
        double _forgettingFactor;

        public LagSearch(MotionHistory history, SearchDensity density)
        {
            (_history, _density) = (history, density);
            // A step of whole grid steps is at least half of the density's step, so there are at most twice as many lags.
            var maxLags = (int)(2 * MaxLag / density.LagStep) + 1;
            _costs = new double[maxLags + 1];
        }

        /// <summary>The best lags, the best first. Only the first <see cref="Count"/> elements are valid.</summary>
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
            _step = Math.Max(1, (int)(_density.LagStep / _history.Step + 1e-6));
            _stride = (int)Math.Ceiling(_density.CompareInterval / _history.Step - 1e-6);
            _forgettingFactor = Math.Exp(-_stride * _history.Step / Forgetting);
        }

        /// <summary>Adds the new grid points of the history.</summary>
        /// <param name="minLag">Minimum lag in grid steps; smaller lags would compare the motion with itself.</param>
        public void Update(int minLag)
        {
            for (; _taken < _history.Count; _taken++)
                if (_taken % _stride == 0) Compare(_taken, minLag);
        }

        // Adds the squared differences at all lags to their costs, and finds the best local minima.
        void Compare(long newest, int minLag)
        {
            Count = 0;
            var longest = (int)Math.Min(Math.Min(MaxLag / _history.Step, MotionHistory.Capacity - 1), newest);
            var lags = Math.Max(0, (longest - minLag) / _step + 1);
            var (points, costs, now, forgettingFactor, step, worst) = (_history.Points, _costs, _history[newest], _forgettingFactor, _step, Worst);
            var point = (int)newest - minLag;
            // The costs of the two previous lags are in local variables, because the runtime checks each access of an array.
            var (before, last) = (costs[0], costs[0]);
            for (var i = 1; i <= lags; i++)
            {
                var difference = now - points[point & MotionHistory.Mask];
                var cost = forgettingFactor * costs[i] + difference * difference;
                costs[i] = cost;
                point -= step;
                // The first lag has no lower neighbour, and the history must cover the neighbourhood of the last one.
                if (last < worst && last < cost && last <= before && i > 2)
                {
                    var lag = minLag + (i - 2) * step;
                    if (lag + step < Math.Min(newest, MotionHistory.Capacity) - MotionHistory.Margin) Keep(lag, last);
                    worst = Worst;
                }
                (before, last) = (last, cost);
            }
        }

        // Cost below which a further lag is kept.
        double Worst => Count < Kept ? double.PositiveInfinity : _lagCosts[Kept - 1];

        void Keep(int lag, double cost)
        {
            if (Count < Kept) Count++;
            var place = Count - 1;
            for (; place > 0 && cost < _lagCosts[place - 1]; place--) (Lags[place], _lagCosts[place]) = (Lags[place - 1], _lagCosts[place - 1]);
            (Lags[place], _lagCosts[place]) = (lag, cost);
        }
    }
}
