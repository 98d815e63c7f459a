using System;

namespace Nowpose.Prediction
{
    /// <summary>How far ahead a predictor is asked, and how often it is sampled: running means of both.</summary>
    /// <remarks>What a forecaster learns from, it learns one horizon ahead.</remarks>
    sealed class ForecastHorizon
    {
        const double Learning = 0.02;
        const double Least = 0.01;
        const double Greatest = 0.45;
        const double First = 0.125;
        const double IntervalLearning = 0.1;
        const double FirstInterval = 0.05;
        const double LongestInterval = 0.3;

        double _asked;
        double _askedBefore;

        public ForecastHorizon() => Reset();

        /// <summary>From the newest sample to what is asked for, s.</summary>
        public double Seconds { get; private set; }

        /// <summary>From one sample to the next, s.</summary>
        public double Interval { get; private set; }

        /// <param name="time">Asked for, s.</param>
        /// <param name="ahead">Of the newest sample, s; a time between samples tells of no horizon.</param>
        public void Ask(double time, double ahead)
        {
            // Whoever asks once more about a moment that was shown shows nothing new.
            // Twice, for between the two somebody may ask for a forecast.
            if (!(ahead > 0) || time == _asked) return;
            if (time != _askedBefore) Seconds += Learning * (Math.Min(Math.Max(ahead, Least), Greatest) - Seconds);
            (_askedBefore, _asked) = (_asked, time);
        }

        /// <param name="interval">Before the newest sample, s.</param>
        public void Sample(double interval) => Interval += IntervalLearning * (Math.Min(interval, LongestInterval) - Interval);

        public void Reset()
        {
            Seconds = First;
            Interval = FirstInterval;
            _asked = _askedBefore = double.NegativeInfinity;
        }
    }
}
