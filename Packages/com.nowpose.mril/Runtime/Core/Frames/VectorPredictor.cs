using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Samples;

namespace Nowpose.Frames
{
    /// <summary>
    /// Predicts the position or the angles of a body: interpolates between its samples, forecasts after the newest one, and blends sections.
    /// </summary>
    /// <remarks>For a vector what <see cref="JointPredictor"/> is for a joint. Allocates nothing after construction.</remarks>
    sealed class VectorPredictor
    {
        readonly BodyPart _part;
        readonly BodySamples _samples;
        readonly VectorForecaster _forecaster;
        readonly VectorBlend _blend;

        // Jump from the end of the curve, which is the newest sample, to the forecast at that time. It is subtracted from the forecast and decays.
        Vector3D _jump;

        /// <param name="samples">The samples of the body.</param>
        /// <param name="blend">Time constant of the blend between two sections, s; 0 disables the blend.</param>
        public VectorPredictor(BodyPart part, BodySamples samples, VectorForecaster forecaster, double blend)
        {
            (_part, _samples, _forecaster) = (part, samples, forecaster);
            _blend = new VectorBlend(blend);
        }

        /// <summary>Fits the forecaster to the newest samples.</summary>
        /// <param name="interpolates">Whether the vector is interpolated up to the newest sample, so that its forecast must start there.</param>
        /// <inheritdoc cref="VectorForecaster.Solve" path="/param[@name='isElsewhere']"/>
        /// <returns>See <see cref="VectorForecaster.Solve"/>.</returns>
        public bool Solve(bool interpolates, bool isElsewhere = false)
        {
            var isSolved = _forecaster.Solve(_samples, isElsewhere);
            _jump = isSolved && interpolates ? _forecaster.At(0) : default;
            return isSolved;
        }

        /// <inheritdoc cref="VectorForecaster.HasJumped"/>
        public bool HasJumped => _forecaster.HasJumped;

        /// <inheritdoc cref="SectionBlend.IsNeeded"/>
        public bool IsBlendNeeded(double displayed) => _blend.IsNeeded(displayed);

        /// <summary>Continues from the displayed vector after the samples have changed.</summary>
        /// <param name="displayed">Last display time, in s.</param>
        /// <param name="shown">Vector that was displayed at this time.</param>
        /// <param name="place">Place of this time in the new section.</param>
        /// <param name="before">Time of the newest sample before the change, in s.</param>
        public void Blend(double displayed, in Vector3D shown, in SectionPlace place, double before) =>
            _blend.Start(displayed, shown, SectionAt(place), before, _samples, _part);

        /// <summary>Returns the displayed vector. Does not change the state.</summary>
        /// <param name="time">Time in s.</param>
        /// <param name="place">Place of this time in the section.</param>
        public Vector3D At(double time, in SectionPlace place) => double.IsNaN(time) ? SectionAt(place) : _blend.At(time, SectionAt(place));

        /// <summary>Discards all learned state.</summary>
        public void Reset()
        {
            _forecaster.Reset();
            _blend.Clear();
            _jump = default;
        }

        Vector3D SectionAt(in SectionPlace place)
        {
            var newest = _samples.History[0];
            if (place.IsOnCurve) return CurveAt(newest.Time + place.Ahead);
            if (double.IsNaN(place.Ahead)) return newest[_part];
            var forecast = _forecaster.At(place.Ahead) - _jump * Math.Exp(-place.Ahead / JointPredictor.JumpTimeConstant);
            // An overflow must not reach a transform.
            return double.IsFinite(forecast.X + forecast.Y + forecast.Z) ? newest[_part] + forecast : newest[_part];
        }

        Vector3D CurveAt(double time)
        {
            Span<double> components = stackalloc double[3];
            var first = _part == BodyPart.Position ? 0 : components.Length;
            for (var c = 0; c < components.Length; c++)
                components[c] = new SampleCurve<BodySample>(_samples.History, first + c, _samples.Timing.ConnectedSamples).At(time);
            return new Vector3D(components[0], components[1], components[2]);
        }
    }

    /// <summary>Place of a time in the section of a body: on the curve through its samples, or on the forecast.</summary>
    readonly struct SectionPlace
    {
        /// <param name="kind">How the pose at this time is computed.</param>
        /// <param name="ahead">Seconds after the newest sample; NaN for the newest sample itself.</param>
        /// <param name="isOnCurve">Whether the pose is interpolated between samples.</param>
        public SectionPlace(PredictionKind kind, double ahead, bool isOnCurve = false) => (Kind, Ahead, IsOnCurve) = (kind, ahead, isOnCurve);

        public PredictionKind Kind { get; }

        public double Ahead { get; }

        public bool IsOnCurve { get; }
    }
}
