using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>State of the position of the robot's base.</summary>
    public enum BaseAnchorState
    {
        /// <summary>A person or a script has placed the base; markers do not move it.</summary>
        Placed,

        /// <summary>The markers have not yet determined the position.</summary>
        Searching,

        /// <summary>
        /// The device has restored the position of an earlier run, or has moved the position far by correcting its map. No marker has confirmed it
        /// yet.
        /// </summary>
        Restored,

        /// <summary>The markers have determined the position.</summary>
        Locked,

        /// <summary>A marker has moved relative to the base: either the marker or the robot was moved. The base stays in its position.</summary>
        Moved,

        /// <summary>The device has lost the stored position; the base stays in its last position.</summary>
        Lost,
    }

    /// <summary>Details of a lock of the robot's base.</summary>
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

        /// <summary>Returns a lock by a person.</summary>
        internal static LockReport ByHand(in RigidTransform locked) => new LockReport(locked, 0, 0, 0, 0, 0);

        /// <summary>Returns the lock after a person has moved the base.</summary>
        /// <param name="at">New pose of the base in the room frame.</param>
        /// <param name="by">The same pose relative to the previous pose.</param>
        internal LockReport Nudged(in RigidTransform at, in RigidTransform by) =>
            new LockReport(at, Markers, SpreadMetres, SpreadRadians, ChangeMetres, ChangeRadians) { Nudge = (Nudge ?? RigidTransform.Identity) * by };

        /// <summary>Pose of the base relative to its pose according to the markers; null if it has not been moved by hand since the lock.</summary>
        internal RigidTransform? Nudge { get; private set; }

        /// <summary>Base in the room frame at the time of the lock.</summary>
        public RigidTransform Base { get; }

        /// <summary>Number of markers used; 0 for a lock by hand.</summary>
        public int Markers { get; }

        /// <summary>Root mean square distance of the markers' poses from their means, in metres; 0 for a lock by hand.</summary>
        public double SpreadMetres { get; }

        /// <summary>Root mean square of the angles between the markers' poses and their means, in radians.</summary>
        public double SpreadRadians { get; }

        /// <summary>Distance by which the base moved from its previous position, in metres; 0 for the first lock.</summary>
        public double ChangeMetres { get; }

        /// <summary>Angle by which the base turned from its previous orientation, in radians.</summary>
        public double ChangeRadians { get; }
    }
}
