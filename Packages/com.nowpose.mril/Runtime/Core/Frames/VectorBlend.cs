using System;

namespace Nowpose.Frames
{
    /// <summary>Keeps a displayed vector continuous when a sample changes its prediction: the difference at the last displayed moment decays.</summary>
    /// <remarks>The same as for a joint, with the lengths of vectors in place of displacements. Allocates nothing.</remarks>
    sealed class VectorBlend
    {
        /// <summary>Maximum time constant, as a share of the sampling interval: as for a joint.</summary>
        const double MaxShareOfInterval = 0.2;

        /// <summary>
        /// Maximum difference that is blended, relative to the maximum speed times the age of the displayed prediction: as for a joint. A larger
        /// one comes from an object that was moved elsewhere.
        /// </summary>
        const double MaxError = 4;

        readonly double _timeConstant;
        Vector3D _residual;
        double _residualFrom, _residualTimeConstant, _lastDisplayed, _sectionOf, _maxSpeed;
        bool _isOpen;

        /// <param name="timeConstant">s; 0: no blending, the vector jumps.</param>
        public VectorBlend(double timeConstant)
        {
            _timeConstant = timeConstant;
            Clear();
        }

        /// <summary>Whether a vector displayed at a time is needed when a sample comes.</summary>
        public bool IsNeededAt(double displayed) => _timeConstant > 0 && !double.IsNaN(displayed);

        /// <summary>Starts from the vector that was displayed before the newest sample.</summary>
        /// <param name="shown">What was displayed.</param>
        /// <param name="predicted">What the newest prediction gives at the same time.</param>
        /// <param name="before">Time of the newest sample of the displayed prediction, s.</param>
        /// <param name="recent">The samples with the newest one.</param>
        public void Start(double displayed, in Vector3D shown, in Vector3D predicted, double before, RecentVectors recent)
        {
            // If several samples arrive between two frames, the displayed prediction is the one before the first of them.
            if (displayed != _lastDisplayed) (_lastDisplayed, _sectionOf) = (displayed, before);
            Measure(recent);
            _residual = shown - predicted;
            (_residualFrom, _residualTimeConstant) = (displayed, Math.Min(_timeConstant, MaxShareOfInterval * recent.MeanInterval));
            _isOpen = _residualTimeConstant > 0 && _residual.Length <= MaxError * _maxSpeed * (displayed - _sectionOf);
        }

        /// <param name="predicted">The newest prediction for the time.</param>
        public Vector3D At(double time, in Vector3D predicted) =>
            _isOpen ? predicted + _residual * Math.Exp(-Math.Abs(time - _residualFrom) / _residualTimeConstant) : predicted;

        public void Clear()
        {
            (_lastDisplayed, _sectionOf, _maxSpeed) = (double.NaN, double.NegativeInfinity, 0);
            _isOpen = false;
        }

        // One interval is not enough, because an object that was moved elsewhere has any speed in it.
        void Measure(RecentVectors recent)
        {
            if (recent.Count < 3) return;
            double interval = recent.TimeOf(0) - recent.TimeOf(1), intervalBefore = recent.TimeOf(1) - recent.TimeOf(2);
            if (!(interval > 0 && intervalBefore > 0)) return;
            var (newest, before) = ((recent[0] - recent[1]) * (1 / interval), (recent[1] - recent[2]) * (1 / intervalBefore));
            if (newest.Dot(before) > 0) _maxSpeed = Math.Max(_maxSpeed, Math.Min(newest.Length, before.Length));
        }
    }
}
