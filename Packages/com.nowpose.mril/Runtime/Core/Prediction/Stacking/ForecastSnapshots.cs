namespace Nowpose.Prediction.Stacking
{
    /// <summary>Forecasts as they were made, kept until the samples that they are about have come.</summary>
    sealed class ForecastSnapshots
    {
        const int Capacity = 64;

        readonly Snapshot[] _snapshots = new Snapshot[Capacity];
        int _first;

        /// <param name="forecasts">Tables in each snapshot.</param>
        public ForecastSnapshots(int forecasts)
        {
            for (var i = 0; i < Capacity; i++) _snapshots[i] = new Snapshot(new double[forecasts * ForecastGrid.Points]);
        }

        public int Count { get; private set; }

        /// <summary>Index 0 is the oldest.</summary>
        public Snapshot this[int index] => _snapshots[(_first + index) % Capacity];

        /// <summary>A new newest one, to be filled; the oldest goes when there is no room.</summary>
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
            public Snapshot(double[] tables) => Tables = tables;

            /// <summary>Time of the newest sample then, s.</summary>
            public double Time { get; set; }

            /// <summary>Position of the newest sample then.</summary>
            public double Position { get; set; }

            /// <summary>Shocks until then: across a shock a forecast says nothing about the forecaster.</summary>
            public int Shocks { get; set; }

            public bool WasAtRest { get; set; }

            /// <summary>One table of <see cref="ForecastGrid"/> after another.</summary>
            public double[] Tables { get; }
        }
    }
}
