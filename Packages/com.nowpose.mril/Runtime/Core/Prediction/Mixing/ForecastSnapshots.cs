using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>Stores past forecasts until the samples of their times have arrived.</summary>
    /// <remarks>
    /// They have single precision: the snapshots of many joints exceed the processor's cache, and reading them takes longer than the arithmetic.
    /// </remarks>
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

        /// <summary>Finds the last snapshot at or before a time and the next snapshot, and drops all earlier snapshots.</summary>
        /// <param name="time">Time to find, in s.</param>
        /// <param name="older">The newest snapshot at or before that time.</param>
        /// <param name="younger">The next snapshot; null if there is none.</param>
        /// <returns>False if all snapshots are later than that time.</returns>
        public bool TryFind(double time, out Snapshot older, out Snapshot younger)
        {
            (older, younger) = (null, Count > 0 ? _snapshots[0] : null);
            while (younger != null && younger.Time <= time + JointSample.SameSeconds)
            {
                if (older != null) _snapshots.DropFirst();
                (older, younger) = (younger, Count > 1 ? _snapshots[1] : null);
            }
            return older != null;
        }

        public void Clear() => _snapshots.Clear();

        public sealed class Snapshot
        {
            readonly int _forecasts;

            // Stored point by point, so that the four points that a comparison needs are adjacent in memory. Hold is not stored, because its table is
            // zero.
            readonly float[] _values;

            // One bit per forecast.
            uint _withForecast;

            public Snapshot(int forecasts) => (_forecasts, _values) = (forecasts - 1, new float[(forecasts - 1) * ForecastTable.Points]);

            /// <summary>Time of the sample that was the newest when the forecast was made, in s.</summary>
            public double Time { get; set; }

            /// <summary>Position of the sample that was the newest when the forecast was made.</summary>
            public double Position { get; set; }

            /// <summary>Number of change points before the forecast. The weights do not learn from a forecast across a change point.</summary>
            public int ChangePoints { get; set; }

            /// <summary>Whether the joint was at rest (<see cref="RestDetector.IsAtRest"/>); its samples may have scattered.</summary>
            public bool WasAtRest { get; set; }

            /// <summary>Whether the joint stood still (<see cref="Standstill.Samples"/>).</summary>
            public bool WasStill { get; set; }

            /// <summary>Stores tables of <see cref="ForecastTable"/>, one after another, with single precision.</summary>
            /// <param name="points">Number of points of each table that are used.</param>
            /// <param name="withForecast">One bit per table that contains a forecast.</param>
            public void Store(double[] tables, int points, uint withForecast)
            {
                _withForecast = withForecast;
                for (int point = 0, i = 0; point < points; point++)
                    for (int forecast = 0, from = ForecastTable.Points + point; forecast < _forecasts; forecast++, from += ForecastTable.Points)
                        _values[i++] = (float)tables[from];
            }

            /// <summary>Returns whether the table of the mixture or of a candidate contains a forecast.</summary>
            public bool HasForecast(int forecast) => (_withForecast & 1u << forecast) != 0;

            /// <summary>Returns a forecast position, in the samples' unit.</summary>
            public double At(int forecast, in TableTime time) =>
                forecast == MixedForecasters.Hold ? Position : Position + time.Read(_values, forecast - 1, _forecasts);
        }
    }
}
