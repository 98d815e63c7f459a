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

        /// <summary>Name of the joint that is followed; it moves, and may follow another itself.</summary>
        public string Master { get; }

        public double Multiplier { get; }

        /// <summary>Radians, for a prismatic follower metres.</summary>
        public double Offset { get; }
    }
}
