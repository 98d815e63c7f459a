using System;
using Nowpose.Messages;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction
{
    /// <summary>
    /// Keeps the displayed value continuous when a new section replaces the previous one: their difference at the last display time, the residual, is
    /// added to the new section and decays exponentially.
    /// </summary>
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

        readonly double _maxTimeConstant, _maxAhead;
        readonly double[] _residual;
        double _from, _timeConstant;
        bool _isActive;

        // Last display time, and the time of the newest sample of the section that was displayed at this time; negative infinity if nothing was
        // displayed, or a held position.
        double _lastDisplayed, _displayedSection;

        /// <param name="components">Number of components of the displayed value.</param>
        /// <param name="blend">Maximum time constant of the decay, in s. 0 means no blending: the displayed value jumps.</param>
        /// <param name="maxAhead">Time after its newest sample from which on a section is held, in s.</param>
        /// <exception cref="ArgumentOutOfRangeException">The time constant is negative or not finite.</exception>
        public SectionBlend(int components, double blend, double maxAhead)
        {
            if (!(blend >= 0) || double.IsPositiveInfinity(blend))
                throw new ArgumentOutOfRangeException(nameof(blend), blend, PredictionMessages.NegativeSeconds);
            (_maxTimeConstant, _residual, _maxAhead) = (blend, new double[components], maxAhead);
            Reset();
        }

        /// <summary>Returns whether a new section needs the value that was displayed before it.</summary>
        /// <param name="displayed">Last display time, in s; NaN if nothing is displayed.</param>
        public bool IsNeeded(double displayed) => _maxTimeConstant > 0 && !double.IsNaN(displayed);

        /// <summary>Returns the time constant for a sampling interval, in s.</summary>
        public double TimeConstant(double interval) => Math.Min(_maxTimeConstant, MaxTimeConstantRatio * interval);

        /// <summary>Stores which section a sample replaces.</summary>
        /// <param name="displayed">See <see cref="IsNeeded"/>.</param>
        /// <param name="replaced">Time of the newest sample of the replaced section, in s.</param>
        public void StoreReplaced(double displayed, double replaced)
        {
            // If several samples arrive between two frames, the displayed section is the section before the first of them.
            if (displayed == _lastDisplayed) return;
            // Blending would show a part of a held position as current.
            (_lastDisplayed, _displayedSection) = (displayed, displayed - replaced > _maxAhead ? double.NegativeInfinity : replaced);
        }

        /// <summary>Starts the decay at the last display time.</summary>
        /// <param name="displayed">See <see cref="IsNeeded"/>.</param>
        /// <param name="residual">
        /// Value that was displayed at that time, which includes the remainder of the previous residual, minus that of the new section.
        /// </param>
        /// <param name="motion">The motion after the sample.</param>
        public void Start(double displayed, ReadOnlySpan<double> residual, MotionState motion)
        {
            (_from, _timeConstant) = (displayed, TimeConstant(motion.Timing.MeanInterval));
            var squares = 0.0;
            for (var c = 0; c < _residual.Length; c++)
            {
                _residual[c] = residual[c];
                squares += _residual[c] * _residual[c];
            }
            _isActive = _timeConstant > 0 && !double.IsInfinity(_displayedSection)
                && Math.Sqrt(squares) <= MaxResidualRatio * motion.MaxSpeed * (displayed - _displayedSection);
        }

        /// <summary>Ends the decay: the section is displayed as it is.</summary>
        public void Stop() => _isActive = false;

        /// <summary>Returns the remainder of the residual that is added to the section at a given time.</summary>
        public double RemainderAt(double time, int component) => _isActive ? _residual[component] * Math.Exp(-Math.Abs(time - _from) / _timeConstant) : 0;

        /// <summary>Discards the displayed section.</summary>
        public void Reset() => (_lastDisplayed, _displayedSection, _isActive) = (double.NaN, double.NegativeInfinity, false);
    }
}
