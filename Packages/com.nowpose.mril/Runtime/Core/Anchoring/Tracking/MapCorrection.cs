using Nowpose.Kinematics;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>Distance and angle by which the device has moved a base since its lock, by correcting its map.</summary>
    readonly struct MapCorrection
    {
        /// <param name="locked">Base at the lock, in the room frame.</param>
        /// <param name="now">Pose of the base that the device reports now, in the room frame.</param>
        public MapCorrection(in RigidTransform locked, in RigidTransform now)
        {
            Metres = locked.DistanceTo(now);
            Radians = locked.AngleTo(now);
        }

        public double Metres { get; }

        public double Radians { get; }
    }
}
