using System;

namespace Nowpose.Prediction.Repetition
{
    /// <summary>Finds how long ago the joint last moved as it does now: whole grid steps at which the motion resembles itself most.</summary>
    /// <remarks>
    /// For every lag k the squared differences x(n) − x(n−k) are summed with exponential forgetting, one addition per lag and
    /// grid point. The slow forgetting is what tells one dwell from another. Allocates nothing once made.
    /// </remarks>
    sealed class LagSearch
    {
        public const int Kept = 3;

        const int PointsPerChoice = 3;

        readonly double[] _costs = new double[MotionHistory.Capacity];
        long _taken;

        /// <summary>The best lags, best first, as many as <see cref="Count"/>.</summary>
        public int[] Lags { get; } = new int[Kept];

        public int Count { get; private set; }

        public void Reset()
        {
            Array.Clear(_costs, 0, _costs.Length);
            _taken = 0;
            Count = 0;
        }

        /// <summary>Takes in the grid points that have come since.</summary>
        /// <param name="leastLag">In grid steps; nearer ones are the motion itself.</param>
        /// <param name="keeping">What the sum keeps per grid step, 0 to 1.</param>
        public void Follow(MotionHistory history, int leastLag, double keeping)
        {
            for (; _taken < history.Count; _taken++)
            {
                Take(history, leastLag, keeping);
                // A lag stays what it is while the motion repeats.
                if (_taken % PointsPerChoice == 0) Choose(history, leastLag);
            }
        }

        void Take(MotionHistory history, int leastLag, double keeping)
        {
            var now = history[_taken];
            var longest = (int)Math.Min(_taken, MotionHistory.Capacity - 1);
            for (var lag = leastLag; lag <= longest; lag++)
            {
                var difference = now - history[_taken - lag];
                _costs[lag] = keeping * _costs[lag] + difference * difference;
            }
        }

        void Choose(MotionHistory history, int leastLag)
        {
            Count = 0;
            var longest = (int)Math.Min(history.Count - 4, MotionHistory.Capacity - 4);
            for (var lag = leastLag + 1; lag < longest; lag++)
            {
                var cost = _costs[lag];
                if (cost > _costs[lag - 1] || cost >= _costs[lag + 1]) continue;
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
