using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>How a base was locked.</summary>
    public sealed class LockReport
    {
        internal LockReport(
            in RigidTransform locked, int markers, double spreadMetres, double spreadRadians, double changeMetres, double changeRadians)
        {
            Base = locked;
            Markers = markers;
            SpreadMetres = spreadMetres;
            SpreadRadians = spreadRadians;
            ChangeMetres = changeMetres;
            ChangeRadians = changeRadians;
        }

        /// <summary>In the room frame, at that moment.</summary>
        public RigidTransform Base { get; }

        /// <summary>How many went into it; 0 by hand.</summary>
        public int Markers { get; }

        /// <summary>Root mean square distance of the markers' poses from their means, metres; 0 by hand.</summary>
        public double SpreadMetres { get; }

        /// <summary>Root mean square angle of the markers' poses to their means, radians.</summary>
        public double SpreadRadians { get; }

        /// <summary>How far it moved the base from where it was locked before, metres; 0 for the first.</summary>
        public double ChangeMetres { get; }

        /// <summary>By how much it turned it, radians.</summary>
        public double ChangeRadians { get; }
    }
}
