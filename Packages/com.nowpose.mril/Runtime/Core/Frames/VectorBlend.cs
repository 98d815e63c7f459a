using System;
using Nowpose.Prediction;

namespace Nowpose.Frames
{
    /// <summary>Keeps a displayed vector continuous when a sample changes its prediction: a <see cref="SectionBlend"/> with vectors.</summary>
    /// <remarks>Allocates nothing.</remarks>
    sealed class VectorBlend
    {
        /// <summary>Number of newest samples that determine the maximum speed.</summary>
        public const int Samples = 3;

        readonly SectionBlend _blend;
        Vector3D _residual;
        double _maxSpeed;
        bool _isActive;

        /// <param name="timeConstant">Maximum time constant, in s; 0 disables the blend.</param>
        public VectorBlend(double timeConstant) => _blend = new SectionBlend(timeConstant);

        /// <inheritdoc cref="SectionBlend.IsNeeded"/>
        public bool IsNeeded(double displayed) => _blend.IsNeeded(displayed);

        /// <summary>Starts from the vector that was displayed before the newest sample.</summary>
        /// <param name="displayed">Last display time, in s.</param>
        /// <param name="shown">The vector displayed at that time.</param>
        /// <param name="predicted">Vector that the newest prediction gives for that time.</param>
        /// <param name="before">Time of the newest sample of the displayed prediction, in s.</param>
        /// <param name="samples">The samples, including the one that changed the prediction.</param>
        public void Start(double displayed, in Vector3D shown, in Vector3D predicted, double before, BodySamples samples, BodyPart part)
        {
            _blend.Replace(displayed, before);
            UpdateMaxSpeed(samples, part);
            _residual = shown - predicted;
            _isActive = _blend.TryStart(displayed, _residual.Length, _maxSpeed, samples.Timing.MeanInterval);
        }

        /// <summary>Returns the displayed vector.</summary>
        /// <param name="predicted">The newest prediction for <paramref name="time"/>.</param>
        public Vector3D At(double time, in Vector3D predicted) => _isActive ? predicted + _residual * _blend.RemainderAt(time) : predicted;

        /// <summary>Discards the displayed prediction and the maximum speed.</summary>
        public void Clear()
        {
            _blend.Reset();
            _maxSpeed = 0;
            _isActive = false;
        }

        // Uses two intervals, because the speed in a single one can have any value if the object was moved elsewhere.
        void UpdateMaxSpeed(BodySamples samples, BodyPart part)
        {
            if (samples.Timing.ConnectedSamples < Samples) return;
            var (newest, middle, oldest) = (samples.History[0], samples.History[1], samples.History[2]);
            var speed = (newest[part] - middle[part]) * (1 / (newest.Time - middle.Time));
            var before = (middle[part] - oldest[part]) * (1 / (middle.Time - oldest.Time));
            if (speed.Dot(before) > 0) _maxSpeed = Math.Max(_maxSpeed, Math.Min(speed.Length, before.Length));
        }
    }
}
