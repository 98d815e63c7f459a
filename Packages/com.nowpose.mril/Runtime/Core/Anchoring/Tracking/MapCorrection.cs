using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>Distance and angle by which the device has moved a base by correcting its map.</summary>
    readonly struct MapCorrection
    {
        /// <param name="before">Base before the correction, in the room frame.</param>
        /// <param name="now">Pose of the base that the device reports now, in the room frame.</param>
        public MapCorrection(in RigidTransform before, in RigidTransform now)
        {
            Metres = before.DistanceTo(now);
            Radians = before.AngleTo(now);
        }

        public double Metres { get; }

        public double Radians { get; }

        public bool IsBeyond(double metres, double radians) => Metres > metres || Radians > radians;
    }
}
