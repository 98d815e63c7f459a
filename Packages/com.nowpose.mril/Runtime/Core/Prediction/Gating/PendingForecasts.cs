namespace Nowpose.Prediction.Gating
{
    /// <summary>Forecasts that wait for their time, oldest first; when there are too many the oldest goes unjudged.</summary>
    sealed class PendingForecasts
    {
        const int Capacity = 64;

        readonly Forecast[] _forecasts = new Forecast[Capacity];
        int _first;
        int _count;

        public void Add(in Forecast forecast)
        {
            if (_count == Capacity) RemoveFirst();
            _forecasts[(_first + _count++) % Capacity] = forecast;
        }

        /// <summary>Takes the oldest whose time has come.</summary>
        /// <param name="now">Time of the newest sample, s; a microsecond early counts.</param>
        public bool TryTakeDue(double now, out Forecast forecast)
        {
            forecast = _forecasts[_first];
            if (_count == 0 || forecast.Time > now + 1e-6) return false;
            RemoveFirst();
            return true;
        }

        public void Clear() => _first = _count = 0;

        void RemoveFirst()
        {
            _first = (_first + 1) % Capacity;
            _count--;
        }

        /// <summary>What two predictors said of one time, and what hold says.</summary>
        public readonly struct Forecast
        {
            public Forecast(double time, double held, double candidate, double fallback, bool isAtRest)
            {
                Time = time;
                Held = held;
                Candidate = candidate;
                Fallback = fallback;
                IsAtRest = isAtRest;
            }

            public double Time { get; }
            public double Held { get; }
            public double Candidate { get; }
            public double Fallback { get; }

            /// <summary>Whether the joint was at rest when they were made.</summary>
            public bool IsAtRest { get; }
        }
    }
}
