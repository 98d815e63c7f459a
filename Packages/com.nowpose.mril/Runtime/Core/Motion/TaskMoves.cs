namespace Nowpose.Motion
{
    /// <summary>The moves of a pick-and-place cycle that depend on the cell. Move i begins at waypoint i.</summary>
    readonly struct TaskMoves
    {
        public TaskMoves(int approach, int grip, int lower, int release) => (Approach, Grip, Lower, Release) = (approach, grip, lower, release);

        /// <summary>First move for which the workpiece must be at the pick place. Until its end, the gripper is open.</summary>
        public int Approach { get; }

        /// <summary>Move in which the gripper closes. The arm is at rest.</summary>
        public int Grip { get; }

        /// <summary>First move in which the gripper is away from the pick place. It carries the workpiece to the fixture.</summary>
        public int Carry => Grip + 2;

        /// <summary>First move for which the fixture must be free.</summary>
        public int Lower { get; }

        /// <summary>Move in which the gripper opens. The arm is at rest.</summary>
        public int Release { get; }

        /// <summary>First move in which the gripper is away from the fixture.</summary>
        public int Leave => Release + 2;

        /// <summary>Returns whether the gripper carries a workpiece between pick place and fixture.</summary>
        public bool IsCarrying(int move) => move >= Carry && move < Lower;

        /// <summary>Returns whether the belt must be at rest during a move, because the gripper is at the pick place or at the fixture.</summary>
        public bool IsAtBelt(int move) => move >= Approach && move < Leave && !IsCarrying(move);
    }
}
