using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Fitting
{
    /// <summary>Where a marker is by what was seen of it, and by how much that is probably wrong.</summary>
    readonly struct MarkerEstimate
    {
        /// <summary>
        /// Of one code, however long it is looked at, along and about an axis: how well its place at the base can be measured, and how
        /// flat the print is. So much is not averaged away.
        /// </summary>
        const double PlacedMetres = 0.00025;

        /// <summary>The same of its angle, where there are no other markers to tell.</summary>
        public const double PlacedRadians = 0.5 * System.Math.PI / 180;

        /// <param name="inBase">Where it is in the base frame, as it was measured.</param>
        /// <param name="mean">In the room frame.</param>
        public MarkerEstimate(in RigidTransform inBase, in RigidTransform mean, double errorMetres, double errorRadians)
        {
            InBase = inBase;
            Mean = mean;
            ErrorMetres = errorMetres;
            ErrorRadians = errorRadians;
        }

        public RigidTransform InBase { get; }
        public RigidTransform Mean { get; }

        /// <summary>Root mean square of what the mean's position is probably off by.</summary>
        public double ErrorMetres { get; }

        public double ErrorRadians { get; }

        public double PositionWeight => 1 / (ErrorMetres * ErrorMetres / 3 + PlacedMetres * PlacedMetres);

        /// <summary>Along an axis, what is averaged away by looking longer.</summary>
        public double RotationVariance => ErrorRadians * ErrorRadians / 3;

        /// <param name="placedVariance">Square of what the angle is off by about an axis, however long it is looked at, rad².</param>
        public double RotationWeight(double placedVariance) => 1 / (RotationVariance + placedVariance);

        /// <summary>The same, from where the room is seen otherwise.</summary>
        public MarkerEstimate From(in RigidTransform room) => new MarkerEstimate(InBase, room * Mean, ErrorMetres, ErrorRadians);
    }
}
