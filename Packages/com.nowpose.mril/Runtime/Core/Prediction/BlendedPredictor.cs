using System;

namespace Nowpose.Prediction
{
    /// <summary>Shows a predictor's sections without a jump where one replaces the other; what is asked for is what is displayed.</summary>
    /// <remarks>
    /// A frame asks once, or twice for the same moment or a later one. In the frame after a sample the section is evaluated
    /// twice, otherwise once. A difference that no motion of the joint explains (it was set elsewhere, its angle wrapped) is
    /// shown at once: drawn out, it would be a motion that never was.
    /// </remarks>
    public sealed class BlendedPredictor : IJointPredictor
    {
        /// <summary>
        /// Most of the sampling interval that the time constant takes. What remains of one section when the next comes adds
        /// up: beyond a fifth the RMS error grows by more than 5 % (display.md has the numbers).
        /// </summary>
        const double GreatestShareOfInterval = 0.2;

        /// <summary>After a longer pause of the display nobody remembers what was shown, s.</summary>
        const double LongestPause = 0.25;

        /// <summary>
        /// A prediction errs by twice the joint's way at most when it runs ahead of a joint that turned back; polynomials
        /// overshoot that by half and more.
        /// </summary>
        const double GreatestError = 4;

        readonly IJointPredictor _inner;
        readonly PredictionLimits _limits;
        readonly double _timeConstant;
        readonly SamplePace _pace = new SamplePace();
        SectionBlend _blend;
        double _shownAt = double.NegativeInfinity;
        double _shown;
        double _sectionOf;
        bool _isNewSection;
        bool _wasPlanned;

        /// <param name="limits">Only the position limits matter here: what is shown keeps within them.</param>
        /// <param name="timeConstant">Within which a difference falls to 1/e, s; less where samples come in quick succession. 0: off.</param>
        public BlendedPredictor(IJointPredictor inner, PredictionLimits limits, double timeConstant)
        {
            if (!(timeConstant >= 0) || double.IsPositiveInfinity(timeConstant))
                throw new ArgumentOutOfRangeException(nameof(timeConstant), timeConstant, "seconds, 0 or more");
            _inner = inner ?? throw new ArgumentNullException(nameof(inner));
            _limits = limits ?? throw new ArgumentNullException(nameof(limits));
            _timeConstant = timeConstant;
        }

        /// <inheritdoc/>
        public double Hold => _inner.Hold;

        /// <inheritdoc/>
        public double NewestTime => _inner.NewestTime;

        /// <inheritdoc/>
        public SampleOutcome Add(in JointSample sample)
        {
            var before = _inner.NewestTime;
            var outcome = _inner.Add(sample);
            if (outcome != SampleOutcome.Accepted && outcome != SampleOutcome.Late) return outcome;
            // Of several samples between two frames, what is shown was made of the section before the first.
            if (!_isNewSection) _sectionOf = before;
            _isNewSection = true;
            _pace.Add(sample.Time, sample.Position);
            return outcome;
        }

        /// <summary>The inner predictor says something else than before, for another reason than a sample.</summary>
        public void Renew()
        {
            if (!_isNewSection) _sectionOf = _inner.NewestTime;
            _isNewSection = true;
        }

        /// <inheritdoc/>
        public JointPrediction At(double time)
        {
            if (_timeConstant == 0) return _inner.At(time);
            var isContinued = Math.Abs(time - _shownAt) <= LongestPause;
            // First of what was shown: what learns from being asked has just been asked the same.
            if (_isNewSection && isContinued) Carry();
            _isNewSection = false;
            var section = _inner.At(time);
            if (section.Kind == PredictionKind.None) return section;
            var isPlanned = section.Kind == PredictionKind.Planned;
            if (!isContinued) _blend.Clear();
            else if (isPlanned != _wasPlanned) Carry();
            _wasPlanned = isPlanned;
            _shownAt = time;
            var shown = section.Position + _blend.At(time);
            _shown = _limits.Clamp(double.IsFinite(shown) ? shown : section.Position);
            return new JointPrediction(_shown, section.Kind);
        }

        /// <inheritdoc/>
        public void Reset()
        {
            _inner.Reset();
            _blend.Clear();
            _pace.Clear();
            _shownAt = double.NegativeInfinity;
            _isNewSection = false;
        }

        void Carry()
        {
            var residual = _shown - _inner.At(_shownAt).Position;
            var timeConstant = Math.Min(_timeConstant, GreatestShareOfInterval * _pace.Interval);
            if (timeConstant > 0 && Math.Abs(residual) <= GreatestError * _pace.GreatestSpeed * (_shownAt - _sectionOf))
                _blend.Start(_shownAt, residual, timeConstant);
            else
                _blend.Clear();
        }
    }
}
