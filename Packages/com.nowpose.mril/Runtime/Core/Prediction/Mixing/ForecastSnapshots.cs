using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>Forecasts as they were made, kept until the samples that they are about have come.</summary>
    sealed class ForecastSnapshots
    {
        /// <summary>The longest horizon at the shortest interval between samples: 0.45 s at 180 Hz are 81.</summary>
        const int Capacity = 96;

        readonly Snapshot[] _snapshots = new Snapshot[Capacity];
        int _first;

        /// <param name="forecasts">Tables in each snapshot.</param>
        public ForecastSnapshots(int forecasts)
        {
            for (var i = 0; i < Capacity; i++) _snapshots[i] = new Snapshot(forecasts);
        }

        public int Count { get; private set; }

        /// <summary>Index 0 is the oldest.</summary>
        public Snapshot this[int index] => _snapshots[(_first + index) % Capacity];

        /// <summary>Appends a snapshot to be filled. Drops the oldest when full.</summary>
        public Snapshot Append()
        {
            if (Count == Capacity) Drop(1);
            return this[Count++];
        }

        /// <summary>Forgets the oldest ones.</summary>
        public void Drop(int count)
        {
            _first = (_first + count) % Capacity;
            Count -= count;
        }

        public void Clear() => _first = Count = 0;

        public sealed class Snapshot
        {
            readonly bool[] _speaks;

            public Snapshot(int forecasts)
            {
                Tables = new double[forecasts * ForecastTable.Points];
                _speaks = new bool[forecasts];
            }

            /// <summary>Time of the newest sample then, s.</summary>
            public double Time { get; set; }

            /// <summary>Position of the newest sample then.</summary>
            public double Position { get; set; }

            /// <summary>Change points until then: forecasts across one are not scored.</summary>
            public int ChangePoints { get; set; }

            /// <summary>Whether the joint was at rest, noise included.</summary>
            public bool WasAtRest { get; set; }

            /// <summary>Whether the newest sample lay where the one before did.</summary>
            public bool WasStill { get; set; }

            /// <summary>One table of <see cref="ForecastTable"/> after another.</summary>
            public double[] Tables { get; }

            /// <summary>Whether a candidate had a forecast.</summary>
            public ref bool Speaks(int forecast) => ref _speaks[forecast];

            /// <summary>Forecast position, in the samples' unit.</summary>
            public double At(int forecast, double ahead) => Position + ForecastTable.Read(Tables, forecast * ForecastTable.Points, ahead);
        }
    }
}
