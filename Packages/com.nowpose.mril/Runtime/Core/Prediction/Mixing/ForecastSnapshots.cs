using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>Stores past forecasts until the samples of their times have arrived.</summary>
    sealed class ForecastSnapshots
    {
        /// <summary>Capacity for the maximum horizon at the minimum sampling interval: 0.45 s at 180 Hz are 81.</summary>
        const int Capacity = 96;

        readonly RecyclingQueue<Snapshot> _snapshots;

        /// <param name="forecasts">Number of tables in each snapshot.</param>
        public ForecastSnapshots(int forecasts) => _snapshots = new RecyclingQueue<Snapshot>(Capacity, () => new Snapshot(forecasts));

        public int Count => _snapshots.Count;

        /// <summary>Index 0 is the oldest.</summary>
        public Snapshot this[int index] => _snapshots[index];

        /// <summary>Appends a snapshot to be filled. Drops the oldest when full.</summary>
        public Snapshot Append() => _snapshots.Append();

        /// <summary>Finds the last snapshot before a time and the first one after it, and drops all older snapshots.</summary>
        /// <param name="time">In s.</param>
        /// <param name="older">The newest snapshot at or before that time.</param>
        /// <param name="younger">The next snapshot; null if there is none.</param>
        /// <returns>False if all snapshots are younger.</returns>
        public bool TryFind(double time, out Snapshot older, out Snapshot younger)
        {
            var i = Count - 1;
            while (i >= 0 && _snapshots[i].Time > time + JointSample.SameSeconds) i--;
            (older, younger) = (i < 0 ? null : _snapshots[i], i + 1 < Count ? _snapshots[i + 1] : null);
            for (; i > 0; i--) _snapshots.DropFirst();
            return older != null;
        }

        public void Clear() => _snapshots.Clear();

        public sealed class Snapshot
        {
            readonly bool[] _hasForecast;

            public Snapshot(int forecasts)
            {
                Tables = new double[forecasts * ForecastTable.Points];
                _hasForecast = new bool[forecasts];
            }

            /// <summary>Time of the sample that was the newest when the forecast was made, in s.</summary>
            public double Time { get; set; }

            /// <summary>Position of the sample that was the newest when the forecast was made.</summary>
            public double Position { get; set; }

            /// <summary>Number of change points before the forecast. The weights do not learn from a forecast across a change point.</summary>
            public int ChangePoints { get; set; }

            /// <summary>Whether the joint was at rest, including noise.</summary>
            public bool WasAtRest { get; set; }

            /// <summary>Whether the joint stood still (<see cref="RestDetector.StillSamples"/>).</summary>
            public bool WasStill { get; set; }

            /// <summary>The tables of <see cref="ForecastTable"/>, one after another.</summary>
            public double[] Tables { get; }

            /// <summary>Whether a candidate had a forecast.</summary>
            public ref bool HasForecast(int forecast) => ref _hasForecast[forecast];

            /// <summary>Returns a forecast position, in the samples' unit.</summary>
            public double At(int forecast, in TableTime time) => Position + time.Read(Tables, forecast * ForecastTable.Points);
        }
    }
}
