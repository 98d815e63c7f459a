using System;

namespace Nowpose.Frames
{
    /// <summary>Limits the distance of forecasts from the line through the two newest samples.</summary>
    /// <remarks>
    /// A motion that breaks off, such as a vehicle that stops to turn within one sample, makes polynomials through samples before and after the break
    /// overshoot by a multiple of all their earlier errors. The line has the shortest window, so a forecast much further from it than
    /// any before is not used as it is. The maximum includes the forecasts that were limited: a new kind of motion is limited for few samples only.
    /// </remarks>
    sealed class DistanceLimit
    {
        /// <summary>Maximum distance relative to the recent maximum: 1 and 2.5 gave the same mean errors within 0.2 %.</summary>
        const double Growth = 1.5;

        readonly double _memory;
        double _max;

        /// <param name="memory">Time constant in which the maximum is forgotten, s.</param>
        public DistanceLimit(double memory)
        {
            _memory = memory;
            Clear();
        }

        /// <summary>Part of the distance that is used until the next sample, 0 to 1.</summary>
        public double Factor { get; private set; }

        /// <summary>Adds the distance of the forecast after a sample.</summary>
        /// <param name="interval">Time since the sample before, s.</param>
        /// <param name="distance">Distance from the line after one horizon, m or rad.</param>
        public void Add(double interval, double distance)
        {
            var max = Growth * _max;
            Factor = max > 0 && distance > max ? max / distance : 1;
            if (double.IsFinite(distance)) _max = Math.Max(_max * Math.Exp(-Math.Max(interval, 0) / _memory), distance);
        }

        public void Clear() => (_max, Factor) = (0, 1);
    }
}
