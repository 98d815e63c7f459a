using System;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Prediction.Mixing;
using Nowpose.Prediction.Samples;
using Nowpose.Signals;

namespace Nowpose.Frames
{
    /// <summary>Predicts the pose of one tracked frame in its parent at times near its newest samples, usually ahead of them.</summary>
    /// <remarks>
    /// The position and the angles of <see cref="RotationHistory"/> are two motions with the same sample times. Each has sections as a joint has
    /// (<see cref="PredictionPipeline{TSample}"/>). Times and order of samples have the same meaning as in <see cref="JointPredictor"/>.
    /// </remarks>
    sealed class BodyPredictor
    {
        const int Position = 0, Angles = 1, Parts = 2, Components = 3;

        readonly RotationHistory _rotations = new RotationHistory();
        readonly PredictionPipeline<BodySample> _pipeline;
        readonly SectionBlend[] _blends = new SectionBlend[Parts];
        readonly PastValues<PoseSample> _past;
        readonly double _horizonCap;
        bool _restsBeforeSecondSample;

        /// <param name="predictor">A name that <see cref="Predictors.Create(string, PredictionLimits, double)"/> accepts.</param>
        /// <param name="limits">Horizon cap and maximum gap. An object has no position limits.</param>
        /// <param name="blend">See <see cref="Predictors.Create(string, PredictionLimits, double)"/>.</param>
        /// <param name="forecasters">
        /// <see cref="Predictors.ForecastersOfObjects"/>, for all objects of a cell. Objects in one message have the same sample times, so the weights are
        /// then computed once per message. Null to create forecasters for this object only.
        /// </param>
        /// <param name="parts">Parts of the default predictor.</param>
        /// <exception cref="InputException">The name is unknown.</exception>
        public BodyPredictor(string predictor, PredictionLimits limits, double blend = 0, ForecasterSet forecasters = null,
            PredictionParts parts = PredictionParts.Object)
        {
            _pipeline = Predictors.OfAnObject<BodySample>(predictor, limits, forecasters, parts);
            for (var part = 0; part < Parts; part++)
                _blends[part] = new SectionBlend(Components, Predictors.BlendOf(predictor, blend), _pipeline.MaxAhead);
            _past = new PastValues<PoseSample>(limits.MaximumGap, Between);
            _horizonCap = limits.HorizonCap;
        }

        /// <summary>Pose of the newest sample, which a display without compensation shows; the identity before the first sample.</summary>
        public RigidTransform Hold => PoseOf(_rotations.Newest, _pipeline.Newest.Position);

        /// <summary>Uncorrected stamp of the newest sample, in s; negative infinity before the first sample.</summary>
        public double NewestTime => _pipeline.NewestStamp;

        /// <inheritdoc cref="PredictionPipeline{TSample}.MaxAhead"/>
        public double MaxAhead => _pipeline.MaxAhead;

        /// <inheritdoc cref="SampleTiming.Interval"/>
        public double Interval => _pipeline.Timing.Interval;

        /// <inheritdoc cref="PredictionPipeline{TSample}.IsNewestStampWrong"/>
        public bool IsNewestStampWrong => _pipeline.IsNewestStampWrong;

        /// <inheritdoc cref="JointPredictor.Restarts"/>
        public int Restarts => _pipeline.Restarts;

        /// <summary>
        /// Adds a sample. Samples may be added in any order. If any coordinate shows that the clock of the samples went back, a new history starts.
        /// </summary>
        /// <param name="displayed">See <see cref="JointPredictor.Add"/>.</param>
        /// <returns>See <see cref="JointPredictor.Add"/>.</returns>
        public DropReason Add(in PoseSample sample, double displayed = double.NaN)
        {
            if (sample.Time > NewestTime) _restsBeforeSecondSample &= _pipeline.IsEmpty;
            var reason = Receive(sample, out var hasRestarted);
            // See JointTracks.Add, and for the display JointPredictor.Add.
            if (IsNewestStampWrong) _past.Clear();
            if (hasRestarted) Restart(displayed);
            else UseReady(IsNewestStampWrong ? double.NaN : displayed);
            if (reason == DropReason.None) _past.Add(sample.Time, sample);
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
            var place = _pipeline.PlaceOf(time);
            kind = place.Kind;
            if (kind == PredictionKind.None) return RigidTransform.Identity;
            if (kind == PredictionKind.Held && _restsBeforeSecondSample && time - NewestTime <= _horizonCap) kind = PredictionKind.Predicted;
            return PoseOf(_rotations.RotationOf(At(Angles, time, place), time), At(Position, time, place));
        }

        /// <summary>
        /// Returns the pose at a given time, which may be earlier than the samples that are used for predictions: up to 1.2 s before the newest sample.
        /// </summary>
        public RigidTransform PoseAt(double time, out PoseOrigin origin)
        {
            var pose = At(time, out var kind);
            var (isAhead, isHeld) = (time > NewestTime, kind == PredictionKind.Held);
            var isKnown = kind != PredictionKind.None && (!isHeld || isAhead);
            origin = !isKnown ? PoseOrigin.None : !isAhead ? PoseOrigin.Measured : isHeld ? PoseOrigin.Held : PoseOrigin.Forecast;
            if (isKnown || !_past.TryGet(time, out var past)) return pose;
            origin = PoseOrigin.Measured;
            return PoseOf(past.Rotation, past.Position);
        }

        /// <summary>Returns <see cref="Hold"/>. Use it while the display time is unknown.</summary>
        /// <param name="kind"><see cref="PredictionKind.Held"/>, or <see cref="PredictionKind.None"/> before the first sample.</param>
        public RigidTransform Newest(out PredictionKind kind)
        {
            kind = _pipeline.IsEmpty ? PredictionKind.None : PredictionKind.Held;
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
            _rotations.Clear();
            _past.Clear();
            _pipeline.Reset();
            foreach (var blend in _blends) blend.Reset();
        }

        DropReason Receive(in PoseSample sample, out bool hasRestarted)
        {
            var newest = _pipeline.Newest.Order;
            var body = new BodySample(sample.Time, sample.Position, _rotations.Add(sample.Order, sample.Rotation), sample.Order);
            var reason = _pipeline.Receive(body, out hasRestarted);
            // Otherwise, the sample with the wrong stamp was not admitted, and the newest one is right.
            if (_pipeline.IsNewestStampWrong && newest > _pipeline.Ready[0].Order) _rotations.Remove(newest);
            return reason;
        }

        // Adds the samples of the clock that went back again, because their angles are relative to the earlier history.
        void Restart(double displayed)
        {
            Span<PoseSample> poses = stackalloc PoseSample[_pipeline.Ready.Length];
            for (var i = 0; i < poses.Length; i++)
            {
                ref readonly var ready = ref _pipeline.Ready[i];
                poses[i] = new PoseSample(ready.Time, ready.Position, _rotations.RotationOf(ready.Angles, ready.Order), ready.Order);
            }
            Reset();
            foreach (ref readonly var pose in poses)
            {
                Receive(pose, out _);
                UseReady(displayed);
            }
        }

        void UseReady(double displayed)
        {
            foreach (ref readonly var ready in _pipeline.Ready) Use(ready, displayed);
        }

        void Use(in BodySample sample, double displayed)
        {
            if (!_pipeline.Admit(sample)) return;
            if (_pipeline.IsEmpty)
                foreach (var blend in _blends) blend.Reset();
            var (isBlended, before) = (_blends[Position].IsNeeded(displayed) && !_pipeline.IsEmpty, _pipeline.NewestTime);
            Span<double> residuals = stackalloc double[Parts * Components];
            var place = isBlended ? _pipeline.PlaceOf(displayed) : default;
            for (var i = 0; i < residuals.Length && isBlended; i++) residuals[i] = At(i / Components, i % Components, displayed, place);
            if (!_pipeline.Add(sample, displayed) || !isBlended) return;
            place = _pipeline.PlaceOf(displayed);
            for (var part = 0; part < Parts; part++)
            {
                var residual = residuals.Slice(part * Components, Components);
                for (var c = 0; c < Components; c++) residual[c] -= _pipeline.At(place, part, c);
                _blends[part].StoreReplaced(displayed, before);
                _blends[part].Start(displayed, residual, _pipeline.MotionOf(part));
            }
        }

        Vector3D At(int part, double time, in SectionPlace place) => new Vector3D(At(part, 0, time, place), At(part, 1, time, place), At(part, 2, time, place));

        double At(int part, int component, double time, in SectionPlace place)
        {
            var position = _pipeline.At(place, part, component);
            return double.IsNaN(time) ? position : position + _blends[part].RemainderAt(time, component);
        }

        static PoseSample Between(PoseSample before, PoseSample after, double fraction) => new PoseSample(
            before.Time + fraction * (after.Time - before.Time), before.Position + (after.Position - before.Position) * fraction,
            UnitQuaternion.Slerp(before.Rotation, after.Rotation, fraction));

        static RigidTransform PoseOf(in UnitQuaternion rotation, in Vector3D position) => rotation.At(position.X, position.Y, position.Z);
    }
}
