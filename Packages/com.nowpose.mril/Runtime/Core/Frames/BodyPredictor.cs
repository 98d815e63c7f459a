using System;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Samples;

namespace Nowpose.Frames
{
    /// <summary>Predicts the pose of one tracked frame in its parent at times near its newest samples, usually ahead of them.</summary>
    /// <remarks>
    /// The position and the angles of <see cref="RotationHistory"/> are two vectors with the same sample times. Samples are put into order and prepared
    /// once per pose (<see cref="ArrivalOrder{TSample}"/>, <see cref="BodySamples"/>); then each vector has a section as a joint has one
    /// (<see cref="VectorPredictor"/>). Times and order of samples have the same meaning as in <see cref="JointPredictor"/>. Not thread-safe. Allocates
    /// nothing after construction.
    /// </remarks>
    sealed class BodyPredictor
    {
        readonly RotationHistory _rotations = new RotationHistory();
        readonly ArrivalOrder<BodySample> _arrivals = new ArrivalOrder<BodySample>(isEndless: false);
        readonly BodySamples _samples;
        readonly VectorForecaster _forecaster;
        readonly VectorPredictor _position, _angles;
        readonly double _horizonCap;
        readonly bool _interpolates;
        bool _isSolved, _restsBeforeSecondSample;

        /// <param name="predictor">A name that <see cref="Predictors.Create(string, PredictionLimits, double)"/> accepts.</param>
        /// <param name="limits">Horizon cap and maximum gap. An object has no position limits.</param>
        /// <param name="blend">See <see cref="Predictors.Create(string, PredictionLimits, double)"/>.</param>
        /// <param name="shared">
        /// Result of <see cref="VectorForecasts.NewForecasters"/>, for all objects of a cell. Objects in one message have the same sample times, so the
        /// weights are then computed once per message. Null to create forecasters for this object only.
        /// </param>
        /// <exception cref="InputException">The name is unknown.</exception>
        public BodyPredictor(string predictor, PredictionLimits limits, double blend = 0, PositionWeights[] shared = null)
        {
            var mixed = predictor == Predictors.Default ? shared ?? VectorForecasts.NewForecasters() : null;
            VectorForecaster Create(BodyPart part) => mixed != null ? new VectorMixture(part, mixed, limits)
                : (VectorForecaster)new VectorPolynomial(part, predictor == "gp" ? new GaussianProcess() : (PositionWeights)Predictors.Polynomial(predictor));
            _interpolates = mixed != null || predictor == "gp";
            _forecaster = Create(BodyPart.Position);
            var kept = mixed != null ? VectorForecasts.SamplesOf(mixed) : _forecaster.Samples;
            _samples = new BodySamples(Math.Max(kept, VectorBlend.Samples), _interpolates, limits);
            _position = new VectorPredictor(BodyPart.Position, _samples, _forecaster, blend);
            _angles = new VectorPredictor(BodyPart.Angles, _samples, Create(BodyPart.Angles), blend);
            _horizonCap = limits.HorizonCap;
        }

        /// <summary>Pose of the newest sample, which a display without compensation shows; the identity before the first sample.</summary>
        public RigidTransform Hold => PoseOf(_rotations.Newest, _samples.Newest.Position);

        /// <summary>Uncorrected stamp of the newest sample, in s; negative infinity before the first sample.</summary>
        public double NewestTime => _samples.NewestTime;

        /// <summary>Mean time from the newest sample to the display time, in s.</summary>
        public double Horizon => _samples.Timing.Horizon;

        /// <inheritdoc cref="JointPredictor.Restarts"/>
        public int Restarts => _arrivals.Restarts;

        /// <summary>
        /// Adds a sample. Samples may be added in any order. If any coordinate shows that the clock of the samples went back, a new history starts with
        /// this sample.
        /// </summary>
        /// <param name="displayed">See <see cref="JointPredictor.Add"/>.</param>
        /// <returns>See <see cref="JointPredictor.Add"/>.</returns>
        public DropReason Add(in PoseSample sample, double displayed = double.NaN)
        {
            if (sample.Time > NewestTime) _restsBeforeSecondSample &= _samples.IsEmpty;
            var restarts = Restarts;
            var reason = Order(sample);
            if (Restarts != restarts)
            {
                Reset();
                reason = Order(sample);
            }
            foreach (ref readonly var ready in _arrivals.Ready) Use(ready, displayed);
            return reason;
        }

        /// <summary>Returns the pose at a given time; its rotation always has unit length. Does not change the state.</summary>
        /// <param name="time">See <see cref="JointPredictor.At"/>.</param>
        /// <returns>The identity before the first sample.</returns>
        public RigidTransform At(double time) => At(time, out _);

        /// <inheritdoc cref="At(double)"/>
        /// <param name="kind">Origin of the pose; <see cref="PredictionKind.None"/> before the first sample.</param>
        public RigidTransform At(double time, out PredictionKind kind)
        {
            var place = PlaceOf(time);
            kind = place.Kind;
            if (kind == PredictionKind.None) return RigidTransform.Identity;
            if (kind == PredictionKind.Held && _restsBeforeSecondSample && time - NewestTime <= _horizonCap) kind = PredictionKind.Predicted;
            return PoseOf(_rotations.RotationOf(_angles.At(time, place), time), _position.At(time, place));
        }

        /// <summary>Returns <see cref="Hold"/>. Use it while the display time is unknown.</summary>
        /// <param name="kind"><see cref="PredictionKind.Held"/>, or <see cref="PredictionKind.None"/> before the first sample.</param>
        public RigidTransform Newest(out PredictionKind kind)
        {
            kind = _samples.IsEmpty ? PredictionKind.None : PredictionKind.Held;
            return Hold;
        }

        /// <summary>
        /// Discards all samples, because the parent has changed. Until the second sample in the new parent arrives, the object is predicted to be at
        /// rest there, up to the horizon cap, as in a gripper or a fixture. The second sample determines the first speed.
        /// </summary>
        public void ChangeParent()
        {
            Reset();
            _restsBeforeSecondSample = true;
        }

        /// <summary>Discards all samples and all estimates from them, after a restart of the source.</summary>
        public void Reset()
        {
            _restsBeforeSecondSample = false;
            _arrivals.Clear();
            _rotations.Clear();
            Restart();
        }

        void Restart()
        {
            _samples.Clear();
            _position.Reset();
            _angles.Reset();
            _isSolved = false;
        }

        DropReason Order(in PoseSample sample)
        {
            var body = new BodySample(sample.Time, sample.Position, _rotations.Add(sample.Order, sample.Rotation), sample.Order);
            return _arrivals.Add(body, _samples.IsNewer(body) ? double.NegativeInfinity : _samples.History.Oldest);
        }

        void Use(in BodySample sample, double displayed)
        {
            // Products of such displacements can overflow. If the sample is the newest, a new history starts with it; otherwise it is ignored.
            var isNear = (sample.Position - _samples.Newest.Position).Length < JointSample.MaxMagnitude;
            if (!isNear && !_samples.IsNewer(sample)) return;
            if (!isNear) Restart();
            var (isBlended, before) = (_position.IsBlendNeeded(displayed) && !_samples.IsEmpty, NewestTime);
            var place = isBlended ? PlaceOf(displayed) : default;
            var (position, angles) = isBlended ? (_position.At(displayed, place), _angles.At(displayed, place)) : default;
            if (!_samples.Add(sample, displayed)) return;
            _isSolved = _position.Solve(_interpolates);
            // If the position jumps, the object is elsewhere. A tracker may confuse two rotations although the position is right.
            _angles.Solve(_interpolates, _position.HasJumped);
            if (!isBlended) return;
            place = PlaceOf(displayed);
            _position.Blend(displayed, position, place, before);
            _angles.Blend(displayed, angles, place, before);
        }

        // The same cases as for a joint.
        SectionPlace PlaceOf(double time)
        {
            if (_samples.IsEmpty) return new SectionPlace(PredictionKind.None, double.NaN);
            var (history, connected, ahead) = (_samples.History, _samples.Timing.ConnectedSamples, time - _samples.History.NewestTime);
            if (_interpolates && ahead <= 0 && connected > 1)
            {
                var start = history[connected - 1].Time - history.NewestTime;
                return ahead < start ? new SectionPlace(PredictionKind.Held, start, isOnCurve: true)
                    : new SectionPlace(PredictionKind.Interpolated, ahead, isOnCurve: true);
            }
            if (!_isSolved || double.IsNaN(time)) return new SectionPlace(PredictionKind.Held, double.NaN);
            var furthest = Math.Min(_horizonCap, _forecaster.Span);
            if (ahead > furthest) return new SectionPlace(PredictionKind.Held, furthest);
            if (ahead < 0 && !double.IsPositiveInfinity(_horizonCap))
            {
                var start = history.StartOf(Math.Min(connected, _forecaster.Samples));
                if (ahead < start) return new SectionPlace(PredictionKind.Held, start);
            }
            if (ahead <= 0) return new SectionPlace(PredictionKind.Interpolated, ahead);
            // One part may jump while the other moves on.
            return new SectionPlace(_position.HasJumped || _angles.HasJumped ? PredictionKind.Held : PredictionKind.Predicted, ahead);
        }

        static RigidTransform PoseOf(in UnitQuaternion rotation, in Vector3D position) => rotation.At(position.X, position.Y, position.Z);
    }
}
