using System;
using Nowpose.Messages;

namespace Nowpose.Prediction
{
    /// <summary>
    /// Keeps the displayed value continuous when a new section replaces the previous one: their difference at the last display time, the residual, is
    /// added to the new section and decays exponentially.
    /// </summary>
    /// <remarks>The caller stores the residual, which is a position for a joint and a vector for an object.</remarks>
    sealed class SectionBlend
    {
        /// <summary>
        /// Maximum time constant relative to the sampling interval: residuals of several sections add up, and beyond a fifth the RMS error
        /// grows by more than 5 % (display-reference.md).
        /// </summary>
        const double MaxTimeConstantRatio = 0.2;

        /// <summary>
        /// Maximum residual relative to the maximum speed times the age of the previous section. A larger residual comes from a repositioned joint
        /// or object, or from an angle that wrapped, and blending would display it as a motion. The value must exceed 3: when a joint reverses at
        /// full speed, the ratio is 2, and a polynomial that overshoots adds half of that or more.
        /// </summary>
        const double MaxResidualRatio = 4;

        readonly double _maxTimeConstant;
        double _from, _timeConstant;

        // Last display time, and the time of the newest sample of the section that was displayed at this time.
        double _lastDisplayed, _displayedSection;

        /// <param name="blend">Maximum time constant of the decay, in s. 0 means no blending: the displayed value jumps.</param>
        /// <exception cref="ArgumentOutOfRangeException">The time constant is negative or not finite.</exception>
        public SectionBlend(double blend)
        {
            if (!(blend >= 0) || double.IsPositiveInfinity(blend))
                throw new ArgumentOutOfRangeException(nameof(blend), blend, PredictionMessages.NegativeSeconds);
            _maxTimeConstant = blend;
            Reset();
        }

        /// <summary>Returns whether a new section needs the value that was displayed before it.</summary>
        /// <param name="displayed">Last display time, in s; NaN if nothing is displayed.</param>
        public bool IsNeeded(double displayed) => _maxTimeConstant > 0 && !double.IsNaN(displayed);

        /// <summary>Returns the time constant for a sampling interval, in s.</summary>
        public double TimeConstant(double interval) => Math.Min(_maxTimeConstant, MaxTimeConstantRatio * interval);

        /// <summary>Stores which section a sample replaces.</summary>
        /// <param name="displayed">See <see cref="IsNeeded"/>.</param>
        /// <param name="newest">Time of the previous newest sample, in s.</param>
        public void Replace(double displayed, double newest)
        {
            // If several samples arrive between two frames, the displayed section is the section before the first of them.
            if (displayed != _lastDisplayed) (_lastDisplayed, _displayedSection) = (displayed, newest);
        }

        /// <summary>Starts the decay at the last display time.</summary>
        /// <param name="displayed">See <see cref="IsNeeded"/>.</param>
        /// <param name="residual">Magnitude of the residual.</param>
        /// <param name="maxSpeed">Maximum speed so far, per second.</param>
        /// <param name="interval">Sampling interval, in s.</param>
        /// <returns>False if the new section must be shown at once.</returns>
        public bool TryStart(double displayed, double residual, double maxSpeed, double interval)
        {
            (_from, _timeConstant) = (displayed, TimeConstant(interval));
            return _timeConstant > 0 && residual <= MaxResidualRatio * maxSpeed * (displayed - _displayedSection);
        }

        /// <summary>Returns the remaining part of the residual at a given time, 0 to 1.</summary>
        public double RemainderAt(double time) => Math.Exp(-Math.Abs(time - _from) / _timeConstant);

        /// <summary>Discards the displayed section.</summary>
        public void Reset() => (_lastDisplayed, _displayedSection) = (double.NaN, double.NegativeInfinity);
    }
}
