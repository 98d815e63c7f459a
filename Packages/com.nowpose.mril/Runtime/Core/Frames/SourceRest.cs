using System;
using Nowpose.Kinematics;

namespace Nowpose.Frames
{
    /// <summary>
    /// The poses that the source of an object reports while a gripper determines the object's place. Distinguishes another pose from a
    /// tracker's noise about the pose at the release.
    /// </summary>
    /// <remarks>
    /// The noise is measured from the grip on, by <see cref="ScatterDetector"/>. The limit for white noise with the standard deviation σ in each
    /// component is 13.5 σ for three components and 6.8 σ for one; the difference of two samples has √2 σ. Allocates nothing after construction.
    /// </remarks>
    sealed class SourceRest
    {
        /// <summary>Differences up to these are rounding, m and rad.</summary>
        const double SamePosition = 1e-6, SameRotation = 1e-6;

        /// <summary>Maximum difference of two samples of one pose, relative to the mean difference of consecutive ones.</summary>
        const double MaxDifference = 6;

        /// <summary>Number of consecutive samples of another pose that show a motion, if the samples have noise. A tracker has outliers.</summary>
        const int MinConsecutive = 2;

        readonly ScatterDetector _positions = new ScatterDetector();
        readonly ScatterDetector _rotations = new ScatterDetector();
        RigidTransform _rest, _first;
        bool _isFirst;
        double _metres, _radians;
        int _different;

        /// <summary>Begins with a grip.</summary>
        public void Begin()
        {
            _positions.Clear();
            _rotations.Clear();
            _isFirst = true;
        }

        /// <summary>Takes the noise until now as that of the pose at the release.</summary>
        /// <param name="rest">Newest pose of the source.</param>
        public void Release(in RigidTransform rest)
        {
            _rest = rest;
            _metres = Math.Max(SamePosition, MaxDifference * _positions.Noise);
            _radians = Math.Max(SameRotation, MaxDifference * _rotations.Noise);
            _different = 0;
        }

        /// <summary>Adds a pose of the source, newer than those before.</summary>
        public void Add(in RigidTransform pose)
        {
            if (_isFirst) _first = pose;
            _isFirst = false;
            _positions.Add(new Vector3D(pose.X, pose.Y, pose.Z));
            _rotations.Add(UnitQuaternion.Of(_first.Inverse * pose).Log());
        }

        /// <summary>Returns whether the source has left the pose of the release, with a pose after it. Call it once for each pose.</summary>
        public bool IsLeftBy(in RigidTransform pose)
        {
            var difference = _rest.Inverse * pose;
            var isDifferent = new Vector3D(difference.X, difference.Y, difference.Z).Length > _metres || UnitQuaternion.Of(difference).Log().Length > _radians;
            _different = isDifferent ? _different + 1 : 0;
            return _different >= (_metres > SamePosition || _radians > SameRotation ? MinConsecutive : 1);
        }
    }
}
