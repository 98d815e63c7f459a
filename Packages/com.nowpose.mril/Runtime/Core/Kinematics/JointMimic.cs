namespace Nowpose.Kinematics
{
    /// <summary>A joint that follows another: position = multiplier · master's position + offset.</summary>
    public sealed class JointMimic
    {
        internal JointMimic(string master, double multiplier, double offset)
        {
            Master = master;
            Multiplier = multiplier;
            Offset = offset;
        }

        /// <summary>Name of the joint that is mimicked. It is a moving joint, and may mimic another one.</summary>
        public string Master { get; }

        public double Multiplier { get; }

        /// <summary>Offset in radians, for a prismatic follower in metres.</summary>
        public double Offset { get; }
    }
}
