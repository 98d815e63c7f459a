using System;
using Nowpose.Kinematics;
using Nowpose.Prediction.Candidates;

namespace Nowpose.Frames
{
    /// <summary>
    /// Detects that the source of an object reports a pose that differs from its pose at the release by more than the noise of a tracker. It is used
    /// while a gripper, and not the source, determines the place of the object, and while a gripper may have moved the object.
    /// </summary>
    /// <remarks>
    /// <see cref="ScatterDetector"/> measures the noise from the grip on, if necessary until after the release. For white noise with the standard
    /// deviation σ in each component, the limit is 13.5 σ for three components and 6.8 σ for one; the difference of two samples has √2 σ. Allocates
    /// nothing after construction.
    /// </remarks>
    sealed class SourceRest
    {
        /// <summary>
        /// Maximum differences of a source at rest, in m and rad, also if it has no noise: an encoder or a camera system may change the last digit
        /// now and then.
        /// </summary>
        const double SamePosition = 1e-3, SameRotation = 5e-3;

        /// <summary>Maximum noise that is a rounding error, in m or rad.</summary>
        const double Rounding = 1e-7;

        /// <summary>Maximum difference between two samples of the same pose, relative to the mean difference between consecutive samples.</summary>
        const double MaxDifference = 6;

        /// <summary>
        /// Minimum number of consecutive samples with a different pose that count as a motion if the samples have noise, because a single sample may
        /// be an outlier.
        /// </summary>
        const int MinConsecutive = 2;

        const int Components = 3;

        readonly PositionWindow _positions = new PositionWindow(ScatterDetector.Window, Components);
        readonly PositionWindow _rotations = new PositionWindow(ScatterDetector.Window, Components);
        readonly ScatterDetector _position = new ScatterDetector(Components), _rotation = new ScatterDetector(Components);
        RigidTransform _rest, _first;
        double _metres, _radians;
        int _different, _minDifferent = 1;

        /// <summary>
        /// Whether enough samples have been added to measure the noise. After 4 samples, white noise remains undetected in half of all cases; after this
        /// number, in 1 % of the cases if it is in one component, and in less than 0.02 % if it is in three.
        /// </summary>
        public bool IsNoiseKnown => _positions.Count == ScatterDetector.Window;

        /// <summary>Starts measuring the noise. Call it at a grip.</summary>
        public void Begin()
        {
            _positions.Clear();
            _rotations.Clear();
            _position.Reset();
            _rotation.Reset();
        }

        /// <summary>Stores the first pose since the grip as the pose at the release, because the time of the release is unknown.</summary>
        /// <param name="newest">Newest pose of the source.</param>
        /// <returns>Whether the newest pose differs from the first one by more than the noise; false while the noise is unknown.</returns>
        public bool ReleaseAtFirst(in RigidTransform newest)
        {
            Release(_positions.Count == 0 ? newest : _first);
            return IsNoiseKnown && IsDifferent(newest);
        }

        /// <summary>Stores the pose at the release, and the noise measured so far.</summary>
        /// <param name="rest">Newest pose of the source.</param>
        public void Release(in RigidTransform rest)
        {
            _rest = rest;
            _different = 0;
            SetLimits();
        }

        void SetLimits()
        {
            _metres = Math.Max(SamePosition, MaxDifference * _position.Noise);
            _radians = Math.Max(SameRotation, MaxDifference * _rotation.Noise);
            _minDifferent = _position.Noise > Rounding || _rotation.Noise > Rounding ? MinConsecutive : 1;
        }

        /// <summary>Adds a pose of the source that is newer than the previous poses.</summary>
        public void Add(in RigidTransform pose)
        {
            var isMeasuring = !IsNoiseKnown;
            if (_positions.Count == 0) _first = pose;
            Add(_position, _positions, new Vector3D(pose.X, pose.Y, pose.Z));
            Add(_rotation, _rotations, UnitQuaternion.Of(_first.Inverse * pose).Log());
            if (isMeasuring) SetLimits();
        }

        static void Add(ScatterDetector detector, PositionWindow window, in Vector3D vector)
        {
            window.Add(stackalloc[] { vector.X, vector.Y, vector.Z });
            detector.Add(window.Positions, window.Count);
        }

        /// <summary>
        /// Returns whether a pose after the release shows that the source has left its pose at the release. Call it once for each pose.
        /// </summary>
        public bool IsLeftBy(in RigidTransform pose)
        {
            _different = IsDifferent(pose) ? _different + 1 : 0;
            return _different >= _minDifferent;
        }

        bool IsDifferent(in RigidTransform pose)
        {
            var difference = _rest.Inverse * pose;
            return new Vector3D(difference.X, difference.Y, difference.Z).Length > _metres || UnitQuaternion.Of(difference).Log().Length > _radians;
        }
    }

    /// <summary>Keeps the positions of the newest samples, newest first; the components of a position are adjacent.</summary>
    sealed class PositionWindow
    {
        readonly int _samples, _components;

        public PositionWindow(int samples, int components) =>
            (_samples, _components, Positions) = (samples, components, new double[samples * components]);

        /// <summary>Number of samples.</summary>
        public int Count { get; private set; }

        public double[] Positions { get; }

        public void Add(ReadOnlySpan<double> position)
        {
            Count = Math.Min(Count + 1, _samples);
            Array.Copy(Positions, 0, Positions, _components, (Count - 1) * _components);
            position.CopyTo(Positions);
        }

        public void Clear() => Count = 0;
    }
}
